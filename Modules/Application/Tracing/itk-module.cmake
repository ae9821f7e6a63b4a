itk_module(Tracing
  DEPENDS
    CaseRegistration
    TracingPage
    ITKCommon
  DESCRIPTION
    "A radiograph is traced in a browser: the server of the page, and what registers while somebody draws."
)
