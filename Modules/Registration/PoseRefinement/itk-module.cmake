itk_module(PoseRefinement
  DEPENDS
    DentalCommon
    CephalometricGeometry
    ContourMetric
    DentalContour
    SilhouetteContour
    UMidlineDentalAxis
    ITKCommon
    ITKMesh
    ITKTransform
  TEST_DEPENDS
    DentalPhantom
    ITKTestKernel
  DESCRIPTION
    "The robust registration: pose of the jaws through the perspective geometry, regenerated outlines, correlated noise, priors, covariance and verdict."
)
