itk_module(SilhouetteContour
  DEPENDS
    DentalCommon
    CephalometricGeometry
    DentalContour
    ITKCommon
    ITKMesh
    ITKTransform
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "Outer silhouettes: exactly from a mesh and its geometry, and at sub-pixel precision from an image or a label map, and resampling by arc length."
)
