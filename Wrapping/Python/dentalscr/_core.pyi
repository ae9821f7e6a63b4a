"""
The compiled part of dentalscr.
"""
from __future__ import annotations
import numpy
import numpy.typing
import typing
__all__: list[str] = ['AnnotationFileFormat', 'AnnotationPixelOrigin', 'CaseLandmarkErrorFilter', 'CaseRegistration', 'CaseResultFolderWriter', 'CephalogramFileReader', 'CephalometricGeometry', 'CephalometricLandmarkFileReader', 'CephalometricPoseTransform', 'CoherentPointDriftContourRegistrationMethod', 'CohortExperiment', 'Contour', 'ContourChamferMetricv4', 'ContourDirection', 'ContourDistanceFilter', 'ContourMaskFilter', 'ContourOverlapFilter', 'ContourPointDistance', 'ContourResampleFilter', 'ContourToContourMetricv4', 'ContourTransformFilter', 'CorrelatedNoiseModel', 'CrownRegionMeshFilter', 'DataObject', 'DentalCaseReader', 'DentalContourFileReader', 'DentalContourFileWriter', 'DentalFrames', 'DentalLandmarkFileReader2D', 'DentalLandmarkFileReader3D', 'DentalLandmarkFileWriter2D', 'DentalLandmarkFileWriter3D', 'DentalPhantomCaseSource', 'DentalPhantomMeshSource', 'DentalPhantomParameters', 'ExchangedJawsHypothesis', 'ExchangedLandmarksHypothesis', 'ExperimentStudy', 'GemanMcClureKernel', 'GeometryPlacementFilter', 'ITK_VERSION', 'Image', 'IntensityMeasure', 'IntensityRegistrationMethod', 'IterativeClosestPointContourRegistrationMethod', 'Jaw', 'JawsShareFrame', 'LandmarkCounterpartFilter', 'LandmarkErrorFilter', 'LandmarkMatrixProjectionFilter', 'LandmarkPoseMetricv4', 'LandmarkProjectionFilter', 'LeastSquaresMetricv4', 'LeastSquaresSumMetricv4', 'LevenbergMarquardtOptimizerv4', 'MatchedContourFilter', 'Mesh', 'MeshSilhouetteContourSource', 'MetricHold', 'MidlineSideMeshFilter', 'MidsagittalPlaneFilter', 'MillimetreLandmarksHypothesis', 'Motion', 'Numbering', 'ObjectToObjectOptimizerBase', 'OpenSilhouetteContourSource', 'OtherFacingHypothesis', 'OtherSideHypothesis', 'OtherSpacingHypothesis', 'ParameterPrior', 'ParameterPriorMetricv4', 'PhantomArchFamily', 'PhantomCohort', 'PhantomFrame', 'Picture', 'PixelSpacingVerdict', 'Polyline', 'PoseCandidate', 'PoseHypothesis', 'PoseHypothesisOutcome', 'PoseIteration', 'PoseMetricv4', 'PoseRegistrationMethod', 'PoseRegistrationOptions', 'PoseSolution', 'PoseStage', 'PoseStart', 'PoseStartSearch', 'PoseStateBlocks', 'Preset', 'ProcessObject', 'ProjectionSimilarityFilter', 'ReadTransform', 'RegistrationEventKind', 'RegistrationIterationCommand', 'RegistrationIterationRecord', 'RegistrationLevel', 'RegistrationLevelResult', 'RegistrationOverlayFilter', 'RegistrationVerdictFilter', 'RegistrationVerdictThresholds', 'ResidualNoiseModel', 'RobustKernel', 'ScanCheckFilter', 'Side', 'SilhouetteContent', 'SilhouetteContourFilter', 'SilhouetteCoordinates', 'SilhouetteLevel', 'SilhouettePoseMetricv4', 'SilhouetteToContourRegistrationMethod', 'Similarity2DTransform', 'SimilarityPlacementFilter', 'SpacingPlane', 'SpacingSource', 'SquaresKernel', 'StateBlock', 'StateParameter', 'StopCondition', 'SurfaceDRRImageSource', 'SurfaceDRRNormalization', 'SurfaceDRROutput', 'SurfaceSplatWidthCalculator', 'ToothCrownFilter', 'ToothLabelFileReader', 'TracedSide', 'TracingPixelSpacingFilter', 'Transform', 'TurnedDrawingHypothesis', 'UMidlineDentalAxisFilter', 'VersorRigid3DTransform', 'WriteTransform', 'experiment_methods', 'tooth_fdi', 'tooth_name']
class DataObject:
    """
    What process objects exchange.
    """
class Jaw:
    """
    A jaw; Unknown stands for both where a filter takes it.

    Members:

      Upper

      Lower

      Unknown
    """
    Lower: typing.ClassVar[Jaw]
    Unknown: typing.ClassVar[Jaw]
    Upper: typing.ClassVar[Jaw]
    __members__: typing.ClassVar[dict[str, Jaw]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class Numbering:
    """
    How tooth codes are written: UR1, 11 or 8.

    Members:

      Quadrant

      FDI

      Universal
    """
    FDI: typing.ClassVar[Numbering]
    Quadrant: typing.ClassVar[Numbering]
    Universal: typing.ClassVar[Numbering]
    __members__: typing.ClassVar[dict[str, Numbering]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class Mesh(DataObject):
    """
    A triangle mesh: a scan of a jaw.

    Coordinates are kept as 32-bit floats, as STL has them, in mm unless a function says otherwise. Triangles are wound
    counter-clockwise seen from outside.

    Parameters
    ----------
    points : (N, 3) array of numbers
    triangles : (M, 3) array of integers
        Indices into the points.
    labels : (N,) array of integers, optional
        FDI number of the tooth of each point, 0 for gingiva.
    """
    def GetNumberOfPoints(self) -> int:
        ...
    def GetNumberOfTriangles(self) -> int:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, points: numpy.typing.ArrayLike, triangles: numpy.typing.ArrayLike, labels: typing.Any = None) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    @property
    def bounds(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 3): smallest and largest coordinates.
        """
    @property
    def faces(self) -> numpy.typing.NDArray[typing.Any]:
        """
        The triangles, under the name that trimesh has.
        """
    @property
    def labels(self) -> typing.Any:
        """
        (N,) uint8 or None: a copy. FDI numbers, 0 for gingiva.
        """
    @labels.setter
    def labels(self, arg1: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def points(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 3) float32: a read-only view, no copy.
        """
    @property
    def triangles(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (M, 3) uint32: a copy.
        """
    @property
    def vertices(self) -> numpy.typing.NDArray[typing.Any]:
        """
        The points, under the name that trimesh has.
        """
class Image(DataObject):
    """
    A grey picture of 32-bit floats: radiograph, DRR or label map.

    Arrays are [row, column] = [v, u]; sizes, spacings and points are (u, v) as in SimpleITK. ``numpy.asarray(image)`` is a
    read-only view.

    Parameters
    ----------
    array : (height, width) array
        Copied.
    spacing, origin : pair of numbers, optional
        mm a pixel, and the place of the pixel (0, 0).
    direction : 4 numbers, optional
        Row-major.
    index : pair of int, optional
        Index of the first pixel; a DRR may begin at a negative one.
    """
    def GetDimension(self) -> int:
        ...
    def GetDirection(self) -> tuple[typing.Any, ...]:
        ...
    def GetHeight(self) -> int:
        ...
    def GetIndex(self) -> tuple[int, int]:
        ...
    def GetOrigin(self) -> tuple[float, float]:
        ...
    def GetSize(self) -> tuple[int, int]:
        """
        (width, height)
        """
    def GetSpacing(self) -> tuple[float, float]:
        ...
    def GetWidth(self) -> int:
        ...
    def TransformContinuousIndexToPhysicalPoint(self, index: typing.Sequence[float]) -> tuple[float, float]:
        ...
    def TransformPhysicalPointToContinuousIndex(self, point: typing.Sequence[float]) -> tuple[float, float]:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, array: numpy.typing.ArrayLike, spacing: typing.Sequence[float] = (1.0, 1.0), origin: typing.Sequence[float] = (0.0, 0.0), direction: typing.Sequence[float] = [1.0, 0.0, 0.0, 1.0], index: typing.Sequence[int] = (0, 0)) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    def _repr_png_(self) -> bytes:
        """
        The picture, for notebooks.
        """
    @property
    def array(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (height, width) float32: a read-only view, no copy.
        """
class Picture(DataObject):
    """
    A colour picture; ``numpy.asarray(picture)`` is a read-only view.
    """
    def GetSize(self) -> tuple[int, int]:
        """
        (width, height)
        """
    def Write(self, fileName: str) -> None:
        """
        As PNG, whole or not at all.
        """
    def __repr__(self) -> str:
        ...
    def _repr_png_(self) -> bytes:
        """
        The picture, for notebooks.
        """
class Polyline:
    """
    One stretch of a contour.

    Parameters
    ----------
    points : (N, 2) array
        Continuous pixel indices (u, v); a closed one does not repeat its first.
    code : str or int, optional
        "UR1" or the FDI number; "" is unknown.
    closed : bool, optional
    weights : (N,) array, optional
        In [0, 1], 0 is ignored.
    sigmas : float or (N,) array, optional
        Drawing errors of the points, pixels; 0 where nobody knows.
    outline : "crown", "tooth" or "labial", optional
        What of the tooth was drawn; found out unless given.
    """
    def __init__(self, points: numpy.typing.ArrayLike, code: typing.Any = '', closed: bool = False, weights: typing.Any = None, sigmas: typing.Any = None, outline: typing.Any = None) -> None:
        ...
    def __len__(self) -> int:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def closed(self) -> bool:
        ...
    @property
    def code(self) -> str:
        """
        "UR1" or "".
        """
    @property
    def fdi(self) -> int:
        """
        0 is unknown.
        """
    @property
    def outline(self) -> typing.Any:
        """
        "crown", "tooth", "labial", or None.
        """
    @property
    def points(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 2) copy.
        """
    @property
    def sigmas(self) -> typing.Any:
        """
        (N,) copy, or None.
        """
    @property
    def weights(self) -> typing.Any:
        """
        (N,) copy, or None.
        """
class Contour(DataObject):
    """
    Polylines in a radiograph, each with the code of its tooth.

    Points are continuous pixel indices (u, v): (0, 0) is the centre of the first pixel. A tracing is one, a silhouette and
    what a segmentation yields are others.

    Parameters
    ----------
    polylines : sequence of Polyline, optional
    """
    def AddPolyline(self, points: numpy.typing.ArrayLike, code: typing.Any = '', closed: bool = False, weights: typing.Any = None, sigmas: typing.Any = None, outline: typing.Any = None) -> None:
        ...
    def GetLength(self) -> float:
        """
        Sum of the segments' lengths, pixels.
        """
    def GetNumberOfPoints(self) -> int:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, polylines: typing.Sequence[Polyline] = []) -> None:
        ...
    def __len__(self) -> int:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    def _repr_svg_(self) -> str:
        """
        The picture, for notebooks.
        """
    @property
    def points(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 2) float64: the points of all polylines, a copy.
        """
    @property
    def polylines(self) -> list[Polyline]:
        """
        Copies.
        """
class Transform:
    """
    Maps points; which way is the maker's to say.
    """
    __hash__: typing.ClassVar[None] = None  # type: ignore[assignment]
    def GetFixedParameters(self) -> tuple[typing.Any, ...]:
        ...
    def GetName(self) -> str:
        ...
    def GetNumberOfParameters(self) -> int:
        ...
    def GetParameters(self) -> tuple[typing.Any, ...]:
        ...
    def __eq__(self, other: object) -> bool:
        ...
class Similarity2DTransform(Transform):
    """
    p = scale R(angle) (q - center) + center + translation, in the plane.

    Parameters are (scale, angle, tx, ty), fixed parameters the centre, as in SimpleITK. A registration's result maps the
    moving contour to the fixed one.

    Parameters
    ----------
    scale : float, optional
    angle : float, optional
        Radians, from u towards v.
    translation, center : pair of numbers, optional
    """
    def GetAngle(self) -> float:
        ...
    def GetCenter(self) -> tuple[float, float]:
        ...
    def GetDimension(self) -> int:
        ...
    def GetInverse(self) -> Similarity2DTransform:
        ...
    def GetMatrix(self) -> tuple[typing.Any, ...]:
        """
        Row-major.
        """
    def GetScale(self) -> float:
        ...
    def GetTranslation(self) -> tuple[float, float]:
        ...
    def SetAngle(self, angle: float) -> None:
        ...
    def SetCenter(self, center: typing.Sequence[float]) -> None:
        ...
    def SetFixedParameters(self, parameters: typing.Sequence[float]) -> None:
        ...
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        ...
    def SetScale(self, scale: float) -> None:
        ...
    def SetTranslation(self, translation: typing.Sequence[float]) -> None:
        ...
    def TransformPoint(self, point: typing.Sequence[float]) -> tuple[float, float]:
        ...
    def TransformPoints(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[typing.Any]:
        """
        All rows of an array; a copy.
        """
    def __copy__(self) -> Similarity2DTransform:
        ...
    def __deepcopy__(self, memo: dict[str, typing.Any]) -> Similarity2DTransform:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, scale: float = 1.0, angle: float = 0.0, translation: typing.Sequence[float] = (0.0, 0.0), center: typing.Sequence[float] = (0.0, 0.0)) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    @property
    def matrix(self) -> numpy.typing.NDArray[typing.Any]:
        """
        Homogeneous, for column vectors; a copy.
        """
class VersorRigid3DTransform(Transform):
    """
    A rigid motion of space: three versor parameters and three of translation, as in SimpleITK.

    Parameters
    ----------
    matrix : (4, 4) or (3, 4) array, optional
        A rigid motion to begin with.
    """
    def GetCenter(self) -> tuple[float, float, float]:
        ...
    def GetDimension(self) -> int:
        ...
    def GetInverse(self) -> VersorRigid3DTransform:
        ...
    def GetMatrix(self) -> tuple[typing.Any, ...]:
        """
        Row-major.
        """
    def GetTranslation(self) -> tuple[float, float, float]:
        ...
    def SetCenter(self, center: typing.Sequence[float]) -> None:
        ...
    def SetFixedParameters(self, parameters: typing.Sequence[float]) -> None:
        ...
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        ...
    def SetTranslation(self, translation: typing.Sequence[float]) -> None:
        ...
    def TransformPoint(self, point: typing.Sequence[float]) -> tuple[float, float, float]:
        ...
    def TransformPoints(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[typing.Any]:
        """
        All rows of an array; a copy.
        """
    def __copy__(self) -> VersorRigid3DTransform:
        ...
    def __deepcopy__(self, memo: dict[str, typing.Any]) -> VersorRigid3DTransform:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, matrix: typing.Any = None) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    @property
    def matrix(self) -> numpy.typing.NDArray[typing.Any]:
        """
        Homogeneous, for column vectors; a copy.
        """
class CephalometricGeometry(DataObject):
    """
    Where source, detector and pixels of a cephalogram are.

    Cephalostat frame, mm: origin where the central ray meets the midsagittal plane, x anterior, y to the patient's left, z
    superior. The pose maps the object's frame to it.

    Parameters
    ----------
    sourceToMidsagittal, sourceToDetector : float, optional
        mm.
    pixelSpacing : float or pair of float, optional
        mm in the detector plane. There is no default: projecting without one raises.
    principalPoint : pair of float, optional
        Continuous pixel index where the central ray meets the detector.
    sourceSide : SourceSide or str, optional
        The side of the patient on which the source stands.
    facing : Facing or str, optional
        Where the face points in the image.
    direction : Direction or str, optional
        Of the rays: Lateral, or Frontal, with ``sourceToMidsagittal`` the distance to the midcoronal plane.
    frontalSource : FrontalSource or str, optional
        Where the source of a frontal radiograph stands.
    patientLeft : PatientLeft or str, optional
        Where the patient's left is in a frontal radiograph.
    """
    class Direction:
        """
        From which side of the head the rays come.

        Members:

          Lateral

          Frontal
        """
        Frontal: typing.ClassVar[CephalometricGeometry.Direction]
        Lateral: typing.ClassVar[CephalometricGeometry.Direction]
        __members__: typing.ClassVar[dict[str, CephalometricGeometry.Direction]]
        def __eq__(self, other: typing.Any) -> bool:
            ...
        def __getstate__(self) -> int:
            ...
        def __hash__(self) -> int:
            ...
        def __index__(self) -> int:
            ...
        @typing.overload
        def __init__(self, value: int) -> None:
            ...
        @typing.overload
        def __init__(self, name: str) -> None:
            ...
        def __int__(self) -> int:
            ...
        def __ne__(self, other: typing.Any) -> bool:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, state: int) -> None:
            ...
        def __str__(self) -> str:
            ...
        @property
        def name(self) -> str:
            ...
        @property
        def value(self) -> int:
            ...
    class FrontalSource:
        """
        Where the X-ray source of a frontal radiograph stands.

        Members:

          Behind

          InFront
        """
        Behind: typing.ClassVar[CephalometricGeometry.FrontalSource]
        InFront: typing.ClassVar[CephalometricGeometry.FrontalSource]
        __members__: typing.ClassVar[dict[str, CephalometricGeometry.FrontalSource]]
        def __eq__(self, other: typing.Any) -> bool:
            ...
        def __getstate__(self) -> int:
            ...
        def __hash__(self) -> int:
            ...
        def __index__(self) -> int:
            ...
        @typing.overload
        def __init__(self, value: int) -> None:
            ...
        @typing.overload
        def __init__(self, name: str) -> None:
            ...
        def __int__(self) -> int:
            ...
        def __ne__(self, other: typing.Any) -> bool:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, state: int) -> None:
            ...
        def __str__(self) -> str:
            ...
        @property
        def name(self) -> str:
            ...
        @property
        def value(self) -> int:
            ...
    class PatientLeft:
        """
        Where the patient's left is in a frontal radiograph.

        Members:

          Right

          Left
        """
        Left: typing.ClassVar[CephalometricGeometry.PatientLeft]
        Right: typing.ClassVar[CephalometricGeometry.PatientLeft]
        __members__: typing.ClassVar[dict[str, CephalometricGeometry.PatientLeft]]
        def __eq__(self, other: typing.Any) -> bool:
            ...
        def __getstate__(self) -> int:
            ...
        def __hash__(self) -> int:
            ...
        def __index__(self) -> int:
            ...
        @typing.overload
        def __init__(self, value: int) -> None:
            ...
        @typing.overload
        def __init__(self, name: str) -> None:
            ...
        def __int__(self) -> int:
            ...
        def __ne__(self, other: typing.Any) -> bool:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, state: int) -> None:
            ...
        def __str__(self) -> str:
            ...
        @property
        def name(self) -> str:
            ...
        @property
        def value(self) -> int:
            ...
    class SourceSide:
        """
        Side of the X-ray source.

        Members:

          Right

          Left
        """
        Left: typing.ClassVar[CephalometricGeometry.SourceSide]
        Right: typing.ClassVar[CephalometricGeometry.SourceSide]
        __members__: typing.ClassVar[dict[str, CephalometricGeometry.SourceSide]]
        def __eq__(self, other: typing.Any) -> bool:
            ...
        def __getstate__(self) -> int:
            ...
        def __hash__(self) -> int:
            ...
        def __index__(self) -> int:
            ...
        @typing.overload
        def __init__(self, value: int) -> None:
            ...
        @typing.overload
        def __init__(self, name: str) -> None:
            ...
        def __int__(self) -> int:
            ...
        def __ne__(self, other: typing.Any) -> bool:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, state: int) -> None:
            ...
        def __str__(self) -> str:
            ...
        @property
        def name(self) -> str:
            ...
        @property
        def value(self) -> int:
            ...
    class Facing:
        """
        Where the face points.

        Members:

          Right

          Left
        """
        Left: typing.ClassVar[CephalometricGeometry.Facing]
        Right: typing.ClassVar[CephalometricGeometry.Facing]
        __members__: typing.ClassVar[dict[str, CephalometricGeometry.Facing]]
        def __eq__(self, other: typing.Any) -> bool:
            ...
        def __getstate__(self) -> int:
            ...
        def __hash__(self) -> int:
            ...
        def __index__(self) -> int:
            ...
        @typing.overload
        def __init__(self, value: int) -> None:
            ...
        @typing.overload
        def __init__(self, name: str) -> None:
            ...
        def __int__(self) -> int:
            ...
        def __ne__(self, other: typing.Any) -> bool:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, state: int) -> None:
            ...
        def __str__(self) -> str:
            ...
        @property
        def name(self) -> str:
            ...
        @property
        def value(self) -> int:
            ...
    def BackProject(self, index: typing.Sequence[float]) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """
        The ray of a pixel in the object frame: the source, and the unit direction.
        """
    def ComputePointJacobian(self, point: typing.Sequence[float]) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 3): d(u, v) / d(point).
        """
    def ComputePoseJacobian(self, point: typing.Sequence[float]) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 6): three rotations (rad) about the cephalostat's axes, three translations (mm).
        """
    def GetDirection(self) -> CephalometricGeometry.Direction:
        ...
    def GetFacing(self) -> CephalometricGeometry.Facing:
        ...
    def GetFrontalSource(self) -> CephalometricGeometry.FrontalSource:
        ...
    def GetMagnification(self, point: typing.Sequence[float]) -> float:
        ...
    def GetPatientLeft(self) -> CephalometricGeometry.PatientLeft:
        ...
    def GetPixelSpacing(self) -> tuple[float, float]:
        ...
    def GetPose(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (4, 4), a copy.
        """
    def GetPrincipalPoint(self) -> tuple[float, float]:
        ...
    def GetProjectionMatrix(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (3, 4): object frame (mm) to homogeneous pixel index, pose included.
        """
    def GetSourcePosition(self) -> tuple[float, float, float]:
        ...
    def GetSourceSide(self) -> CephalometricGeometry.SourceSide:
        ...
    def GetSourceToDetectorDistance(self) -> float:
        ...
    def GetSourceToMidsagittalDistance(self) -> float:
        ...
    def HasPixelSpacing(self) -> bool:
        ...
    def ProjectPoint(self, point: typing.Sequence[float]) -> tuple[float, float]:
        """
        Object frame (mm) to continuous pixel index (u, v).
        """
    def ProjectPoints(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[typing.Any]:
        """
        All rows of an (N, 3) array: (N, 2), a copy.
        """
    def SetDirection(self, direction: CephalometricGeometry.Direction | str) -> None:
        ...
    def SetFacing(self, facing: CephalometricGeometry.Facing | str) -> None:
        ...
    def SetFrontalSource(self, source: CephalometricGeometry.FrontalSource | str) -> None:
        ...
    def SetPatientLeft(self, side: CephalometricGeometry.PatientLeft | str) -> None:
        ...
    def SetPixelSpacing(self, spacing: typing.Sequence[float]) -> None:
        ...
    def SetPose(self, matrix: numpy.typing.ArrayLike) -> None:
        """
        Rigid 4x4 or 3x4: object frame (mm) to cephalostat frame (mm).
        """
    def SetPoseToIdentity(self) -> None:
        ...
    def SetPrincipalPoint(self, index: typing.Sequence[float]) -> None:
        ...
    def SetSourceSide(self, side: CephalometricGeometry.SourceSide | str) -> None:
        ...
    def SetSourceToDetectorDistance(self, value: float) -> None:
        ...
    def SetSourceToMidsagittalDistance(self, value: float) -> None:
        ...
    def TransformToCephalostat(self, point: typing.Sequence[float]) -> tuple[float, float, float]:
        ...
    def VerifyComplete(self) -> None:
        ...
    def __copy__(self) -> CephalometricGeometry:
        ...
    def __deepcopy__(self, memo: dict[str, typing.Any]) -> CephalometricGeometry:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, sourceToMidsagittal: float = 1524.0, sourceToDetector: float = 1674.0, pixelSpacing: typing.Any = None, principalPoint: typing.Any = None, sourceSide: CephalometricGeometry.SourceSide | str = ..., facing: CephalometricGeometry.Facing | str = ..., direction: CephalometricGeometry.Direction | str = ..., frontalSource: CephalometricGeometry.FrontalSource | str = ..., patientLeft: CephalometricGeometry.PatientLeft | str = ...) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
class CephalometricPoseTransform(Transform):
    """
    Maps a point of the dental frame (mm) to the radiograph (continuous pixel index) under the seven parameters of a pose.

    Parameters are (pitch, roll, yaw, tx, ty, tz, kappa): rad, mm, and the logarithm of the factor on the magnification.
    Fixed parameters are the distances from the source to the midsagittal plane and to the detector (mm), the signs of the
    source's side and of the facing, the pixel spacing (mm) and the principal point (px); SetGeometry() fills them.

    Parameters
    ----------
    geometry : CephalometricGeometry, optional
        With a pixel spacing; its pose is not taken.
    parameters : seven numbers, optional
    """
    def ComputeJacobianWithRespectToParameters(self, point: typing.Sequence[float]) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 7): pixels a rad, a mm and a unit of kappa.
        """
    def ComputeJacobianWithRespectToPosition(self, point: typing.Sequence[float]) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 3): pixels a mm.
        """
    def CopyToGeometry(self, geometry: CephalometricGeometry) -> None:
        """
        Gives a geometry all of this transform; ProjectPoint(p) is TransformPoint(p) then.
        """
    def GetRigidTransform(self) -> VersorRigid3DTransform:
        """
        Dental frame to cephalostat frame, mm.
        """
    def GetScaleFactor(self) -> float:
        """
        exp(kappa).
        """
    def SetFixedParameters(self, parameters: typing.Sequence[float]) -> None:
        ...
    def SetGeometry(self, geometry: CephalometricGeometry) -> None:
        """
        Copies it; its pose is not taken.
        """
    def SetIdentity(self) -> None:
        """
        All seven parameters 0; the geometry stays.
        """
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        ...
    def SetParametersFromRotation(self, rotation: numpy.typing.ArrayLike, translation: typing.Sequence[float], kappa: float = 0.0) -> None:
        """
        c = rotation p + translation (mm), and kappa.
        """
    def TransformPoint(self, point: typing.Sequence[float]) -> tuple[float, float]:
        ...
    def TransformPoints(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[typing.Any]:
        """
        All rows of an (N, 3) array: (N, 2).
        """
    def __copy__(self) -> CephalometricPoseTransform:
        ...
    def __deepcopy__(self, memo: dict[str, typing.Any]) -> CephalometricPoseTransform:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, geometry: CephalometricGeometry | None = None, parameters: typing.Sequence[float] = []) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
