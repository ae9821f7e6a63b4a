itk_module(Baselines
  DEPENDS
    ContourMetric
    DentalCommon
    DentalContour
    SilhouetteToContour
    ITKCommon
    ITKOptimizersv4
    ITKMetricsv4
    ITKRegistrationMethodsv4
    ITKImageGradient
    ITKImageGrid
    ITKSmoothing
    ITKTransform
  DESCRIPTION
    "What the method is compared with: iterative closest points, coherent point drift, image intensities."
)
