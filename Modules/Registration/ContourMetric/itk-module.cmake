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
    "Distances between contours: exact nearest-point search, the Chamfer metric for v4 optimizers, and the same figures as filters."
)
