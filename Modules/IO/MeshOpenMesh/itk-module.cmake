itk_module(MeshOpenMesh
  DEPENDS
    DentalCommon
    ITKCommon
    ITKIOMeshBase
    ITKMesh
  DESCRIPTION
    "Strict reading and writing of STL, PLY, OBJ and OFF through the stock itk::MeshFileReader and itk::MeshFileWriter."
)
