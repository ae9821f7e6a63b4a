itk_module(CephalometricGeometry
  DEPENDS
    DentalCommon
    ITKCommon
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "Source, detector, pixel grid and pose of a lateral cephalogram as one data object."
)
