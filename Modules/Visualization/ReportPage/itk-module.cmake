itk_module(ReportPage
  DEPENDS
    DentalCommon
    Annotation
    CephalometricGeometry
    RegistrationScene
    SurfaceDRR
    ITKCommon
    ITKMesh
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "The page that a registration is judged by: one HTML file with everything in it."
)
