itk_module(DentalPhantom
  DEPENDS
    DentalCommon
    DentalContour
    CephalometricGeometry
    ITKCommon
    ITKMesh
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "Parametric dental arches, radiograph and tracing with a known answer."
)
