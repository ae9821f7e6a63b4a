itk_module(CrownRegion
  DEPENDS
    Annotation
    DentalCommon
    DentalContour
    UMidlineDentalAxis
    ITKCommon
    ITKMesh
    ITKTransform
  TEST_DEPENDS
    DentalPhantom
    MeshOpenMesh
    ITKTestKernel
  DESCRIPTION
    "The crowns of a scan without gingiva, palate and base, from its shape or from tooth labels; one side of the midline."
)
