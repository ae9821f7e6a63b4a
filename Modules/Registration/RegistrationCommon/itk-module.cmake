itk_module(RegistrationCommon
  DEPENDS
    DentalCommon
    ITKCommon
    ITKOptimizersv4
    ITKTransform
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "What all registrations share: metrics that are sums of squares over named blocks of parameters, their sum, robust kernels, the noise of a tracing, and the optimizer that takes them."
)
