itk_module(Annotation
  DEPENDS
    DentalCommon
    DentalContour
    ITKCommon
    ITKMesh
  DESCRIPTION
    "Contours and landmarks from and to files: the case's JSON, Slicer markups, labelme, CSV; the checked JSON reading behind them."
)
