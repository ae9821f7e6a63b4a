itk_module(Cephalogram
  DEPENDS
    CephalometricGeometry
    DentalCommon
    ITKCommon
    ITKIOBMP
    ITKIOGDCM
    ITKIOImageBase
    ITKIOJPEG
    ITKIOMeta
    ITKIONRRD
    ITKIOPNG
    ITKIOTIFF
  DESCRIPTION
    "Reads a radiograph and says what its pixel spacing is worth."
)
