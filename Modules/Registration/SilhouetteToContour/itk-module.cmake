itk_module(SilhouetteToContour
  DEPENDS
    CephalometricGeometry
    CephalometricPose
    ContourMetric
    DentalCommon
    DentalContour
    RegistrationCommon
    ITKCommon
    ITKMesh
    ITKOptimizersv4
    ITKTransform
  DESCRIPTION
    "Multi-stage registration of a projected silhouette with a traced contour, and what follows from the similarity that it finds."
)
