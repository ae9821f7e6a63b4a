# ITK's transform IO is linked by the part that is loaded with the first transform that is written (src/CMakeLists.txt). It is
# named here because in a static build that part is in this module; the shared library uses nothing of it, and the linker
# leaves it out.
itk_module(CaseRegistration
  DEPENDS
    DentalCommon
    CephalometricGeometry
    CephalometricPose
    DentalContour
    MeshOpenMesh
    MeshVTK
    Annotation
    Cephalogram
    UMidlineDentalAxis
    CrownRegion
    SurfaceDRR
    SilhouetteContour
    RegistrationCommon
    ContourMetric
    SilhouetteToContour
    PoseRegistration
    RegistrationEvaluation
    RegistrationReport
    RegistrationScene
    ReportPage
    ITKCommon
    ITKMesh
    ITKTransform
    ITKIOTransformBase
    ITKIOTransformInsightLegacy
  TEST_DEPENDS
    DentalPhantom
  DESCRIPTION
    "A case file through the whole chain to its result: what the program and the Python package share."
)
