# VTK is no dependency of the module's library: what needs it are headers for whoever links VTK, and the library
# RegistrationSceneVTK beside it, which is built where VTK is found (src/CMakeLists.txt).
itk_module(RegistrationScene
  DEPENDS
    CephalometricGeometry
    DentalCommon
    DentalContour
    SilhouetteContour
    ITKCommon
    ITKMesh
  TEST_DEPENDS
    DentalPhantom
  DESCRIPTION
    "A registration in space: scans, source, detector with the radiograph and what is drawn on it, for VTK and others."
)
