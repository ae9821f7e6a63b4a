itk_module(CommandLine
  DEPENDS
    CaseRegistration
    DentalPhantom
    ITKCommon
  DESCRIPTION
    "The program dentalscr: one file a verb."
)
