itk_module(ContourMetric
  DEPENDS
    DentalContour
    ITKCommon
    ITKMesh
    ITKOptimizersv4
    ITKTransform
  DESCRIPTION
    "Distances between contours: exact nearest-point search, Chamfer metric for v4 optimizers, and the same figures as a filter."
)
