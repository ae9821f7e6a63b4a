itk_module(CephalometricPose
  DEPENDS
    CephalometricGeometry
    DentalCommon
    ITKCommon
    ITKTransform
  TEST_DEPENDS
    ITKIOTransformBase
    ITKIOTransformInsightLegacy
    ITKTestKernel
    ITKTransformFactory
  DESCRIPTION
    "The pose of a scan in front of the source: perspective projection under seven parameters, as a transform from 3-D to the radiograph with its Jacobians."
)
