itk_module(Annotation
  DEPENDS
    Cephalogram
    DentalCommon
    DentalContour
    SilhouetteContour
    ITKBinaryMathematicalMorphology
    ITKCommon
    ITKMesh
  DESCRIPTION
    "Contours and landmarks from and to files: the case's JSON, other programs' JSON, XML and tables, label maps and drawn lines; the checked JSON reading behind them."
)
