itk_module(Batch
  DEPENDS
    Annotation
    CaseRegistration
    DentalCommon
    ITKCommon
  DESCRIPTION
    "Many cases: found in a folder or a table, registered by a process each, summed up in tables and a page."
)
