"""DentalSCR: aligns 3-D intraoral scans with a lateral cephalometric radiograph.

``dentalscr.register("case.json")`` does all of it; the classes are the steps, under the names of the C++ toolkit and
with the verbs of SimpleITK: ``Set...``, ``Get...``, ``AddCommand``, ``Execute``. Each has a procedural twin without
the suffix of its name. Documentation/Python.md has the conventions. Research software, not a medical device.
"""
from ._core import (
    AnnotationFileFormat,
    AnnotationPixelOrigin,
    CephalometricGeometry,
    Contour,
    Image,
    Jaw,
    Mesh,
    Numbering,
    Picture,
    PixelSpacingVerdict,
    Polyline,
    Preset,
    Similarity2DTransform,
    SpacingPlane,
    Transform,
    VersorRigid3DTransform,
    __version__,
    tooth_fdi,
    tooth_name,
)
from ._case import Case, CaseRegistration, CaseResult, JawResult, ReadCase, register
from ._errors import AbortedError, ArgumentError, Error, FilterError, InputError
from ._events import (
    Command,
    EventEnum,
    sitkAbortEvent,
    sitkAnyEvent,
    sitkDeleteEvent,
    sitkEndEvent,
    sitkIterationEvent,
    sitkMultiResolutionIterationEvent,
    sitkProgressEvent,
    sitkStartEvent,
    sitkUserEvent,
)
from ._inputs import as_contour, as_image, as_landmarks, as_mesh, as_transform
from ._io import (
    CephalogramFileReader,
    Contours,
    DentalContourFileReader,
    DentalContourFileWriter,
    DentalLandmarkFileReader2D,
    DentalLandmarkFileReader3D,
    DentalLandmarkFileWriter2D,
    DentalLandmarkFileWriter3D,
    ReadCephalogram,
    ReadContours,
    ReadLandmarks,
    ReadMesh,
    ReadToothLabels,
    ReadTransform,
    ToothLabelFileReader,
    WriteContours,
    WriteLandmarks,
    WriteMesh,
    WriteTransform,
)
from ._process import ProcessObject

__all__ = [name for name in dir() if not name.startswith("_")]
