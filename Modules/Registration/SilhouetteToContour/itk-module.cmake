itk_module(SilhouetteToContour
  DEPENDS
    ContourMetric
    DentalCommon
    DentalContour
    RegistrationCommon
    ITKCommon
    ITKOptimizersv4
    ITKTransform
  DESCRIPTION
    "Multi-stage registration of a projected silhouette with a traced contour, its schedules and observers."
)
