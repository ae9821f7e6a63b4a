itk_module(DentalCommon
  DEPENDS
    ITKCommon
    ITKMesh
  DESCRIPTION
    "What every module shares: input errors, flat surfaces and the projection that kernels speak, seeded random numbers."
)
