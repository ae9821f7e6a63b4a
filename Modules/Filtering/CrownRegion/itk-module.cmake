itk_module(CrownRegion
  DEPENDS
    Annotation
    DentalCommon
    DentalContour
    MeshOpenMesh
    MeshVTK
    UMidlineDentalAxis
    ITKCommon
    ITKMesh
    ITKTransform
  TEST_DEPENDS
    DentalPhantom
    ITKTestKernel
  DESCRIPTION
    "The crowns of a scan without gingiva, palate and base, from its shape or from tooth labels; one side of the midline."
)
