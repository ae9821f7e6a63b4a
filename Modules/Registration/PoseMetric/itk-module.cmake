itk_module(PoseMetric
  DEPENDS
    CephalometricGeometry
    CephalometricPose
    DentalCommon
    DentalContour
    RegistrationCommon
    SilhouetteContour
    UMidlineDentalAxis
    ITKCommon
    ITKMesh
    ITKTransform
  TEST_DEPENDS
    DentalPhantom
    ITKTestKernel
  DESCRIPTION
    "Residuals of a pose: a scan's silhouette against a tracing, landmarks of a scan against landmarks of a radiograph."
)
