itk_module(DentalContour
  DEPENDS
    DentalCommon
    ITKCommon
    ITKMesh
  DESCRIPTION
    "Tooth codes, tooth-coded contours and landmarks: plain data objects."
)