class ProcessObject:
    """
    What every filter has.
    """
    @staticmethod
    def GetGlobalDefaultNumberOfThreads() -> int:
        ...
    @staticmethod
    def SetGlobalDefaultNumberOfThreads(threads: int) -> None:
        """
        Threads of every object made from now on; 0: all of the machine's. No result depends on it.
        """
    def Abort(self) -> None:
        """
        Ends the run that is under way: Execute raises AbortedError.
        """
    def GetName(self) -> str:
        ...
    def GetNumberOfWorkUnits(self) -> int:
        ...
    def GetProgress(self) -> float:
        """
        Share that is done, 0 to 1.
        """
    def SetNumberOfWorkUnits(self, numberOfWorkUnits: int) -> None:
        ...
    def _AddCommand(self, event: int, key: int) -> int:
        ...
    def _RemoveCommand(self, tag: int) -> None:
        ...
    def _Update(self) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __str__(self) -> str:
        ...
class AnnotationFileFormat:
    """
    What an annotation file is written in.

    Members:

      Automatic

      DentalSCR

      SlicerMarkups

      Labelme

      CSV

      Aariz

      LandmarkDetector

      CLDetection

      ISBI2015

      CVAT

      COCO

      VIA

      LabelStudio

      Supervisely

      LabelImage
    """
    Aariz: typing.ClassVar[AnnotationFileFormat]
    Automatic: typing.ClassVar[AnnotationFileFormat]
    CLDetection: typing.ClassVar[AnnotationFileFormat]
    COCO: typing.ClassVar[AnnotationFileFormat]
    CSV: typing.ClassVar[AnnotationFileFormat]
    CVAT: typing.ClassVar[AnnotationFileFormat]
    DentalSCR: typing.ClassVar[AnnotationFileFormat]
    ISBI2015: typing.ClassVar[AnnotationFileFormat]
    LabelImage: typing.ClassVar[AnnotationFileFormat]
    LabelStudio: typing.ClassVar[AnnotationFileFormat]
    Labelme: typing.ClassVar[AnnotationFileFormat]
    LandmarkDetector: typing.ClassVar[AnnotationFileFormat]
    SlicerMarkups: typing.ClassVar[AnnotationFileFormat]
    Supervisely: typing.ClassVar[AnnotationFileFormat]
    VIA: typing.ClassVar[AnnotationFileFormat]
    __members__: typing.ClassVar[dict[str, AnnotationFileFormat]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class AnnotationPixelOrigin:
    """
    Where a 2-D annotation's (0, 0) is: in the first pixel's centre or corner.

    Members:

      FormatDefault

      Centre

      Corner
    """
    Centre: typing.ClassVar[AnnotationPixelOrigin]
    Corner: typing.ClassVar[AnnotationPixelOrigin]
    FormatDefault: typing.ClassVar[AnnotationPixelOrigin]
    __members__: typing.ClassVar[dict[str, AnnotationPixelOrigin]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class PixelSpacingVerdict:
    """
    What a radiograph's pixel spacing is worth.

    Members:

      Detector

      Calibrated

      EstimatedMagnification

      Unknown

      UserGiven
    """
    Calibrated: typing.ClassVar[PixelSpacingVerdict]
    Detector: typing.ClassVar[PixelSpacingVerdict]
    EstimatedMagnification: typing.ClassVar[PixelSpacingVerdict]
    Unknown: typing.ClassVar[PixelSpacingVerdict]
    UserGiven: typing.ClassVar[PixelSpacingVerdict]
    __members__: typing.ClassVar[dict[str, PixelSpacingVerdict]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class SpacingPlane:
    """
    The plane in which a pixel spacing holds.

    Members:

      Detector

      Midsagittal

      Unknown
    """
    Detector: typing.ClassVar[SpacingPlane]
    Midsagittal: typing.ClassVar[SpacingPlane]
    Unknown: typing.ClassVar[SpacingPlane]
    __members__: typing.ClassVar[dict[str, SpacingPlane]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class DentalContourFileReader(ProcessObject):
    """
    Reads the tracing on a radiograph.
    """
    def GetCalibrations(self) -> list[tuple[str, float, float]]:
        ...
    def GetClassFiles(self) -> list[tuple[str, str]]:
        ...
    def GetFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetFileName(self) -> str:
        ...
    def GetImageFileName(self) -> str:
        ...
    def GetImageSize(self) -> tuple[int, int]:
        ...
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        ...
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        ...
    def GetNumberOfPointsOutside(self) -> int:
        ...
    def GetNumberOfSidelessCodes(self) -> int:
        ...
    def GetNumbering(self) -> Numbering:
        ...
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        ...
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetReadImageSize(self) -> tuple[int, int]:
        ...
    def GetReadNumbering(self) -> Numbering:
        ...
    def GetSidelessCodesAreLeft(self) -> bool:
        ...
    def GetWarnings(self) -> list[str]:
        ...
    def SetClassFiles(self, files: typing.Sequence[tuple[str, str]]) -> None:
        ...
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def SetImageFileName(self, fileName: str) -> None:
        ...
    def SetImageSize(self, size: typing.Sequence[int]) -> None:
        ...
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        ...
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        ...
    def SetNumbering(self, numbering: Numbering | str) -> None:
        ...
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        ...
    def SetSidelessCodesAreLeft(self, on: bool) -> None:
        ...
    def _TakeOutputs(self) -> tuple[Contour, Contour]:
        ...
    def __init__(self) -> None:
        ...
class DentalContourFileWriter(ProcessObject):
    """
    Writes a tracing as contours.json.
    """
    def GetFileName(self) -> str:
        ...
    def GetImageSize(self) -> tuple[int, int]:
        ...
    def GetNumbering(self) -> Numbering:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def SetImageSize(self, size: typing.Sequence[int]) -> None:
        ...
    def SetNumbering(self, numbering: Numbering | str) -> None:
        ...
    def _SetLower(self, contour: Contour | None) -> None:
        ...
    def _SetUpper(self, contour: Contour | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class DentalLandmarkFileReader2D(ProcessObject):
    """
    Reads named landmarks; see ReadLandmarks().
    """
    def GetFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetFileName(self) -> str:
        ...
    def GetImageFileName(self) -> str:
        ...
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        ...
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        ...
    def GetNumbering(self) -> Numbering:
        ...
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        ...
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetWarnings(self) -> list[str]:
        ...
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def SetImageFileName(self, fileName: str) -> None:
        ...
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        ...
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        ...
    def SetNumbering(self, numbering: Numbering | str) -> None:
        ...
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        ...
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def __init__(self) -> None:
        ...
class DentalLandmarkFileWriter2D(ProcessObject):
    """
    Writes named landmarks; see WriteLandmarks().
    """
    def GetFileName(self) -> str:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def _SetInput(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def __init__(self) -> None:
        ...
class DentalLandmarkFileReader3D(ProcessObject):
    """
    Reads named landmarks; see ReadLandmarks().
    """
    def GetFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetFileName(self) -> str:
        ...
    def GetImageFileName(self) -> str:
        ...
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        ...
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        ...
    def GetNumbering(self) -> Numbering:
        ...
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        ...
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetWarnings(self) -> list[str]:
        ...
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def SetImageFileName(self, fileName: str) -> None:
        ...
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        ...
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        ...
    def SetNumbering(self, numbering: Numbering | str) -> None:
        ...
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        ...
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def __init__(self) -> None:
        ...
class DentalLandmarkFileWriter3D(ProcessObject):
    """
    Writes named landmarks; see WriteLandmarks().
    """
    def GetFileName(self) -> str:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def _SetInput(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def __init__(self) -> None:
        ...
class CephalometricLandmarkFileReader(ProcessObject):
    """
    Reads the dental landmarks of a cephalometric analysis; see ReadCephalometricLandmarks().
    """
    def GetFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetFileName(self) -> str:
        ...
    def GetImageFileName(self) -> str:
        ...
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        ...
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        ...
    def GetNumbering(self) -> Numbering:
        ...
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        ...
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        ...
    def GetWarnings(self) -> list[str]:
        ...
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def SetImageFileName(self, fileName: str) -> None:
        ...
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        ...
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        ...
    def SetNumbering(self, numbering: Numbering | str) -> None:
        ...
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        ...
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def __init__(self) -> None:
        ...
class CephalogramFileReader(ProcessObject):
    """
    Reads a radiograph and says what its pixel spacing is worth.
    """
    def ClearUserPixelSpacing(self) -> None:
        ...
    def GetDetectorPixelSpacing(self, sourceToDetector: float, sourceToMidsagittal: float) -> tuple[float, float]:
        ...
    def GetFacing(self) -> CephalometricGeometry.Facing:
        ...
    def GetFileFormat(self) -> str:
        ...
    def GetFileName(self) -> str:
        ...
    def GetMagnificationFactor(self) -> float:
        ...
    def GetPixelSpacing(self) -> tuple[float, float]:
        """
        Raises where the verdict is Unknown.
        """
    def GetPixelSpacingVerdict(self) -> PixelSpacingVerdict:
        ...
    def GetProvenance(self) -> dict[str, str]:
        ...
    def GetSourceToDetectorDistance(self) -> float:
        ...
    def GetSourceToMidsagittalDistance(self) -> float:
        ...
    def GetSpacingPlane(self) -> SpacingPlane:
        ...
    def GetWarnings(self) -> list[str]:
        ...
    def HasFacing(self) -> bool:
        ...
    def HasMagnificationFactor(self) -> bool:
        ...
    def HasPixelSpacing(self) -> bool:
        ...
    def HasSourceToDetectorDistance(self) -> bool:
        ...
    def HasSourceToMidsagittalDistance(self) -> bool:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def SetUserPixelSpacing(self, spacing: typing.Sequence[float], plane: SpacingPlane | str = ...) -> None:
        ...
    def _TakeOutput(self) -> Image:
        ...
    def __init__(self) -> None:
        ...
class ToothLabelFileReader(ProcessObject):
    """
    Reads tooth labels of a mesh's points.
    """
    def GetFileName(self) -> str:
        ...
    def GetJaw(self) -> Jaw:
        ...
    def GetNumberOfPoints(self) -> int:
        ...
    def GetNumbering(self) -> Numbering:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def SetNumberOfPoints(self, count: int) -> None:
        ...
    def SetNumbering(self, numbering: Numbering | str) -> None:
        ...
    def _GetOutput(self) -> numpy.typing.NDArray[typing.Any]:
        ...
    def __init__(self) -> None:
        ...
class JawsShareFrame:
    """
    Whether two scans share a frame in occlusion: said, or tested.

    Members:

      Off

      On

      Check
    """
    Check: typing.ClassVar[JawsShareFrame]
    Off: typing.ClassVar[JawsShareFrame]
    On: typing.ClassVar[JawsShareFrame]
    __members__: typing.ClassVar[dict[str, JawsShareFrame]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class DentalFrames:
    """
    Everything that UMidlineDentalAxisFilter found, for ScanCheckFilter to judge.
    """
class UMidlineDentalAxisFilter(ProcessObject):
    """
    The anatomical frame of dental arches.
    """
    def EmbedAxesOff(self) -> None:
        ...
    def EmbedAxesOn(self) -> None:
        ...
    def GetArchDepth(self, jaw: Jaw | str) -> float:
        """
        mm.
        """
    def GetArchWidth(self, jaw: Jaw | str) -> float:
        """
        mm.
        """
    def GetAxesLength(self) -> float:
        ...
    def GetBaselineLeft(self, jaw: Jaw | str) -> tuple[float, float, float]:
        ...
    def GetBaselineMidpoint(self, jaw: Jaw | str) -> tuple[float, float, float]:
        ...
    def GetBaselineRight(self, jaw: Jaw | str) -> tuple[float, float, float]:
        """
        End of the molar baseline on the patient's right, mesh frame, mm.
        """
    def GetConfidence(self, jaw: Jaw | str) -> float:
        """
        In [0, 1]; below 0.5 a person should look at the axes.
        """
    def GetCrownFraction(self) -> float:
        ...
    def GetEmbedAxes(self) -> bool:
        ...
    def GetIncisalEdge(self, jaw: Jaw | str) -> tuple[float, float, float]:
        ...
    def GetJawsAreInOneFrame(self) -> bool:
        ...
    def GetJawsShareFrame(self) -> JawsShareFrame:
        ...
    def GetMaximumIterations(self) -> int:
        ...
    def GetOverbite(self) -> float:
        """
        mm; means something only where the jaws are in one frame.
        """
    def GetOverjet(self) -> float:
        """
        mm; means something only where the jaws are in one frame.
        """
    def GetRefineMidline(self) -> bool:
        ...
    def GetRequireArches(self) -> bool:
        ...
    def GetTransformMeshes(self) -> bool:
        ...
    def RefineMidlineOff(self) -> None:
        ...
    def RefineMidlineOn(self) -> None:
        ...
    def RequireArchesOff(self) -> None:
        ...
    def RequireArchesOn(self) -> None:
        ...
    def SetAxesLength(self, value: float) -> None:
        ...
    def SetCrownFraction(self, value: float) -> None:
        ...
    def SetEmbedAxes(self, value: bool) -> None:
        ...
    def SetJawsShareFrame(self, mode: JawsShareFrame | str) -> None:
        ...
    def SetMaximumIterations(self, value: int) -> None:
        ...
    def SetRefineMidline(self, value: bool) -> None:
        ...
    def SetRequireArches(self, value: bool) -> None:
        ...
    def SetTransformMeshes(self, value: bool) -> None:
        ...
    def TransformMeshesOff(self) -> None:
        ...
    def TransformMeshesOn(self) -> None:
        ...
    def _GetFrames(self) -> DentalFrames:
        ...
    def _GetTransform(self, jaw: Jaw | str) -> VersorRigid3DTransform | None:
        """
        Of both jaws together for Unknown.
        """
    def _SetLowerMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetUpperMesh(self, mesh: Mesh | None) -> None:
        ...
    def _TakeMesh(self, arg0: Jaw | str) -> Mesh:
        ...
    def __init__(self) -> None:
        ...
class MidsagittalPlaneFilter(ProcessObject):
    """
    The mirror plane of one arch or of a pair.
    """
    def GetNormal(self) -> tuple[float, float, float]:
        ...
    def GetOffset(self) -> float:
        ...
    def SignedDistance(self, point: typing.Sequence[float]) -> float:
        ...
    def _GetPlane(self) -> dict[str, typing.Any]:
        ...
    def _SetLowerMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetUpperMesh(self, mesh: Mesh | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class SurfaceDRRNormalization:
    """
    What a splat weighs.

    Members:

      Paper

      Physical
    """
    Paper: typing.ClassVar[SurfaceDRRNormalization]
    Physical: typing.ClassVar[SurfaceDRRNormalization]
    __members__: typing.ClassVar[dict[str, SurfaceDRRNormalization]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class SurfaceDRROutput:
    """
    What a pixel holds.

    Members:

      Thickness

      Intensity

      InvertedIntensity
    """
    Intensity: typing.ClassVar[SurfaceDRROutput]
    InvertedIntensity: typing.ClassVar[SurfaceDRROutput]
    Thickness: typing.ClassVar[SurfaceDRROutput]
    __members__: typing.ClassVar[dict[str, SurfaceDRROutput]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class SurfaceDRRImageSource(ProcessObject):
    """
    Digitally reconstructed radiograph of surfaces.
    """
    def CoverMeshesOff(self) -> None:
        ...
    def CoverMeshesOn(self) -> None:
        ...
    def GetAttenuation(self) -> float:
        ...
    def GetCoverMargin(self) -> float:
        ...
    def GetCoverMeshes(self) -> bool:
        ...
    def GetDensity(self) -> float:
        ...
    def GetMeshSigma(self, number: int) -> float:
        ...
    def GetNormalization(self) -> SurfaceDRRNormalization:
        ...
    def GetNumberOfProjections(self) -> int:
        """
        How often the splats were projected.
        """
    def GetOrigin(self) -> tuple[float, float]:
        ...
    def GetOutputMode(self) -> SurfaceDRROutput:
        ...
    def GetSigma(self) -> float:
        ...
    def GetSize(self) -> tuple[int, int]:
        ...
    def GetSourceIntensity(self) -> float:
        ...
    def GetSpacing(self) -> tuple[float, float]:
        ...
    def GetStartIndex(self) -> tuple[int, int]:
        ...
    def GetTolerance(self) -> float:
        ...
    def GetUseGeometrySpacing(self) -> bool:
        ...
    def GetVertexSigmas(self, number: int) -> list[float]:
        ...
    def SetAttenuation(self, value: float) -> None:
        ...
    def SetCoverMargin(self, value: float) -> None:
        ...
    def SetCoverMeshes(self, value: bool) -> None:
        ...
    def SetDensity(self, value: float) -> None:
        ...
    def SetMeshSigma(self, number: int, sigma: float) -> None:
        ...
    def SetNormalization(self, normalization: SurfaceDRRNormalization | str) -> None:
        ...
    def SetOrigin(self, origin: typing.Sequence[float]) -> None:
        ...
    def SetOutputMode(self, mode: SurfaceDRROutput | str) -> None:
        ...
    def SetSigma(self, value: float) -> None:
        ...
    def SetSize(self, size: typing.Sequence[int]) -> None:
        ...
    def SetSizeToCoverMeshes(self, margin: float) -> None:
        ...
    def SetSourceIntensity(self, value: float) -> None:
        ...
    def SetSpacing(self, spacing: typing.Sequence[float]) -> None:
        ...
    def SetStartIndex(self, index: typing.Sequence[int]) -> None:
        ...
    def SetTolerance(self, value: float) -> None:
        ...
    def SetUseGeometrySpacing(self, value: bool) -> None:
        ...
    def SetVertexSigmas(self, number: int, sigmas: typing.Sequence[float]) -> None:
        ...
    def UseGeometrySpacingOff(self) -> None:
        ...
    def UseGeometrySpacingOn(self) -> None:
        ...
    def _GetNumberOfMeshes(self) -> int:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetInput(self, number: int, mesh: Mesh | None) -> None:
        ...
    def _SetReferenceImage(self, image: Image | None) -> None:
        ...
    def _TakeOutput(self) -> Image:
        ...
    def _UpdateOutputInformation(self) -> tuple[tuple[int, int], tuple[int, int]]:
        ...
    def _UpdateRegion(self, index: typing.Sequence[int], size: typing.Sequence[int]) -> Image:
        ...
    def __init__(self) -> None:
        ...
class SilhouetteContent:
    """
    What the pixels are: grey values, FDI numbers, or labels of any meaning.

    Members:

      Intensity

      ToothLabels

      MergedLabels
    """
    Intensity: typing.ClassVar[SilhouetteContent]
    MergedLabels: typing.ClassVar[SilhouetteContent]
    ToothLabels: typing.ClassVar[SilhouetteContent]
    __members__: typing.ClassVar[dict[str, SilhouetteContent]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class SilhouetteLevel:
    """
    How the level of grey values is found.

    Members:

      Absolute

      Fraction

      Automatic
    """
    Absolute: typing.ClassVar[SilhouetteLevel]
    Automatic: typing.ClassVar[SilhouetteLevel]
    Fraction: typing.ClassVar[SilhouetteLevel]
    __members__: typing.ClassVar[dict[str, SilhouetteLevel]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class SilhouetteCoordinates:
    """
    In what a contour is expressed.

    Members:

      Index

      Physical

      PhysicalOverSpacing
    """
    Index: typing.ClassVar[SilhouetteCoordinates]
    Physical: typing.ClassVar[SilhouetteCoordinates]
    PhysicalOverSpacing: typing.ClassVar[SilhouetteCoordinates]
    __members__: typing.ClassVar[dict[str, SilhouetteCoordinates]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class SilhouetteContourFilter(ProcessObject):
    """
    The outer silhouette in an image, or of labels.
    """
    def GetContent(self) -> SilhouetteContent:
        ...
    def GetLabelSmoothing(self) -> float:
        ...
    def GetLargestPartOnly(self) -> bool:
        ...
    def GetLevel(self) -> SilhouetteLevel:
        ...
    def GetLevelFraction(self) -> float:
        ...
    def GetLevelValue(self) -> float:
        ...
    def GetMinimumArea(self) -> float:
        ...
    def GetNumberOfStreamDivisions(self) -> int:
        ...
    def GetObjectIsDark(self) -> bool:
        ...
    def GetOutputCoordinates(self) -> SilhouetteCoordinates:
        ...
    def GetOutputOffset(self) -> tuple[float, float]:
        ...
    def GetUsedLevel(self) -> float:
        """
        Of the last Execute().
        """
    def LargestPartOnlyOff(self) -> None:
        ...
    def LargestPartOnlyOn(self) -> None:
        ...
    def ObjectIsDarkOff(self) -> None:
        ...
    def ObjectIsDarkOn(self) -> None:
        ...
    def SetContent(self, content: SilhouetteContent | str) -> None:
        ...
    def SetLabelSmoothing(self, value: float) -> None:
        ...
    def SetLargestPartOnly(self, value: bool) -> None:
        ...
    def SetLevel(self, level: SilhouetteLevel | str) -> None:
        ...
    def SetLevelFraction(self, value: float) -> None:
        ...
    def SetLevelValue(self, value: float) -> None:
        ...
    def SetMinimumArea(self, value: float) -> None:
        ...
    def SetNumberOfStreamDivisions(self, value: int) -> None:
        ...
    def SetObjectIsDark(self, value: bool) -> None:
        ...
    def SetOutputCoordinates(self, coordinates: SilhouetteCoordinates | str) -> None:
        ...
    def SetOutputOffset(self, offset: typing.Sequence[float]) -> None:
        ...
    def _SetInput(self, image: Image | None) -> None:
        ...
    def _TakeOutput(self) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class MeshSilhouetteContourSource(ProcessObject):
    """
    The exact outer silhouette of a mesh.
    """
    def GetLargestPartOnly(self) -> bool:
        ...
    def GetNumberOfPoints(self) -> int:
        ...
    def LargestPartOnlyOff(self) -> None:
        ...
    def LargestPartOnlyOn(self) -> None:
        ...
    def SetLargestPartOnly(self, value: bool) -> None:
        ...
    def SetNumberOfPoints(self, value: int) -> None:
        ...
    def _GetSamples(self) -> tuple[typing.Any, ...]:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetInput(self, mesh: Mesh | None) -> None:
        ...
    def _TakeOutput(self) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class OpenSilhouetteContourSource(ProcessObject):
    """
    The part of a jaw's outline that a tracing can lie on.
    """
    def GetJaw(self) -> Jaw:
        ...
    def GetNormals(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 2), outward.
        """
    def GetRimPoints(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 3), object frame, mm.
        """
    def GetSpacing(self) -> float:
        ...
    def SetJaw(self, jaw: Jaw | str) -> None:
        ...
    def SetSpacing(self, value: float) -> None:
        ...
    def _SetFrameTransform(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetInput(self, mesh: Mesh | None) -> None:
        ...
    def _TakeOutput(self) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class ContourMaskFilter(ProcessObject):
    """
    The stretches of a contour that run through a mask.
    """
    def GetMinimumNumberOfPoints(self) -> int:
        ...
    def SetMinimumNumberOfPoints(self, number: int) -> None:
        ...
    def _SetInput(self, contour: Contour | None) -> None:
        ...
    def _SetMaskImage(self, image: Image | None) -> None:
        ...
    def _TakeOutput(self) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class ContourResampleFilter(ProcessObject):
    """
    Points at equal distances along a contour.
    """
    def GetNumberOfPoints(self) -> int:
        ...
    def GetSpacing(self) -> float:
        ...
    def SetNumberOfPoints(self, value: int) -> None:
        ...
    def SetSpacing(self, value: float) -> None:
        ...
    def _SetInput(self, contour: Contour | None) -> None:
        ...
    def _TakeOutput(self) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class CrownRegionMeshFilter(ProcessObject):
    """
    The crowns of a scan.
    """
    def GetCrownArea(self) -> float:
        """
        mm^2.
        """
    def GetJaw(self) -> Jaw:
        ...
    def GetKeepWholeMesh(self) -> bool:
        ...
    def GetLabelNumbering(self) -> Numbering:
        ...
    def GetLabelsWereUsed(self) -> bool:
        ...
    def GetMarginAngle(self) -> float:
        """
        rad.
        """
    def GetMaximumCrownHeight(self) -> float:
        ...
    def GetMeanCrownHeight(self) -> float:
        """
        mm.
        """
    def GetMinimumCrownHeight(self) -> float:
        ...
    def GetPointMask(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N,) of 0 and 1.
        """
    def GetTriangleMask(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (M,) of 0 and 1.
        """
    def GetUseLabels(self) -> bool:
        ...
    def KeepWholeMeshOff(self) -> None:
        ...
    def KeepWholeMeshOn(self) -> None:
        ...
    def SetJaw(self, jaw: Jaw | str) -> None:
        ...
    def SetKeepWholeMesh(self, value: bool) -> None:
        ...
    def SetLabelNumbering(self, numbering: Numbering | str) -> None:
        ...
    def SetMaximumCrownHeight(self, value: float) -> None:
        ...
    def SetMinimumCrownHeight(self, value: float) -> None:
        ...
    def SetUseLabels(self, value: bool) -> None:
        ...
    def UseLabelsOff(self) -> None:
        ...
    def UseLabelsOn(self) -> None:
        ...
    def _SetFrameTransform(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetInput(self, mesh: Mesh | None) -> None:
        ...
    def _TakeOutput(self) -> Mesh:
        ...
    def __init__(self) -> None:
        ...
class Side:
    """
    The patient's side.

    Members:

      Right

      Left
    """
    Left: typing.ClassVar[Side]
    Right: typing.ClassVar[Side]
    __members__: typing.ClassVar[dict[str, Side]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class MidlineSideMeshFilter(ProcessObject):
    """
    The part of a jaw on one side of the midline plane.
    """
    def GetMargin(self) -> float:
        ...
    def GetSide(self) -> Side:
        ...
    def GetTriangleMask(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (M,) of 0 and 1.
        """
    def SetMargin(self, value: float) -> None:
        ...
    def SetSide(self, side: Side | str) -> None:
        ...
    def _SetFrameTransform(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetInput(self, mesh: Mesh | None) -> None:
        ...
    def _TakeOutput(self) -> Mesh:
        ...
    def __init__(self) -> None:
        ...
class ContourDirection:
    """
    Which way distances between two contours are taken.

    Members:

      Symmetric

      MovingToFixed

      FixedToMoving
    """
    FixedToMoving: typing.ClassVar[ContourDirection]
    MovingToFixed: typing.ClassVar[ContourDirection]
    Symmetric: typing.ClassVar[ContourDirection]
    __members__: typing.ClassVar[dict[str, ContourDirection]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class ContourPointDistance:
    """
    To what distances are taken: the nearest point, or the nearest place on a line.

    Members:

      PointToPoint

      PointToSegment
    """
    PointToPoint: typing.ClassVar[ContourPointDistance]
    PointToSegment: typing.ClassVar[ContourPointDistance]
    __members__: typing.ClassVar[dict[str, ContourPointDistance]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class ContourDistanceFilter(ProcessObject):
    """
    Distances between two contours.
    """
    def GetChamfer(self) -> float:
        """
        Average of the two means, px.
        """
    def GetDistance(self) -> ContourPointDistance:
        ...
    def GetFixedToMovingDistances(self) -> numpy.typing.NDArray[typing.Any]:
        """
        One a point, px; NaN for points of weight 0.
        """
    def GetFixedToMovingHausdorff(self) -> float:
        """
        px.
        """
    def GetFixedToMovingMean(self) -> float:
        """
        px.
        """
    def GetHausdorff(self) -> float:
        """
        px.
        """
    def GetMovingToFixedDistances(self) -> numpy.typing.NDArray[typing.Any]:
        """
        One a point, px; NaN for points of weight 0.
        """
    def GetMovingToFixedHausdorff(self) -> float:
        """
        px.
        """
    def GetMovingToFixedMean(self) -> float:
        """
        px.
        """
    def SetDistance(self, distance: ContourPointDistance | str) -> None:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def _SetTransform(self, transform: Similarity2DTransform | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class ContourOverlapFilter(ProcessObject):
    """
    How much of an open tracing and of a contour lies together.
    """
    def GetFixedDistances(self) -> numpy.typing.NDArray[typing.Any]:
        """
        One a point, px; NaN for points that are ignored.
        """
    def GetFixedShare(self) -> float:
        """
        Of the tracing, 0 to 1.
        """
    def GetGapLength(self) -> float:
        ...
    def GetLargestDistance(self) -> float:
        """
        px.
        """
    def GetMaximumDistance(self) -> float:
        ...
    def GetMovingDistances(self) -> numpy.typing.NDArray[typing.Any]:
        """
        One a point, px; NaN for points without tracing beside them.
        """
    def GetMovingShare(self) -> float:
        """
        Of the outline, 0 to 1.
        """
    def GetRootMeanSquare(self) -> float:
        """
        px.
        """
    def SetGapLength(self, value: float) -> None:
        ...
    def SetMaximumDistance(self, value: float) -> None:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def _SetTransform(self, transform: Similarity2DTransform | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class SpacingSource:
    """
    Where a pixel spacing comes from, for the scale's prior.

    Members:

      Given

      Dicom

      Default

      Estimated
    """
    Default: typing.ClassVar[SpacingSource]
    Dicom: typing.ClassVar[SpacingSource]
    Estimated: typing.ClassVar[SpacingSource]
    Given: typing.ClassVar[SpacingSource]
    __members__: typing.ClassVar[dict[str, SpacingSource]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class ContourToContourMetricv4:
    """
    A figure of merit between two contours, for SetMetric().
    """
    def GetName(self) -> str:
        ...
    def GetPivot(self) -> tuple[float, float]:
        """
        Of scale and rotation, in the moving frame, px.
        """
    def GetReferenceLength(self) -> float:
        """
        What makes the four parameters alike, px.
        """
    def __str__(self) -> str:
        ...
class ContourChamferMetricv4(ContourToContourMetricv4):
    """
    Symmetric or one-sided Chamfer distance: the sum of the directed means, px.
    """
    def GetDirection(self) -> ContourDirection:
        ...
    def GetDistance(self) -> ContourPointDistance:
        ...
    def GetTruncation(self) -> float:
        ...
    def SetDirection(self, direction: ContourDirection | str) -> None:
        ...
    def SetDistance(self, distance: ContourPointDistance | str) -> None:
        ...
    def SetTruncation(self, value: float) -> None:
        ...
    def __init__(self) -> None:
        ...
class RegistrationLevel:
    """
    What one level of a registration may search, and how. Bounds are half-widths around the estimate.

    Parameters
    ----------
    scaleBound : float
        Fraction: 0.35 allows 0.65 to 1.35 times the present scale.
    rotationBound : float
        Radians.
    translationBound : float
        Shift of the silhouette's centroid in u and v, mm.
    numberOfScales, numberOfRotations, numberOfTranslations : int
        Candidates a parameter before the optimizer runs; 0 is none.
    numberOfStarts : int
        The optimizer runs from so many of the best candidates.
    numberOfIterations : int
        From a start; 0 leaves the optimizer's own.
    """
    numberOfIterations: int
    numberOfRotations: int
    numberOfScales: int
    numberOfStarts: int
    numberOfTranslations: int
    rotationBound: float
    scaleBound: float
    translationBound: float
    def __init__(self, scaleBound: float = 0.35, rotationBound: float = 0.0, translationBound: float = 0.0, numberOfScales: int = 0, numberOfRotations: int = 0, numberOfTranslations: int = 0, numberOfStarts: int = 1, numberOfIterations: int = 0) -> None:
        ...
    def __repr__(self) -> str:
        ...
class RegistrationLevelResult:
    """
    How a level went.
    """
    def __repr__(self) -> str:
        ...
    @property
    def boundsHit(self) -> list[int]:
        ...
    @property
    def finalParameters(self) -> list[float]:
        ...
    @property
    def finalValue(self) -> float:
        ...
    @property
    def initialParameters(self) -> list[float]:
        ...
    @property
    def initialValue(self) -> float:
        ...
    @property
    def numberOfCandidates(self) -> int:
        ...
    @property
    def numberOfEvaluations(self) -> int:
        ...
    @property
    def numberOfIterations(self) -> int:
        ...
    @property
    def stopConditionDescription(self) -> str:
        ...
class SilhouetteToContourRegistrationMethod(ProcessObject):
    """
    Aligns a silhouette with a tracing by a 2-D similarity.
    """
    @staticmethod
    def _ComputeBoundingBoxTransform(fixed: Contour, moving: Contour) -> Similarity2DTransform:
        ...
    def FixRotationOff(self) -> None:
        ...
    def FixRotationOn(self) -> None:
        ...
    def FixScaleOff(self) -> None:
        ...
    def FixScaleOn(self) -> None:
        ...
    def FixTranslationOff(self) -> None:
        ...
    def FixTranslationOn(self) -> None:
        ...
    def GetCurrentLevel(self) -> int:
        """
        0 is the coarsest.
        """
    def GetFixRotation(self) -> bool:
        ...
    def GetFixScale(self) -> bool:
        ...
    def GetFixTranslation(self) -> bool:
        ...
    def GetInitialParameters(self) -> tuple[typing.Any, ...]:
        """
        The start (scale, rad, px, px).
        """
    def GetLevel(self, index: int) -> RegistrationLevel:
        ...
    def GetLevelResults(self) -> list[RegistrationLevelResult]:
        """
        How the levels went, after Execute().
        """
    def GetMetricValue(self) -> float:
        ...
    def GetNumberOfLevels(self) -> int:
        ...
    def GetOptimizerIteration(self) -> int:
        ...
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        ...
    def GetPixelSpacing(self) -> float:
        ...
    def GetRandomSeed(self) -> int:
        ...
    def SetFixRotation(self, value: bool) -> None:
        ...
    def SetFixScale(self, value: bool) -> None:
        ...
    def SetFixTranslation(self, value: bool) -> None:
        ...
    def SetLevel(self, index: int, level: RegistrationLevel) -> None:
        ...
    def SetMetric(self, metric: ContourToContourMetricv4 | None) -> None:
        """
        A metric object; None: the paper's.
        """
    def SetMetricAsChamfer(self, direction: ContourDirection | str = ..., distance: ContourPointDistance | str = ..., truncation: float = ...) -> None:
        """
        The paper's: symmetric, point to point, no truncation (px).
        """
    def SetMetricAsFunction(self, function: typing.Callable[..., typing.Any]) -> None:
        """
        A metric of your own: ``function(fixed, moved)``.

        Parameters
        ----------
        function : callable
            Given two (N, 2) arrays in pixels of the radiograph, the tracing and the silhouette under the similarity that is
            tried; returns the value, or the value and its derivatives by ``moved``. Without derivatives they are found by
            central differences.
        """
    def SetMetricAsSymmetricChamfer(self, truncation: float = ...) -> None:
        ...
    def SetNumberOfLevels(self, number: int) -> None:
        ...
    def SetOptimizerAsAmoeba(self, simplexDelta: float = 0.0, numberOfIterations: int = 500, parametersConvergenceTolerance: float = 1e-08, functionConvergenceTolerance: float = 0.0001, withRestarts: bool = False) -> None:
        """
        simplexDelta 0: a quarter of the level's bounds.
        """
    def SetOptimizerAsExhaustive(self, numberOfSteps: typing.Sequence[int], stepLength: float = 1.0) -> None:
        """
        Steps to each side in scale, rotation, u and v: the grid reaches the level's bounds.
        """
    def SetOptimizerAsGradientDescent(self, learningRate: float, numberOfIterations: int, convergenceMinimumValue: float = 1e-06, convergenceWindowSize: int = 10) -> None:
        ...
    def SetOptimizerAsGradientDescentLineSearch(self, learningRate: float, numberOfIterations: int, convergenceMinimumValue: float = 1e-06, convergenceWindowSize: int = 10, lineSearchLowerLimit: float = 0.0, lineSearchUpperLimit: float = 5.0, lineSearchEpsilon: float = 0.01, lineSearchMaximumIterations: int = 20) -> None:
        ...
    def SetOptimizerAsLBFGS2(self, solutionAccuracy: float = 1e-05, numberOfIterations: int = 100, hessianApproximateAccuracy: int = 6, deltaConvergenceDistance: int = 0, deltaConvergenceTolerance: float = 1e-05, lineSearchMaximumEvaluations: int = 40) -> None:
        ...
    def SetOptimizerAsLBFGSB(self, gradientConvergenceTolerance: float = 1e-05, numberOfIterations: int = 500, maximumNumberOfCorrections: int = 5, maximumNumberOfFunctionEvaluations: int = 2000, costFunctionConvergenceFactor: float = 10000000.0) -> None:
        ...
    def SetOptimizerAsOnePlusOneEvolutionary(self, numberOfIterations: int = 100, epsilon: float = 0.00015, initialRadius: float = 1.01, growthFactor: float = 0.0, shrinkFactor: float = 0.0, seed: int = 0) -> None:
        """
        The seed is recorded: the same seed, the same result.
        """
    def SetOptimizerAsPowell(self, numberOfIterations: int = 100, maximumLineIterations: int = 100, stepLength: float = 1.0, stepTolerance: float = 1e-06, valueTolerance: float = 1e-06) -> None:
        ...
    def SetOptimizerAsRegularStepGradientDescent(self, learningRate: float, minStep: float, numberOfIterations: int, relaxationFactor: float = 0.5, gradientMagnitudeTolerance: float = 0.0001) -> None:
        ...
    def SetPixelSpacing(self, spacing: float) -> None:
        """
        mm, mean of u and v.
        """
    def SetPresetToBoundingBox(self) -> None:
        ...
    def SetPresetToGlobal(self) -> None:
        ...
    def SetPresetToPaper(self) -> None:
        ...
    def SetPresetToSingleStage(self) -> None:
        ...
    def SetRandomSeed(self, value: int) -> None:
        ...
    def StopRegistration(self) -> bool:
        """
        Ends the optimizer's present run at the present iteration, keeping the result; False where it can't.
        """
    def _GetMetricName(self) -> str:
        ...
    def _GetOptimizerName(self) -> str:
        ...
    def _GetTransform(self) -> Similarity2DTransform:
        ...
    def _MetricEvaluate(self, fixed: Contour, moving: Contour, transform: Similarity2DTransform) -> float:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetInitialTransform(self, transform: Similarity2DTransform | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class Motion:
    """
    What a baseline may estimate; Rigid keeps the start's scale.

    Members:

      Rigid

      Similarity
    """
    Rigid: typing.ClassVar[Motion]
    Similarity: typing.ClassVar[Motion]
    __members__: typing.ClassVar[dict[str, Motion]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class IterativeClosestPointContourRegistrationMethod(ProcessObject):
    """
    Iterative closest points between two contours.
    """
    def GetCurrentLevel(self) -> int:
        """
        0 is the coarsest.
        """
    def GetDirection(self) -> ContourDirection:
        ...
    def GetInitialParameters(self) -> tuple[typing.Any, ...]:
        """
        The start (scale, rad, px, px).
        """
    def GetMaximumNumberOfIterations(self) -> int:
        ...
    def GetMetricValue(self) -> float:
        ...
    def GetMotion(self) -> Motion:
        ...
    def GetOptimizerIteration(self) -> int:
        ...
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        ...
    def GetTolerance(self) -> float:
        ...
    def GetTrimmedFraction(self) -> float:
        ...
    def SetDirection(self, direction: ContourDirection | str) -> None:
        ...
    def SetMaximumNumberOfIterations(self, value: int) -> None:
        ...
    def SetMotion(self, motion: Motion | str) -> None:
        ...
    def SetTolerance(self, value: float) -> None:
        ...
    def SetTrimmedFraction(self, value: float) -> None:
        ...
    def _GetTransform(self) -> Similarity2DTransform:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetInitialTransform(self, transform: Similarity2DTransform | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class CoherentPointDriftContourRegistrationMethod(ProcessObject):
    """
    Coherent point drift between two contours.
    """
    def GetCurrentLevel(self) -> int:
        """
        0 is the coarsest.
        """
    def GetInitialParameters(self) -> tuple[typing.Any, ...]:
        """
        The start (scale, rad, px, px).
        """
    def GetMaximumNumberOfIterations(self) -> int:
        ...
    def GetMetricValue(self) -> float:
        ...
    def GetMotion(self) -> Motion:
        ...
    def GetOptimizerIteration(self) -> int:
        ...
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        ...
    def GetOutlierWeight(self) -> float:
        ...
    def GetTolerance(self) -> float:
        ...
    def SetMaximumNumberOfIterations(self, value: int) -> None:
        ...
    def SetMotion(self, motion: Motion | str) -> None:
        ...
    def SetOutlierWeight(self, value: float) -> None:
        ...
    def SetTolerance(self, value: float) -> None:
        ...
    def _GetTransform(self) -> Similarity2DTransform:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetInitialTransform(self, transform: Similarity2DTransform | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class IntensityMeasure:
    """
    How two radiographs are compared.

    Members:

      MutualInformation

      NormalizedCorrelation

      GradientCorrelation
    """
    GradientCorrelation: typing.ClassVar[IntensityMeasure]
    MutualInformation: typing.ClassVar[IntensityMeasure]
    NormalizedCorrelation: typing.ClassVar[IntensityMeasure]
    __members__: typing.ClassVar[dict[str, IntensityMeasure]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class IntensityRegistrationMethod(ProcessObject):
    """
    Aligns a DRR with the radiograph by their grey values.
    """
    def GetCurrentLevel(self) -> int:
        """
        0 is the coarsest.
        """
    def GetInitialParameters(self) -> tuple[typing.Any, ...]:
        """
        The start (scale, rad, px, px).
        """
    def GetMargin(self) -> float:
        ...
    def GetMaximumNumberOfIterations(self) -> int:
        ...
    def GetMeasure(self) -> IntensityMeasure:
        ...
    def GetMetricValue(self) -> float:
        ...
    def GetMotion(self) -> Motion:
        ...
    def GetOptimizerIteration(self) -> int:
        ...
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        ...
    def SetMargin(self, value: float) -> None:
        ...
    def SetMaximumNumberOfIterations(self, value: int) -> None:
        ...
    def SetMeasure(self, measure: IntensityMeasure | str) -> None:
        ...
    def SetMotion(self, motion: Motion | str) -> None:
        ...
    def _GetTransform(self) -> Similarity2DTransform:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetFixedImage(self, image: Image | None) -> None:
        ...
    def _SetInitialTransform(self, transform: Similarity2DTransform | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingImage(self, image: Image | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class StateParameter:
    """
    One unknown of a registration.

    Parameters
    ----------
    name : str
    value : float, optional
        Natural units: rad, mm, 1.
    scale : float, optional
        Units of the optimizer in one natural unit, positive: mm a rad for an angle.
    maximumStep : float, optional
        The longest step an optimizer should take, natural units; 0 is any.
    isFree : bool, optional
        Whether an optimizer may move it.
    """
    def __init__(self, name: str, value: float = 0.0, scale: float = 1.0, maximumStep: float = 0.0, isFree: bool = True) -> None:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def isFree(self) -> bool:
        ...
    @property
    def maximumStep(self) -> float:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def scale(self) -> float:
        ...
    @property
    def value(self) -> float:
        ...
class StateBlock:
    """
    Unknowns of a registration that belong together. Metrics that name the same block are about the same unknowns.
    """
    def __init__(self, name: str, parameters: typing.Sequence[StateParameter]) -> None:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def parameters(self) -> list[StateParameter]:
        ...
class PoseStateBlocks:
    """
    The blocks that the metrics of a pose read.
    """
    Arm: typing.ClassVar[float] = 64.0
    @staticmethod
    def MakePose(name: str = 'pose') -> StateBlock:
        """
        pitch, roll, yaw (rad), tx, ty, tz (mm).
        """
    @staticmethod
    def MakeScale(name: str = 'scale') -> StateBlock:
        """
        kappa, the logarithm of the factor on the geometry's magnification.
        """
class RobustKernel:
    """
    How much a residual counts by its size.
    """
    def GetCharge(self, weight: float) -> float:
        """
        For a weight, in units of the squared width.
        """
    def GetName(self) -> str:
        ...
    def GetWeight(self, squaredDistance: float, width: float) -> float:
        """
        Between 1 at distance 0 and 0 far away.
        """
class GemanMcClureKernel(RobustKernel):
    """
    Robust: far residuals hardly count.
    """
    def __init__(self) -> None:
        ...
class SquaresKernel(RobustKernel):
    """
    Least squares: all residuals count alike.
    """
    def __init__(self) -> None:
        ...
class ResidualNoiseModel:
    """
    How the errors of a tracing's points hang together.
    """
    def GetCorrelation(self, arcDistance: float) -> float:
        """
        px of 0.25 mm along the tracing.
        """
    def GetName(self) -> str:
        ...
class CorrelatedNoiseModel(ResidualNoiseModel):
    """
    The hand drifts smoothly along a tracing; length 0 is independent errors.
    """
    def GetCorrelationLength(self) -> float:
        ...
    def SetCorrelationLength(self, value: float) -> None:
        ...
    def __init__(self) -> None:
        ...
class MetricHold:
    """
    What of a metric stays as it is while the parameters move.

    Members:

      Nothing

      Contours

      Matches
    """
    Contours: typing.ClassVar[MetricHold]
    Matches: typing.ClassVar[MetricHold]
    Nothing: typing.ClassVar[MetricHold]
    __members__: typing.ClassVar[dict[str, MetricHold]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class LeastSquaresMetricv4:
    """
    A figure of merit that is, or is majorised by, a sum of squares over named blocks of parameters.

    Values of blocks are in natural units (rad, mm, 1). The parameters of SetParameters(), GetParameters() and
    GetDerivative() are an optimizer's: the free ones alone, each multiplied by its scale.
    """
    def Clone(self) -> LeastSquaresMetricv4:
        """
        A metric of its own with the same inputs and state.
        """
    def EstimateNoise(self, minimumWeight: float = 0.0) -> float:
        """
        Estimates the levels of the noise at the current values and sets them; minus twice the log likelihood.
        """
    def GetBlockValues(self, block: str) -> numpy.typing.NDArray[typing.Any]:
        ...
    def GetBlocks(self) -> list[StateBlock]:
        """
        Blocks, values and what is free; a copy.
        """
    def GetDerivative(self) -> numpy.typing.NDArray[typing.Any]:
        """
        By the optimizer's parameters, with ITK's sign: minus the gradient.
        """
    def GetFreeIndices(self) -> list[int]:
        """
        Places of the free parameters among GetValues().
        """
    def GetName(self) -> str:
        ...
    def GetNoiseLevels(self) -> typing.Any:
        """
        (smooth, white), or None where no term has such noise.
        """
    def GetNumberOfParameters(self) -> int:
        """
        The free ones.
        """
    def GetNumberOfResiduals(self) -> int:
        ...
    def GetParameters(self) -> numpy.typing.NDArray[typing.Any]:
        ...
    def GetResiduals(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N,): divided by their standard deviations.
        """
    def GetResidualsAndJacobian(self) -> tuple[typing.Any, ...]:
        """
        (N,) and (N, M): by the optimizer's parameters, plus sign.
        """
    def GetValue(self) -> float:
        ...
    def GetValueAndDerivative(self) -> tuple[typing.Any, ...]:
        ...
    def GetValues(self) -> numpy.typing.NDArray[typing.Any]:
        """
        Of all blocks, one behind the other.
        """
    def Hold(self, what: MetricHold | str) -> None:
        ...
    def Initialize(self) -> None:
        """
        Checks the inputs and prepares the evaluation; values stay.
        """
    def Modified(self) -> None:
        """
        Says that what the metric computes has changed.
        """
    @typing.overload
    def SetBlockFree(self, block: str, isFree: typing.Sequence[bool]) -> None:
        ...
    @typing.overload
    def SetBlockFree(self, block: str, isFree: bool) -> None:
        """
        Whether an optimizer may move the block's parameters, all alike or one by one.
        """
    def SetBlockValues(self, block: str, values: typing.Sequence[float]) -> None:
        ...
    def SetKernelWidth(self, width: float) -> None:
        """
        Of the robust kernel, px of 0.25 mm.
        """
    def SetNoiseLevels(self, smooth: float, white: float) -> None:
        """
        Standard deviations of the drift along a tracing and of each point, px of 0.25 mm.
        """
    def SetNoiseModel(self, model: ResidualNoiseModel) -> None:
        ...
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        ...
    def SetRobustKernel(self, kernel: RobustKernel) -> None:
        ...
    def SetValues(self, values: typing.Sequence[float]) -> None:
        ...
    def UpdateNoiseCorrelation(self) -> None:
        """
        Takes the correlation of the noise from the current values, where it is held from then on.

        A metric that was not told takes it from the first place that is evaluated: call this between runs of an optimizer.
        """
    def __str__(self) -> str:
        ...
class TracedSide:
    """
    Which side's outline was traced, or is to be; Standard is a cephalometric analysis's own way.

    Members:

      Right

      Left

      Mean

      Both

      Standard
    """
    Both: typing.ClassVar[TracedSide]
    Left: typing.ClassVar[TracedSide]
    Mean: typing.ClassVar[TracedSide]
    Right: typing.ClassVar[TracedSide]
    Standard: typing.ClassVar[TracedSide]
    __members__: typing.ClassVar[dict[str, TracedSide]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class _LeastSquaresMetric(LeastSquaresMetricv4):
    def _Bind(self, object: typing.Any) -> None:
        ...
    def __init__(self) -> None:
        ...
class LeastSquaresSumMetricv4(LeastSquaresMetricv4):
    """
    Sum of metrics over one state: silhouettes, priors, terms of your own.

    Terms that name the same block are about the same unknowns. A term's own values and what is free there are the sum's
    from the moment it is added.
    """
    def AddMetric(self, metric: LeastSquaresMetricv4, keepsSettings: bool = False) -> None:
        """
        keepsSettings: robust kernel and noise stay as the term has them, where else the sum's setters reach them.
        """
    def GetMetric(self, index: int) -> LeastSquaresMetricv4:
        ...
    def GetNumberOfMetrics(self) -> int:
        ...
    def RemoveMetric(self, metric: LeastSquaresMetricv4) -> None:
        ...
    def __init__(self) -> None:
        ...
class ParameterPrior:
    """
    What is known of a parameter beforehand: Gaussian, or Student's t where degreesOfFreedom > 2.
    """
    def __init__(self, mean: float = 0.0, sigma: float = 1.0, degreesOfFreedom: float = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def degreesOfFreedom(self) -> float:
        ...
    @property
    def mean(self) -> float:
        ...
    @property
    def sigma(self) -> float:
        """
        Infinity: nothing is known.
        """
class ParameterPriorMetricv4(LeastSquaresMetricv4):
    """
    What is known of a block's parameters beforehand, as a term.
    """
    def GetBlock(self) -> StateBlock:
        ...
    def GetPriors(self) -> list[ParameterPrior]:
        ...
    def GetUseVariancePrecision(self) -> bool:
        ...
    def SetBlock(self, block: StateBlock) -> None:
        ...
    def SetPriors(self, priors: typing.Sequence[ParameterPrior]) -> None:
        """
        One a parameter of the block.
        """
    def SetUseVariancePrecision(self, value: bool) -> None:
        ...
    def UseVariancePrecisionOff(self) -> None:
        ...
    def UseVariancePrecisionOn(self) -> None:
        ...
    def __init__(self) -> None:
        ...
class PoseMetricv4(LeastSquaresMetricv4):
    """
    Base of the terms whose residuals are those of a scan's pose on a radiograph.
    """
    def GetPoseBlock(self) -> str:
        ...
    def GetScaleBlock(self) -> str:
        ...
    def GetTransform(self) -> CephalometricPoseTransform:
        ...
    def SetPoseBlock(self, name: str) -> None:
        """
        Another body has another one.
        """
    def SetScaleBlock(self, name: str) -> None:
        """
        Another view has another one.
        """
    def SetTransform(self, transform: CephalometricPoseTransform) -> None:
        """
        Its geometry is the radiograph's; its parameters are where pose and scale begin.
        """
class LandmarkPoseMetricv4(PoseMetricv4):
    """
    Landmarks of a scan against landmarks of the radiograph: a term of its pose.
    """
    def ClearCovariances(self) -> None:
        ...
    def GetKernelWidthInSigmas(self) -> float:
        ...
    def GetMatchedNames(self) -> list[str]:
        """
        In the order of the residuals, u and v each.
        """
    def GetSigma(self) -> float:
        ...
    def SetCovariance(self, name: str, covariance: numpy.typing.ArrayLike) -> None:
        """
        Of one mark, square pixels, instead of Sigma.
        """
    def SetKernelWidthInSigmas(self, value: float) -> None:
        ...
    def SetSigma(self, value: float) -> None:
        ...
    def _SetFixedLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetMovingLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def __init__(self) -> None:
        ...
class SilhouettePoseMetricv4(PoseMetricv4):
    """
    A scan's silhouette against a tracing of it: the term of a jaw in a registration of its pose.

    Reads the blocks "pose" and "scale", or as named. The mesh is in its dental frame, as UMidlineDentalAxis() returns it.
    """
    def GateByToothOff(self) -> None:
        ...
    def GateByToothOn(self) -> None:
        ...
    def GetExcludedTeeth(self) -> list[int]:
        ...
    def GetFailure(self) -> str:
        """
        Why the tracing can't be matched; empty where it can.
        """
    def GetFit(self) -> list[typing.Any]:
        """
        How well each strand of the tracing is explained, px of 0.25 mm.
        """
    def GetGapLength(self) -> float:
        ...
    def GetGateByTooth(self) -> bool:
        ...
    def GetJaw(self) -> Jaw:
        ...
    def GetKernelWidth(self) -> float:
        ...
    def GetMaximumTracingPoints(self) -> int:
        ...
    def GetMidlineMargin(self) -> float:
        ...
    def GetOrientationWeight(self) -> float:
        ...
    def GetReverseWeight(self) -> float:
        ...
    def GetTaperLength(self) -> float:
        ...
    def GetToothRange(self) -> int:
        ...
    def GetTracedSide(self) -> TracedSide:
        ...
    def GetUseFacingFilter(self) -> bool:
        ...
    def GetUseOrientation(self) -> bool:
        ...
    def GetUseSideSelection(self) -> bool:
        ...
    def SetExcludedTeeth(self, teeth: typing.Sequence[int]) -> None:
        """
        FDI numbers.
        """
    def SetGapLength(self, value: float) -> None:
        ...
    def SetGateByTooth(self, value: bool) -> None:
        ...
    def SetJaw(self, jaw: Jaw | str) -> None:
        ...
    def SetMaximumTracingPoints(self, value: int) -> None:
        ...
    def SetMidlineMargin(self, value: float) -> None:
        ...
    def SetOrientationWeight(self, value: float) -> None:
        ...
    def SetReverseWeight(self, value: float) -> None:
        ...
    def SetTaperLength(self, value: float) -> None:
        ...
    def SetToothRange(self, value: int) -> None:
        ...
    def SetTracedSide(self, side: TracedSide | str) -> None:
        ...
    def SetUseFacingFilter(self, value: bool) -> None:
        ...
    def SetUseOrientation(self, value: bool) -> None:
        ...
    def SetUseSideSelection(self, value: bool) -> None:
        ...
    def UseFacingFilterOff(self) -> None:
        ...
    def UseFacingFilterOn(self) -> None:
        ...
    def UseOrientationOff(self) -> None:
        ...
    def UseOrientationOn(self) -> None:
        ...
    def UseSideSelectionOff(self) -> None:
        ...
    def UseSideSelectionOn(self) -> None:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingMesh(self, mesh: Mesh | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class StopCondition:
    """
    Why a run of LevenbergMarquardtOptimizerv4 ended.

    Members:

      NotStarted

      Running

      StepTolerance

      ValueTolerance

      MaximumNumberOfIterations

      MaximumNumberOfEvaluations

      StoppedByObserver

      NotFinite

      Exception
    """
    Exception: typing.ClassVar[StopCondition]
    MaximumNumberOfEvaluations: typing.ClassVar[StopCondition]
    MaximumNumberOfIterations: typing.ClassVar[StopCondition]
    NotFinite: typing.ClassVar[StopCondition]
    NotStarted: typing.ClassVar[StopCondition]
    Running: typing.ClassVar[StopCondition]
    StepTolerance: typing.ClassVar[StopCondition]
    StoppedByObserver: typing.ClassVar[StopCondition]
    ValueTolerance: typing.ClassVar[StopCondition]
    __members__: typing.ClassVar[dict[str, StopCondition]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class ObjectToObjectOptimizerBase:
    """
    An optimizer of ITK's v4 framework.
    """
    def GetName(self) -> str:
        ...
    def GetStopConditionDescription(self) -> str:
        ...
    def __str__(self) -> str:
        ...
class LevenbergMarquardtOptimizerv4(ObjectToObjectOptimizerBase):
    """
    Levenberg-Marquardt for metrics that are, or are majorised by, sums of squares.
    """
    def GetCurrentIteration(self) -> int:
        ...
    def GetCurrentMetricValue(self) -> float:
        """
        There.
        """
    def GetCurrentPosition(self) -> numpy.typing.NDArray[typing.Any]:
        """
        The optimizer's parameters: the best so far in commands, the metric's outside of them.
        """
    def GetDamping(self) -> float:
        ...
    def GetInitialDamping(self) -> float:
        ...
    def GetMaximumNumberOfEvaluations(self) -> int:
        ...
    def GetNumberOfEvaluations(self) -> int:
        ...
    def GetNumberOfIterations(self) -> int:
        ...
    def GetStepAccepted(self) -> bool:
        ...
    def GetStepLength(self) -> float:
        """
        In the metric's own unit.
        """
    def GetStepTolerance(self) -> float:
        ...
    def GetStopCondition(self) -> StopCondition:
        ...
    def GetTrialValue(self) -> float:
        """
        Where the last step was tried.
        """
    def GetValueTolerance(self) -> float:
        ...
    def HasConverged(self) -> bool:
        ...
    def SetInitialDamping(self, value: float) -> None:
        ...
    def SetMaximumNumberOfEvaluations(self, value: int) -> None:
        ...
    def SetMetric(self, metric: LeastSquaresMetricv4) -> None:
        ...
    def SetNumberOfIterations(self, value: int) -> None:
        """
        Most steps that are accepted.
        """
    def SetStepTolerance(self, value: float) -> None:
        ...
    def SetValueTolerance(self, value: float) -> None:
        ...
    def StartOptimization(self) -> None:
        """
        Runs from the metric's position and leaves the metric at the best one found.
        """
    def StopOptimization(self) -> None:
        """
        In a command: the run ends before the next evaluation.
        """
    def _AddCommand(self, event: int, key: int) -> int:
        ...
    def _RemoveCommand(self, tag: int) -> None:
        ...
    def __init__(self) -> None:
        ...
class RegistrationEventKind:
    """
    What a record of RegistrationIterationCommand is of.

    Members:

      Start

      Level

      Iteration

      Abort

      End
    """
    Abort: typing.ClassVar[RegistrationEventKind]
    End: typing.ClassVar[RegistrationEventKind]
    Iteration: typing.ClassVar[RegistrationEventKind]
    Level: typing.ClassVar[RegistrationEventKind]
    Start: typing.ClassVar[RegistrationEventKind]
    __members__: typing.ClassVar[dict[str, RegistrationEventKind]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class RegistrationIterationRecord:
    """
    One event of a registration.
    """
    def __repr__(self) -> str:
        ...
    @property
    def accepted(self) -> bool:
        """
        Whether the step was taken.
        """
    @property
    def candidate(self) -> int:
        ...
    @property
    def iteration(self) -> int:
        ...
    @property
    def kind(self) -> RegistrationEventKind:
        ...
    @property
    def level(self) -> int:
        ...
    @property
    def parameters(self) -> numpy.typing.NDArray[typing.Any]:
        ...
    @property
    def stepLength(self) -> float:
        """
        In the method's own unit of length.
        """
    @property
    def stopReason(self) -> str:
        """
        At a level's start that of the level before; at the end.
        """
    @property
    def value(self) -> float:
        """
        Of the metric, at parameters.
        """
class RegistrationIterationCommand:
    """
    Ready observer of any registration: level, candidate, iteration, value, step, parameters, stop reason.

    Records every step, not the mere evaluations, and is cleared at each start, so that one serves many runs.
    """
    def GetRecords(self) -> list[RegistrationIterationRecord]:
        """
        A copy.
        """
    def GetTable(self) -> str:
        """
        All iterations as comma-separated values: level, candidate, iteration, value, step_length, accepted, p0 ...
        """
    def GetWriteEvery(self) -> int:
        ...
    @typing.overload
    def Observe(self, method: ProcessObject) -> None:
        """
        Adds itself to a registration method; which keeps it.
        """
    @typing.overload
    def Observe(self, optimizer: ObjectToObjectOptimizerBase) -> None:
        """
        Adds itself to an optimizer that runs alone.
        """
    def SetStream(self, stream: typing.Any) -> None:
        """
        What has a write(text), as sys.stdout, to write one line an event to; None writes nothing.
        """
    def SetWriteEvery(self, iterations: int) -> None:
        """
        Records all of them.
        """
    def __init__(self) -> None:
        ...
class PoseRegistrationOptions:
    """
    Every ingredient of the robust method; px are units of 0.25 mm in the detector plane, angles are in rad.
    """
    @staticmethod
    def GetEntries() -> list[tuple[str, str]]:
        """
        (name, description) of what SetOption() and the command line's --option take.
        """
    def GetChanges(self) -> list[str]:
        """
        What differs from the defaults, as assignments.
        """
    def GetOption(self, name: str) -> str:
        """
        The value as the command line writes it.
        """
    def SetOption(self, assignment: str) -> None:
        """
        "NAME=VALUE" as on the command line; a value out of range is an error.
        """
    def __copy__(self) -> PoseRegistrationOptions:
        ...
    def __deepcopy__(self, memo: dict[str, typing.Any]) -> PoseRegistrationOptions:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    @property
    def absorbedNoise(self) -> float:
        """
        noise that the nearest point absorbs, for the covariance; 0: none
        """
    @absorbedNoise.setter
    def absorbedNoise(self, arg1: float) -> None:
        ...
    @property
    def absorbedNoiseLimit(self) -> float:
        """
        the most that absorbedNoise multiplies levels by
        """
    @absorbedNoiseLimit.setter
    def absorbedNoiseLimit(self, arg1: float) -> None:
        ...
    @property
    def adaptiveKernelFactor(self) -> float:
        """
        kernel width in standard deviations of the noise
        """
    @adaptiveKernelFactor.setter
    def adaptiveKernelFactor(self, arg1: float) -> None:
        ...
    @property
    def checkHypotheses(self) -> bool:
        """
        try the other side, exchanged jaws, the other facing
        """
    @checkHypotheses.setter
    def checkHypotheses(self, arg1: bool) -> None:
        ...
    @property
    def coarseEvaluations(self) -> int:
        """
        evaluations of a candidate before the choice
        """
    @coarseEvaluations.setter
    def coarseEvaluations(self, arg1: int) -> None:
        ...
    @property
    def coarseKernelWidths(self) -> list[float]:
        """
        kernel widths of the candidates' refinement, px
        """
    @coarseKernelWidths.setter
    def coarseKernelWidths(self, arg1: typing.Sequence[float]) -> None:
        ...
    @property
    def coarseTolerance(self) -> float:
        """
        step below which a candidate ends, px
        """
    @coarseTolerance.setter
    def coarseTolerance(self, arg1: float) -> None:
        ...
    @property
    def codeSigma(self) -> float:
        """
        sd of the codes' places in the last choice, mm
        """
    @codeSigma.setter
    def codeSigma(self, arg1: float) -> None:
        ...
    @property
    def codeWeight(self) -> float:
        """
        weight of the tooth codes' places; 0: off
        """
    @codeWeight.setter
    def codeWeight(self, arg1: float) -> None:
        ...
    @property
    def correlationLength(self) -> float:
        """
        its correlation length, px
        """
    @correlationLength.setter
    def correlationLength(self, arg1: float) -> None:
        ...
    @property
    def covarianceCorrelationLength(self) -> float:
        """
        correlation length for the covariance, px
        """
    @covarianceCorrelationLength.setter
    def covarianceCorrelationLength(self, arg1: float) -> None:
        ...
    @property
    def covarianceInflation(self) -> float:
        """
        factor on the standard deviations
        """
    @covarianceInflation.setter
    def covarianceInflation(self, arg1: float) -> None:
        ...
    @property
    def estimateNoise(self) -> bool:
        """
        estimate the two noise levels
        """
    @estimateNoise.setter
    def estimateNoise(self, arg1: bool) -> None:
        ...
    @property
    def excludedTeeth(self) -> list[int]:
        """
        FDI numbers of teeth to leave out; a copy.
        """
    @excludedTeeth.setter
    def excludedTeeth(self, arg1: typing.Sequence[int]) -> None:
        ...
    @property
    def fineKernelWidth(self) -> float:
        """
        kernel width before the noise is known, px
        """
    @fineKernelWidth.setter
    def fineKernelWidth(self, arg1: float) -> None:
        ...
    @property
    def fineTolerance(self) -> float:
        """
        step below which the refinement ends, px
        """
    @fineTolerance.setter
    def fineTolerance(self, arg1: float) -> None:
        ...
    @property
    def fixRotation(self) -> bool:
        """
        Hold the rotation at its start.
        """
    @fixRotation.setter
    def fixRotation(self, arg0: bool) -> None:
        ...
    @property
    def fixScale(self) -> bool:
        """
        Hold the scale at its start.
        """
    @fixScale.setter
    def fixScale(self, arg0: bool) -> None:
        ...
    @property
    def fixTranslation(self) -> bool:
        """
        Hold the shift at its start.
        """
    @fixTranslation.setter
    def fixTranslation(self, arg0: bool) -> None:
        ...
    @property
    def gapLength(self) -> float:
        """
        gaps of the tracing shorter than this have no ends, px
        """
    @gapLength.setter
    def gapLength(self, arg1: float) -> None:
        ...
    @property
    def gateByTooth(self) -> bool:
        """
        match a tooth's points with it or its neighbours alone
        """
    @gateByTooth.setter
    def gateByTooth(self, arg1: bool) -> None:
        ...
    @property
    def heldPitchSigma(self) -> float:
        """
        of a held pitch, in the covariance, rad
        """
    @heldPitchSigma.setter
    def heldPitchSigma(self, arg1: float) -> None:
        ...
    @property
    def heldTranslationSigma(self) -> float:
        """
        of a held shift, in the covariance, mm
        """
    @heldTranslationSigma.setter
    def heldTranslationSigma(self, arg1: float) -> None:
        ...
    @property
    def initialPose(self) -> list[float]:
        """
        pitch, roll, yaw (rad), tx, ty, tz (mm), kappa of the dental frame; a copy.
        """
    @initialPose.setter
    def initialPose(self, arg0: typing.Sequence[float]) -> None:
        ...
    @property
    def initialSmoothSigma(self) -> float:
        """
        correlated noise at the start, px
        """
    @initialSmoothSigma.setter
    def initialSmoothSigma(self, arg1: float) -> None:
        ...
    @property
    def initialWhiteSigma(self) -> float:
        """
        independent noise at the start, px
        """
    @initialWhiteSigma.setter
    def initialWhiteSigma(self, arg1: float) -> None:
        ...
    @property
    def kappaSigma(self) -> float:
        """
        prior of the log scale; 0: fixed
        """
    @kappaSigma.setter
    def kappaSigma(self, arg1: float) -> None:
        ...
    @property
    def kappaSigmaWithoutSpacing(self) -> float:
        """
        the same where the pixel spacing is unknown
        """
    @kappaSigmaWithoutSpacing.setter
    def kappaSigmaWithoutSpacing(self, arg1: float) -> None:
        ...
    @property
    def maximumEvaluations(self) -> int:
        """
        evaluations of the refinement
        """
    @maximumEvaluations.setter
    def maximumEvaluations(self, arg1: int) -> None:
        ...
    @property
    def maximumPlaces(self) -> int:
        """
        places whose best candidate goes on
        """
    @maximumPlaces.setter
    def maximumPlaces(self, arg1: int) -> None:
        ...
    @property
    def maximumTracingPoints(self) -> int:
        """
        points a jaw above which a tracing is thinned
        """
    @maximumTracingPoints.setter
    def maximumTracingPoints(self, arg1: int) -> None:
        ...
    @property
    def midlineMargin(self) -> float:
        """
        how far beyond the midline plane the cut lies, mm
        """
    @midlineMargin.setter
    def midlineMargin(self, arg1: float) -> None:
        ...
    @property
    def modelSigma(self) -> float:
        """
        error of the outline itself, for the covariance, px
        """
    @modelSigma.setter
    def modelSigma(self, arg1: float) -> None:
        ...
    @property
    def orientationWeight(self) -> float:
        """
        weight of a unit normal, px
        """
    @orientationWeight.setter
    def orientationWeight(self, arg1: float) -> None:
        ...
    @property
    def placeDistance(self) -> float:
        """
        candidates further apart lie in different places, px
        """
    @placeDistance.setter
    def placeDistance(self, arg1: float) -> None:
        ...
    @property
    def poorScore(self) -> float:
        """
        score above which the latter two are tried
        """
    @poorScore.setter
    def poorScore(self, arg1: float) -> None:
        ...
    @property
    def regenerateOutline(self) -> bool:
        """
        make the outline anew as the pose moves
        """
    @regenerateOutline.setter
    def regenerateOutline(self, arg1: bool) -> None:
        ...
    @property
    def reverseWeight(self) -> float:
        """
        weight of the direction from outline to tracing; 0: off
        """
    @reverseWeight.setter
    def reverseWeight(self, arg1: float) -> None:
        ...
    @property
    def rollSigma(self) -> float:
        """
        prior, rad; 0: fixed
        """
    @rollSigma.setter
    def rollSigma(self, arg1: float) -> None:
        ...
    @property
    def rotationPriorFreedom(self) -> float:
        """
        degrees of freedom of roll's and yaw's t prior; up to 2: Gaussian
        """
    @rotationPriorFreedom.setter
    def rotationPriorFreedom(self, arg1: float) -> None:
        ...
    @property
    def scoreMargin(self) -> float:
        """
        candidates further behind the best do not go on
        """
    @scoreMargin.setter
    def scoreMargin(self, arg1: float) -> None:
        ...
    @property
    def secondWayDistance(self) -> float:
        """
        how far a second candidate of the best place must lie, px
        """
    @secondWayDistance.setter
    def secondWayDistance(self, arg1: float) -> None:
        ...
    @property
    def startDistance(self) -> float:
        """
        starts nearer than this are the same, px
        """
    @startDistance.setter
    def startDistance(self, arg1: float) -> None:
        ...
    @property
    def startEvaluations(self) -> int:
        """
        evaluations of a start
        """
    @startEvaluations.setter
    def startEvaluations(self, arg1: int) -> None:
        ...
    @property
    def startKernelWidths(self) -> list[float]:
        """
        kernel widths of the starts' refinement, px
        """
    @startKernelWidths.setter
    def startKernelWidths(self, arg1: typing.Sequence[float]) -> None:
        ...
    @property
    def startTolerance(self) -> float:
        """
        step below which a start ends, px
        """
    @startTolerance.setter
    def startTolerance(self, arg1: float) -> None:
        ...
    @property
    def startsPerYaw(self) -> int:
        """
        candidates kept a yaw
        """
    @startsPerYaw.setter
    def startsPerYaw(self, arg1: int) -> None:
        ...
    @property
    def taperLength(self) -> float:
        """
        over which it fades in from the tracing's ends, px
        """
    @taperLength.setter
    def taperLength(self, arg1: float) -> None:
        ...
    @property
    def toothRange(self) -> int:
        """
        how many positions away a neighbour may be
        """
    @toothRange.setter
    def toothRange(self, arg1: int) -> None:
        ...
    @property
    def tracedSide(self) -> TracedSide:
        """
        Which side's outline was traced.
        """
    @tracedSide.setter
    def tracedSide(self, arg0: TracedSide | str) -> None:
        ...
    @property
    def tySigma(self) -> float:
        """
        prior of the lateral shift, mm; 0: fixed
        """
    @tySigma.setter
    def tySigma(self, arg1: float) -> None:
        ...
    @property
    def unobservedRotationSigma(self) -> float:
        """
        of rotations that are not estimated, in the covariance, rad
        """
    @unobservedRotationSigma.setter
    def unobservedRotationSigma(self, arg1: float) -> None:
        ...
    @property
    def useCorrelatedNoise(self) -> bool:
        """
        noise correlated along the tracing
        """
    @useCorrelatedNoise.setter
    def useCorrelatedNoise(self, arg1: bool) -> None:
        ...
    @property
    def useFacingFilter(self) -> bool:
        """
        keep the occlusal and anterior part of the outline alone
        """
    @useFacingFilter.setter
    def useFacingFilter(self, arg1: bool) -> None:
        ...
    @property
    def useFullPose(self) -> bool:
        """
        six degrees of freedom and scale instead of a similarity
        """
    @useFullPose.setter
    def useFullPose(self, arg1: bool) -> None:
        ...
    @property
    def useInitialPose(self) -> bool:
        """
        Start from initialPose instead of a search.
        """
    @useInitialPose.setter
    def useInitialPose(self, arg0: bool) -> None:
        ...
    @property
    def useJointPose(self) -> bool:
        """
        one pose for jaws in occlusion
        """
    @useJointPose.setter
    def useJointPose(self, arg1: bool) -> None:
        ...
    @property
    def useOrientation(self) -> bool:
        """
        match normals beside positions
        """
    @useOrientation.setter
    def useOrientation(self, arg1: bool) -> None:
        ...
    @property
    def useRobustKernel(self) -> bool:
        """
        Geman-McClure instead of least squares
        """
    @useRobustKernel.setter
    def useRobustKernel(self, arg1: bool) -> None:
        ...
    @property
    def useSideSelection(self) -> bool:
        """
        cut the scan at the midline plane
        """
    @useSideSelection.setter
    def useSideSelection(self, arg1: bool) -> None:
        ...
    @property
    def yawSigma(self) -> float:
        """
        prior, rad; 0: fixed
        """
    @yawSigma.setter
    def yawSigma(self, arg1: float) -> None:
        ...
    @property
    def yawStarts(self) -> list[float]:
        """
        yaw of the global starts, rad
        """
    @yawStarts.setter
    def yawStarts(self, arg1: typing.Sequence[float]) -> None:
        ...
class PoseStage:
    """
    What a pose registration is at.

    Members:

      Start

      Candidates

      Refinement

      Uncertainty
    """
    Candidates: typing.ClassVar[PoseStage]
    Refinement: typing.ClassVar[PoseStage]
    Start: typing.ClassVar[PoseStage]
    Uncertainty: typing.ClassVar[PoseStage]
    __members__: typing.ClassVar[dict[str, PoseStage]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class PoseIteration:
    """
    A tried step of one candidate: what a command of PoseRegistrationMethod asks GetCurrentIteration() for.
    """
    def __repr__(self) -> str:
        ...
    @property
    def accepted(self) -> bool:
        """
        Whether it lowered the value.
        """
    @property
    def candidate(self) -> int:
        """
        Candidates are refined at the same time; their steps may alternate.
        """
    @property
    def damping(self) -> float:
        ...
    @property
    def evaluations(self) -> int:
        """
        Steps tried so far, of this candidate in this stage.
        """
    @property
    def group(self) -> int:
        """
        Jaws with a pose of their own are groups, one after the other.
        """
    @property
    def hypothesis(self) -> bool:
        """
        Whether it is of another reading that is tried beside the result.
        """
    @property
    def iteration(self) -> int:
        """
        Steps accepted so far, of this candidate in this stage.
        """
    @property
    def kernelWidth(self) -> float:
        """
        px of 0.25 mm.
        """
    @property
    def level(self) -> int:
        """
        4 group + stage.
        """
    @property
    def pose(self) -> list[float]:
        """
        Best so far: pitch, roll, yaw (rad), tx, ty, tz (mm), kappa of the dental frame.
        """
    @property
    def position(self) -> numpy.typing.NDArray[typing.Any]:
        ...
    @property
    def smoothNoise(self) -> float:
        """
        Standard deviation of the tracer's drift, px of 0.25 mm.
        """
    @property
    def stage(self) -> PoseStage:
        ...
    @property
    def stepLength(self) -> float:
        """
        Root mean square, px of 0.25 mm.
        """
    @property
    def trialValue(self) -> float:
        """
        Where the step led.
        """
    @property
    def value(self) -> float:
        """
        Of the criterion, at the best position.
        """
    @property
    def whiteNoise(self) -> float:
        """
        Standard deviation of the points' own errors, px of 0.25 mm.
        """
class PoseCandidate:
    """
    One minimum of the criterion.
    """
    def __repr__(self) -> str:
        ...
    @property
    def codeTerm(self) -> float:
        ...
    @property
    def cost(self) -> float:
        ...
    @property
    def deviance(self) -> float:
        """
        What candidates are ranked by: minus twice the logarithm of their posterior weight.
        """
    @property
    def distance(self) -> float:
        """
        Of its contour from the best candidate's, px of 0.25 mm.
        """
    @property
    def parameters(self) -> list[float]:
        """
        pitch, roll, yaw (rad), tx, ty, tz (mm), kappa.
        """
    @property
    def score(self) -> float:
        """
        Cost and code term: what starts are ranked by.
        """
class PoseHypothesisOutcome:
    """
    What came of another reading of the same input.
    """
    def __repr__(self) -> str:
        ...
    @property
    def deviance(self) -> float:
        """
        Minus twice the log likelihood under it minus that of the result: clearly negative where it explains the evidence better. 0 where it was not asked for.
        """
    @property
    def pixelSpacing(self) -> list[float]:
        """
        mm a pixel in the detector plane that its best candidate amounts to; 0 where there is none.
        """
    @property
    def score(self) -> float:
        """
        Of its best candidate; 1 where there is none.
        """
class PoseSolution(DataObject):
    """
    What a pose registration found: poses, covariance, candidates, fit, and why a jaw was not registered.

    Points of a jaw are in the frame of its mesh, mm; pixels are continuous indices of the radiograph. A question about a
    jaw that had no input or was not registered is an error: ask IsRegistered() first.
    """
    def ComputeCovariance(self, jaw: Jaw | str, point: typing.Sequence[float]) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 2) square pixels: of the projection of a point.
        """
    def GetCandidates(self, jaw: Jaw | str) -> list[PoseCandidate]:
        """
        The minima that were refined to the end, best first.
        """
    def GetFailure(self, jaw: Jaw | str) -> str:
        """
        Why the jaw was not registered; empty where it was.
        """
    def GetFit(self, jaw: Jaw | str) -> dict[str, typing.Any]:
        """
        How well the tracing is explained, px of 0.25 mm.
        """
    def GetFrame(self, jaw: Jaw | str) -> numpy.typing.NDArray[typing.Any]:
        """
        (4, 4): mesh frame to the dental frame that the pose is of.
        """
    def GetGeometry(self, jaw: Jaw | str) -> CephalometricGeometry:
        """
        A geometry with the pose of the jaw's mesh; the scale of the fit is in its pixel spacing.
        """
    def GetJawsShareFrame(self) -> bool:
        """
        Whether one pose was fitted to both jaws.
        """
    def GetMargin(self, jaw: Jaw | str) -> float:
        """
        1 minus the odds of the best candidate that lies elsewhere; 1 where there is none.
        """
    def GetMovingContour(self, jaw: Jaw | str) -> Contour:
        """
        What could be matched, at the solution, pixels; open.
        """
    def GetMovingContourPoints(self, jaw: Jaw | str) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 3): the points of the mesh that GetMovingContour() shows.
        """
    def GetNoiseLevels(self, jaw: Jaw | str) -> tuple[float, float]:
        """
        Standard deviations (drift, each point's own), px of 0.25 mm.
        """
    def GetNumberOfEvaluations(self, jaw: Jaw | str) -> int:
        ...
    def GetOptions(self) -> PoseRegistrationOptions:
        """
        What was asked for; a copy.
        """
    def GetOutcomes(self, jaw: Jaw | str) -> dict[str, PoseHypothesisOutcome]:
        """
        {code: PoseHypothesisOutcome} of the hypotheses that were tried beside the result: other-side, and where the fit is poor facing and jaws-exchanged, of landmarks landmarks-exchanged and landmarks-mm.
        """
    def GetPose(self, jaw: Jaw | str) -> list[float]:
        """
        pitch, roll, yaw (rad), tx, ty, tz (mm), kappa of the dental frame.
        """
    def GetPoseCovariance(self, jaw: Jaw | str) -> numpy.typing.NDArray[typing.Any]:
        """
        (7, 7): of GetPose().
        """
    def GetPoseTransform(self, jaw: Jaw | str) -> CephalometricPoseTransform:
        """
        Dental frame to the radiograph.
        """
    def GetPriorTension(self, jaw: Jaw | str) -> list[float]:
        """
        Of GetPose(), standard deviations of the priors; 0 where there is none.
        """
    def GetProjectionMatrix(self, jaw: Jaw | str) -> numpy.typing.NDArray[typing.Any]:
        """
        (3, 4): mesh frame (mm) to homogeneous pixel index.
        """
    def GetScore(self, jaw: Jaw | str) -> float:
        ...
    def GetStatus(self, jaw: Jaw | str) -> str:
        """
        "ok", "suspect" or "failed" by the usual thresholds; RegistrationVerdict() has the reasons.
        """
    def GetStopConditionDescription(self, jaw: Jaw | str) -> str:
        ...
    def GetTransform(self, jaw: Jaw | str) -> VersorRigid3DTransform:
        """
        Mesh frame to cephalostat frame, mm.
        """
    def GetUntried(self, jaw: Jaw | str) -> dict[str, str]:
        """
        {code: why} of the hypotheses that were worth trying and could not be asked.
        """
    def GetViewNames(self) -> list[str]:
        """
        Of the views beside the first.
        """
    def HasConverged(self, jaw: Jaw | str) -> bool:
        ...
    def HasJaw(self, jaw: Jaw | str) -> bool:
        """
        Whether the jaw had a mesh and a contour.
        """
    def IsRegistered(self, jaw: Jaw | str) -> bool:
        ...
    def MakeViewSolution(self, name: str) -> PoseSolution:
        """
        The same solution as another view shows it: everything downstream takes it.
        """
    def ProjectPoint(self, jaw: Jaw | str, point: typing.Sequence[float]) -> tuple[float, float]:
        ...
    def ProjectPoints(self, jaw: Jaw | str, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[typing.Any]:
        """
        All rows of an (N, 3) array: (N, 2).
        """
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    def __str__(self) -> str:
        ...
class PoseHypothesis:
    """
    Another reading of the same input, tried beside the result to name a likely mistake.
    """
    def GetCode(self) -> str:
        """
        Short and stable, as the verdict's codes.
        """
    def GetName(self) -> str:
        ...
class OtherSideHypothesis(PoseHypothesis):
    """
    The other side's outline was traced: its likelihood is compared.
    """
    def __init__(self) -> None:
        ...
class OtherFacingHypothesis(PoseHypothesis):
    """
    The patient faces the other way.
    """
    def __init__(self) -> None:
        ...
class ExchangedJawsHypothesis(PoseHypothesis):
    """
    Upper and lower scan were exchanged.
    """
    def __init__(self) -> None:
        ...
class ExchangedLandmarksHypothesis(PoseHypothesis):
    """
    The landmarks' names are of the other jaw.
    """
    def __init__(self) -> None:
        ...
class MillimetreLandmarksHypothesis(PoseHypothesis):
    """
    The landmarks are in millimetres, not in pixels.
    """
    def __init__(self) -> None:
        ...
class OtherSpacingHypothesis(PoseHypothesis):
    """
    The pixel spacing is another one: the scale is left to the fit.
    """
    def __init__(self) -> None:
        ...
class TurnedDrawingHypothesis(PoseHypothesis):
    """
    The radiograph was turned by quarter turns before or after it was drawn on.
    """
    def GetQuarterTurns(self) -> int:
        ...
    def SetQuarterTurns(self, turns: int) -> None:
        """
        1, 2 or 3, clockwise.
        """
    def __init__(self) -> None:
        ...
class PoseStart:
    """
    Finds poses where a registration may begin.
    """
class PoseStartSearch(PoseStart):
    """
    Exhaustive search over in-plane rotation, shift and scale of the tracing against one contour.
    """
    def GetHorizontalRange(self) -> float:
        ...
    def GetKappas(self) -> list[float]:
        ...
    def GetRotationRange(self) -> float:
        ...
    def GetRotationStep(self) -> float:
        ...
    def GetShiftStep(self) -> float:
        ...
    def GetVerticalRange(self) -> float:
        ...
    def SetHorizontalRange(self, value: float) -> None:
        ...
    def SetKappas(self, kappas: typing.Sequence[float]) -> None:
        """
        Logarithms of the scale factors that are tried where the scale is searched.
        """
    def SetRotationRange(self, value: float) -> None:
        ...
    def SetRotationStep(self, value: float) -> None:
        ...
    def SetShiftStep(self, value: float) -> None:
        ...
    def SetVerticalRange(self, value: float) -> None:
        ...
    def __init__(self) -> None:
        ...
class PoseRegistrationMethod(ProcessObject):
    """
    The robust registration.
    """
    def AddHypothesis(self, hypothesis: PoseHypothesis) -> None:
        ...
    def AddMetric(self, metric: LeastSquaresMetricv4, jaw: Jaw | str = ...) -> None:
        """
        A further term of the sum that is minimized: a LeastSquaresMetric of your own, a prior, another sum.

        It may read the blocks "pose" and "scale", which are those of the dental frame, or have blocks of its own. Jaws that
        stand apart have a sum each: with a jaw it is a term of that jaw's alone. Its robust kernel and noise stay its own. The
        registration works on clones of it.
        """
    def ClearHypotheses(self) -> None:
        ...
    def ClearInitialTransforms(self) -> None:
        """
        Back to a search.
        """
    def ClearMetrics(self) -> None:
        ...
    def ClearSpacingSource(self) -> None:
        """
        Back to the option.
        """
    def ClearViews(self) -> None:
        """
        Back to the lateral radiograph alone.
        """
    def GetCurrentCandidate(self) -> int:
        """
        Of the stage; candidates are refined at the same time and their steps may alternate.
        """
    def GetCurrentIteration(self) -> PoseIteration:
        """
        The step that the last IterationEvent was about; a copy.
        """
    def GetCurrentLevel(self) -> int:
        """
        4 group + stage: 0 starts, 1 candidates, 2 refinement, 3 uncertainty.
        """
    def GetJawsShareFrame(self) -> bool:
        """
        Whether one frame was used for both jaws.
        """
    def GetMetric(self) -> LeastSquaresMetricv4:
        """
        The sum of the group that runs, at the position of the last IterationEvent; None before the first group.
        """
    def GetMetricValue(self) -> float:
        """
        With the kernel width and the noise of GetCurrentIteration(): comparable as long as these stay.
        """
    def GetMetrics(self) -> list[LeastSquaresMetricv4]:
        """
        What was added.
        """
    def GetNumberOfLevels(self) -> int:
        ...
    def GetOptimizer(self) -> ObjectToObjectOptimizerBase:
        ...
    def GetOptimizerIteration(self) -> int:
        """
        Steps that were accepted in this stage, of this candidate.
        """
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        pitch, roll, yaw (rad), tx, ty, tz (mm), kappa.
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        ...
    def GetOptions(self) -> PoseRegistrationOptions:
        """
        A copy.
        """
    def GetPrincipalPointKnown(self) -> bool:
        ...
    def GetStepAccepted(self) -> bool:
        ...
    def GetStepLength(self) -> float:
        """
        Root mean square, px of 0.25 mm.
        """
    def GetTracedSide(self) -> TracedSide:
        ...
    def PrincipalPointKnownOff(self) -> None:
        ...
    def PrincipalPointKnownOn(self) -> None:
        ...
    def SetCovarianceNoiseModel(self, model: ResidualNoiseModel | None) -> None:
        """
        Of the silhouettes in the covariance; None: the options'.
        """
    def SetNoiseModel(self, model: ResidualNoiseModel | None) -> None:
        """
        Of the silhouettes; None: the options'.
        """
    def SetOptimizer(self, optimizer: ObjectToObjectOptimizerBase) -> None:
        """
        A LevenbergMarquardtOptimizerv4, of which candidates take clones, also in other threads.

        Its own tolerances and numbers of iterations are set by the options; its events are sent in the thread that runs
        Execute(), and StopOptimization() in a command of it ends the registration.
        """
    def SetOptimizerAsLBFGS2(self, solutionAccuracy: float = 1e-05, numberOfIterations: int = 100, hessianApproximateAccuracy: int = 6, deltaConvergenceDistance: int = 0, deltaConvergenceTolerance: float = 1e-05, lineSearchMaximumEvaluations: int = 40) -> None:
        ...
    def SetOptimizerAsLBFGSB(self, gradientConvergenceTolerance: float = 1e-05, numberOfIterations: int = 500, maximumNumberOfCorrections: int = 5, maximumNumberOfFunctionEvaluations: int = 2000, costFunctionConvergenceFactor: float = 10000000.0) -> None:
        ...
    def SetOptions(self, options: PoseRegistrationOptions) -> None:
        ...
    def SetPrincipalPointKnown(self, value: bool) -> None:
        ...
    def SetRobustKernel(self, kernel: RobustKernel | None) -> None:
        """
        Of the silhouettes; None: the options'.
        """
    def SetSpacingSource(self, source: SpacingSource | str) -> None:
        """
        Where the pixel spacing comes from: its prior of the scale takes the place of the option kappaSigma.
        """
    def SetStart(self, start: PoseStart) -> None:
        ...
    def SetTracedSide(self, side: TracedSide | str) -> None:
        ...
    def _AddView(self, name: str, geometry: CephalometricGeometry | None, upperContour: Contour | None, lowerContour: Contour | None, landmarks: typing.Any, counterparts: typing.Any, sameHeadPosition: bool, principalPointSigma: float) -> None:
        ...
    def _GetSolution(self) -> PoseSolution:
        ...
    def _SetCephalometricLandmarks(self, landmarks: typing.Any) -> None:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetInitialTransform(self, jaw: Jaw | str, transform: VersorRigid3DTransform | None, scaleFactor: float) -> None:
        ...
    def _SetJointFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetLandmarkCounterparts(self, counterparts: typing.Any) -> None:
        ...
    def _SetLowerContour(self, contour: Contour | None) -> None:
        ...
    def _SetLowerFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetLowerMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetToothCrowns(self, crowns: typing.Any) -> None:
        ...
    def _SetUpperContour(self, contour: Contour | None) -> None:
        ...
    def _SetUpperFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetUpperMesh(self, mesh: Mesh | None) -> None:
        ...
    def _TryHypothesis(self, hypothesis: PoseHypothesis, jaw: Jaw | str) -> PoseHypothesisOutcome:
        ...
    def __init__(self) -> None:
        ...
class RegistrationVerdictThresholds:
    """
    What is suspect and what has failed; px of 0.25 mm and mm.
    """
    failedCost: float
    failedFilmLength: float
    failedInlierShare: float
    failedPitch: float
    failedPredictedSigma: float
    hypothesisGain: float
    landmarkApart: float
    maximumArchWidth: float
    minimumArchWidth: float
    shortestFilm: float
    spacingDifference: float
    spacingScore: float
    suspectCodeOffset: float
    suspectCost: float
    suspectExtrapolatedSigma: float
    suspectFilmLength: float
    suspectInlierShare: float
    suspectLandmarkRatio: float
    suspectLargestMiddleSigma: float
    suspectMargin: float
    suspectMedian: float
    suspectMiddleSigma: float
    suspectOtherSideDeviance: float
    suspectP90: float
    suspectPitch: float
    suspectPredictedSigma: float
    suspectPriorTension: float
    suspectRotationTension: float
    suspectSmoothSigma: float
    suspectWinding: float
    def __init__(self) -> None:
        ...
class RegistrationVerdictFilter(ProcessObject):
    """
    Judges a pose registration.
    """
    def GetImageSize(self) -> tuple[int, int]:
        ...
    def GetNotCheckable(self) -> list[str]:
        """
        What the data could not tell, as sentences.
        """
    def GetThresholds(self) -> RegistrationVerdictThresholds:
        """
        A copy.
        """
    def SetImageSize(self, size: typing.Sequence[int]) -> None:
        """
        (width, height) of the radiograph, pixels: what a spacing that only the fit tells is judged by. (0, 0): unknown.
        """
    def SetThresholds(self, thresholds: RegistrationVerdictThresholds) -> None:
        ...
    def _GetVerdict(self, jaw: Jaw | str) -> typing.Any:
        ...
    def _SetSolution(self, solution: PoseSolution) -> None:
        ...
    def __init__(self) -> None:
        ...
class LandmarkProjectionFilter(ProcessObject):
    """
    Landmarks of the scans as a registration places them, with uncertainty.
    """
    def GetCovariance(self, name: str) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 2) square pixels.
        """
    def GetMiddleCovariance(self, name: str) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 2) square pixels: of the middle between a right landmark and its left one.
        """
    def GetMiddles(self) -> dict[str, typing.Any]:
        """
        {"U6_MB": ((u, v), (2, 2) square pixels)} between each right landmark's image and its left one's.
        """
    def GetMillimetresPerUnit(self) -> float:
        ...
    def GetSigma(self, name: str) -> float:
        """
        Standard deviation an axis, pixels.
        """
    def HasMiddleCovariance(self, name: str) -> bool:
        ...
    def SetMillimetresPerUnit(self, value: float) -> None:
        ...
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def _SetLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetSolution(self, solution: PoseSolution) -> None:
        ...
    def __init__(self) -> None:
        ...
class ScanCheckFilter(ProcessObject):
    """
    What can be said of the scans before anything is registered.
    """
    def GetMillimetresPerUnit(self) -> float:
        ...
    def GetNotCheckable(self) -> list[str]:
        """
        What the data could not tell, as sentences.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        ...
    def _GetFindings(self, jaw: Jaw | str) -> list[typing.Any]:
        ...
    def _SetFrames(self, frames: DentalFrames) -> None:
        ...
    def _SetLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetLowerMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetUpperMesh(self, mesh: Mesh | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class LandmarkCounterpartFilter(ProcessObject):
    """
    Where the landmarks of a cephalometric analysis are on the scans.
    """
    def GetIgnoreSides(self) -> bool:
        ...
    def GetLabels(self, jaw: Jaw | str) -> list[int]:
        ...
    def GetMillimetresPerUnit(self) -> float:
        ...
    def GetUnused(self) -> list[tuple[str, str]]:
        ...
    def IgnoreSidesOff(self) -> None:
        ...
    def IgnoreSidesOn(self) -> None:
        ...
    def SetExcludedTeeth(self, teeth: typing.Sequence[str]) -> None:
        """
        Codes of teeth that are left out: ["UR3"].
        """
    def SetIgnoreSides(self, value: bool) -> None:
        ...
    def SetLabels(self, jaw: Jaw | str, labels: typing.Sequence[int]) -> None:
        """
        FDI number by point of the jaw's mesh, 0 gingiva; empty: none.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        ...
    def _GetCounterparts(self) -> dict[str, typing.Any]:
        ...
    def _SetCephalometricLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetLowerFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetLowerMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetScanLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetUpperFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetUpperMesh(self, mesh: Mesh | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class ToothCrownFilter(ProcessObject):
    """
    Cuts the crowns of the teeth that an analysis has outlined out of the scans.
    """
    def GetLabels(self, jaw: Jaw | str) -> list[int]:
        ...
    def GetMillimetresPerUnit(self) -> float:
        ...
    def GetMissing(self) -> list[str]:
        """
        Names of teeth of the tracings whose crowns were not found.
        """
    def SetExcludedTeeth(self, teeth: typing.Sequence[str]) -> None:
        """
        Codes of teeth that are left out: ["UR3"].
        """
    def SetLabels(self, jaw: Jaw | str, labels: typing.Sequence[int]) -> None:
        """
        FDI number by point of the jaw's mesh, 0 gingiva; empty: none.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        ...
    def _GetCrowns(self) -> dict[str, typing.Any]:
        ...
    def _SetLowerContour(self, contour: Contour | None) -> None:
        ...
    def _SetLowerFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetLowerMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetScanLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetUpperContour(self, contour: Contour | None) -> None:
        ...
    def _SetUpperFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetUpperMesh(self, mesh: Mesh | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class MatchedContourFilter(ProcessObject):
    """
    The part of a moving contour that has a tracing beside it.
    """
    def GetMaximumDistance(self) -> float:
        ...
    def GetMaximumGap(self) -> float:
        ...
    def SetMaximumDistance(self, value: float) -> None:
        ...
    def SetMaximumGap(self, value: float) -> None:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def _TakeOutput(self) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class ProjectionSimilarityFilter(ProcessObject):
    """
    The 2-D similarity that comes nearest to a registered pose.
    """
    def GetJaw(self) -> Jaw:
        ...
    def GetRMS(self) -> float:
        """
        What the similarity leaves, pixels.
        """
    def SetJaw(self, jaw: Jaw | str) -> None:
        ...
    def _GetTransform(self) -> Similarity2DTransform | None:
        ...
    def _SetFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetSolution(self, solution: PoseSolution) -> None:
        ...
    def __init__(self) -> None:
        ...
class GeometryPlacementFilter(ProcessObject):
    """
    A radiograph's geometry with an object in it.
    """
    def CentralRayThroughOriginOff(self) -> None:
        ...
    def CentralRayThroughOriginOn(self) -> None:
        ...
    def GetCentralRayThroughOrigin(self) -> bool:
        ...
    def SetCentralRayThroughOrigin(self, value: bool) -> None:
        ...
    def _SetFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _TakeOutput(self) -> CephalometricGeometry:
        ...
    def __init__(self) -> None:
        ...
class SurfaceSplatWidthCalculator(ProcessObject):
    """
    The width of a DRR's splats that closes a surface.
    """
    def GetSigma(self) -> float:
        """
        mm in the detector plane.
        """
    def GetWidthFactor(self) -> float:
        ...
    def SetWidthFactor(self, value: float) -> None:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetMesh(self, mesh: Mesh | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class TracingPixelSpacingFilter(ProcessObject):
    """
    A geometry with a rough pixel spacing where none is known.
    """
    def GetDefaultPixelSpacing(self) -> float:
        ...
    def SetDefaultPixelSpacing(self, value: float) -> None:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetJaw(self, jaw: Jaw | str, mesh: Mesh | None, contour: Contour | None, frame: VersorRigid3DTransform | None) -> None:
        ...
    def _TakeOutput(self) -> CephalometricGeometry:
        ...
    def __init__(self) -> None:
        ...
class SimilarityPlacementFilter(ProcessObject):
    """
    Where a similarity puts the scan.
    """
    def GetMillimetresPerUnit(self) -> float:
        ...
    def GetProjectionMatrix(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (3, 4): mesh, in the unit of its file, to homogeneous pixel index.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        ...
    def _GetTransform(self) -> VersorRigid3DTransform | None:
        ...
    def _SetFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetSimilarity(self, transform: Similarity2DTransform | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class ContourTransformFilter(ProcessObject):
    """
    A contour that a similarity has moved.
    """
    def _SetInput(self, contour: Contour | None) -> None:
        ...
    def _SetTransform(self, transform: Similarity2DTransform | None) -> None:
        ...
    def _TakeOutput(self) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class LandmarkMatrixProjectionFilter(ProcessObject):
    """
    Landmarks by a projection matrix alone.
    """
    def GetJaw(self) -> Jaw:
        ...
    def SetJaw(self, jaw: Jaw | str) -> None:
        ...
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def _SetLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetProjectionMatrix(self, matrix: numpy.typing.ArrayLike) -> None:
        ...
    def __init__(self) -> None:
        ...
class LandmarkErrorFilter(ProcessObject):
    """
    Distances between predicted and marked landmarks.
    """
    def BisectSidesOff(self) -> None:
        ...
    def BisectSidesOn(self) -> None:
        ...
    def GetBisectSides(self) -> bool:
        ...
    def GetJaw(self) -> Jaw:
        ...
    def GetPixelSpacing(self) -> tuple[float, float]:
        ...
    def GetUnpairedLandmarks(self) -> list[str]:
        """
        Names whose partner is missing.
        """
    def SetBisectSides(self, value: bool) -> None:
        ...
    def SetJaw(self, jaw: Jaw | str) -> None:
        """
        Unknown, the default, is both.
        """
    def SetPixelSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        mm (u, v); 0 is unknown.
        """
    def _GetErrors(self) -> dict[str, typing.Any]:
        ...
    def _GetStatistics(self) -> dict[str, typing.Any]:
        ...
    def _SetPredictedLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetReferenceLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def __init__(self) -> None:
        ...
class RegistrationOverlayFilter(ProcessObject):
    """
    The picture by which a person judges a registration.
    """
    def GetLandmarkSigmas(self) -> dict[str, float]:
        ...
    def GetMargin(self) -> float:
        ...
    def GetPictureSize(self) -> tuple[int, int]:
        ...
    def GetPixelSpacing(self) -> tuple[float, float]:
        ...
    def GetStatus(self) -> str:
        ...
    def GetTextLines(self) -> list[str]:
        ...
    def GetTitle(self) -> str:
        ...
    def SetLandmarkSigmas(self, sigmas: typing.Mapping[str, float]) -> None:
        """
        px by name.
        """
    def SetMargin(self, value: float) -> None:
        ...
    def SetPictureSize(self, width: int, height: int) -> None:
        ...
    def SetPixelSpacing(self, spacing: typing.Sequence[float]) -> None:
        ...
    def SetRadiographSize(self, width: int, height: int) -> None:
        ...
    def SetStatus(self, status: str) -> None:
        ...
    def SetTextLines(self, lines: typing.Sequence[str]) -> None:
        ...
    def SetTitle(self, title: str) -> None:
        ...
    def SetView(self, firstU: float, lastU: float, firstV: float, lastV: float) -> None:
        """
        First and last pixel index of u, then of v.
        """
    def SetViewToContours(self) -> None:
        ...
    def SetWindow(self, black: float, white: float) -> None:
        ...
    def _GetNumberOfMovingContours(self) -> int:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingContour(self, number: int, contour: Contour | None, label: str) -> None:
        ...
    def _SetPredictedLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetRadiograph(self, image: Image | None) -> None:
        ...
    def _SetReferenceLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _TakeOutput(self) -> Picture:
        ...
    def __init__(self) -> None:
        ...
class PhantomCohort:
    """
    How well a simulated case is taken and traced.

    Members:

      Ideal

      Typical

      Hard
    """
    Hard: typing.ClassVar[PhantomCohort]
    Ideal: typing.ClassVar[PhantomCohort]
    Typical: typing.ClassVar[PhantomCohort]
    __members__: typing.ClassVar[dict[str, PhantomCohort]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class PhantomFrame:
    """
    The frame of a phantom's meshes.

    Members:

      Anatomical

      SharedScanner

      SeparateScanner
    """
    Anatomical: typing.ClassVar[PhantomFrame]
    SeparateScanner: typing.ClassVar[PhantomFrame]
    SharedScanner: typing.ClassVar[PhantomFrame]
    __members__: typing.ClassVar[dict[str, PhantomFrame]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class PhantomArchFamily:
    """
    The shape of a phantom's arches.

    Members:

      Tapered

      Ovoid

      Square
    """
    Ovoid: typing.ClassVar[PhantomArchFamily]
    Square: typing.ClassVar[PhantomArchFamily]
    Tapered: typing.ClassVar[PhantomArchFamily]
    __members__: typing.ClassVar[dict[str, PhantomArchFamily]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class DentalPhantomParameters:
    """
    What shapes a pair of phantom jaws; mm and radians.
    """
    archCoverage: float
    archExponent: float
    archFamily: PhantomArchFamily
    archHalfWidth: float
    baseHeight: float
    frame: PhantomFrame
    frameSeed: int
    noiseSeed: int
    numberOfTriangles: int
    overbite: float
    overjet: float
    scannerNoise: float
    speeDepth: float
    stoneBase: bool
    wilson: float
    @staticmethod
    def Draw(seed: int) -> DentalPhantomParameters:
        """
        One of a kind.
        """
    def GetMissingTeeth(self) -> list[int]:
        ...
    def SetMissingTeeth(self, teeth: typing.Sequence[int]) -> None:
        """
        FDI numbers: 11-17, 21-27, 31-37, 41-47. All others are there.
        """
    def Validate(self) -> None:
        """
        Raises where no jaws can be made of it.
        """
    def __init__(self) -> None:
        ...
    def __repr__(self) -> str:
        ...
class DentalPhantomMeshSource(ProcessObject):
    """
    A pair of parametric arches in occlusion.
    """
    def DrawParameters(self, seed: int) -> None:
        ...
    def GetParameters(self) -> DentalPhantomParameters:
        """
        A copy.
        """
    def SetParameters(self, parameters: DentalPhantomParameters) -> None:
        ...
    def _GetLandmarks(self, arg0: Jaw | str) -> dict[str, typing.Any]:
        ...
    def _TakeMesh(self, arg0: Jaw | str) -> Mesh:
        ...
    def __init__(self) -> None:
        ...
class DentalPhantomCaseSource(ProcessObject):
    """
    A simulated case for a seed, with the truth.
    """
    def BuccalOutlineOff(self) -> None:
        ...
    def BuccalOutlineOn(self) -> None:
        ...
    def GetAdditionalRoll(self) -> float:
        ...
    def GetAdditionalYaw(self) -> float:
        ...
    def GetBuccalOutline(self) -> bool:
        ...
    def GetCohort(self) -> PhantomCohort:
        ...
    def GetDropOutFraction(self) -> float:
        ...
    def GetFacing(self) -> CephalometricGeometry.Facing:
        ...
    def GetFrame(self) -> PhantomFrame:
        ...
    def GetImageSize(self) -> tuple[int, int]:
        ...
    def GetLowerNumberOfPoints(self) -> int:
        ...
    def GetMakeRadiograph(self) -> bool:
        ...
    def GetMissingTeeth(self) -> list[int]:
        ...
    def GetNumberOfTriangles(self) -> int:
        ...
    def GetParameters(self) -> DentalPhantomParameters:
        """
        What was drawn; a copy.
        """
    def GetSeed(self) -> int:
        ...
    def GetSourceSide(self) -> CephalometricGeometry.SourceSide:
        ...
    def GetStoneBase(self) -> bool:
        ...
    def GetToothBias(self) -> float:
        ...
    def GetTracedSide(self) -> TracedSide:
        ...
    def GetUpperNumberOfPoints(self) -> int:
        ...
    def MakeRadiographOff(self) -> None:
        ...
    def MakeRadiographOn(self) -> None:
        ...
    def SetAdditionalRoll(self, value: float) -> None:
        ...
    def SetAdditionalYaw(self, value: float) -> None:
        ...
    def SetBuccalOutline(self, value: bool) -> None:
        ...
    def SetCohort(self, cohort: PhantomCohort | str) -> None:
        ...
    def SetDropOutFraction(self, value: float) -> None:
        ...
    def SetFacing(self, facing: CephalometricGeometry.Facing | str) -> None:
        ...
    def SetFrame(self, frame: PhantomFrame | str) -> None:
        ...
    def SetImageSize(self, size: typing.Sequence[int]) -> None:
        ...
    def SetLowerNumberOfPoints(self, value: int) -> None:
        ...
    def SetMakeRadiograph(self, value: bool) -> None:
        ...
    def SetMissingTeeth(self, value: typing.Sequence[int]) -> None:
        ...
    def SetNumberOfTriangles(self, value: int) -> None:
        ...
    def SetSeed(self, value: int) -> None:
        ...
    def SetSourceSide(self, side: CephalometricGeometry.SourceSide | str) -> None:
        ...
    def SetStoneBase(self, value: bool) -> None:
        ...
    def SetToothBias(self, value: float) -> None:
        ...
    def SetTracedSide(self, side: TracedSide | str) -> None:
        ...
    def SetUpperNumberOfPoints(self, value: int) -> None:
        ...
    def StoneBaseOff(self) -> None:
        ...
    def StoneBaseOn(self) -> None:
        ...
    def _GetLandmarks2D(self, arg0: Jaw | str) -> dict[str, typing.Any]:
        ...
    def _GetLandmarks3D(self, arg0: Jaw | str) -> dict[str, typing.Any]:
        ...
    def _GetNominalGeometry(self) -> CephalometricGeometry:
        ...
    def _GetRadiograph(self) -> Image | None:
        ...
    def _GetTrueGeometry(self, arg0: Jaw | str) -> CephalometricGeometry:
        ...
    def _TakeMesh(self, arg0: Jaw | str) -> Mesh:
        ...
    def _TakeTracing(self, arg0: Jaw | str) -> Contour:
        ...
    def _TakeTrueTracing(self, arg0: Jaw | str) -> Contour:
        ...
    def _Write(self, folder: str, meshExtension: str) -> None:
        ...
    def __init__(self) -> None:
        ...
class ExperimentStudy:
    """
    What an experiment asks.

    Members:

      Tables

      Capture

      Sensitivity

      Ablation

      Coverage

      Verdict

      Practice
    """
    Ablation: typing.ClassVar[ExperimentStudy]
    Capture: typing.ClassVar[ExperimentStudy]
    Coverage: typing.ClassVar[ExperimentStudy]
    Practice: typing.ClassVar[ExperimentStudy]
    Sensitivity: typing.ClassVar[ExperimentStudy]
    Tables: typing.ClassVar[ExperimentStudy]
    Verdict: typing.ClassVar[ExperimentStudy]
    __members__: typing.ClassVar[dict[str, ExperimentStudy]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class CohortExperiment(ProcessObject):
    """
    Methods on a cohort: tables, statistics, plot data.
    """
    def DrawFiguresOff(self) -> None:
        ...
    def DrawFiguresOn(self) -> None:
        ...
    def GetCaseDirectory(self) -> str:
        ...
    def GetCurrentStage(self) -> str:
        ...
    def GetDrawFigures(self) -> bool:
        ...
    def GetLevel(self) -> PhantomCohort:
        ...
    def GetMethods(self) -> list[str]:
        ...
    def GetNumberOfCases(self) -> int:
        ...
    def GetNumberOfResumedCases(self) -> int:
        ...
    def GetNumberOfStarts(self) -> int:
        ...
    def GetOutputDirectory(self) -> str:
        ...
    def GetSeed(self) -> int:
        ...
    def GetStudy(self) -> ExperimentStudy:
        ...
    def GetWrittenFiles(self) -> list[str]:
        """
        Names in the output folder, after Execute().
        """
    def SetCaseDirectory(self, folder: str) -> None:
        ...
    def SetDrawFigures(self, value: bool) -> None:
        ...
    def SetLevel(self, level: PhantomCohort | str) -> None:
        ...
    def SetMethods(self, names: typing.Sequence[str]) -> None:
        ...
    def SetNumberOfCases(self, value: int) -> None:
        ...
    def SetNumberOfStarts(self, value: int) -> None:
        ...
    def SetOutputDirectory(self, folder: str) -> None:
        ...
    def SetSeed(self, value: int) -> None:
        ...
    def SetStudy(self, study: ExperimentStudy | str) -> None:
        ...
    def __init__(self) -> None:
        ...
class Preset:
    """
    How a case is registered.

    Members:

      Robust

      Paper

      BoundingBox

      SingleStage
    """
    BoundingBox: typing.ClassVar[Preset]
    Paper: typing.ClassVar[Preset]
    Robust: typing.ClassVar[Preset]
    SingleStage: typing.ClassVar[Preset]
    __members__: typing.ClassVar[dict[str, Preset]]
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    @typing.overload
    def __init__(self, value: int) -> None:
        ...
    @typing.overload
    def __init__(self, name: str) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: int) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class _Case:
    @staticmethod
    def _Read(fileName: str, exclude: typing.Sequence[str], fix: typing.Sequence[str], init: str) -> _Case:
        ...
    def _AddView(self, name: str, geometry: CephalometricGeometry | None, upperContour: Contour | None, lowerContour: Contour | None, cephalometricLandmarks: typing.Any, image: Image | None, imageSize: typing.Sequence[int], sameHeadPosition: bool, principalPointSigma: float) -> None:
        ...
    def _GetCephalometricLandmarks(self) -> dict[str, typing.Any]:
        ...
    def _GetContour(self, jaw: Jaw | str) -> Contour | None:
        ...
    def _GetFileName(self) -> str:
        ...
    def _GetGeometry(self) -> CephalometricGeometry:
        ...
    def _GetImage(self) -> Image | None:
        ...
    def _GetImageSize(self) -> tuple[int, int]:
        ...
    def _GetLandmarks3D(self) -> dict[str, typing.Any]:
        ...
    def _GetMesh(self, jaw: Jaw | str) -> Mesh | None:
        ...
    def _GetTracedSide(self) -> str:
        ...
    def _GetWarnings(self) -> list[str]:
        ...
    def _HasPrincipalPoint(self) -> bool:
        ...
    def __init__(self, upper: Mesh | None, lower: Mesh | None, upperContour: Contour | None, lowerContour: Contour | None, geometry: CephalometricGeometry | None, image: Image | None, imageSize: typing.Sequence[int], principalPointKnown: bool, tracedSide: str | None, occlusion: str, cephalometricLandmarks: typing.Any, landmarks3D: typing.Any, landmarks2D: typing.Any, exclude: typing.Sequence[str], fix: typing.Sequence[str]) -> None:
        ...
class _CaseResult:
    def _GetGeometry(self) -> CephalometricGeometry:
        ...
    def _GetJaw(self, arg0: str) -> dict[str, typing.Any]:
        ...
    def _GetJaws(self) -> list[str]:
        ...
    def _GetOverlay(self, jaw: str) -> Picture:
        ...
    def _GetScene(self) -> dict[str, typing.Any]:
        ...
    def _ToJson(self) -> str:
        ...
    def _Write(self, folder: str, report: bool, page: bool, anonymous: bool) -> None:
        ...
class CaseRegistration(ProcessObject):
    """
    A case through the whole chain; see register().
    """
    def GetCurrentStage(self) -> str:
        ...
    def GetNumberOfLowerContourPoints(self) -> int:
        ...
    def GetNumberOfUpperContourPoints(self) -> int:
        ...
    def GetPoseOptions(self) -> PoseRegistrationOptions:
        """
        A copy.
        """
    def GetPreset(self) -> Preset:
        ...
    def GetRefineMidline(self) -> bool:
        ...
    def GetUseSurfaceDRR(self) -> bool:
        ...
    def RefineMidlineOff(self) -> None:
        ...
    def RefineMidlineOn(self) -> None:
        ...
    def SetNumberOfLowerContourPoints(self, value: int) -> None:
        ...
    def SetNumberOfUpperContourPoints(self, value: int) -> None:
        ...
    def SetOption(self, assignment: str) -> None:
        """
        One ingredient of preset Robust, "NAME=VALUE" (Documentation/Robust.md).
        """
    def SetPoseOptions(self, options: PoseRegistrationOptions) -> None:
        """
        Ingredients of preset Robust.
        """
    def SetPreset(self, preset: Preset | str) -> None:
        ...
    def SetRefineMidline(self, value: bool) -> None:
        ...
    def SetUseSurfaceDRR(self, value: bool) -> None:
        ...
    def UseSurfaceDRROff(self) -> None:
        ...
    def UseSurfaceDRROn(self) -> None:
        ...
    def _SetData(self, case: _Case) -> None:
        ...
    def _TakeResult(self, case: _Case) -> _CaseResult:
        ...
    def __init__(self) -> None:
        ...
class DentalCaseReader(ProcessObject):
    """
    Reads a case; see ReadCase().
    """
    def GetFileName(self) -> str:
        ...
    def SetFileName(self, fileName: str) -> None:
        ...
    def _TakeOutput(self) -> _Case:
        ...
    def __init__(self) -> None:
        ...
class CaseLandmarkErrorFilter(ProcessObject):
    """
    Measures a result against the landmarks that its case has marked.
    """
    def _SetInput(self, result: _CaseResult) -> None:
        ...
    def _TakeOutput(self) -> _CaseResult:
        ...
    def __init__(self) -> None:
        ...
class CaseResultFolderWriter(ProcessObject):
    """
    Writes a result into a folder; see WriteCaseResult().
    """
    def AnonymousOff(self) -> None:
        ...
    def AnonymousOn(self) -> None:
        ...
    def GetAnonymous(self) -> bool:
        ...
    def GetFolderName(self) -> str:
        ...
    def GetWritePage(self) -> bool:
        ...
    def GetWriteReport(self) -> bool:
        ...
    def SetAnonymous(self, value: bool) -> None:
        ...
    def SetFolderName(self, folderName: str) -> None:
        ...
    def SetWritePage(self, value: bool) -> None:
        ...
    def SetWriteReport(self, value: bool) -> None:
        ...
    def WritePageOff(self) -> None:
        ...
    def WritePageOn(self) -> None:
        ...
    def WriteReportOff(self) -> None:
        ...
    def WriteReportOn(self) -> None:
        ...
    def _SetInput(self, result: _CaseResult) -> None:
        ...
    def __init__(self) -> None:
        ...
def ReadTransform(fileName: str) -> Transform:
    ...
def WriteTransform(transform: Transform, fileName: str) -> None:
    ...
def _FindBatchCases(input: str) -> list[tuple[str, str]]:
    """
    Names and files of the cases of a folder, a table of case files, a case file or a pattern.
    """
def _Main(arguments: typing.Sequence[str]) -> int:
    ...
def _ReadMesh(fileName: str) -> Mesh:
    ...
def _WriteMesh(mesh: Mesh, fileName: str) -> None:
    ...
def _WriteReportPage(result: str, fileName: str, imageFile: str, anonymous: bool) -> list[str]:
    ...
def experiment_methods() -> list[tuple[str, str]]:
    """
    Name and title of every method that an experiment compares.
    """
def tooth_fdi(code: typing.Any) -> int:
    """
    11 from "UR1", "11" or 11.
    """
def tooth_name(code: typing.Any) -> str:
    """
    "UR1" from "UR1", "11" or 11.
    """
ITK_VERSION: str = '5.2.1'
__version__: str = '0.1.0'
