itk_module(RegistrationEvaluation
  DEPENDS
    DentalContour
    ITKCommon
  DESCRIPTION
    "Landmark errors of a registration: mean, RMSE, standard deviation, tooth groups, success detection rates, cohorts."
)
