itk_module(UMidlineDentalAxis
  DEPENDS
    DentalCommon
    DentalContour
    ITKCommon
    ITKMesh
    ITKTransform
  TEST_DEPENDS
    DentalPhantom
    ITKTestKernel
  DESCRIPTION
    "The anatomical frame of dental arches: U-midline dental axis (UMDA), mirror plane, occlusion check."
)
