itk_module(SurfaceDRR
  DEPENDS
    DentalCommon
    CephalometricGeometry
    ITKCommon
    ITKMesh
    ITKImageSources
  TEST_DEPENDS
    ITKTestKernel
    ITKImageFilterBase
  DESCRIPTION
    "Digitally reconstructed radiograph of surfaces: area-weighted Gaussian splats in perspective."
)
