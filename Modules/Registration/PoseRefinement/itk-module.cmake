itk_module(PoseRefinement
  DEPENDS
    DentalCommon
    CephalometricGeometry
    DentalContour
    SilhouetteContour
    ITKCommon
    ITKMesh
    ITKTransform
  TEST_DEPENDS
    UMidlineDentalAxis
    ITKTestKernel
  DESCRIPTION
    "The robust registration: pose of the jaws through the perspective geometry, regenerated outlines, correlated noise, priors, covariance and verdict."
)
