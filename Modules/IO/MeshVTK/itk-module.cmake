itk_module(MeshVTK
  DEPENDS
    DentalCommon
    ITKCommon
    ITKMesh
  TEST_DEPENDS
    ITKTestKernel
  DESCRIPTION
    "Reading of VTK surfaces (legacy .vtk, XML .vtp) with the tooth labels that segmentation tools leave in them."
)
