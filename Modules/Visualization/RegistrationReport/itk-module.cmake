itk_module(RegistrationReport
  DEPENDS
    DentalCommon
    DentalContour
    ITKCommon
    ITKIOImageBase
    ITKIOPNG
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "Pictures of a registration, drawn without a screen."
)
