itk_module(DentalPhantom
  DEPENDS
    Annotation
    CephalometricGeometry
    DentalCommon
    DentalContour
    MeshOpenMesh
    ITKCommon
    ITKIOImageBase
    ITKIOMeshBase
    ITKIOPNG
    ITKMesh
    ITKPath
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "Parametric dental arches, radiograph and tracing with a known answer."
)
