# ITKIOGDCM is linked by the part that is loaded with the first DICOM file (src/CMakeLists.txt). It is named here because in a
# static build that part is in this module; the shared library uses nothing of it, and the linker leaves it out.
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
