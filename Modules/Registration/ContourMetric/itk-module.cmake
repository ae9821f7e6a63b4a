itk_module(ContourMetric
  DEPENDS
    DentalContour
    RegistrationCommon
    ITKCommon
    ITKMesh
    ITKOptimizersv4
    ITKTransform
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "Distances between contours: exact nearest-point search, Chamfer and partial-overlap metrics for v4 and least-squares optimizers, and the same figures as filters."
)
