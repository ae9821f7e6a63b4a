itk_module(TracingPage
  DEPENDS
    Annotation
    DentalCommon
    ReportPage
    ITKCommon
  DESCRIPTION
    "The page on which a radiograph is traced: one HTML file with everything in it."
)
