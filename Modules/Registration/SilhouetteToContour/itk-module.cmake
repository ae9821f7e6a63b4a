itk_module(SilhouetteToContour
  DEPENDS
    ContourMetric
    DentalCommon
    DentalContour
    ITKCommon
    ITKOptimizersv4
    ITKTransform
  TEST_DEPENDS
    ITKStatistics
  DESCRIPTION
    "Multi-stage registration of a projected silhouette with a traced contour, its schedules and observers."
)
