itk_module(CommandLine
  DEPENDS
    Batch
    CaseRegistration
    DentalPhantom
    Experiment
    ITKCommon
    ITKIOImageBase
    ITKIOBMP
    ITKIOJPEG
    ITKIOMeta
    ITKIONRRD
    ITKIOPNG
    ITKIOTIFF
    ITKImageIntensity
  DESCRIPTION
    "The program dentalscr: one file a verb."
)
