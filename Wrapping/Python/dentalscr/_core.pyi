"""
The compiled part of dentalscr.
"""
from __future__ import annotations
import numpy
import numpy.typing
import typing
__all__: list[str] = ['AnnotationFileFormat', 'AnnotationPixelOrigin', 'CaseLandmarkErrorFilter', 'CaseRegistration', 'CaseResultFolderWriter', 'CephalogramFileReader', 'CephalometricGeometry', 'CephalometricLandmarkFileReader', 'CephalometricPoseTransform', 'CoherentPointDriftContourRegistrationMethod', 'CohortExperiment', 'Contour', 'ContourChamferMetricv4', 'ContourDirection', 'ContourDistanceFilter', 'ContourMaskFilter', 'ContourOverlapFilter', 'ContourPointDistance', 'ContourResampleFilter', 'ContourToContourMetricv4', 'ContourTransformFilter', 'CorrelatedNoiseModel', 'CrownRegionMeshFilter', 'DataObject', 'DentalCaseReader', 'DentalContourFileReader', 'DentalContourFileWriter', 'DentalFrames', 'DentalLandmarkFileReader2D', 'DentalLandmarkFileReader3D', 'DentalLandmarkFileWriter2D', 'DentalLandmarkFileWriter3D', 'DentalPhantomCaseSource', 'DentalPhantomMeshSource', 'DentalPhantomParameters', 'ExchangedJawsHypothesis', 'ExchangedLandmarksHypothesis', 'ExperimentStudy', 'GemanMcClureKernel', 'GeometryPlacementFilter', 'ITK_VERSION', 'Image', 'IntensityMeasure', 'IntensityRegistrationMethod', 'IterativeClosestPointContourRegistrationMethod', 'Jaw', 'JawsShareFrame', 'LandmarkCounterpartFilter', 'LandmarkErrorFilter', 'LandmarkMatrixProjectionFilter', 'LandmarkPoseMetricv4', 'LandmarkProjectionFilter', 'LeastSquaresMetricv4', 'LeastSquaresSumMetricv4', 'LevenbergMarquardtOptimizerv4', 'MatchedContourFilter', 'Mesh', 'MeshSilhouetteContourSource', 'MetricHold', 'MetricJoins', 'MidlineSideMeshFilter', 'MidsagittalPlaneFilter', 'MillimetreLandmarksHypothesis', 'Motion', 'Numbering', 'ObjectToObjectOptimizerBase', 'OpenSilhouetteContourSource', 'OtherFacingHypothesis', 'OtherSideHypothesis', 'OtherSpacingHypothesis', 'ParameterPrior', 'ParameterPriorMetricv4', 'PhantomArchFamily', 'PhantomCohort', 'PhantomFrame', 'Picture', 'PictureCheckFilter', 'PixelSpacingVerdict', 'Polyline', 'PoseCandidate', 'PoseHypothesis', 'PoseHypothesisOutcome', 'PoseIteration', 'PoseMetricv4', 'PoseRegistrationMethod', 'PoseRegistrationOptions', 'PoseSolution', 'PoseStage', 'PoseStart', 'PoseStartSearch', 'PoseStateBlocks', 'Preset', 'ProcessObject', 'ProjectionSimilarityFilter', 'ReadTransform', 'RegistrationEventKind', 'RegistrationIterationCommand', 'RegistrationIterationRecord', 'RegistrationLevel', 'RegistrationLevelResult', 'RegistrationOverlayFilter', 'RegistrationVerdictFilter', 'RegistrationVerdictThresholds', 'ResidualNoiseModel', 'RobustKernel', 'ScanCheckFilter', 'Side', 'SilhouetteContent', 'SilhouetteContourFilter', 'SilhouetteCoordinates', 'SilhouetteLevel', 'SilhouettePoseMetricv4', 'SilhouetteToContourRegistrationMethod', 'Similarity2DTransform', 'SimilarityPlacementFilter', 'SpacingPlane', 'SpacingSource', 'SquaresKernel', 'StateBlock', 'StateParameter', 'StopCondition', 'SurfaceDRRImageSource', 'SurfaceDRRNormalization', 'SurfaceDRROutput', 'SurfaceSplatWidthCalculator', 'ToothCrownFilter', 'ToothLabelFileReader', 'ToothOutlineErrors', 'ToothOutlinePoseMetricv4', 'TracedSide', 'TracedSideFilter', 'TracingPixelSpacingFilter', 'Transform', 'TurnedDrawingHypothesis', 'UMidlineDentalAxisFilter', 'UpwardDrawingHypothesis', 'VersorRigid3DTransform', 'ViewPoseMetricv4', 'ViewVerdictThresholds', 'WriteTransform', 'experiment_methods', 'tooth_fdi', 'tooth_name']
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
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
        """
        How many vertices the mesh has.
        """
    def GetNumberOfTriangles(self) -> int:
        """
        How many triangles the mesh has.
        """
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, points: numpy.typing.ArrayLike, triangles: typing.Any, labels: typing.Any = None) -> None:
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
    def labels(self, arg1: typing.Any) -> None:
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
        """
        Number of axes, which is 2.
        """
    def GetDirection(self) -> tuple[typing.Any, ...]:
        """
        Directions of the axes as a row-major tuple of 4; the identity for radiographs.
        """
    def GetHeight(self) -> int:
        """
        Number of rows.
        """
    def GetIndex(self) -> tuple[int, int]:
        """
        First pixel of the image's region, (u, v). A simulated radiograph may begin below 0.
        """
    def GetOrigin(self) -> tuple[float, float]:
        """
        Physical point of the pixel with index (0, 0), (u, v), in the unit of the spacing.
        """
    def GetSize(self) -> tuple[int, int]:
        """
        (width, height)
        """
    def GetSpacing(self) -> tuple[float, float]:
        """
        Distance between pixels, (u, v), in mm where a spacing is known and 1 otherwise.
        """
    def GetWidth(self) -> int:
        """
        Number of columns.
        """
    def TransformContinuousIndexToPhysicalPoint(self, index: typing.Sequence[float]) -> tuple[float, float]:
        """
        Continuous pixel index (u, v) to the physical point (x, y).
        """
    def TransformPhysicalPointToContinuousIndex(self, point: typing.Sequence[float]) -> tuple[float, float]:
        """
        Physical point (x, y) to the continuous pixel index (u, v).
        """
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
    normals : (N, 2) array, optional
        Of a silhouette: outward unit normals in the image, (0, 0) where one is not known.
    rimPoints : (N, 3) array, optional
        Of a silhouette: the points of the scan that project to its points, frame of the mesh, mm; NaN where one is not
        known.
    teeth : sequence of str or int, optional
        The teeth of the points where they are not all of one; the code is then that of the first.
    drafted : bool, optional
        A registration projected it and nobody has mended it: no independent evidence.
    """
    def __init__(self, points: numpy.typing.ArrayLike, code: typing.Any = '', closed: bool = False, weights: typing.Any = None, sigmas: typing.Any = None, outline: typing.Any = None, normals: typing.Any = None, rimPoints: typing.Any = None, teeth: typing.Any = None, drafted: bool = False) -> None:
        ...
    def __len__(self) -> int:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def closed(self) -> bool:
        """
        Whether the last point is joined to the first, which is not repeated.
        """
    @property
    def code(self) -> str:
        """
        "UR1" or "".
        """
    @property
    def drafted(self) -> bool:
        """
        Whether a registration projected it and nobody has mended it.
        """
    @property
    def fdi(self) -> int:
        """
        0 is unknown.
        """
    @property
    def normals(self) -> typing.Any:
        """
        (N, 2) copy: outward unit normals in the image, (0, 0) where one is not known; or None.
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
    def rimPoints(self) -> typing.Any:
        """
        (N, 3) copy: the points of the scan that project to these, frame of the mesh, mm, NaN where one is not known; or None.
        """
    @property
    def sigmas(self) -> typing.Any:
        """
        (N,) copy, or None.
        """
    @property
    def teeth(self) -> typing.Any:
        """
        The names of the points' teeth where they are not all of one, or None.
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
    def AddPolyline(self, points: numpy.typing.ArrayLike, code: typing.Any = '', closed: bool = False, weights: typing.Any = None, sigmas: typing.Any = None, outline: typing.Any = None, normals: typing.Any = None, rimPoints: typing.Any = None, teeth: typing.Any = None, drafted: bool = False) -> None:
        """
        Appends a polyline of continuous pixel indices (u, v), as Polyline describes it. It raises an error where a point is not finite, where weights, sigmas, normals, rimPoints or teeth are not one a point, or where a closed one has fewer than 3 points.
        """
    def GetDraftedShare(self) -> float:
        """
        Share of the points with a weight above 0 that a registration drafted and nobody mended, 0 to 1.
        """
    def GetLength(self) -> float:
        """
        Sum of the segments' lengths, pixels.
        """
    def GetNumberOfPoints(self) -> int:
        """
        How many points all polylines have together.
        """
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
        """
        The fixed parameters.
        """
    def GetName(self) -> str:
        """
        Name of the class in C++.
        """
    def GetNumberOfParameters(self) -> int:
        """
        How many parameters it has.
        """
    def GetParameters(self) -> tuple[typing.Any, ...]:
        """
        The parameters, in the order that ITK's transform of the same name has.
        """
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
        """
        Returns the angle of rotation, rad.
        """
    def GetCenter(self) -> tuple[float, float]:
        """
        Returns the centre of rotation and scale, in the unit of the points.
        """
    def GetDimension(self) -> int:
        """
        Number of axes of the points.
        """
    def GetInverse(self) -> Similarity2DTransform:
        """
        The inverse as a new transform of the same class.
        """
    def GetMatrix(self) -> tuple[typing.Any, ...]:
        """
        Row-major.
        """
    def GetScale(self) -> float:
        """
        Returns the scale factor, no unit.
        """
    def GetTranslation(self) -> tuple[float, float]:
        """
        Returns the translation, in the unit of the points.
        """
    def SetAngle(self, angle: float) -> None:
        """
        Sets the angle of rotation, rad.
        """
    def SetCenter(self, center: typing.Sequence[float]) -> None:
        """
        Sets the centre of rotation and scale, in the unit of the points.
        """
    def SetFixedParameters(self, parameters: typing.Sequence[float]) -> None:
        """
        Sets the fixed parameters: the centre.
        """
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        """
        Sets the parameters, in the order that ITK's transform of the same name has.
        """
    def SetScale(self, scale: float) -> None:
        """
        Sets the scale factor, no unit.
        """
    def SetTranslation(self, translation: typing.Sequence[float]) -> None:
        """
        Sets the translation, in the unit of the points.
        """
    def TransformPoint(self, point: typing.Sequence[float]) -> tuple[float, float]:
        """
        The place that a point goes to, in the unit of the points.
        """
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
        """
        Returns the centre of rotation and scale, in the unit of the points.
        """
    def GetDimension(self) -> int:
        """
        Number of axes of the points.
        """
    def GetInverse(self) -> VersorRigid3DTransform:
        """
        The inverse as a new transform of the same class.
        """
    def GetMatrix(self) -> tuple[typing.Any, ...]:
        """
        Row-major.
        """
    def GetTranslation(self) -> tuple[float, float, float]:
        """
        Returns the translation, in the unit of the points.
        """
    def SetCenter(self, center: typing.Sequence[float]) -> None:
        """
        Sets the centre of rotation and scale, in the unit of the points.
        """
    def SetFixedParameters(self, parameters: typing.Sequence[float]) -> None:
        """
        Sets the fixed parameters: the centre.
        """
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        """
        Sets the parameters, in the order that ITK's transform of the same name has.
        """
    def SetTranslation(self, translation: typing.Sequence[float]) -> None:
        """
        Sets the translation, in the unit of the points.
        """
    def TransformPoint(self, point: typing.Sequence[float]) -> tuple[float, float, float]:
        """
        The place that a point goes to, in the unit of the points.
        """
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
            """
            The value as a number.
            """
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
            """
            The value as a number.
            """
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
            """
            The value as a number.
            """
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
            """
            The value as a number.
            """
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
            """
            The value as a number.
            """
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
        """
        Returns the direction of the radiograph: Lateral (the default) or Frontal. What is said of sides holds in its own direction.
        """
    def GetFacing(self) -> CephalometricGeometry.Facing:
        """
        Returns the side of the image to which the face of a lateral radiograph looks; Right by default.
        """
    def GetFrontalSource(self) -> CephalometricGeometry.FrontalSource:
        """
        Returns where the source of a frontal radiograph is: Behind (the default) the patient or in front.
        """
    def GetMagnification(self, point: typing.Sequence[float]) -> float:
        """
        Magnification of a point of the object frame (mm): the length of its picture in the detector plane over its own.
        """
    def GetPatientLeft(self) -> CephalometricGeometry.PatientLeft:
        """
        Returns the side of a frontal image at which the patient's left is: Right by default, as one faces the patient.
        """
    def GetPixelSpacing(self) -> tuple[float, float]:
        """
        Returns the pixel spacing (u, v) in the detector plane, mm, both above 0. It is not set by default.
        """
    def GetPose(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (4, 4), a copy.
        """
    def GetPrincipalPoint(self) -> tuple[float, float]:
        """
        Returns the continuous pixel index (u, v) where the central ray meets the detector, the ear-rod ring of a cephalostat; (0, 0) by default.
        """
    def GetProjectionMatrix(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (3, 4): object frame (mm) to homogeneous pixel index, pose included.
        """
    def GetSourcePosition(self) -> tuple[float, float, float]:
        """
        The X-ray source in the object frame, mm.
        """
    def GetSourceSide(self) -> CephalometricGeometry.SourceSide:
        """
        Returns the patient's side at which the source of a lateral radiograph is; Right by default.
        """
    def GetSourceToDetectorDistance(self) -> float:
        """
        Returns the distance from the source to the detector, mm; 1674 by default.
        """
    def GetSourceToMidsagittalDistance(self) -> float:
        """
        Returns the distance from the source to the midsagittal plane, mm, above 0 and below that to the detector; 1524 by default (60 inches). In a frontal cephalogram it is that to the midcoronal plane.
        """
    def HasPixelSpacing(self) -> bool:
        """
        Whether a pixel spacing was set.
        """
    def ProjectPoint(self, point: typing.Sequence[float]) -> tuple[float, float]:
        """
        Object frame (mm) to continuous pixel index (u, v).
        """
    def ProjectPoints(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[typing.Any]:
        """
        All rows of an (N, 3) array: (N, 2), a copy.
        """
    def SetDirection(self, direction: CephalometricGeometry.Direction | str) -> None:
        """
        Sets the direction of the radiograph: Lateral (the default) or Frontal. What is said of sides holds in its own direction.
        """
    def SetFacing(self, facing: CephalometricGeometry.Facing | str) -> None:
        """
        Sets the side of the image to which the face of a lateral radiograph looks; Right by default.
        """
    def SetFrontalSource(self, source: CephalometricGeometry.FrontalSource | str) -> None:
        """
        Sets where the source of a frontal radiograph is: Behind (the default) the patient or in front.
        """
    def SetPatientLeft(self, side: CephalometricGeometry.PatientLeft | str) -> None:
        """
        Sets the side of a frontal image at which the patient's left is: Right by default, as one faces the patient.
        """
    def SetPixelSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        Sets the pixel spacing (u, v) in the detector plane, mm, both above 0. It is not set by default.
        """
    def SetPose(self, matrix: numpy.typing.ArrayLike) -> None:
        """
        Rigid 4x4 or 3x4: object frame (mm) to cephalostat frame (mm).
        """
    def SetPoseToIdentity(self) -> None:
        """
        Takes the object frame for the cephalostat frame.
        """
    def SetPrincipalPoint(self, index: typing.Sequence[float]) -> None:
        """
        Sets the continuous pixel index (u, v) where the central ray meets the detector, the ear-rod ring of a cephalostat; (0, 0) by default.
        """
    def SetSourceSide(self, side: CephalometricGeometry.SourceSide | str) -> None:
        """
        Sets the patient's side at which the source of a lateral radiograph is; Right by default.
        """
    def SetSourceToDetectorDistance(self, value: float) -> None:
        """
        Sets the distance from the source to the detector, mm; 1674 by default.
        """
    def SetSourceToMidsagittalDistance(self, value: float) -> None:
        """
        Sets the distance from the source to the midsagittal plane, mm, above 0 and below that to the detector; 1524 by default (60 inches). In a frontal cephalogram it is that to the midcoronal plane.
        """
    def TransformToCephalostat(self, point: typing.Sequence[float]) -> tuple[float, float, float]:
        """
        Point of the object frame (mm) to the cephalostat frame (mm).
        """
    def VerifyComplete(self) -> None:
        """
        Raises an error that names what is missing, and the remedy, unless the geometry can project.
        """
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
        """
        Sets the nine fixed parameters, the geometry; eight, as in older files, are those of a lateral radiograph.
        """
    def SetGeometry(self, geometry: CephalometricGeometry) -> None:
        """
        Copies it; its pose is not taken.
        """
    def SetIdentity(self) -> None:
        """
        All seven parameters 0; the geometry stays.
        """
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        """
        Sets the seven parameters: rotation (rad), translation (mm), kappa (the logarithm of the scale).
        """
    def SetParametersFromRotation(self, rotation: numpy.typing.ArrayLike, translation: typing.Sequence[float], kappa: float = 0.0) -> None:
        """
        c = rotation p + translation (mm), and kappa.
        """
    def TransformPoint(self, point: typing.Sequence[float]) -> tuple[float, float]:
        """
        Point of the dental frame (mm) to the continuous pixel index (u, v).
        """
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
    @property
    def matrix(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (4, 4), of the rigid part: dental frame to cephalostat frame, mm; a copy. The projection follows it, and so does the scale exp(kappa).
        """
class ProcessObject:
    """
    What every filter has.
    """
    @staticmethod
    def GetGlobalDefaultNumberOfThreads() -> int:
        """
        The number of threads of every process object that is made from now on.
        """
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
        """
        Name of the class in C++.
        """
    def GetNumberOfWorkUnits(self) -> int:
        """
        The number of parts that the work is split in.
        """
    def GetProgress(self) -> float:
        """
        Share that is done, 0 to 1.
        """
    def SetNumberOfWorkUnits(self, numberOfWorkUnits: int) -> None:
        """
        Sets the number of parts that the work is split in; the result does not depend on it.
        """
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

      WebCeph

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
    WebCeph: typing.ClassVar[AnnotationFileFormat]
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
class DentalContourFileReader(ProcessObject):
    """
    Reads the tracing on a radiograph.
    """
    def GetCalibrations(self) -> list[tuple[str, float, float]]:
        """
        What was drawn along rulers: (label, length in mm, length in pixels) each, valid after Execute().
        """
    def GetClassFiles(self) -> list[tuple[str, str]]:
        """
        Returns the files of one tooth or jaw each (masks, drawn lines, what a program drew) that are read in place of one file; none by default.
        """
    def GetFileFormat(self) -> AnnotationFileFormat:
        """
        Returns the format of the file; Automatic, the default, tells it by what is in it.
        """
    def GetFileName(self) -> str:
        """
        Returns the name of the file. To set it takes back SetClassFiles().
        """
    def GetImageFileName(self) -> str:
        """
        Returns the name of the radiograph whose tracing is wanted, where a file holds those of several.
        """
    def GetImageSize(self) -> tuple[int, int]:
        """
        Returns the width and height of the radiograph, pixels; (0, 0), the default, is unknown, and the file has to say it.
        """
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        """
        Returns the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        """
        Returns the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def GetNumberOfPointsOutside(self) -> int:
        """
        How many points of both jaws lie outside the radiograph, valid after Execute().
        """
    def GetNumberOfSidelessCodes(self) -> int:
        """
        How many contours have a code without a side, valid after Execute().
        """
    def GetNumbering(self) -> Numbering:
        """
        Returns how the file numbers teeth, where its codes leave it open.
        """
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        """
        Returns where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        """
        The format that was read, valid after Execute().
        """
    def GetReadImageSize(self) -> tuple[int, int]:
        """
        Width and height of the radiograph, pixels, as set or as the file says, valid after Execute().
        """
    def GetReadNumbering(self) -> Numbering:
        """
        The numbering under which the codes were read, valid after Execute().
        """
    def GetSidelessCodesAreLeft(self) -> bool:
        """
        Returns whether codes that do not say a side (U1, L6) are the left teeth. Off by default: right.
        """
    def GetWarnings(self) -> list[str]:
        """
        What a person should know of the file, a sentence each, valid after Execute().
        """
    def SetClassFiles(self, files: typing.Sequence[tuple[str, str]]) -> None:
        """
        Sets the files of one tooth or jaw each (masks, drawn lines, what a program drew) that are read in place of one file; none by default.
        """
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        """
        Sets the format of the file; Automatic, the default, tells it by what is in it.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file. To set it takes back SetClassFiles().
        """
    def SetImageFileName(self, fileName: str) -> None:
        """
        Sets the name of the radiograph whose tracing is wanted, where a file holds those of several.
        """
    def SetImageSize(self, size: typing.Sequence[int]) -> None:
        """
        Sets the width and height of the radiograph, pixels; (0, 0), the default, is unknown, and the file has to say it.
        """
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        """
        Sets the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        Sets the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def SetNumbering(self, numbering: Numbering | str) -> None:
        """
        Sets how the file numbers teeth, where its codes leave it open.
        """
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        """
        Sets where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def SetSidelessCodesAreLeft(self, on: bool) -> None:
        """
        Sets whether codes that do not say a side (U1, L6) are the left teeth. Off by default: right.
        """
    def _TakeOutputs(self) -> tuple[Contour, Contour]:
        ...
    def __init__(self) -> None:
        ...
class DentalContourFileWriter(ProcessObject):
    """
    Writes a tracing as contours.json.
    """
    def GetFileName(self) -> str:
        """
        Returns the name of the file.
        """
    def GetImageSize(self) -> tuple[int, int]:
        """
        Returns the width and height of the radiograph, pixels, which the file has to say.
        """
    def GetNumbering(self) -> Numbering:
        """
        Returns how the file numbers teeth; Quadrant by default.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file.
        """
    def SetImageSize(self, size: typing.Sequence[int]) -> None:
        """
        Sets the width and height of the radiograph, pixels, which the file has to say.
        """
    def SetNumbering(self, numbering: Numbering | str) -> None:
        """
        Sets how the file numbers teeth; Quadrant by default.
        """
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
        """
        Returns the format of the file; Automatic, the default, tells it by what is in it.
        """
    def GetFileName(self) -> str:
        """
        Returns the name of the file.
        """
    def GetImageFileName(self) -> str:
        """
        Returns the name of the radiograph whose annotation is wanted, where a file holds those of several.
        """
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        """
        Returns the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        """
        Returns the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def GetNumbering(self) -> Numbering:
        """
        Returns how the file numbers teeth, where its codes leave it open.
        """
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        """
        Returns where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        """
        The format that was read, valid after Execute().
        """
    def GetWarnings(self) -> list[str]:
        """
        What a person should know of the file, a sentence each, valid after Execute().
        """
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        """
        Sets the format of the file; Automatic, the default, tells it by what is in it.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file.
        """
    def SetImageFileName(self, fileName: str) -> None:
        """
        Sets the name of the radiograph whose annotation is wanted, where a file holds those of several.
        """
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        """
        Sets the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        Sets the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def SetNumbering(self, numbering: Numbering | str) -> None:
        """
        Sets how the file numbers teeth, where its codes leave it open.
        """
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        """
        Sets where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def __init__(self) -> None:
        ...
class DentalLandmarkFileWriter2D(ProcessObject):
    """
    Writes named landmarks; see WriteLandmarks().
    """
    def GetFileName(self) -> str:
        """
        Returns the name of the file.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file.
        """
    def _SetInput(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def __init__(self) -> None:
        ...
class DentalLandmarkFileReader3D(ProcessObject):
    """
    Reads named landmarks; see ReadLandmarks().
    """
    def GetFileFormat(self) -> AnnotationFileFormat:
        """
        Returns the format of the file; Automatic, the default, tells it by what is in it.
        """
    def GetFileName(self) -> str:
        """
        Returns the name of the file.
        """
    def GetImageFileName(self) -> str:
        """
        Returns the name of the radiograph whose annotation is wanted, where a file holds those of several.
        """
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        """
        Returns the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        """
        Returns the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def GetNumbering(self) -> Numbering:
        """
        Returns how the file numbers teeth, where its codes leave it open.
        """
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        """
        Returns where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        """
        The format that was read, valid after Execute().
        """
    def GetWarnings(self) -> list[str]:
        """
        What a person should know of the file, a sentence each, valid after Execute().
        """
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        """
        Sets the format of the file; Automatic, the default, tells it by what is in it.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file.
        """
    def SetImageFileName(self, fileName: str) -> None:
        """
        Sets the name of the radiograph whose annotation is wanted, where a file holds those of several.
        """
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        """
        Sets the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        Sets the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def SetNumbering(self, numbering: Numbering | str) -> None:
        """
        Sets how the file numbers teeth, where its codes leave it open.
        """
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        """
        Sets where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def __init__(self) -> None:
        ...
class DentalLandmarkFileWriter3D(ProcessObject):
    """
    Writes named landmarks; see WriteLandmarks().
    """
    def GetFileName(self) -> str:
        """
        Returns the name of the file.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file.
        """
    def _SetInput(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def __init__(self) -> None:
        ...
class CephalometricLandmarkFileReader(ProcessObject):
    """
    Reads the dental landmarks of a cephalometric analysis; see ReadCephalometricLandmarks().
    """
    def GetFileFormat(self) -> AnnotationFileFormat:
        """
        Returns the format of the file; Automatic, the default, tells it by what is in it.
        """
    def GetFileName(self) -> str:
        """
        Returns the name of the file.
        """
    def GetImageFileName(self) -> str:
        """
        Returns the name of the radiograph whose annotation is wanted, where a file holds those of several.
        """
    def GetMarkupsOrigin(self) -> tuple[float, float]:
        """
        Returns the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def GetMarkupsSpacing(self) -> tuple[float, float]:
        """
        Returns the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def GetNumbering(self) -> Numbering:
        """
        Returns how the file numbers teeth, where its codes leave it open.
        """
    def GetPixelOrigin(self) -> AnnotationPixelOrigin:
        """
        Returns where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def GetReadFileFormat(self) -> AnnotationFileFormat:
        """
        The format that was read, valid after Execute().
        """
    def GetWarnings(self) -> list[str]:
        """
        What a person should know of the file, a sentence each, valid after Execute().
        """
    def SetFileFormat(self, format: AnnotationFileFormat | str) -> None:
        """
        Sets the format of the file; Automatic, the default, tells it by what is in it.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file.
        """
    def SetImageFileName(self, fileName: str) -> None:
        """
        Sets the name of the radiograph whose annotation is wanted, where a file holds those of several.
        """
    def SetMarkupsOrigin(self, origin: typing.Sequence[float]) -> None:
        """
        Sets the origin (x, y) of the image that a Slicer markups file was drawn on, mm.
        """
    def SetMarkupsSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        Sets the spacing (u, v) of the image that a Slicer markups file was drawn on, mm a pixel.
        """
    def SetNumbering(self, numbering: Numbering | str) -> None:
        """
        Sets how the file numbers teeth, where its codes leave it open.
        """
    def SetPixelOrigin(self, origin: AnnotationPixelOrigin | str) -> None:
        """
        Sets where (0, 0) is in the file: at the centre or the corner of the first pixel. FormatDefault, the default, is as its program counts.
        """
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def __init__(self) -> None:
        ...
class CephalogramFileReader(ProcessObject):
    """
    Reads a radiograph and says what its pixel spacing is worth.
    """
    def ClearUserPixelSpacing(self) -> None:
        """
        Goes back to the spacing that the file says.
        """
    def GetDetectorPixelSpacing(self, sourceToDetector: float, sourceToMidsagittal: float) -> tuple[float, float]:
        """
        The spacing (u, v) in the detector plane, mm. One that holds in the midsagittal plane is multiplied by the ratio of the two distances from the source (mm); of EstimatedMagnification it is the file's imager pixel spacing, whatever the distances. It raises an error where the verdict is Unknown.
        """
    def GetFacing(self) -> CephalometricGeometry.Facing:
        """
        The side of the image to which the face looks, from DICOM (0020,0020). It raises an error where that is missing.
        """
    def GetFileFormat(self) -> str:
        """
        The format that was read: "PNG", "JPEG", "TIFF", "BMP", "NRRD", "MetaImage", "NIfTI" or "DICOM".
        """
    def GetFileName(self) -> str:
        """
        Returns the name of the image file.
        """
    def GetMagnificationFactor(self) -> float:
        """
        The magnification, DICOM (0018,1114), no unit. It raises an error where there is none.
        """
    def GetPixelSpacing(self) -> tuple[float, float]:
        """
        Raises where the verdict is Unknown.
        """
    def GetPixelSpacingVerdict(self) -> PixelSpacingVerdict:
        """
        What the pixel spacing of the file is worth, valid after Execute().
        """
    def GetProvenance(self) -> dict[str, str]:
        """
        Where the pixel spacing comes from, in words.
        """
    def GetSourceToDetectorDistance(self) -> float:
        """
        Distance from source to detector, mm, DICOM (0018,1110). It raises an error where there is none.
        """
    def GetSourceToMidsagittalDistance(self) -> float:
        """
        Distance from source to midsagittal plane, mm: DICOM (0018,1110) over (0018,1114). It raises an error where one of them is missing.
        """
    def GetSpacingPlane(self) -> SpacingPlane:
        """
        The plane in which the pixel spacing holds, valid after Execute().
        """
    def GetWarnings(self) -> list[str]:
        """
        What a person should know of the file, a sentence each.
        """
    def HasFacing(self) -> bool:
        """
        Whether the file says to which side the face looks.
        """
    def HasMagnificationFactor(self) -> bool:
        """
        Whether the file says a magnification.
        """
    def HasPixelSpacing(self) -> bool:
        """
        Whether a pixel spacing is known, valid after Execute().
        """
    def HasSourceToDetectorDistance(self) -> bool:
        """
        Whether the file says the distance from source to detector.
        """
    def HasSourceToMidsagittalDistance(self) -> bool:
        """
        Whether the file says what the distance from source to midsagittal plane follows from.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the image file.
        """
    def SetUserPixelSpacing(self, spacing: typing.Sequence[float], plane: SpacingPlane | str = ...) -> None:
        """
        Sets the pixel spacing (u, v), mm, and the plane in which it holds, over what the file says.
        """
    def _TakeOutput(self) -> Image:
        ...
    def __init__(self) -> None:
        ...
class ToothLabelFileReader(ProcessObject):
    """
    Reads tooth labels of a mesh's points.
    """
    def GetFileName(self) -> str:
        """
        Returns the name of the file.
        """
    def GetJaw(self) -> Jaw:
        """
        The jaw, as the file says, else as its labels do; Unknown where neither does. Valid after Execute().
        """
    def GetNumberOfPoints(self) -> int:
        """
        Returns the number of points of the mesh that is labelled; 0, the default, checks nothing.
        """
    def GetNumbering(self) -> Numbering:
        """
        Returns how the file numbers teeth: FDI (the default) or Universal.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the file.
        """
    def SetNumberOfPoints(self, count: int) -> None:
        """
        Sets the number of points of the mesh that is labelled; 0, the default, checks nothing.
        """
    def SetNumbering(self, numbering: Numbering | str) -> None:
        """
        Sets how the file numbers teeth: FDI (the default) or Universal.
        """
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
        """
        The value as a number.
        """
class DentalFrames:
    """
    Everything that UMidlineDentalAxisFilter found, for ScanCheckFilter to judge.
    """
class UMidlineDentalAxisFilter(ProcessObject):
    """
    The anatomical frame of dental arches.
    """
    def EmbedAxesOff(self) -> None:
        """
        The same as SetEmbedAxes(False). It sets whether arrows along the axes are added to the output meshes. Off by default.
        """
    def EmbedAxesOn(self) -> None:
        """
        The same as SetEmbedAxes(True). It sets whether arrows along the axes are added to the output meshes. Off by default.
        """
    def GetArchDepth(self, jaw: Jaw | str) -> float:
        """
        mm.
        """
    def GetArchWidth(self, jaw: Jaw | str) -> float:
        """
        mm.
        """
    def GetAxesLength(self) -> float:
        """
        Returns the length of the arrow along x, mm; 40 by default.
        """
    def GetBaselineLeft(self, jaw: Jaw | str) -> tuple[float, float, float]:
        """
        Left end of the molar baseline, mm, in the mesh's frame.
        """
    def GetBaselineMidpoint(self, jaw: Jaw | str) -> tuple[float, float, float]:
        """
        Middle of the molar baseline, mm, in the mesh's frame.
        """
    def GetBaselineRight(self, jaw: Jaw | str) -> tuple[float, float, float]:
        """
        End of the molar baseline on the patient's right, mesh frame, mm.
        """
    def GetConfidence(self, jaw: Jaw | str) -> float:
        """
        In [0, 1]; below 0.5 a person should look at the axes.
        """
    def GetCrownFraction(self) -> float:
        """
        Returns the share of the surface that is taken for crowns, in (0, 1]; 0.15 by default, the paper's p.
        """
    def GetEmbedAxes(self) -> bool:
        """
        Returns whether arrows along the axes are added to the output meshes. Off by default.
        """
    def GetIncisalEdge(self, jaw: Jaw | str) -> tuple[float, float, float]:
        """
        Middle of the incisal edge, mm, in the mesh's frame.
        """
    def GetJawsAreInOneFrame(self) -> bool:
        """
        Whether the jaws were treated as in one frame. Overjet and overbite mean something only then.
        """
    def GetJawsShareFrame(self) -> JawsShareFrame:
        """
        Returns whether both scans lie in one frame, in occlusion. Check, the default, looks at contact, heights and directions of the arches.
        """
    def GetMaximumIterations(self) -> int:
        """
        Returns the most rounds of crown candidates, principal axes and occlusal direction; 20 by default. It stops when the direction does.
        """
    def GetOverbite(self) -> float:
        """
        mm; means something only where the jaws are in one frame.
        """
    def GetOverjet(self) -> float:
        """
        mm; means something only where the jaws are in one frame.
        """
    def GetRefineMidline(self) -> bool:
        """
        Returns whether the midline plane is moved to the scan's mirror plane. Off by default.
        """
    def GetRequireArches(self) -> bool:
        """
        Returns whether a mesh without an arch is an error. On by default; off, its outputs are empty and the other jaw is none the worse.
        """
    def GetTransformMeshes(self) -> bool:
        """
        Returns whether the output meshes are made. On by default; off for those who want the frames alone.
        """
    def RefineMidlineOff(self) -> None:
        """
        The same as SetRefineMidline(False). It sets whether the midline plane is moved to the scan's mirror plane. Off by default.
        """
    def RefineMidlineOn(self) -> None:
        """
        The same as SetRefineMidline(True). It sets whether the midline plane is moved to the scan's mirror plane. Off by default.
        """
    def RequireArchesOff(self) -> None:
        """
        The same as SetRequireArches(False). It sets whether a mesh without an arch is an error. On by default; off, its outputs are empty and the other jaw is none the worse.
        """
    def RequireArchesOn(self) -> None:
        """
        The same as SetRequireArches(True). It sets whether a mesh without an arch is an error. On by default; off, its outputs are empty and the other jaw is none the worse.
        """
    def SetAxesLength(self, value: float) -> None:
        """
        Sets the length of the arrow along x, mm; 40 by default.
        """
    def SetCrownFraction(self, value: float) -> None:
        """
        Sets the share of the surface that is taken for crowns, in (0, 1]; 0.15 by default, the paper's p.
        """
    def SetEmbedAxes(self, value: bool) -> None:
        """
        Sets whether arrows along the axes are added to the output meshes. Off by default.
        """
    def SetJawsShareFrame(self, mode: JawsShareFrame | str) -> None:
        """
        Sets whether both scans lie in one frame, in occlusion. Check, the default, looks at contact, heights and directions of the arches.
        """
    def SetMaximumIterations(self, value: int) -> None:
        """
        Sets the most rounds of crown candidates, principal axes and occlusal direction; 20 by default. It stops when the direction does.
        """
    def SetRefineMidline(self, value: bool) -> None:
        """
        Sets whether the midline plane is moved to the scan's mirror plane. Off by default.
        """
    def SetRequireArches(self, value: bool) -> None:
        """
        Sets whether a mesh without an arch is an error. On by default; off, its outputs are empty and the other jaw is none the worse.
        """
    def SetTransformMeshes(self, value: bool) -> None:
        """
        Sets whether the output meshes are made. On by default; off for those who want the frames alone.
        """
    def TransformMeshesOff(self) -> None:
        """
        The same as SetTransformMeshes(False). It sets whether the output meshes are made. On by default; off for those who want the frames alone.
        """
    def TransformMeshesOn(self) -> None:
        """
        The same as SetTransformMeshes(True). It sets whether the output meshes are made. On by default; off for those who want the frames alone.
        """
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
        """
        Unit normal of the plane that was found, in the frame of the meshes.
        """
    def GetOffset(self) -> float:
        """
        Distance of the plane from the origin along its normal, mm.
        """
    def SignedDistance(self, point: typing.Sequence[float]) -> float:
        """
        Distance of a point (mm, in the frame of the meshes) from the plane, positive on the side of the normal.
        """
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
class SurfaceDRRImageSource(ProcessObject):
    """
    Digitally reconstructed radiograph of surfaces.
    """
    def CoverMeshesOff(self) -> None:
        """
        The same as SetCoverMeshes(False). It sets whether the region holds every projected vertex and a margin. On by default; SetSize() turns it off.
        """
    def CoverMeshesOn(self) -> None:
        """
        The same as SetCoverMeshes(True). It sets whether the region holds every projected vertex and a margin. On by default; SetSize() turns it off.
        """
    def GetAttenuation(self) -> float:
        """
        Returns the attenuation coefficient, 1/mm under Physical; 0.08 by default, that of enamel at about 60 keV.
        """
    def GetCoverMargin(self) -> float:
        """
        Returns the margin of CoverMeshes, mm in the detector plane. A negative one, the default, stands for four times the largest sigma.
        """
    def GetCoverMeshes(self) -> bool:
        """
        Returns whether the region holds every projected vertex and a margin. On by default; SetSize() turns it off.
        """
    def GetDensity(self) -> float:
        """
        Returns the thickness of the shell, mm, under Physical, and a factor under Paper; 1 by default.
        """
    def GetMeshSigma(self, number: int) -> float:
        """
        Width of the splats of one mesh by its number, mm in the detector plane; 0 stands for Sigma.
        """
    def GetNormalization(self) -> SurfaceDRRNormalization:
        """
        Returns how the sum of the splats becomes a thickness: Physical (the default, mm) or Paper.
        """
    def GetNumberOfProjections(self) -> int:
        """
        How often the splats were projected.
        """
    def GetOrigin(self) -> tuple[float, float]:
        """
        Returns the physical point of the pixel with index (0, 0), mm in the detector plane.
        """
    def GetOutputMode(self) -> SurfaceDRROutput:
        """
        Returns what the pixels hold; Thickness by default.
        """
    def GetSigma(self) -> float:
        """
        Returns the width of the splats, mm in the detector plane, of every mesh without one of its own; 0.5 by default.
        """
    def GetSize(self) -> tuple[int, int]:
        """
        Returns the size of the output region (width, height), pixels. To set it turns CoverMeshes off.
        """
    def GetSourceIntensity(self) -> float:
        """
        Returns the intensity without anything in the beam; 1 by default.
        """
    def GetSpacing(self) -> tuple[float, float]:
        """
        Returns the distance between pixels (u, v), mm in the detector plane, where UseGeometrySpacing is off.
        """
    def GetStartIndex(self) -> tuple[int, int]:
        """
        Returns the first pixel of the output region, (u, v), which may be negative.
        """
    def GetTolerance(self) -> float:
        """
        Returns the largest error relative to the maximum on the detector plane, in [1e-6, 0.1]; 1e-3 by default.
        """
    def GetUseGeometrySpacing(self) -> bool:
        """
        Returns whether the pixel spacing is that of the geometry. On by default.
        """
    def GetVertexSigmas(self, number: int) -> list[float]:
        """
        Widths of the splats of one mesh, one a vertex, mm; empty where it has one width.
        """
    def SetAttenuation(self, value: float) -> None:
        """
        Sets the attenuation coefficient, 1/mm under Physical; 0.08 by default, that of enamel at about 60 keV.
        """
    def SetCoverMargin(self, value: float) -> None:
        """
        Sets the margin of CoverMeshes, mm in the detector plane. A negative one, the default, stands for four times the largest sigma.
        """
    def SetCoverMeshes(self, value: bool) -> None:
        """
        Sets whether the region holds every projected vertex and a margin. On by default; SetSize() turns it off.
        """
    def SetDensity(self, value: float) -> None:
        """
        Sets the thickness of the shell, mm, under Physical, and a factor under Paper; 1 by default.
        """
    def SetMeshSigma(self, number: int, sigma: float) -> None:
        """
        Sets the width of the splats of one mesh by its number, mm in the detector plane; 0 returns to Sigma.
        """
    def SetNormalization(self, normalization: SurfaceDRRNormalization | str) -> None:
        """
        Sets how the sum of the splats becomes a thickness: Physical (the default, mm) or Paper.
        """
    def SetOrigin(self, origin: typing.Sequence[float]) -> None:
        """
        Sets the physical point of the pixel with index (0, 0), mm in the detector plane.
        """
    def SetOutputMode(self, mode: SurfaceDRROutput | str) -> None:
        """
        Sets what the pixels hold; Thickness by default.
        """
    def SetSigma(self, value: float) -> None:
        """
        Sets the width of the splats, mm in the detector plane, of every mesh without one of its own; 0.5 by default.
        """
    def SetSize(self, size: typing.Sequence[int]) -> None:
        """
        Sets the size of the output region (width, height), pixels. To set it turns CoverMeshes off.
        """
    def SetSizeToCoverMeshes(self, margin: float) -> None:
        """
        Turns CoverMeshes on and sets its margin, mm in the detector plane.
        """
    def SetSourceIntensity(self, value: float) -> None:
        """
        Sets the intensity without anything in the beam; 1 by default.
        """
    def SetSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        Sets the distance between pixels (u, v), mm in the detector plane, where UseGeometrySpacing is off.
        """
    def SetStartIndex(self, index: typing.Sequence[int]) -> None:
        """
        Sets the first pixel of the output region, (u, v), which may be negative.
        """
    def SetTolerance(self, value: float) -> None:
        """
        Sets the largest error relative to the maximum on the detector plane, in [1e-6, 0.1]; 1e-3 by default.
        """
    def SetUseGeometrySpacing(self, value: bool) -> None:
        """
        Sets whether the pixel spacing is that of the geometry. On by default.
        """
    def SetVertexSigmas(self, number: int, sigmas: typing.Sequence[float]) -> None:
        """
        Sets the widths of the splats of one mesh, one a vertex in the order of the points, mm; an empty list returns to one width.
        """
    def UseGeometrySpacingOff(self) -> None:
        """
        The same as SetUseGeometrySpacing(False). It sets whether the pixel spacing is that of the geometry. On by default.
        """
    def UseGeometrySpacingOn(self) -> None:
        """
        The same as SetUseGeometrySpacing(True). It sets whether the pixel spacing is that of the geometry. On by default.
        """
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
class SilhouetteContourFilter(ProcessObject):
    """
    The outer silhouette in an image, or of labels.
    """
    def GetContent(self) -> SilhouetteContent:
        """
        Returns what the pixels are: grey values (Intensity, the default), FDI numbers (ToothLabels), or labels of any meaning (MergedLabels).
        """
    def GetLabelSmoothing(self) -> float:
        """
        Returns the width of the Gaussian under which labels are outlined, pixels, up to 100; 0 by default: the edges of pixels.
        """
    def GetLargestPartOnly(self) -> bool:
        """
        Returns whether only the part with the largest area is kept, of each label under ToothLabels. On by default.
        """
    def GetLevel(self) -> SilhouetteLevel:
        """
        Returns how the level of the contour is chosen; Automatic by default.
        """
    def GetLevelFraction(self) -> float:
        """
        Returns the level under Fraction, between the darkest and the brightest pixel, above 0 and below 1; 0.5 by default.
        """
    def GetLevelValue(self) -> float:
        """
        Returns the level under Absolute, in grey values; 0.5 by default.
        """
    def GetMinimumArea(self) -> float:
        """
        Returns the area below which parts are left out, square pixels; 0 by default.
        """
    def GetNumberOfStreamDivisions(self) -> int:
        """
        Returns the number of strips in which the image is pulled; 1 by default, the whole image at once.
        """
    def GetObjectIsDark(self) -> bool:
        """
        Returns whether the object is darker than the background. Off by default.
        """
    def GetOutputCoordinates(self) -> SilhouetteCoordinates:
        """
        Returns whether the points come out as continuous pixel indices (Index, the default) or as physical points.
        """
    def GetOutputOffset(self) -> tuple[float, float]:
        """
        Returns what is subtracted from every point of the output, (u, v) in its unit; 0 by default.
        """
    def GetUsedLevel(self) -> float:
        """
        Of the last Execute().
        """
    def LargestPartOnlyOff(self) -> None:
        """
        The same as SetLargestPartOnly(False). It sets whether only the part with the largest area is kept, of each label under ToothLabels. On by default.
        """
    def LargestPartOnlyOn(self) -> None:
        """
        The same as SetLargestPartOnly(True). It sets whether only the part with the largest area is kept, of each label under ToothLabels. On by default.
        """
    def ObjectIsDarkOff(self) -> None:
        """
        The same as SetObjectIsDark(False). It sets whether the object is darker than the background. Off by default.
        """
    def ObjectIsDarkOn(self) -> None:
        """
        The same as SetObjectIsDark(True). It sets whether the object is darker than the background. Off by default.
        """
    def SetContent(self, content: SilhouetteContent | str) -> None:
        """
        Sets what the pixels are: grey values (Intensity, the default), FDI numbers (ToothLabels), or labels of any meaning (MergedLabels).
        """
    def SetLabelSmoothing(self, value: float) -> None:
        """
        Sets the width of the Gaussian under which labels are outlined, pixels, up to 100; 0 by default: the edges of pixels.
        """
    def SetLargestPartOnly(self, value: bool) -> None:
        """
        Sets whether only the part with the largest area is kept, of each label under ToothLabels. On by default.
        """
    def SetLevel(self, level: SilhouetteLevel | str) -> None:
        """
        Sets how the level of the contour is chosen; Automatic by default.
        """
    def SetLevelFraction(self, value: float) -> None:
        """
        Sets the level under Fraction, between the darkest and the brightest pixel, above 0 and below 1; 0.5 by default.
        """
    def SetLevelValue(self, value: float) -> None:
        """
        Sets the level under Absolute, in grey values; 0.5 by default.
        """
    def SetMinimumArea(self, value: float) -> None:
        """
        Sets the area below which parts are left out, square pixels; 0 by default.
        """
    def SetNumberOfStreamDivisions(self, value: int) -> None:
        """
        Sets the number of strips in which the image is pulled; 1 by default, the whole image at once.
        """
    def SetObjectIsDark(self, value: bool) -> None:
        """
        Sets whether the object is darker than the background. Off by default.
        """
    def SetOutputCoordinates(self, coordinates: SilhouetteCoordinates | str) -> None:
        """
        Sets whether the points come out as continuous pixel indices (Index, the default) or as physical points.
        """
    def SetOutputOffset(self, offset: typing.Sequence[float]) -> None:
        """
        Sets what is subtracted from every point of the output, (u, v) in its unit; 0 by default.
        """
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
        """
        Returns whether only the part with the largest area is given. On by default; off, all parts that do not hide in another.
        """
    def GetNumberOfPoints(self) -> int:
        """
        Returns the number of points of the output, at equal distances; 0, the default, gives the corners of the silhouette.
        """
    def GetUseLabels(self) -> bool:
        """
        Returns whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
    def LargestPartOnlyOff(self) -> None:
        """
        The same as SetLargestPartOnly(False). It sets whether only the part with the largest area is given. On by default; off, all parts that do not hide in another.
        """
    def LargestPartOnlyOn(self) -> None:
        """
        The same as SetLargestPartOnly(True). It sets whether only the part with the largest area is given. On by default; off, all parts that do not hide in another.
        """
    def SetLargestPartOnly(self, value: bool) -> None:
        """
        Sets whether only the part with the largest area is given. On by default; off, all parts that do not hide in another.
        """
    def SetNumberOfPoints(self, value: int) -> None:
        """
        Sets the number of points of the output, at equal distances; 0, the default, gives the corners of the silhouette.
        """
    def SetUseLabels(self, value: bool) -> None:
        """
        Sets whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
    def UseLabelsOff(self) -> None:
        """
        The same as SetUseLabels(False). It sets whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
    def UseLabelsOn(self) -> None:
        """
        The same as SetUseLabels(True). It sets whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
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
        """
        Returns the jaw of the mesh, which says which way is occlusal: Upper (the default) or Lower.
        """
    def GetNormals(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 2), outward.
        """
    def GetRimPoints(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N, 3), object frame, mm.
        """
    def GetSpacing(self) -> float:
        """
        Returns the distance between points of the output, mm in the detector plane; 0.125 by default.
        """
    def GetUseLabels(self) -> bool:
        """
        Returns whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
    def SetJaw(self, jaw: Jaw | str) -> None:
        """
        Sets the jaw of the mesh, which says which way is occlusal: Upper (the default) or Lower.
        """
    def SetSpacing(self, value: float) -> None:
        """
        Sets the distance between points of the output, mm in the detector plane; 0.125 by default.
        """
    def SetUseLabels(self, value: bool) -> None:
        """
        Sets whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
    def UseLabelsOff(self) -> None:
        """
        The same as SetUseLabels(False). It sets whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
    def UseLabelsOn(self) -> None:
        """
        The same as SetUseLabels(True). It sets whether the mesh's point data are FDI numbers of teeth, so that the output's points know their tooth. Off by default.
        """
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
        """
        Returns the number of points below which a stretch is left out; 2 by default.
        """
    def SetMinimumNumberOfPoints(self, number: int) -> None:
        """
        Sets the number of points below which a stretch is left out; 2 by default.
        """
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
        """
        Returns the number of points in total; 0, the default, goes by the spacing.
        """
    def GetSpacing(self) -> float:
        """
        Returns the distance between points, pixels, where the number of points is 0; 1 by default.
        """
    def SetNumberOfPoints(self, value: int) -> None:
        """
        Sets the number of points in total; 0, the default, goes by the spacing.
        """
    def SetSpacing(self, value: float) -> None:
        """
        Sets the distance between points, pixels, where the number of points is 0; 1 by default.
        """
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
        """
        Returns the jaw of the mesh; Upper by default.
        """
    def GetKeepWholeMesh(self) -> bool:
        """
        Returns whether the whole mesh comes out, with what is crown as its point data. Off by default.
        """
    def GetLabelNumbering(self) -> Numbering:
        """
        Returns how the labels number teeth: FDI (the default) or Universal.
        """
    def GetLabelsWereUsed(self) -> bool:
        """
        Whether the last run took the labels.
        """
    def GetMarginAngle(self) -> float:
        """
        rad.
        """
    def GetMaximumCrownHeight(self) -> float:
        """
        Returns the greatest depth below the occlusal surface at which the gingival margin is looked for, mm; 12.5 by default.
        """
    def GetMeanCrownHeight(self) -> float:
        """
        mm.
        """
    def GetMinimumCrownHeight(self) -> float:
        """
        Returns the least depth below the occlusal surface at which the gingival margin is looked for, mm; 2.5 by default.
        """
    def GetPointMask(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N,) of 0 and 1.
        """
    def GetTriangleMask(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (M,) of 0 and 1.
        """
    def GetUseLabels(self) -> bool:
        """
        Returns whether tooth labels of the mesh, where it has any, say what is crown. On by default.
        """
    def KeepWholeMeshOff(self) -> None:
        """
        The same as SetKeepWholeMesh(False). It sets whether the whole mesh comes out, with what is crown as its point data. Off by default.
        """
    def KeepWholeMeshOn(self) -> None:
        """
        The same as SetKeepWholeMesh(True). It sets whether the whole mesh comes out, with what is crown as its point data. Off by default.
        """
    def SetJaw(self, jaw: Jaw | str) -> None:
        """
        Sets the jaw of the mesh; Upper by default.
        """
    def SetKeepWholeMesh(self, value: bool) -> None:
        """
        Sets whether the whole mesh comes out, with what is crown as its point data. Off by default.
        """
    def SetLabelNumbering(self, numbering: Numbering | str) -> None:
        """
        Sets how the labels number teeth: FDI (the default) or Universal.
        """
    def SetMaximumCrownHeight(self, value: float) -> None:
        """
        Sets the greatest depth below the occlusal surface at which the gingival margin is looked for, mm; 12.5 by default.
        """
    def SetMinimumCrownHeight(self, value: float) -> None:
        """
        Sets the least depth below the occlusal surface at which the gingival margin is looked for, mm; 2.5 by default.
        """
    def SetUseLabels(self, value: bool) -> None:
        """
        Sets whether tooth labels of the mesh, where it has any, say what is crown. On by default.
        """
    def UseLabelsOff(self) -> None:
        """
        The same as SetUseLabels(False). It sets whether tooth labels of the mesh, where it has any, say what is crown. On by default.
        """
    def UseLabelsOn(self) -> None:
        """
        The same as SetUseLabels(True). It sets whether tooth labels of the mesh, where it has any, say what is crown. On by default.
        """
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
        """
        The value as a number.
        """
class MidlineSideMeshFilter(ProcessObject):
    """
    The part of a jaw on one side of the midline plane.
    """
    def GetMargin(self) -> float:
        """
        Returns how far beyond the midline plane the mesh is kept, mm; -0.5 by default, so that the other side's incisor is not the outline.
        """
    def GetSide(self) -> Side:
        """
        Returns the patient's side that is kept; Right by default.
        """
    def GetTriangleMask(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (M,) of 0 and 1.
        """
    def SetMargin(self, value: float) -> None:
        """
        Sets how far beyond the midline plane the mesh is kept, mm; -0.5 by default, so that the other side's incisor is not the outline.
        """
    def SetSide(self, side: Side | str) -> None:
        """
        Sets the patient's side that is kept; Right by default.
        """
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
class ContourDistanceFilter(ProcessObject):
    """
    Distances between two contours.
    """
    def GetChamfer(self) -> float:
        """
        Average of the two means, px.
        """
    def GetDistance(self) -> ContourPointDistance:
        """
        Returns how the distance of a point is measured: PointToPoint (the default, the paper's) or PointToSegment.
        """
    def GetFixedToMovingDistances(self) -> numpy.typing.NDArray[typing.Any]:
        """
        One a point, px; NaN for points of weight 0.
        """
    def GetFixedToMovingDistancesByTooth(self) -> dict[str, typing.Any]:
        """
        {"UR1": {"count", "mean", "rms", "maximum"}}, px: how far the fixed contour's drawing of each tooth lies from the moving contour, over its points that count; "" for those without a code.
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
        """
        Sets how the distance of a point, in pixels, is measured: PointToPoint (the default, the paper's) or PointToSegment.
        """
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
        """
        Returns the length of a gap in the tracing below which it has no ends there, pixels; 8 by default.
        """
    def GetLargestDistance(self) -> float:
        """
        px.
        """
    def GetMaximumDistance(self) -> float:
        """
        Returns the distance beyond which contours do not lie together, pixels; 5 by default.
        """
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
        """
        Sets the length of a gap in the tracing below which it has no ends there, pixels; 8 by default.
        """
    def SetMaximumDistance(self, value: float) -> None:
        """
        Sets the distance beyond which contours do not lie together, pixels; 5 by default.
        """
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
        """
        The value as a number.
        """
class ContourToContourMetricv4:
    """
    A figure of merit between two contours, for SetMetric().
    """
    def GetName(self) -> str:
        """
        Name of the class in C++.
        """
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
        """
        Returns which contour's points are measured: Symmetric (both, the default), MovingToFixed or FixedToMoving.
        """
    def GetDistance(self) -> ContourPointDistance:
        """
        Returns how the distance of a point is measured: PointToPoint (the default, the paper's) or PointToSegment.
        """
    def GetTruncation(self) -> float:
        """
        Returns the distance that all larger ones count as, pixels; infinity by default.
        """
    def SetDirection(self, direction: ContourDirection | str) -> None:
        """
        Sets which contour's points are measured: Symmetric (both, the default), MovingToFixed or FixedToMoving.
        """
    def SetDistance(self, distance: ContourPointDistance | str) -> None:
        """
        Sets how the distance of a point, in pixels, is measured: PointToPoint (the default, the paper's) or PointToSegment.
        """
    def SetTruncation(self, value: float) -> None:
        """
        Sets the distance that all larger ones count as, pixels; infinity by default.
        """
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
    def __copy__(self) -> RegistrationLevel:
        ...
    def __deepcopy__(self, memo: dict[str, typing.Any]) -> RegistrationLevel:
        ...
    def __getstate__(self) -> tuple[typing.Any, ...]:
        ...
    def __init__(self, scaleBound: float = 0.35, rotationBound: float = 0.0, translationBound: float = 0.0, numberOfScales: int = 0, numberOfRotations: int = 0, numberOfTranslations: int = 0, numberOfStarts: int = 1, numberOfIterations: int = 0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple[typing.Any, ...]) -> None:
        ...
    @property
    def numberOfIterations(self) -> int:
        """
        The most iterations of the optimizer from a start; 0 leaves the optimizer's own limit.
        """
    @numberOfIterations.setter
    def numberOfIterations(self, arg0: int) -> None:
        ...
    @property
    def numberOfRotations(self) -> int:
        """
        How many angles within the bound are tried before the optimizer runs; 0 is none.
        """
    @numberOfRotations.setter
    def numberOfRotations(self, arg0: int) -> None:
        ...
    @property
    def numberOfScales(self) -> int:
        """
        How many scales within the bound are tried before the optimizer runs; 0 is none.
        """
    @numberOfScales.setter
    def numberOfScales(self, arg0: int) -> None:
        ...
    @property
    def numberOfStarts(self) -> int:
        """
        How many of the best places are refined.
        """
    @numberOfStarts.setter
    def numberOfStarts(self, arg0: int) -> None:
        ...
    @property
    def numberOfTranslations(self) -> int:
        """
        How many shifts an axis within the bound are tried before the optimizer runs; 0 is none.
        """
    @numberOfTranslations.setter
    def numberOfTranslations(self, arg0: int) -> None:
        ...
    @property
    def rotationBound(self) -> float:
        """
        How far the angle may move from the current one, rad.
        """
    @rotationBound.setter
    def rotationBound(self, arg0: float) -> None:
        ...
    @property
    def scaleBound(self) -> float:
        """
        How far the scale may move, as a part of the current one, in [0, 1): 0.35 allows 0.65 to 1.35 times it.
        """
    @scaleBound.setter
    def scaleBound(self, arg0: float) -> None:
        ...
    @property
    def translationBound(self) -> float:
        """
        How far the silhouette's centroid may move in u and in v, mm in the plane of the pixel spacing.
        """
    @translationBound.setter
    def translationBound(self, arg0: float) -> None:
        ...
class RegistrationLevelResult:
    """
    How a level went.
    """
    def __repr__(self) -> str:
        ...
    @property
    def boundsHit(self) -> list[int]:
        """
        Of scale, rotation, shift in u and in v: -1 where the result lies on the lower bound, 1 on the upper, else 0.
        """
    @property
    def finalParameters(self) -> list[float]:
        """
        Parameters at which the level ended: scale, angle (rad), shift (pixels).
        """
    @property
    def finalValue(self) -> float:
        """
        Value of the metric at the end.
        """
    @property
    def initialParameters(self) -> list[float]:
        """
        Parameters at which the level began: scale, angle (rad), shift (pixels).
        """
    @property
    def initialValue(self) -> float:
        """
        Value of the metric at the beginning.
        """
    @property
    def numberOfCandidates(self) -> int:
        """
        How many places the exploration tried.
        """
    @property
    def numberOfEvaluations(self) -> int:
        """
        How many times the metric was evaluated.
        """
    @property
    def numberOfIterations(self) -> int:
        """
        How many iterations the optimizer needed.
        """
    @property
    def stopConditionDescription(self) -> str:
        """
        Why the optimizer ended, in words.
        """
class SilhouetteToContourRegistrationMethod(ProcessObject):
    """
    Aligns a silhouette with a tracing by a 2-D similarity.
    """
    @staticmethod
    def _ComputeBoundingBoxTransform(fixed: Contour, moving: Contour) -> Similarity2DTransform:
        ...
    def FixRotationOff(self) -> None:
        """
        The same as SetFixRotation(False). It sets whether the angle of the start is held. Off by default.
        """
    def FixRotationOn(self) -> None:
        """
        The same as SetFixRotation(True). It sets whether the angle of the start is held. Off by default.
        """
    def FixScaleOff(self) -> None:
        """
        The same as SetFixScale(False). It sets whether the scale of the start is held. Off by default.
        """
    def FixScaleOn(self) -> None:
        """
        The same as SetFixScale(True). It sets whether the scale of the start is held. Off by default.
        """
    def FixTranslationOff(self) -> None:
        """
        The same as SetFixTranslation(False). It sets whether the translation of the start is held. Off by default.
        """
    def FixTranslationOn(self) -> None:
        """
        The same as SetFixTranslation(True). It sets whether the translation of the start is held. Off by default.
        """
    def GetCurrentLevel(self) -> int:
        """
        0 is the coarsest.
        """
    def GetFixRotation(self) -> bool:
        """
        Returns whether the angle of the start is held. Off by default.
        """
    def GetFixScale(self) -> bool:
        """
        Returns whether the scale of the start is held. Off by default.
        """
    def GetFixTranslation(self) -> bool:
        """
        Returns whether the translation of the start is held. Off by default.
        """
    def GetInitialParameters(self) -> tuple[typing.Any, ...]:
        """
        The start (scale, rad, px, px).
        """
    def GetLevel(self, index: int) -> RegistrationLevel:
        """
        Bounds and effort of a level by its number, from 0.
        """
    def GetLevelResults(self) -> list[RegistrationLevelResult]:
        """
        How the levels went, after Execute().
        """
    def GetMetricValue(self) -> float:
        """
        Value of the metric at the current iteration, pixels for the chamfer metrics.
        """
    def GetNumberOfLevels(self) -> int:
        """
        Returns the number of levels; 3 by default, and 0 gives the start itself. A level that is added has half the bounds of the one before.
        """
    def GetOptimizerIteration(self) -> int:
        """
        Number of the current iteration, from 0.
        """
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        """
        Why the optimizer ended, in words.
        """
    def GetPixelSpacing(self) -> float:
        """
        Pixel spacing of the fixed contour (mean of u and v), mm; 0.25 by default. It turns the bounds on the shift into pixels.
        """
    def GetRandomSeed(self) -> int:
        """
        Returns the seed that the evolutionary optimizer gets at each run; the others draw nothing.
        """
    def SetFixRotation(self, value: bool) -> None:
        """
        Sets whether the angle of the start is held. Off by default.
        """
    def SetFixScale(self, value: bool) -> None:
        """
        Sets whether the scale of the start is held. Off by default.
        """
    def SetFixTranslation(self, value: bool) -> None:
        """
        Sets whether the translation of the start is held. Off by default.
        """
    def SetLevel(self, index: int, level: RegistrationLevel) -> None:
        """
        Sets bounds and effort of a level by its number, from 0.
        """
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
        """
        Measures the mean distance of each contour's points from the other contour, pixels.
        """
    def SetNumberOfLevels(self, number: int) -> None:
        """
        Sets the number of levels; 3 by default, and 0 gives the start itself. A level that is added has half the bounds of the one before.
        """
    def SetOptimizerAsAmoeba(self, simplexDelta: float = 0.0, numberOfIterations: int = 500, parametersConvergenceTolerance: float = 1e-08, functionConvergenceTolerance: float = 0.0001, withRestarts: bool = False) -> None:
        """
        simplexDelta 0: a quarter of the level's bounds.
        """
    def SetOptimizerAsExhaustive(self, numberOfSteps: typing.Sequence[int], stepLength: float = 1.0) -> None:
        """
        Steps to each side in scale, rotation, u and v: the grid reaches the level's bounds.
        """
    def SetOptimizerAsGradientDescent(self, learningRate: float, numberOfIterations: int, convergenceMinimumValue: float = 1e-06, convergenceWindowSize: int = 10) -> None:
        """
        Optimizes with ITK's GradientDescentOptimizerv4. The parameters are ITK's.
        """
    def SetOptimizerAsGradientDescentLineSearch(self, learningRate: float, numberOfIterations: int, convergenceMinimumValue: float = 1e-06, convergenceWindowSize: int = 10, lineSearchLowerLimit: float = 0.0, lineSearchUpperLimit: float = 5.0, lineSearchEpsilon: float = 0.01, lineSearchMaximumIterations: int = 20) -> None:
        """
        Optimizes with ITK's GradientDescentLineSearchOptimizerv4. The parameters are ITK's.
        """
    def SetOptimizerAsLBFGS2(self, solutionAccuracy: float = 1e-05, numberOfIterations: int = 100, hessianApproximateAccuracy: int = 6, deltaConvergenceDistance: int = 0, deltaConvergenceTolerance: float = 1e-05, lineSearchMaximumEvaluations: int = 40) -> None:
        """
        Optimizes with ITK's LBFGS2Optimizerv4, a quasi-Newton method without bounds. The parameters are ITK's.
        """
    def SetOptimizerAsLBFGSB(self, gradientConvergenceTolerance: float = 1e-05, numberOfIterations: int = 500, maximumNumberOfCorrections: int = 5, maximumNumberOfFunctionEvaluations: int = 2000, costFunctionConvergenceFactor: float = 10000000.0) -> None:
        """
        Optimizes with ITK's LBFGSBOptimizerv4, a quasi-Newton method within bounds. The parameters are ITK's.
        """
    def SetOptimizerAsOnePlusOneEvolutionary(self, numberOfIterations: int = 100, epsilon: float = 0.00015, initialRadius: float = 1.01, growthFactor: float = 0.0, shrinkFactor: float = 0.0, seed: int = 0) -> None:
        """
        The seed is recorded: the same seed, the same result.
        """
    def SetOptimizerAsPowell(self, numberOfIterations: int = 100, maximumLineIterations: int = 100, stepLength: float = 1.0, stepTolerance: float = 1e-06, valueTolerance: float = 1e-06) -> None:
        """
        Optimizes with ITK's PowellOptimizerv4, which needs no derivatives. The parameters are ITK's.
        """
    def SetOptimizerAsRegularStepGradientDescent(self, learningRate: float, minStep: float, numberOfIterations: int, relaxationFactor: float = 0.5, gradientMagnitudeTolerance: float = 0.0001) -> None:
        """
        Optimizes with ITK's RegularStepGradientDescentOptimizerv4. The parameters are ITK's.
        """
    def SetPixelSpacing(self, spacing: float) -> None:
        """
        mm, mean of u and v.
        """
    def SetPresetToBoundingBox(self) -> None:
        """
        Takes all levels away: the start from bounding box and centroid is the result.
        """
    def SetPresetToGlobal(self) -> None:
        """
        Sets two levels for a start that is far off: scale 50 %, rotation 45 degrees, shift 15 mm, of which the first explores all.
        """
    def SetPresetToPaper(self) -> None:
        """
        Sets the paper's three levels, the default: scale 35, 10 and 3 %, rotation 20, 6 and 2 degrees, shift 15, 3.75 and 1 mm.
        """
    def SetPresetToSingleStage(self) -> None:
        """
        Sets one level with the broad bounds and 80 iterations that does not explore: the paper's "w/o coarse-to-fine".
        """
    def SetRandomSeed(self, value: int) -> None:
        """
        Sets the seed that the evolutionary optimizer gets at each run; the others draw nothing.
        """
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
        """
        The value as a number.
        """
class IterativeClosestPointContourRegistrationMethod(ProcessObject):
    """
    Iterative closest points between two contours.
    """
    def GetCurrentLevel(self) -> int:
        """
        0 is the coarsest.
        """
    def GetDirection(self) -> ContourDirection:
        """
        Returns whose points look for their nearest: FixedToMoving (the default), MovingToFixed or Symmetric.
        """
    def GetInitialParameters(self) -> tuple[typing.Any, ...]:
        """
        The start (scale, rad, px, px).
        """
    def GetMaximumNumberOfIterations(self) -> int:
        """
        Returns the most iterations of a run.
        """
    def GetMetricValue(self) -> float:
        """
        Value of the metric at the current iteration, pixels for the chamfer metrics.
        """
    def GetMotion(self) -> Motion:
        """
        Returns what may move: Rigid (shift and angle) or Similarity (the default, and scale).
        """
    def GetOptimizerIteration(self) -> int:
        """
        Number of the current iteration, from 0.
        """
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        """
        Why the optimizer ended, in words.
        """
    def GetTolerance(self) -> float:
        """
        Returns the move below which it ends, pixels of the fixed contour; 1e-4 by default.
        """
    def GetTrimmedFraction(self) -> float:
        """
        Returns the share of the pairs that is left out, in [0, 0.9]; 0 by default, which is plain ICP.
        """
    def SetDirection(self, direction: ContourDirection | str) -> None:
        """
        Sets whose points look for their nearest: FixedToMoving (the default), MovingToFixed or Symmetric.
        """
    def SetMaximumNumberOfIterations(self, value: int) -> None:
        """
        Sets the most iterations of a run.
        """
    def SetMotion(self, motion: Motion | str) -> None:
        """
        Sets what may move: Rigid (shift and angle) or Similarity (the default, and scale).
        """
    def SetTolerance(self, value: float) -> None:
        """
        Sets the move below which it ends, pixels of the fixed contour; 1e-4 by default.
        """
    def SetTrimmedFraction(self, value: float) -> None:
        """
        Sets the share of the pairs that is left out, in [0, 0.9]; 0 by default, which is plain ICP.
        """
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
        """
        Returns the most iterations of a run.
        """
    def GetMetricValue(self) -> float:
        """
        Value of the metric at the current iteration, pixels for the chamfer metrics.
        """
    def GetMotion(self) -> Motion:
        """
        Returns what may move: Rigid (shift and angle) or Similarity (the default, and scale).
        """
    def GetOptimizerIteration(self) -> int:
        """
        Number of the current iteration, from 0.
        """
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        """
        Why the optimizer ended, in words.
        """
    def GetOutlierWeight(self) -> float:
        """
        Returns the share of points that belong to nothing, in [0, 0.99]; 0 by default.
        """
    def GetTolerance(self) -> float:
        """
        Returns the move below which it ends, pixels of the fixed contour; 1e-3 by default.
        """
    def SetMaximumNumberOfIterations(self, value: int) -> None:
        """
        Sets the most iterations of a run.
        """
    def SetMotion(self, motion: Motion | str) -> None:
        """
        Sets what may move: Rigid (shift and angle) or Similarity (the default, and scale).
        """
    def SetOutlierWeight(self, value: float) -> None:
        """
        Sets the share of points that belong to nothing, in [0, 0.99]; 0 by default.
        """
    def SetTolerance(self, value: float) -> None:
        """
        Sets the move below which it ends, pixels of the fixed contour; 1e-3 by default.
        """
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
        """
        The value as a number.
        """
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
        """
        Returns the free border of the region of interest, as a part of the tracing's larger extent; 0.15 by default.
        """
    def GetMaximumNumberOfIterations(self) -> int:
        """
        Returns the most iterations of a run.
        """
    def GetMeasure(self) -> IntensityMeasure:
        """
        Returns the measure of likeness of the two images; MutualInformation by default.
        """
    def GetMetricValue(self) -> float:
        """
        Value of the metric at the current iteration, pixels for the chamfer metrics.
        """
    def GetMotion(self) -> Motion:
        """
        Returns what may move: Rigid (shift and angle) or Similarity (the default, and scale).
        """
    def GetOptimizerIteration(self) -> int:
        """
        Number of the current iteration, from 0.
        """
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        Parameters of the transform: (scale, rad, px, px).
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        """
        Why the optimizer ended, in words.
        """
    def SetMargin(self, value: float) -> None:
        """
        Sets the free border of the region of interest, as a part of the tracing's larger extent; 0.15 by default.
        """
    def SetMaximumNumberOfIterations(self, value: int) -> None:
        """
        Sets the most iterations of a run.
        """
    def SetMeasure(self, measure: IntensityMeasure | str) -> None:
        """
        Sets the measure of likeness of the two images; MutualInformation by default.
        """
    def SetMotion(self, motion: Motion | str) -> None:
        """
        Sets what may move: Rigid (shift and angle) or Similarity (the default, and scale).
        """
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
        """
        Whether an optimizer may move it.
        """
    @property
    def maximumStep(self) -> float:
        """
        The longest step that an optimizer should take, in the natural unit; 0 is any.
        """
    @property
    def name(self) -> str:
        """
        Name of the parameter.
        """
    @property
    def scale(self) -> float:
        """
        How many of the optimizer's units there are in one natural unit: the lever arm of an angle in mm, 1 of a length.
        """
    @property
    def value(self) -> float:
        """
        Its value, in its natural unit: mm, rad or none.
        """
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
        """
        Name of the block.
        """
    @property
    def parameters(self) -> list[StateParameter]:
        """
        Its parameters in their order, a list of StateParameter.
        """
class PoseStateBlocks:
    """
    The blocks that the metrics of a pose read. ``Arm`` is the length that an angle is multiplied by, mm.
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
        """
        Name of the class in C++.
        """
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
        """
        Name of the class in C++.
        """
class CorrelatedNoiseModel(ResidualNoiseModel):
    """
    The hand drifts smoothly along a tracing; length 0 is independent errors.
    """
    def GetCorrelationLength(self) -> float:
        """
        Returns the length along the tracing over which its errors hang together, in pixels of 0.25 mm; 14 by default, 0 is independent.
        """
    def SetCorrelationLength(self, value: float) -> None:
        """
        Sets the length along the tracing over which its errors hang together, in pixels of 0.25 mm; 14 by default, 0 is independent.
        """
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
        """
        The value as a number.
        """
class MetricJoins:
    """
    From when on a registration evaluates a term: the search for where to begin, the first steps from each start, the last refinement.

    Members:

      Start

      Candidates

      Refinement
    """
    Candidates: typing.ClassVar[MetricJoins]
    Refinement: typing.ClassVar[MetricJoins]
    Start: typing.ClassVar[MetricJoins]
    __members__: typing.ClassVar[dict[str, MetricJoins]]
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
        """
        The value as a number.
        """
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
        """
        Values of a block by its name, natural units.
        """
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
    def GetJoins(self) -> MetricJoins:
        """
        Returns from when on a registration evaluates this term.
        """
    def GetName(self) -> str:
        """
        Name of the class in C++.
        """
    def GetNoiseLevels(self) -> typing.Any:
        """
        (smooth, white), or None where no term has such noise.
        """
    def GetNumberOfParameters(self) -> int:
        """
        The free ones.
        """
    def GetNumberOfResiduals(self) -> int:
        """
        How many residuals the metric has at the current values.
        """
    def GetParameters(self) -> numpy.typing.NDArray[typing.Any]:
        """
        The free parameters, in the optimizer's unit.
        """
    def GetResiduals(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (N,): divided by their standard deviations.
        """
    def GetResidualsAndJacobian(self) -> tuple[typing.Any, ...]:
        """
        (N,) and (N, M): by the optimizer's parameters, plus sign.
        """
    def GetValue(self) -> float:
        """
        What is minimized, at the current values.
        """
    def GetValueAndDerivative(self) -> tuple[typing.Any, ...]:
        """
        The value and its derivatives by the free parameters, at the current values.
        """
    def GetValues(self) -> numpy.typing.NDArray[typing.Any]:
        """
        Of all blocks, one behind the other.
        """
    def Hold(self, what: MetricHold | str) -> None:
        """
        Says what stays as it is at the current values while the parameters move: Nothing, Contours or Matches.
        """
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
        """
        Sets which parameters of a block an optimizer may move.
        """
    @typing.overload
    def SetBlockFree(self, block: str, isFree: bool) -> None:
        """
        Whether an optimizer may move the block's parameters, all alike or one by one.
        """
    def SetBlockValues(self, block: str, values: typing.Sequence[float]) -> None:
        """
        Sets the values of a block by its name, natural units. Initialize() keeps them.
        """
    def SetJoins(self, joins: MetricJoins | str) -> None:
        """
        Sets from when on a registration evaluates this term (MetricJoins): Start by default.
        """
    def SetKernelWidth(self, width: float) -> None:
        """
        Of the robust kernel, px of 0.25 mm.
        """
    def SetNoiseLevels(self, smooth: float, white: float) -> None:
        """
        Standard deviations of the drift along a tracing and of each point, px of 0.25 mm.
        """
    def SetNoiseModel(self, model: ResidualNoiseModel) -> None:
        """
        Sets the model of the noise of every term that has one.
        """
    def SetParameters(self, parameters: typing.Sequence[float]) -> None:
        """
        Sets the free parameters, in the optimizer's unit.
        """
    def SetRobustKernel(self, kernel: RobustKernel) -> None:
        """
        Sets the robust kernel of every term that has one; widths are in pixels of 0.25 mm.
        """
    def SetValues(self, values: typing.Sequence[float]) -> None:
        """
        Sets the values of all blocks, one behind the other, natural units.
        """
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
        """
        The value as a number.
        """
class _LeastSquaresMetric(LeastSquaresMetricv4):
    """
    What a metric written in Python stands on.
    """
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
        """
        A term of the sum by its number.
        """
    def GetNumberOfMetrics(self) -> int:
        """
        How many terms the sum has.
        """
    def RemoveMetric(self, metric: LeastSquaresMetricv4) -> None:
        """
        Takes a term out of the sum.
        """
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
        """
        Degrees of freedom of Student's t distribution; infinite for a normal one.
        """
    @property
    def mean(self) -> float:
        """
        Mean, in the parameter's natural unit.
        """
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
        """
        Returns the name of the block whose parameters the priors hold for.
        """
    def GetPriors(self) -> list[ParameterPrior]:
        """
        The priors in the order of the block's parameters.
        """
    def GetUseVariancePrecision(self) -> bool:
        """
        Returns whether the curvature is that of the prior's variance, also where its long tails are flatter.
        """
    def SetBlock(self, block: StateBlock) -> None:
        """
        Sets the name of the block whose parameters the priors hold for.
        """
    def SetPriors(self, priors: typing.Sequence[ParameterPrior]) -> None:
        """
        One a parameter of the block.
        """
    def SetUseVariancePrecision(self, value: bool) -> None:
        """
        Sets whether the curvature is that of the prior's variance, also where its long tails are flatter.
        """
    def UseVariancePrecisionOff(self) -> None:
        """
        The same as SetUseVariancePrecision(False). It sets whether the curvature is that of the prior's variance, also where its long tails are flatter.
        """
    def UseVariancePrecisionOn(self) -> None:
        """
        The same as SetUseVariancePrecision(True). It sets whether the curvature is that of the prior's variance, also where its long tails are flatter.
        """
    def __init__(self) -> None:
        ...
class PoseMetricv4(LeastSquaresMetricv4):
    """
    Base of the terms whose residuals are those of a scan's pose on a radiograph.
    """
    def GetPoseBlock(self) -> str:
        """
        Name of the block of the pose.
        """
    def GetScaleBlock(self) -> str:
        """
        Name of the block of the scale.
        """
    def GetTransform(self) -> CephalometricPoseTransform:
        """
        The transform from the dental frame (mm) to pixels that the metric moves.
        """
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
        """
        Takes back all covariances.
        """
    def GetKernelWidthInSigmas(self) -> float:
        """
        Returns the width of the robust kernel in standard deviations; 4 by default.
        """
    def GetMatchedNames(self) -> list[str]:
        """
        In the order of the residuals, u and v each.
        """
    def GetSigma(self) -> float:
        """
        Returns the standard deviation an axis of marks without a covariance of their own, pixels of the radiograph; 4 by default.
        """
    def SetCovariance(self, name: str, covariance: numpy.typing.ArrayLike) -> None:
        """
        Of one mark, square pixels, instead of Sigma.
        """
    def SetKernelWidthInSigmas(self, value: float) -> None:
        """
        Sets the width of the robust kernel in standard deviations; 4 by default.
        """
    def SetSigma(self, value: float) -> None:
        """
        Sets the standard deviation an axis of marks without a covariance of their own, pixels of the radiograph; 4 by default.
        """
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
        """
        The same as SetGateByTooth(False). It sets whether a point that carries a tooth's code is matched with that tooth alone, or one up to ToothRange positions away. Off by default.
        """
    def GateByToothOn(self) -> None:
        """
        The same as SetGateByTooth(True). It sets whether a point that carries a tooth's code is matched with that tooth alone, or one up to ToothRange positions away. Off by default.
        """
    def GetExcludedTeeth(self) -> list[int]:
        """
        FDI numbers of the teeth that are left out.
        """
    def GetFailure(self) -> str:
        """
        Why the tracing can't be matched; empty where it can.
        """
    def GetFit(self) -> list[typing.Any]:
        """
        How well each strand of the tracing is explained, px of 0.25 mm.
        """
    def GetGapLength(self) -> float:
        """
        Returns the length of a gap in the tracing below which it has no ends there, pixels; 8 by default.
        """
    def GetGateByTooth(self) -> bool:
        """
        Returns whether a point that carries a tooth's code is matched with that tooth alone, or one up to ToothRange positions away. Off by default.
        """
    def GetJaw(self) -> Jaw:
        """
        Returns the jaw of the scan: Upper (the default) or Lower.
        """
    def GetKernelWidth(self) -> float:
        """
        Width of the robust kernel, pixels of 0.25 mm; 3 by default.
        """
    def GetMaximumTracingPoints(self) -> int:
        """
        Returns the number of points above which a tracing is thinned; 200 by default.
        """
    def GetMidlineMargin(self) -> float:
        """
        Returns how far beyond the midline plane the scan is kept, mm; -0.5 by default.
        """
    def GetOrientationWeight(self) -> float:
        """
        Returns the weight of directions, pixels a unit normal; 8 by default.
        """
    def GetReverseWeight(self) -> float:
        """
        Returns the weight of the direction from the outline to the tracing, beside the forward one; 0 by default.
        """
    def GetTaperLength(self) -> float:
        """
        Returns the length from an end of the tracing over which the reverse direction fades in, pixels; 6 by default.
        """
    def GetToothRange(self) -> int:
        """
        Returns the number of positions along the arch that a code may be off, under GateByTooth; 1 by default.
        """
    def GetTracedSide(self) -> TracedSide:
        """
        Returns the patient's side whose outline was traced; Right by default.
        """
    def GetUseFacingFilter(self) -> bool:
        """
        Returns whether the occlusal and anterior part of the outline alone is kept. On by default.
        """
    def GetUseOrientation(self) -> bool:
        """
        Returns whether directions are matched beside positions. On by default.
        """
    def GetUseSideSelection(self) -> bool:
        """
        Returns whether the scan is cut at the midline plane. On by default.
        """
    def SetExcludedTeeth(self, teeth: typing.Sequence[int]) -> None:
        """
        FDI numbers.
        """
    def SetGapLength(self, value: float) -> None:
        """
        Sets the length of a gap in the tracing below which it has no ends there, pixels; 8 by default.
        """
    def SetGateByTooth(self, value: bool) -> None:
        """
        Sets whether a point that carries a tooth's code is matched with that tooth alone, or one up to ToothRange positions away. Off by default.
        """
    def SetJaw(self, jaw: Jaw | str) -> None:
        """
        Sets the jaw of the scan: Upper (the default) or Lower.
        """
    def SetMaximumTracingPoints(self, value: int) -> None:
        """
        Sets the number of points above which a tracing is thinned; 200 by default.
        """
    def SetMidlineMargin(self, value: float) -> None:
        """
        Sets how far beyond the midline plane the scan is kept, mm; -0.5 by default.
        """
    def SetOrientationWeight(self, value: float) -> None:
        """
        Sets the weight of directions, pixels a unit normal; 8 by default.
        """
    def SetReverseWeight(self, value: float) -> None:
        """
        Sets the weight of the direction from the outline to the tracing, beside the forward one; 0 by default.
        """
    def SetTaperLength(self, value: float) -> None:
        """
        Sets the length from an end of the tracing over which the reverse direction fades in, pixels; 6 by default.
        """
    def SetToothRange(self, value: int) -> None:
        """
        Sets the number of positions along the arch that a code may be off, under GateByTooth; 1 by default.
        """
    def SetTracedSide(self, side: TracedSide | str) -> None:
        """
        Sets the patient's side whose outline was traced; Right by default.
        """
    def SetUseFacingFilter(self, value: bool) -> None:
        """
        Sets whether the occlusal and anterior part of the outline alone is kept. On by default.
        """
    def SetUseOrientation(self, value: bool) -> None:
        """
        Sets whether directions are matched beside positions. On by default.
        """
    def SetUseSideSelection(self, value: bool) -> None:
        """
        Sets whether the scan is cut at the midline plane. On by default.
        """
    def UseFacingFilterOff(self) -> None:
        """
        The same as SetUseFacingFilter(False). It sets whether the occlusal and anterior part of the outline alone is kept. On by default.
        """
    def UseFacingFilterOn(self) -> None:
        """
        The same as SetUseFacingFilter(True). It sets whether the occlusal and anterior part of the outline alone is kept. On by default.
        """
    def UseOrientationOff(self) -> None:
        """
        The same as SetUseOrientation(False). It sets whether directions are matched beside positions. On by default.
        """
    def UseOrientationOn(self) -> None:
        """
        The same as SetUseOrientation(True). It sets whether directions are matched beside positions. On by default.
        """
    def UseSideSelectionOff(self) -> None:
        """
        The same as SetUseSideSelection(False). It sets whether the scan is cut at the midline plane. On by default.
        """
    def UseSideSelectionOn(self) -> None:
        """
        The same as SetUseSideSelection(True). It sets whether the scan is cut at the midline plane. On by default.
        """
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingContour(self, contour: Contour | None) -> None:
        ...
    def _SetMovingMesh(self, mesh: Mesh | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class ToothOutlineErrors:
    """
    What hands get wrong of a tooth, standard deviations.
    """
    def __init__(self) -> None:
        ...
    @property
    def across(self) -> float:
        """
        Of its place across the occlusal plane, mm on the detector.
        """
    @across.setter
    def across(self, arg0: float) -> None:
        ...
    @property
    def along(self) -> float:
        """
        Of its place along the occlusal plane, mm on the detector.
        """
    @along.setter
    def along(self, arg0: float) -> None:
        ...
    @property
    def drift(self) -> float:
        """
        Of the line, correlated along it, px of 0.25 mm.
        """
    @drift.setter
    def drift(self, arg0: float) -> None:
        ...
    @property
    def frontalJitter(self) -> float:
        """
        Each point's own on a frontal radiograph, px of 0.25 mm.
        """
    @frontalJitter.setter
    def frontalJitter(self, arg0: float) -> None:
        ...
    @property
    def jitter(self) -> float:
        """
        Each point's own, px of 0.25 mm.
        """
    @jitter.setter
    def jitter(self, arg0: float) -> None:
        ...
    @property
    def lingual(self) -> float:
        """
        How far the inner side lies beside the edge, mm on the detector.
        """
    @lingual.setter
    def lingual(self, arg0: float) -> None:
        ...
    @property
    def size(self) -> float:
        """
        Of a hand that draws the tooth: a share of its size.
        """
    @size.setter
    def size(self, arg0: float) -> None:
        ...
    @property
    def templateSize(self) -> float:
        """
        Of a stock template: a share of its size.
        """
    @templateSize.setter
    def templateSize(self, arg0: float) -> None:
        ...
    @property
    def templateTurn(self) -> float:
        """
        Of a stock template: how far it is turned, rad.
        """
    @templateTurn.setter
    def templateTurn(self, arg0: float) -> None:
        ...
    @property
    def turn(self) -> float:
        """
        Of a hand that draws the tooth: how far it is turned, rad.
        """
    @turn.setter
    def turn(self, arg0: float) -> None:
        ...
class ToothOutlinePoseMetricv4(PoseMetricv4):
    """
    Crowns of a scan against outlines of whole teeth: a term of its pose.
    """
    def GetErrors(self) -> ToothOutlineErrors:
        """
        A copy: give it back to SetErrors().
        """
    def GetFailure(self) -> str:
        """
        Why no outline can be matched; empty where one can. Valid after Initialize(), which says it as an error.
        """
    def GetJaw(self) -> Jaw:
        """
        Returns the jaw of the scan: Upper (the default) or Lower.
        """
    def GetMaximumCutSigma(self) -> float:
        """
        Returns how far from where it was cut a crown may be, standard deviation along the arch, mm: others are left out; without a limit by default.
        """
    def GetOutlinedTeeth(self) -> list[str]:
        """
        Names of the teeth whose outlines are used. Valid after Initialize().
        """
    def GetUnused(self) -> dict[str, typing.Any]:
        """
        Outlines that are not used and why: name ("U6"; of a frontal radiograph "UR6") to a sentence.
        """
    def SetErrors(self, errors: ToothOutlineErrors) -> None:
        """
        What hands get wrong (ToothOutlineErrors).
        """
    def SetExcludedTeeth(self, teeth: typing.Sequence[int]) -> None:
        """
        FDI numbers of teeth to leave out.
        """
    def SetJaw(self, jaw: Jaw | str) -> None:
        """
        Sets the jaw of the scan: Upper (the default) or Lower.
        """
    def SetMarkedTeeth(self, teeth: typing.Sequence[str]) -> None:
        """
        Names of teeth whose landmarks are registered with as well: the two share a part of their error.
        """
    def SetMaximumCutSigma(self, value: float) -> None:
        """
        Sets how far from where it was cut a crown may be, standard deviation along the arch, mm: others are left out; without a limit by default.
        """
    def _GetOutlineResiduals(self) -> list[typing.Any]:
        ...
    def _SetCrowns(self, crowns: dict[str, typing.Any]) -> None:
        ...
    def _SetFixedContour(self, contour: Contour | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class ViewPoseMetricv4(LeastSquaresMetricv4):
    """
    A term of another view: the one that it holds, with the head where it was for that view.

    Reads the body's "pose", how the head was moved for the view, and the view's scale: blocks of 6, 6 and 1 parameters
    (GetBlocks()). Kernel, noise and matches are those of the term that it holds. Priors say how far the head may have
    moved: a ParameterPriorMetricv4 on the second block.
    """
    def GetTerm(self) -> PoseMetricv4:
        """
        The term that it holds.
        """
    def GetTermValues(self) -> numpy.typing.NDArray[typing.Any]:
        """
        Where the scan is in the view: pitch, roll, yaw (rad), tx, ty, tz (mm), kappa, by the values of the state.
        """
    def GetView(self) -> str:
        """
        Name of the view.
        """
    def SetTerm(self, term: PoseMetricv4) -> None:
        """
        The term with the view's radiograph, whose geometry is its transform's.
        """
    def SetView(self, name: str) -> None:
        """
        Name of the view, after which its blocks are named.
        """
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
        """
        The value as a number.
        """
class ObjectToObjectOptimizerBase:
    """
    An optimizer of ITK's v4 framework.
    """
    def GetName(self) -> str:
        """
        Name of the class in C++.
        """
    def GetStopConditionDescription(self) -> str:
        """
        Why the last run ended, in words.
        """
    def __str__(self) -> str:
        ...
class LevenbergMarquardtOptimizerv4(ObjectToObjectOptimizerBase):
    """
    Levenberg-Marquardt for metrics that are, or are majorised by, sums of squares.
    """
    def GetCurrentIteration(self) -> int:
        """
        How many steps were accepted in this or the last run.
        """
    def GetCurrentMetricValue(self) -> float:
        """
        There.
        """
    def GetCurrentPosition(self) -> numpy.typing.NDArray[typing.Any]:
        """
        The optimizer's parameters: the best so far in commands, the metric's outside of them.
        """
    def GetDamping(self) -> float:
        """
        The damping now or at the end of the last run.
        """
    def GetInitialDamping(self) -> float:
        """
        Returns the damping of the first step of a run; 0 by default, which is Gauss-Newton.
        """
    def GetMaximumNumberOfEvaluations(self) -> int:
        """
        Returns the most steps tried in a run, accepted or not; 1000 by default.
        """
    def GetNumberOfEvaluations(self) -> int:
        """
        How many steps were tried in this or the last run.
        """
    def GetNumberOfIterations(self) -> int:
        """
        The most steps accepted in a run; 100 by default.
        """
    def GetStepAccepted(self) -> bool:
        """
        Whether the last step tried lowered the value.
        """
    def GetStepLength(self) -> float:
        """
        In the metric's own unit.
        """
    def GetStepTolerance(self) -> float:
        """
        Returns the length of step below which a run ends, in the metric's own unit of step length (pixels); 1e-6 by default.
        """
    def GetStopCondition(self) -> StopCondition:
        """
        Why the last run ended.
        """
    def GetTrialValue(self) -> float:
        """
        Where the last step was tried.
        """
    def GetValueTolerance(self) -> float:
        """
        Returns the part of the value below which an accepted step ends a run; 1e-8 by default, 0 is never.
        """
    def HasConverged(self) -> bool:
        """
        Whether the last run ended by one of the two tolerances.
        """
    def SetInitialDamping(self, value: float) -> None:
        """
        Sets the damping of the first step of a run; 0 by default, which is Gauss-Newton.
        """
    def SetMaximumNumberOfEvaluations(self, value: int) -> None:
        """
        Sets the most steps tried in a run, accepted or not; 1000 by default.
        """
    def SetMetric(self, metric: LeastSquaresMetricv4) -> None:
        """
        Sets the sum of squares that is minimized.
        """
    def SetNumberOfIterations(self, value: int) -> None:
        """
        Most steps that are accepted.
        """
    def SetStepTolerance(self, value: float) -> None:
        """
        Sets the length of step below which a run ends, in the metric's own unit of step length (pixels); 1e-6 by default.
        """
    def SetValueTolerance(self, value: float) -> None:
        """
        Sets the part of the value below which an accepted step ends a run; 1e-8 by default, 0 is never.
        """
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
        """
        The value as a number.
        """
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
        """
        Number of the candidate that is refined, from 0.
        """
    @property
    def iteration(self) -> int:
        """
        Number of the iteration, from 0.
        """
    @property
    def kind(self) -> RegistrationEventKind:
        """
        What the record is of: a start, an iteration or an end.
        """
    @property
    def level(self) -> int:
        """
        Number of the level, from 0.
        """
    @property
    def parameters(self) -> numpy.typing.NDArray[typing.Any]:
        """
        The parameters, as the registration reports them.
        """
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
        """
        Every how many iterations a line is written; 1 by default. All are recorded.
        """
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
        """
        The value as a number.
        """
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
        """
        The damping of the step.
        """
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
        """
        The free parameters as an optimizer sees them.
        """
    @property
    def smoothNoise(self) -> float:
        """
        Standard deviation of the tracer's drift, px of 0.25 mm.
        """
    @property
    def stage(self) -> PoseStage:
        """
        The part of the registration that runs.
        """
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
        """
        What tooth codes that do not fit add to the cost.
        """
    @property
    def cost(self) -> float:
        """
        Robust cost at a fixed kernel width, without the code term; no unit.
        """
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
    def headMove(self) -> float:
        """
        How far its best candidate moves the head for a further view, the largest of turns and shifts in standard deviations of patients who are turned in the ear rods; 0 where nothing may be moved.
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
        """
        How many times the metric was evaluated.
        """
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
        """
        Score of a jaw's fit, by which minima are ranked: the cost at a fixed kernel width and the code term. It has no unit, and less is better.
        """
    def GetStatus(self, jaw: Jaw | str) -> str:
        """
        "ok", "suspect" or "failed" by the usual thresholds; RegistrationVerdict() has the reasons.
        """
    def GetStopConditionDescription(self, jaw: Jaw | str) -> str:
        """
        Why the optimizer ended, in words.
        """
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
        Returns the names of the views beside the first radiograph, in the order in which they were added.
        """
    def HasConverged(self, jaw: Jaw | str) -> bool:
        """
        Whether the optimizer ended by a tolerance.
        """
    def HasJaw(self, jaw: Jaw | str) -> bool:
        """
        Whether the jaw had a mesh and a contour.
        """
    def IsRegistered(self, jaw: Jaw | str) -> bool:
        """
        Whether a jaw has a pose.
        """
    def MakeViewSolution(self, name: str) -> PoseSolution:
        """
        Returns the same solution as the view of that name shows it: its geometry takes points of a scan (mm) to pixels of that radiograph. Everything downstream takes it.
        """
    def ProjectPoint(self, jaw: Jaw | str, point: typing.Sequence[float]) -> tuple[float, float]:
        """
        Point of a jaw's scan (mm, in the frame of its mesh) to the continuous pixel index (u, v).
        """
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
        """
        Name of the class in C++.
        """
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
        """
        By how many quarter turns, clockwise as it is seen, the drawing is turned back.
        """
    def SetQuarterTurns(self, turns: int) -> None:
        """
        1, 2 or 3, clockwise.
        """
    def __init__(self) -> None:
        ...
class UpwardDrawingHypothesis(PoseHypothesis):
    """
    The rows of the drawing were counted from below: above and below are exchanged, the scale is free.
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
        """
        Returns half the range of horizontal shifts of the contour's centre from the tracing's, pixels; 64 by default.
        """
    def GetKappas(self) -> list[float]:
        """
        Logarithms of the scale factors that are tried where the scale is searched.
        """
    def GetRotationRange(self) -> float:
        """
        Returns half the range of rotations that are tried, rad; 0.559 by default (32 degrees).
        """
    def GetRotationStep(self) -> float:
        """
        Returns the step between rotations, rad; 0.070 by default (4 degrees).
        """
    def GetShiftStep(self) -> float:
        """
        Returns the step between shifts, pixels; 8 by default.
        """
    def GetVerticalRange(self) -> float:
        """
        Returns half the range of vertical shifts of the contour's centre from the tracing's, pixels; 40 by default.
        """
    def SetHorizontalRange(self, value: float) -> None:
        """
        Sets half the range of horizontal shifts of the contour's centre from the tracing's, pixels; 64 by default.
        """
    def SetKappas(self, kappas: typing.Sequence[float]) -> None:
        """
        Logarithms of the scale factors that are tried where the scale is searched.
        """
    def SetRotationRange(self, value: float) -> None:
        """
        Sets half the range of rotations that are tried, rad; 0.559 by default (32 degrees).
        """
    def SetRotationStep(self, value: float) -> None:
        """
        Sets the step between rotations, rad; 0.070 by default (4 degrees).
        """
    def SetShiftStep(self, value: float) -> None:
        """
        Sets the step between shifts, pixels; 8 by default.
        """
    def SetVerticalRange(self, value: float) -> None:
        """
        Sets half the range of vertical shifts of the contour's centre from the tracing's, pixels; 40 by default.
        """
    def __init__(self) -> None:
        ...
class PoseRegistrationMethod(ProcessObject):
    """
    The robust registration.
    """
    def AddHypothesis(self, hypothesis: PoseHypothesis) -> None:
        """
        Adds another hypothesis of what the drawing may be, which is fitted too.
        """
    def AddMetric(self, metric: LeastSquaresMetricv4, jaw: Jaw | str = ...) -> None:
        """
        A further term of the sum that is minimized: a LeastSquaresMetric of your own, a prior, another sum.

        It may read the blocks "pose" and "scale", which are those of the dental frame, or have blocks of its own. Jaws that
        stand apart have a sum each: with a jaw it is a term of that jaw's alone. Its robust kernel and noise stay its own. The
        registration works on clones of it.
        """
    def ClearHypotheses(self) -> None:
        """
        Takes all hypotheses out.
        """
    def ClearInitialTransforms(self) -> None:
        """
        Back to a search.
        """
    def ClearMetrics(self) -> None:
        """
        Takes all terms of one's own out.
        """
    def ClearSpacingSource(self) -> None:
        """
        Back to the option.
        """
    def ClearViews(self) -> None:
        """
        Removes all views: the lateral radiograph stands alone again.
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
        """
        How many levels a refinement has.
        """
    def GetOptimizer(self) -> ObjectToObjectOptimizerBase:
        """
        The optimizer.
        """
    def GetOptimizerIteration(self) -> int:
        """
        Steps that were accepted in this stage, of this candidate.
        """
    def GetOptimizerPosition(self) -> tuple[typing.Any, ...]:
        """
        pitch, roll, yaw (rad), tx, ty, tz (mm), kappa.
        """
    def GetOptimizerStopConditionDescription(self) -> str:
        """
        Why the optimizer ended, in words.
        """
    def GetOptions(self) -> PoseRegistrationOptions:
        """
        A copy.
        """
    def GetPrincipalPointKnown(self) -> bool:
        """
        Returns whether the geometry's principal point is known, not a guess.
        """
    def GetStepAccepted(self) -> bool:
        """
        Whether the last step tried lowered the value, within an iteration event.
        """
    def GetStepLength(self) -> float:
        """
        Root mean square, px of 0.25 mm.
        """
    def GetTracedSide(self) -> TracedSide:
        """
        Returns the patient's side whose outline was traced.
        """
    def PrincipalPointKnownOff(self) -> None:
        """
        The same as SetPrincipalPointKnown(False). It sets whether the geometry's principal point is known, not a guess.
        """
    def PrincipalPointKnownOn(self) -> None:
        """
        The same as SetPrincipalPointKnown(True). It sets whether the geometry's principal point is known, not a guess.
        """
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
        """
        Optimizes with ITK's LBFGS2Optimizerv4, a quasi-Newton method without bounds. The parameters are ITK's.
        """
    def SetOptimizerAsLBFGSB(self, gradientConvergenceTolerance: float = 1e-05, numberOfIterations: int = 500, maximumNumberOfCorrections: int = 5, maximumNumberOfFunctionEvaluations: int = 2000, costFunctionConvergenceFactor: float = 10000000.0) -> None:
        """
        Optimizes with ITK's LBFGSBOptimizerv4, a quasi-Newton method within bounds. The parameters are ITK's.
        """
    def SetOptions(self, options: PoseRegistrationOptions) -> None:
        """
        Sets all options at once.
        """
    def SetPrincipalPointKnown(self, value: bool) -> None:
        """
        Sets whether the geometry's principal point is known, not a guess.
        """
    def SetRobustKernel(self, kernel: RobustKernel | None) -> None:
        """
        Of the silhouettes; None: the options'.
        """
    def SetSpacingSource(self, source: SpacingSource | str) -> None:
        """
        Where the pixel spacing comes from: its prior of the scale takes the place of the option kappaSigma.
        """
    def SetStart(self, start: PoseStart) -> None:
        """
        Sets where the registration starts from.
        """
    def SetTracedSide(self, side: TracedSide | str) -> None:
        """
        Sets the patient's side whose outline was traced.
        """
    def _AddView(self, name: str, geometry: CephalometricGeometry | None, upperContour: Contour | None, lowerContour: Contour | None, landmarks: typing.Any, counterparts: typing.Any, sameHeadPosition: bool, principalPointSigma: float) -> None:
        ...
    def _GetSolution(self) -> PoseSolution:
        ...
    def _SetCephalometricLandmarks(self, landmarks: typing.Any) -> None:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetInitialGeometry(self, geometry: CephalometricGeometry | None) -> None:
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
    def _SetStockOutlines(self, outlines: Contour | None) -> None:
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
class ViewVerdictThresholds:
    """
    When a further view is suspect; standard deviations unless said.
    """
    def __init__(self) -> None:
        ...
    @property
    def landmarkApart(self) -> float:
        """
        Distance above which a landmark of the view is a gross error, standard deviations.
        """
    @landmarkApart.setter
    def landmarkApart(self, arg0: float) -> None:
        ...
    @property
    def suspectCost(self) -> float:
        """
        Robust cost of the view's tracing above which it is suspect, no unit.
        """
    @suspectCost.setter
    def suspectCost(self, arg0: float) -> None:
        ...
    @property
    def suspectDeviance(self) -> float:
        """
        Difference of the robust criterion below which the other reading of the view (sides, source) is named.
        """
    @suspectDeviance.setter
    def suspectDeviance(self, arg0: float) -> None:
        ...
    @property
    def suspectDevianceOfLandmark(self) -> float:
        """
        The same for each landmark that was let go, where most of what was drawn was.
        """
    @suspectDevianceOfLandmark.setter
    def suspectDevianceOfLandmark(self, arg0: float) -> None:
        ...
    @property
    def suspectDevianceOfOutline(self) -> float:
        """
        The same for each outline that was let go, where most of what was drawn was.
        """
    @suspectDevianceOfOutline.setter
    def suspectDevianceOfOutline(self, arg0: float) -> None:
        ...
    @property
    def suspectHeadMove(self) -> float:
        """
        And how far the head is moved then, standard deviations of patients who are turned in the ear rods.
        """
    @suspectHeadMove.setter
    def suspectHeadMove(self, arg0: float) -> None:
        ...
    @property
    def suspectLandmarkRatio(self) -> float:
        """
        Root mean square of the other landmarks' distances above which the view is suspect, standard deviations.
        """
    @suspectLandmarkRatio.setter
    def suspectLandmarkRatio(self, arg0: float) -> None:
        ...
    @property
    def suspectMoveDeviance(self) -> float:
        """
        The same of a head that was turned between the radiographs and not said to be.
        """
    @suspectMoveDeviance.setter
    def suspectMoveDeviance(self, arg0: float) -> None:
        ...
    @property
    def suspectPriorTension(self) -> float:
        """
        Distance of move and scale from their priors above which the view is suspect, standard deviations.
        """
    @suspectPriorTension.setter
    def suspectPriorTension(self, arg0: float) -> None:
        ...
class RegistrationVerdictThresholds:
    """
    What is suspect and what has failed; px of 0.25 mm and mm.
    """
    def __init__(self) -> None:
        ...
    @property
    def biteMean(self) -> float:
        """
        Of jaws that marks placed each by itself: how far the cusps of upper and lower first molars stand apart on average, across the occlusal plane, mm.
        """
    @biteMean.setter
    def biteMean(self, arg0: float) -> None:
        ...
    @property
    def biteSigma(self) -> float:
        """
        Its standard deviation beside that of the poses, mm.
        """
    @biteSigma.setter
    def biteSigma(self, arg0: float) -> None:
        ...
    @property
    def borneOutCost(self) -> float:
        """
        Cost up to which a fit bears out a dental axis that was unsure, where roll and yaw are determined.
        """
    @borneOutCost.setter
    def borneOutCost(self, arg0: float) -> None:
        ...
    @property
    def borneOutInlierShare(self) -> float:
        """
        Share of its points within 4 pixels of 0.25 mm from which on it may, 0 to 1.
        """
    @borneOutInlierShare.setter
    def borneOutInlierShare(self, arg0: float) -> None:
        ...
    @property
    def borneOutMargin(self) -> float:
        """
        Margin from which on it does.
        """
    @borneOutMargin.setter
    def borneOutMargin(self, arg0: float) -> None:
        ...
    @property
    def borneOutOtherCost(self) -> float:
        """
        Cost up to which the other jaw's tracing does.
        """
    @borneOutOtherCost.setter
    def borneOutOtherCost(self, arg0: float) -> None:
        ...
    @property
    def borneOutPoorCost(self) -> float:
        """
        Cost up to which a tracing may fit poorly where the other jaw's bears the pose out.
        """
    @borneOutPoorCost.setter
    def borneOutPoorCost(self, arg0: float) -> None:
        ...
    @property
    def borneOutSmoothSigma(self) -> float:
        """
        Drift of both up to which it does, pixels of 0.25 mm, 1 sd.
        """
    @borneOutSmoothSigma.setter
    def borneOutSmoothSigma(self, arg0: float) -> None:
        ...
    @property
    def failedCost(self) -> float:
        """
        Robust cost above which a jaw has failed (no-fit), no unit.
        """
    @failedCost.setter
    def failedCost(self, arg0: float) -> None:
        ...
    @property
    def failedFilmLength(self) -> float:
        """
        Length of the radiograph above which it has failed, mm.
        """
    @failedFilmLength.setter
    def failedFilmLength(self, arg0: float) -> None:
        ...
    @property
    def failedInlierShare(self) -> float:
        """
        Share of the tracing within 4 px below which a jaw has failed, 0 to 1.
        """
    @failedInlierShare.setter
    def failedInlierShare(self, arg0: float) -> None:
        ...
    @property
    def failedPitch(self) -> float:
        """
        Pitch beyond which a patient stands on the head, rad.
        """
    @failedPitch.setter
    def failedPitch(self, arg0: float) -> None:
        ...
    @property
    def failedPredictedSigma(self) -> float:
        """
        Predicted standard deviation above which a jaw has failed (undetermined), pixels of 0.25 mm.
        """
    @failedPredictedSigma.setter
    def failedPredictedSigma(self, arg0: float) -> None:
        ...
    @property
    def hypothesisGain(self) -> float:
        """
        How much better the score of another hypothesis must be to be named.
        """
    @hypothesisGain.setter
    def hypothesisGain(self, arg0: float) -> None:
        ...
    @property
    def landmarkApart(self) -> float:
        """
        Distance of a landmark above which it is a gross error, standard deviations.
        """
    @landmarkApart.setter
    def landmarkApart(self, arg0: float) -> None:
        ...
    @property
    def maximumArchWidth(self) -> float:
        """
        Width above which an arch is no human's, mm.
        """
    @maximumArchWidth.setter
    def maximumArchWidth(self, arg0: float) -> None:
        ...
    @property
    def minimumArchWidth(self) -> float:
        """
        Width below which an arch is no human's, mm.
        """
    @minimumArchWidth.setter
    def minimumArchWidth(self, arg0: float) -> None:
        ...
    @property
    def shortestFilm(self) -> float:
        """
        Length below which a radiograph is no head's, mm.
        """
    @shortestFilm.setter
    def shortestFilm(self, arg0: float) -> None:
        ...
    @property
    def spacingDifference(self) -> float:
        """
        Logarithm of the ratio of two spacings from which on they differ.
        """
    @spacingDifference.setter
    def spacingDifference(self, arg0: float) -> None:
        ...
    @property
    def spacingScore(self) -> float:
        """
        Score up to which the drawing is said to fit with another pixel spacing.
        """
    @spacingScore.setter
    def spacingScore(self, arg0: float) -> None:
        ...
    @property
    def spacingShare(self) -> float:
        """
        Share of a tracing's score up to which another pixel spacing is suspect, 0 to 1.
        """
    @spacingShare.setter
    def spacingShare(self, arg0: float) -> None:
        ...
    @property
    def suspectBite(self) -> float:
        """
        Distance from that average above which the jaws do not bite, standard deviations.
        """
    @suspectBite.setter
    def suspectBite(self, arg0: float) -> None:
        ...
    @property
    def suspectCodeOffset(self) -> float:
        """
        Offset of tooth codes along the arch above which a jaw is suspect, mm.
        """
    @suspectCodeOffset.setter
    def suspectCodeOffset(self, arg0: float) -> None:
        ...
    @property
    def suspectCost(self) -> float:
        """
        Robust cost above which a jaw is suspect (poor-fit), no unit.
        """
    @suspectCost.setter
    def suspectCost(self, arg0: float) -> None:
        ...
    @property
    def suspectDraftedShare(self) -> float:
        """
        Share of a jaw's tracing above which drafts that nobody mended make it suspect, 0 to 1.
        """
    @suspectDraftedShare.setter
    def suspectDraftedShare(self, arg0: float) -> None:
        ...
    @property
    def suspectExtrapolatedSigma(self) -> float:
        """
        Predicted standard deviation anywhere on the outline above which a jaw is suspect, pixels of 0.25 mm.
        """
    @suspectExtrapolatedSigma.setter
    def suspectExtrapolatedSigma(self, arg0: float) -> None:
        ...
    @property
    def suspectFilmLength(self) -> float:
        """
        Length of the radiograph above which a spacing that only the fit tells is suspect, mm.
        """
    @suspectFilmLength.setter
    def suspectFilmLength(self, arg0: float) -> None:
        ...
    @property
    def suspectInlierShare(self) -> float:
        """
        Share of the tracing within 4 px below which a jaw is suspect, 0 to 1.
        """
    @suspectInlierShare.setter
    def suspectInlierShare(self, arg0: float) -> None:
        ...
    @property
    def suspectLandmarkRatio(self) -> float:
        """
        Root mean square of the landmarks' distances above which they are rough, standard deviations.
        """
    @suspectLandmarkRatio.setter
    def suspectLandmarkRatio(self, arg0: float) -> None:
        ...
    @property
    def suspectLargestMiddleSigma(self) -> float:
        """
        The same of the worse of them, pixels of 0.25 mm.
        """
    @suspectLargestMiddleSigma.setter
    def suspectLargestMiddleSigma(self, arg0: float) -> None:
        ...
    @property
    def suspectMargin(self) -> float:
        """
        Margin to the best other place below which a jaw is suspect (ambiguous), in the score's unit.
        """
    @suspectMargin.setter
    def suspectMargin(self, arg0: float) -> None:
        ...
    @property
    def suspectMedian(self) -> float:
        """
        Median distance above which a jaw is suspect, pixels of 0.25 mm.
        """
    @suspectMedian.setter
    def suspectMedian(self, arg0: float) -> None:
        ...
    @property
    def suspectMiddleSigma(self) -> float:
        """
        Predicted standard deviation of the middles of both sides, over incisors and first molars, where landmarks alone placed a jaw, pixels of 0.25 mm.
        """
    @suspectMiddleSigma.setter
    def suspectMiddleSigma(self, arg0: float) -> None:
        ...
    @property
    def suspectOtherSideDeviance(self) -> float:
        """
        Difference of minus twice the log likelihood below which the other side is named.
        """
    @suspectOtherSideDeviance.setter
    def suspectOtherSideDeviance(self, arg0: float) -> None:
        ...
    @property
    def suspectOutlineRatio(self) -> float:
        """
        Root mean square of what the pose leaves free of the outlines' shifts above which they contradict each other, where they alone place it, standard deviations.
        """
    @suspectOutlineRatio.setter
    def suspectOutlineRatio(self, arg0: float) -> None:
        ...
    @property
    def suspectP90(self) -> float:
        """
        90 % quantile of the distances above which a jaw is suspect, pixels of 0.25 mm.
        """
    @suspectP90.setter
    def suspectP90(self, arg0: float) -> None:
        ...
    @property
    def suspectPitch(self) -> float:
        """
        Pitch beyond which the pose stands at the edge of the search, rad, either way.
        """
    @suspectPitch.setter
    def suspectPitch(self, arg0: float) -> None:
        ...
    @property
    def suspectPredictedSigma(self) -> float:
        """
        Predicted standard deviation at the tracing above which a jaw is suspect, pixels of 0.25 mm.
        """
    @suspectPredictedSigma.setter
    def suspectPredictedSigma(self, arg0: float) -> None:
        ...
    @property
    def suspectPriorTension(self) -> float:
        """
        Distance of scale or move from their priors above which a jaw is suspect, standard deviations.
        """
    @suspectPriorTension.setter
    def suspectPriorTension(self, arg0: float) -> None:
        ...
    @property
    def suspectRotationTension(self) -> float:
        """
        Distance of roll and yaw from their prior above which a jaw is suspect, standard deviations.
        """
    @suspectRotationTension.setter
    def suspectRotationTension(self, arg0: float) -> None:
        ...
    @property
    def suspectSmoothSigma(self) -> float:
        """
        Estimated drift of the tracing above which it is called rough, pixels of 0.25 mm.
        """
    @suspectSmoothSigma.setter
    def suspectSmoothSigma(self, arg0: float) -> None:
        ...
    @property
    def suspectWinding(self) -> float:
        """
        Share of the surface, signed, below which the faces are taken to look inward.
        """
    @suspectWinding.setter
    def suspectWinding(self, arg0: float) -> None:
        ...
    @property
    def view(self) -> ViewVerdictThresholds:
        """
        Of each further view.
        """
    @view.setter
    def view(self, arg0: ViewVerdictThresholds) -> None:
        ...
class RegistrationVerdictFilter(ProcessObject):
    """
    Judges a pose registration.
    """
    def GetImageSize(self) -> tuple[int, int]:
        """
        Width and height of the radiograph, pixels; (0, 0), the default, is unknown.
        """
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
        """
        Sets the limits beyond which findings are given.
        """
    def _GetVerdict(self, jaw: Jaw | str) -> typing.Any:
        ...
    def _GetViewVerdicts(self) -> dict[str, typing.Any]:
        ...
    def _SetSolution(self, solution: PoseSolution | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class LandmarkProjectionFilter(ProcessObject):
    """
    Landmarks of the scans as a registration places them, with uncertainty.
    """
    def BisectedOff(self) -> None:
        """
        The same as SetBisected(False). It sets whether what was drawn tells of the middles between the sides alone, so that the expected error is that of the middles. Off by default.
        """
    def BisectedOn(self) -> None:
        """
        The same as SetBisected(True). It sets whether what was drawn tells of the middles between the sides alone, so that the expected error is that of the middles. Off by default.
        """
    def GetBisected(self) -> bool:
        """
        Returns whether what was drawn tells of the middles between the sides alone, so that the expected error is that of the middles. Off by default.
        """
    def GetCovariance(self, name: str) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 2) square pixels.
        """
    def GetExpectedError(self, jaw: Jaw | str) -> float:
        """
        Distance, pixels, that a landmark of the jaw is expected to be off by: the mean over its landmarks, or over its middles where Bisected is on and there are any. Valid after Execute().
        """
    def GetMiddleCovariance(self, name: str) -> numpy.typing.NDArray[typing.Any]:
        """
        (2, 2) square pixels: of the middle between a right landmark and its left one.
        """
    def GetMiddleSources(self) -> dict[str, typing.Any]:
        """
        {"U6_MB": "landmarks_3d"}: how the points of each middle were found on the scan.
        """
    def GetMiddles(self) -> dict[str, typing.Any]:
        """
        {"U6_MB": ((u, v), (2, 2) square pixels)} between each right landmark's image and its left one's; of counterparts, too, where the landmarks have none of that name.
        """
    def GetMillimetresPerUnit(self) -> float:
        """
        Returns the length of the scan landmarks' unit, mm; 1 by default.
        """
    def GetSigma(self, name: str) -> float:
        """
        Standard deviation an axis, pixels.
        """
    def HasExpectedError(self, jaw: Jaw | str) -> bool:
        """
        Whether the output has a landmark of the jaw. Valid after Execute().
        """
    def HasMiddleCovariance(self, name: str) -> bool:
        """
        Whether a landmark of the output, by its name, has a covariance of the middle of both sides. Valid after Execute().
        """
    def SetBisected(self, value: bool) -> None:
        """
        Sets whether what was drawn tells of the middles between the sides alone, so that the expected error is that of the middles. Off by default.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        """
        Sets the length of the scan landmarks' unit, mm; 1 by default.
        """
    def _GetOutput(self) -> dict[str, typing.Any]:
        ...
    def _SetCounterparts(self, counterparts: typing.Any) -> None:
        ...
    def _SetLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetSolution(self, solution: PoseSolution | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class ScanCheckFilter(ProcessObject):
    """
    What can be said of the scans before anything is registered.
    """
    def GetMillimetresPerUnit(self) -> float:
        """
        Returns the length of the unit of landmarks and mesh files, mm; 1 by default.
        """
    def GetNotCheckable(self) -> list[str]:
        """
        What the data could not tell, as sentences.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        """
        Sets the length of the unit of landmarks and mesh files, mm; 1 by default.
        """
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
class PictureCheckFilter(ProcessObject):
    """
    Whether a radiograph is the one that was drawn on, as far as its grey values tell.
    """
    def GetNotCheckable(self) -> list[str]:
        """
        What the data could not tell, as sentences.
        """
    def _GetFindings(self) -> list[typing.Any]:
        ...
    def _SetGeometry(self, geometry: CephalometricGeometry | None) -> None:
        ...
    def _SetLowerContour(self, contour: Contour | None) -> None:
        ...
    def _SetRadiograph(self, radiograph: Image | None) -> None:
        ...
    def _SetUpperContour(self, contour: Contour | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class LandmarkCounterpartFilter(ProcessObject):
    """
    Where the landmarks of a cephalometric analysis are on the scans.
    """
    def BisectedOff(self) -> None:
        """
        The same as SetBisected(False). It sets whether the tracings are the middle between both sides' images. Off by default.
        """
    def BisectedOn(self) -> None:
        """
        The same as SetBisected(True). It sets whether the tracings are the middle between both sides' images. Off by default.
        """
    def GetBisected(self) -> bool:
        """
        Returns whether the tracings are the middle between both sides' images. Off by default.
        """
    def GetDirection(self) -> CephalometricGeometry.Direction:
        """
        Returns the direction of the radiograph. A frontal one shows both sides beside each other: there only a central incisor's landmark may do without a side, and is the middle of both. Lateral by default.
        """
    def GetIgnoreSides(self) -> bool:
        """
        Returns whether the side in a name is ignored, so that "UR6_MB" is the middle of both as in a standard tracing. Off by default.
        """
    def GetLabels(self, jaw: Jaw | str) -> list[int]:
        """
        FDI number by point of the mesh, 0 for gingiva; empty where there are none.
        """
    def GetMillimetresPerUnit(self) -> float:
        """
        Returns the length of the scan landmarks' unit, mm; 1 by default.
        """
    def GetUnused(self) -> list[tuple[str, str]]:
        """
        The landmarks that are not used, as their file calls them, and why. Valid after Execute().
        """
    def IgnoreSidesOff(self) -> None:
        """
        The same as SetIgnoreSides(False). It sets whether the side in a name is ignored, so that "UR6_MB" is the middle of both as in a standard tracing. Off by default.
        """
    def IgnoreSidesOn(self) -> None:
        """
        The same as SetIgnoreSides(True). It sets whether the side in a name is ignored, so that "UR6_MB" is the middle of both as in a standard tracing. Off by default.
        """
    def SetBisected(self, value: bool) -> None:
        """
        Sets whether the tracings are the middle between both sides' images. Off by default.
        """
    def SetDirection(self, value: CephalometricGeometry.Direction | str) -> None:
        """
        Sets the direction of the radiograph. A frontal one shows both sides beside each other: there only a central incisor's landmark may do without a side, and is the middle of both. Lateral by default.
        """
    def SetExcludedTeeth(self, teeth: typing.Sequence[str]) -> None:
        """
        Codes of teeth that are left out: ["UR3"].
        """
    def SetIgnoreSides(self, value: bool) -> None:
        """
        Sets whether the side in a name is ignored, so that "UR6_MB" is the middle of both as in a standard tracing. Off by default.
        """
    def SetLabels(self, jaw: Jaw | str, labels: typing.Sequence[int]) -> None:
        """
        FDI number by point of the jaw's mesh, 0 gingiva; empty: none.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        """
        Sets the length of the scan landmarks' unit, mm; 1 by default.
        """
    def _GetCounterparts(self) -> dict[str, typing.Any]:
        ...
    def _SetCephalometricLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetLowerFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetLowerMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetLowerTracing(self, contour: Contour | None) -> None:
        ...
    def _SetScanLandmarks(self, landmarks: dict[str, typing.Any]) -> None:
        ...
    def _SetSolution(self, solution: PoseSolution | None) -> None:
        ...
    def _SetUpperFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetUpperMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetUpperTracing(self, contour: Contour | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class ToothCrownFilter(ProcessObject):
    """
    Cuts the crowns of the teeth that an analysis has outlined out of the scans.
    """
    def GetLabels(self, jaw: Jaw | str) -> list[int]:
        """
        FDI number by point of the mesh, 0 for gingiva; empty where there are none.
        """
    def GetMillimetresPerUnit(self) -> float:
        """
        Returns the length of the scan landmarks' unit, mm; 1 by default.
        """
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
        """
        Sets the length of the scan landmarks' unit, mm; 1 by default.
        """
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
class TracedSideFilter(ProcessObject):
    """
    Which side's outlines a drawing shows, and the drawing without the other side's.
    """
    def CodesHaveSidesOff(self) -> None:
        """
        The same as SetCodesHaveSides(False). It sets whether the codes of the tracing were written with their sides. On by default; off for a file with codes such as U1 and L6.
        """
    def CodesHaveSidesOn(self) -> None:
        """
        The same as SetCodesHaveSides(True). It sets whether the codes of the tracing were written with their sides. On by default; off for a file with codes such as U1 and L6.
        """
    def GetCodesHaveSides(self) -> bool:
        """
        Returns whether the codes of the tracing were written with their sides. On by default; off for a file with codes such as U1 and L6.
        """
    def GetLeftOutTeeth(self) -> list[str]:
        """
        Names of the other side's teeth that are left out, one a polyline. Valid after Execute().
        """
    def GetReason(self) -> str:
        """
        What that was decided by, as a clause. Valid after Execute().
        """
    def GetSettledSide(self) -> TracedSide:
        """
        Which side was traced. Valid after Execute().
        """
    def GetTracedSide(self) -> TracedSide:
        """
        Returns the side that is said of the drawing, or taken where nothing tells; Right by default.
        """
    def GetTracedSideIsGiven(self) -> bool:
        """
        Returns whether somebody said the traced side. Off by default.
        """
    def SetCodesHaveSides(self, value: bool) -> None:
        """
        Sets whether the codes of the tracing were written with their sides. On by default; off for a file with codes such as U1 and L6.
        """
    def SetTracedSide(self, side: TracedSide | str) -> None:
        """
        Sets the side that is said of the drawing, or taken where nothing tells; Right by default.
        """
    def SetTracedSideIsGiven(self, value: bool) -> None:
        """
        Sets whether somebody said the traced side. Off by default.
        """
    def TracedSideIsGivenOff(self) -> None:
        """
        The same as SetTracedSideIsGiven(False). It sets whether somebody said the traced side. Off by default.
        """
    def TracedSideIsGivenOn(self) -> None:
        """
        The same as SetTracedSideIsGiven(True). It sets whether somebody said the traced side. Off by default.
        """
    def _SetCephalometricLandmarks(self, landmarks: typing.Any) -> None:
        ...
    def _SetLowerContour(self, contour: Contour | None) -> None:
        ...
    def _SetUpperContour(self, contour: Contour | None) -> None:
        ...
    def _TakeOutput(self, arg0: Jaw | str) -> Contour:
        ...
    def __init__(self) -> None:
        ...
class MatchedContourFilter(ProcessObject):
    """
    The part of a moving contour that has a tracing beside it.
    """
    def GetMaximumDistance(self) -> float:
        """
        Returns the distance up to which a point is matched, pixels; 10 by default.
        """
    def GetMaximumGap(self) -> float:
        """
        Returns the length of a gap that is closed, pixels; 12 by default.
        """
    def SetMaximumDistance(self, value: float) -> None:
        """
        Sets the distance up to which a point is matched, pixels; 10 by default.
        """
    def SetMaximumGap(self, value: float) -> None:
        """
        Sets the length of a gap that is closed, pixels; 12 by default.
        """
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
        """
        Returns the jaw: Upper (the default) or Lower.
        """
    def GetRMS(self) -> float:
        """
        What the similarity leaves, pixels.
        """
    def SetJaw(self, jaw: Jaw | str) -> None:
        """
        Sets the jaw: Upper (the default) or Lower.
        """
    def _GetTransform(self) -> Similarity2DTransform | None:
        ...
    def _SetFrame(self, transform: VersorRigid3DTransform | None) -> None:
        ...
    def _SetMesh(self, mesh: Mesh | None) -> None:
        ...
    def _SetSolution(self, solution: PoseSolution | None) -> None:
        ...
    def __init__(self) -> None:
        ...
class GeometryPlacementFilter(ProcessObject):
    """
    A radiograph's geometry with an object in it.
    """
    def CentralRayThroughOriginOff(self) -> None:
        """
        The same as SetCentralRayThroughOrigin(False). It sets whether the central ray is laid through the origin of the frame. Off by default.
        """
    def CentralRayThroughOriginOn(self) -> None:
        """
        The same as SetCentralRayThroughOrigin(True). It sets whether the central ray is laid through the origin of the frame. Off by default.
        """
    def GetCentralRayThroughOrigin(self) -> bool:
        """
        Returns whether the central ray is laid through the origin of the frame. Off by default.
        """
    def SetCentralRayThroughOrigin(self, value: bool) -> None:
        """
        Sets whether the central ray is laid through the origin of the frame. Off by default.
        """
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
        """
        Returns the standard deviation of a splat over the mean distance between vertices; 0.7 by default.
        """
    def SetWidthFactor(self, value: float) -> None:
        """
        Sets the standard deviation of a splat over the mean distance between vertices; 0.7 by default.
        """
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
        """
        Returns the pixel spacing in the detector plane where nothing can be measured, mm; 0.25 by default.
        """
    def SetDefaultPixelSpacing(self, value: float) -> None:
        """
        Sets the pixel spacing in the detector plane where nothing can be measured, mm; 0.25 by default.
        """
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
        """
        Returns the length of the unit of the points that the projection matrix acts on, mm; 1 by default.
        """
    def GetProjectionMatrix(self) -> numpy.typing.NDArray[typing.Any]:
        """
        (3, 4): mesh, in the unit of its file, to homogeneous pixel index.
        """
    def SetMillimetresPerUnit(self, value: float) -> None:
        """
        Sets the length of the unit of the points that the projection matrix acts on, mm; 1 by default.
        """
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
        """
        Returns the jaw whose landmarks are projected; Unknown, the default, is both.
        """
    def SetJaw(self, jaw: Jaw | str) -> None:
        """
        Sets the jaw whose landmarks are projected; Unknown, the default, is both.
        """
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
        """
        The same as SetBisectSides(False). It sets whether the middle between left and right is measured where both are there. Off by default.
        """
    def BisectSidesOn(self) -> None:
        """
        The same as SetBisectSides(True). It sets whether the middle between left and right is measured where both are there. Off by default.
        """
    def GetBisectSides(self) -> bool:
        """
        Returns whether the middle between left and right is measured where both are there. Off by default.
        """
    def GetJaw(self) -> Jaw:
        """
        The jaw whose landmarks count; Unknown, the default, is both.
        """
    def GetPixelSpacing(self) -> tuple[float, float]:
        """
        The pixel spacing (u, v) by which errors are told in mm; 0, the default, is unknown.
        """
    def GetUnpairedLandmarks(self) -> list[str]:
        """
        Names whose partner is missing.
        """
    def SetBisectSides(self, value: bool) -> None:
        """
        Sets whether the middle between left and right is measured where both are there. Off by default.
        """
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
        """
        Standard deviation an axis of each predicted landmark by its name, pixels.
        """
    def GetMargin(self) -> float:
        """
        Returns the free border around tracing and landmarks, as a part of their larger extent; 0.2 by default.
        """
    def GetPictureSize(self) -> tuple[int, int]:
        """
        Returns the size of the output (width, height), pixels; 1400 by 900 by default.
        """
    def GetPixelSpacing(self) -> tuple[float, float]:
        """
        Returns the pixel spacing (u, v) in the detector plane, mm. With 0, the default, lengths are written in pixels.
        """
    def GetStatus(self) -> str:
        """
        Returns the word of the badge: "ok", "suspect", "failed" or any other. None is drawn where it is empty, which is the default.
        """
    def GetTextLines(self) -> list[str]:
        """
        Returns the lines of text beside the radiograph; long ones are wrapped.
        """
    def GetTitle(self) -> str:
        """
        Returns the line above the picture.
        """
    def SetLandmarkSigmas(self, sigmas: typing.Mapping[str, float]) -> None:
        """
        px by name.
        """
    def SetMargin(self, value: float) -> None:
        """
        Sets the free border around tracing and landmarks, as a part of their larger extent; 0.2 by default.
        """
    def SetPictureSize(self, width: int, height: int) -> None:
        """
        Sets the size of the output (width, height), pixels; 1400 by 900 by default.
        """
    def SetPixelSpacing(self, spacing: typing.Sequence[float]) -> None:
        """
        Sets the pixel spacing (u, v) in the detector plane, mm. With 0, the default, lengths are written in pixels.
        """
    def SetRadiographSize(self, width: int, height: int) -> None:
        """
        Width and height of the radiograph, pixels, for the frame where there is no image to show.
        """
    def SetStatus(self, status: str) -> None:
        """
        Sets the word of the badge: "ok", "suspect", "failed" or any other. None is drawn where it is empty, which is the default.
        """
    def SetTextLines(self, lines: typing.Sequence[str]) -> None:
        """
        Sets the lines of text beside the radiograph; long ones are wrapped.
        """
    def SetTitle(self, title: str) -> None:
        """
        Sets the line above the picture.
        """
    def SetView(self, firstU: float, lastU: float, firstV: float, lastV: float) -> None:
        """
        First and last pixel index of u, then of v.
        """
    def SetViewToContours(self) -> None:
        """
        Shows the region around tracing and landmarks, which is the default.
        """
    def SetWindow(self, black: float, white: float) -> None:
        """
        Grey values that are shown as black and as white. Both 0, the default, stand for the 0.2 and 99.8 % quantiles.
        """
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
    The level of a simulated case: how well it is taken and traced, and the arches that it is of.

    Members:

      Ideal

      Typical

      Hard

      Real

      RealHard

      Standard

      Practice
    """
    Hard: typing.ClassVar[PhantomCohort]
    Ideal: typing.ClassVar[PhantomCohort]
    Practice: typing.ClassVar[PhantomCohort]
    Real: typing.ClassVar[PhantomCohort]
    RealHard: typing.ClassVar[PhantomCohort]
    Standard: typing.ClassVar[PhantomCohort]
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
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
        """
        The value as a number.
        """
class DentalPhantomParameters:
    """
    What shapes a pair of phantom jaws; mm and radians.
    """
    @staticmethod
    def Draw(seed: int) -> DentalPhantomParameters:
        """
        One of a kind.
        """
    def GetMissingTeeth(self) -> list[int]:
        """
        FDI numbers of the teeth that the jaws lack.
        """
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
    @property
    def archCoverage(self) -> float:
        """
        How far along a quarter of the arch's curve the second molar ends: less is more tapered.
        """
    @archCoverage.setter
    def archCoverage(self, arg0: float) -> None:
        ...
    @property
    def archExponent(self) -> float:
        """
        Exponent p of the arch ``|y/w|^p + |x/d|^p = 1``: 2 is an ellipse, more is squarer.
        """
    @archExponent.setter
    def archExponent(self, arg0: float) -> None:
        ...
    @property
    def archFamily(self) -> PhantomArchFamily:
        """
        The shape of the arch.
        """
    @archFamily.setter
    def archFamily(self, arg0: PhantomArchFamily | str) -> None:
        ...
    @property
    def archHalfWidth(self) -> float:
        """
        Half the width of the upper arch between the crown lines at the distal ends of the second molars, mm.
        """
    @archHalfWidth.setter
    def archHalfWidth(self, arg0: float) -> None:
        ...
    @property
    def baseHeight(self) -> float:
        """
        Thickness of the base below the deepest gingiva, mm.
        """
    @baseHeight.setter
    def baseHeight(self, arg0: float) -> None:
        ...
    @property
    def frame(self) -> PhantomFrame:
        """
        The frame that the meshes come in.
        """
    @frame.setter
    def frame(self, arg0: PhantomFrame | str) -> None:
        ...
    @property
    def frameSeed(self) -> int:
        """
        Seed of the frame, where it is drawn.
        """
    @frameSeed.setter
    def frameSeed(self, arg0: int) -> None:
        ...
    @property
    def noiseSeed(self) -> int:
        """
        Seed of the scan's noise.
        """
    @noiseSeed.setter
    def noiseSeed(self, arg0: int) -> None:
        ...
    @property
    def numberOfTriangles(self) -> int:
        """
        Triangles of each jaw, reached within 10 %.
        """
    @numberOfTriangles.setter
    def numberOfTriangles(self, arg0: int) -> None:
        ...
    @property
    def overbite(self) -> float:
        """
        How far the upper incisors cover the lower ones, mm.
        """
    @overbite.setter
    def overbite(self, arg0: float) -> None:
        ...
    @property
    def overjet(self) -> float:
        """
        How far the upper incisors stand in front of the lower ones, mm.
        """
    @overjet.setter
    def overjet(self, arg0: float) -> None:
        ...
    @property
    def scannerNoise(self) -> float:
        """
        Standard deviation of the scan along its normals, mm.
        """
    @scannerNoise.setter
    def scannerNoise(self, arg0: float) -> None:
        ...
    @property
    def speeDepth(self) -> float:
        """
        Depth of the curve of Spee, mm.
        """
    @speeDepth.setter
    def speeDepth(self, arg0: float) -> None:
        ...
    @property
    def stoneBase(self) -> bool:
        """
        Whether the scan is a trimmed plaster cast, a closed body with a base.
        """
    @stoneBase.setter
    def stoneBase(self, arg0: bool) -> None:
        ...
    @property
    def wilson(self) -> float:
        """
        Curve of Wilson: factor on the molars' transverse inclination.
        """
    @wilson.setter
    def wilson(self, arg0: float) -> None:
        ...
class DentalPhantomMeshSource(ProcessObject):
    """
    A pair of parametric arches in occlusion.
    """
    def DrawParameters(self, seed: int) -> None:
        """
        Draws parameters of a kind for a seed; the same seed gives the same jaws.
        """
    def GetParameters(self) -> DentalPhantomParameters:
        """
        A copy.
        """
    def SetParameters(self, parameters: DentalPhantomParameters) -> None:
        """
        Sets what to make. The default is an average pair of jaws in the anatomical frame.
        """
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
        """
        The same as SetBuccalOutline(False). It sets whether the tracing follows the buccal cusps of premolars and molars, which lie inside the silhouette where the oral ones hang lower. Off by default.
        """
    def BuccalOutlineOn(self) -> None:
        """
        The same as SetBuccalOutline(True). It sets whether the tracing follows the buccal cusps of premolars and molars, which lie inside the silhouette where the oral ones hang lower. Off by default.
        """
    def GetAdditionalRoll(self) -> float:
        """
        Returns the turn of the head about the anterior axis beyond what the level draws, rad; 0 by default.
        """
    def GetAdditionalYaw(self) -> float:
        """
        Returns the turn of the head about the vertical axis beyond what the level draws, rad; 0 by default.
        """
    def GetBuccalOutline(self) -> bool:
        """
        Returns whether the tracing follows the buccal cusps of premolars and molars, which lie inside the silhouette where the oral ones hang lower. Off by default.
        """
    def GetCohort(self) -> PhantomCohort:
        """
        Returns the level's table of parameters; Typical by default. It sets traced side, frame and number of triangles too, hence comes first.
        """
    def GetDropOutFraction(self) -> float:
        """
        Returns the part of each tooth's border that is not drawn; 0 by default.
        """
    def GetFacing(self) -> CephalometricGeometry.Facing:
        """
        Returns the side of the image to which the face looks; Right by default.
        """
    def GetFrame(self) -> PhantomFrame:
        """
        Returns the frame of the meshes; SharedScanner by default.
        """
    def GetImageSize(self) -> tuple[int, int]:
        """
        Returns the width and height of the radiograph, pixels; 703 by 938 by default.
        """
    def GetLowerNumberOfPoints(self) -> int:
        """
        Returns the number of points of the lower tracing; 75 by default, as in the paper.
        """
    def GetMakeRadiograph(self) -> bool:
        """
        Returns whether the radiograph is simulated, which costs most of the time. On by default.
        """
    def GetMissingTeeth(self) -> list[int]:
        """
        Returns the FDI numbers of teeth that the jaws lack beyond what the level draws; none by default.
        """
    def GetNumberOfTriangles(self) -> int:
        """
        Returns the number of triangles of each jaw, from 2000 to 4000000; 60000 by default.
        """
    def GetParameters(self) -> DentalPhantomParameters:
        """
        What was drawn; a copy.
        """
    def GetSeed(self) -> int:
        """
        Returns the seed: the same one gives the same case.
        """
    def GetSourceSide(self) -> CephalometricGeometry.SourceSide:
        """
        Returns the patient's side at which the source is; Right by default.
        """
    def GetStoneBase(self) -> bool:
        """
        Returns whether the scans are closed casts with bases instead of open shells. Off by default.
        """
    def GetToothBias(self) -> float:
        """
        Returns the error with which each tooth is drawn, as a factor on 1.2 px shift, 2 degrees and 3 % scale (standard deviations); 0 by default.
        """
    def GetTracedSide(self) -> TracedSide:
        """
        Returns the patient's side whose outline is traced; Right by default.
        """
    def GetUpperNumberOfPoints(self) -> int:
        """
        Returns the number of points of the upper tracing; 79 by default, as in the paper.
        """
    def MakeRadiographOff(self) -> None:
        """
        The same as SetMakeRadiograph(False). It sets whether the radiograph is simulated, which costs most of the time. On by default.
        """
    def MakeRadiographOn(self) -> None:
        """
        The same as SetMakeRadiograph(True). It sets whether the radiograph is simulated, which costs most of the time. On by default.
        """
    def SetAdditionalRoll(self, value: float) -> None:
        """
        Sets the turn of the head about the anterior axis beyond what the level draws, rad; 0 by default.
        """
    def SetAdditionalYaw(self, value: float) -> None:
        """
        Sets the turn of the head about the vertical axis beyond what the level draws, rad; 0 by default.
        """
    def SetBuccalOutline(self, value: bool) -> None:
        """
        Sets whether the tracing follows the buccal cusps of premolars and molars, which lie inside the silhouette where the oral ones hang lower. Off by default.
        """
    def SetCohort(self, cohort: PhantomCohort | str) -> None:
        """
        Sets the level's table of parameters; Typical by default. It sets traced side, frame and number of triangles too, hence comes first.
        """
    def SetDropOutFraction(self, value: float) -> None:
        """
        Sets the part of each tooth's border that is not drawn; 0 by default.
        """
    def SetFacing(self, facing: CephalometricGeometry.Facing | str) -> None:
        """
        Sets the side of the image to which the face looks; Right by default.
        """
    def SetFrame(self, frame: PhantomFrame | str) -> None:
        """
        Sets the frame of the meshes; SharedScanner by default.
        """
    def SetImageSize(self, size: typing.Sequence[int]) -> None:
        """
        Sets the width and height of the radiograph, pixels; 703 by 938 by default.
        """
    def SetLowerNumberOfPoints(self, value: int) -> None:
        """
        Sets the number of points of the lower tracing; 75 by default, as in the paper.
        """
    def SetMakeRadiograph(self, value: bool) -> None:
        """
        Sets whether the radiograph is simulated, which costs most of the time. On by default.
        """
    def SetMissingTeeth(self, value: typing.Sequence[int]) -> None:
        """
        Sets the FDI numbers of teeth that the jaws lack beyond what the level draws; none by default.
        """
    def SetNumberOfTriangles(self, value: int) -> None:
        """
        Sets the number of triangles of each jaw, from 2000 to 4000000; 60000 by default.
        """
    def SetSeed(self, value: int) -> None:
        """
        Sets the seed: the same one gives the same case.
        """
    def SetSourceSide(self, side: CephalometricGeometry.SourceSide | str) -> None:
        """
        Sets the patient's side at which the source is; Right by default.
        """
    def SetStoneBase(self, value: bool) -> None:
        """
        Sets whether the scans are closed casts with bases instead of open shells. Off by default.
        """
    def SetToothBias(self, value: float) -> None:
        """
        Sets the error with which each tooth is drawn, as a factor on 1.2 px shift, 2 degrees and 3 % scale (standard deviations); 0 by default.
        """
    def SetTracedSide(self, side: TracedSide | str) -> None:
        """
        Sets the patient's side whose outline is traced; Right by default.
        """
    def SetUpperNumberOfPoints(self, value: int) -> None:
        """
        Sets the number of points of the upper tracing; 79 by default, as in the paper.
        """
    def StoneBaseOff(self) -> None:
        """
        The same as SetStoneBase(False). It sets whether the scans are closed casts with bases instead of open shells. Off by default.
        """
    def StoneBaseOn(self) -> None:
        """
        The same as SetStoneBase(True). It sets whether the scans are closed casts with bases instead of open shells. Off by default.
        """
    def _GetCephalometricLandmarks(self) -> typing.Any:
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
        """
        The value as a number.
        """
class CohortExperiment(ProcessObject):
    """
    Methods on a cohort: tables, statistics, plot data.
    """
    def DrawFiguresOff(self) -> None:
        """
        The same as SetDrawFigures(False). It sets whether the study Tables draws the figure of representative cases. On by default.
        """
    def DrawFiguresOn(self) -> None:
        """
        The same as SetDrawFigures(True). It sets whether the study Tables draws the figure of representative cases. On by default.
        """
    def GetCaseDirectory(self) -> str:
        """
        Returns the folder whose cases are used instead of simulated ones, by the studies Tables and Capture.
        """
    def GetCurrentStage(self) -> str:
        """
        How far it is, in words: "12 of 34 cases".
        """
    def GetDrawFigures(self) -> bool:
        """
        Returns whether the study Tables draws the figure of representative cases. On by default.
        """
    def GetLevel(self) -> PhantomCohort:
        """
        Returns the level of difficulty of the simulated cases; Typical by default. Some studies have levels of their own.
        """
    def GetMethods(self) -> list[str]:
        """
        Returns the names of methods and of groups of them that are compared; see experiment_methods().
        """
    def GetNumberOfCases(self) -> int:
        """
        Returns the number of simulated cases; 34 by default, the paper's.
        """
    def GetNumberOfResumedCases(self) -> int:
        """
        How many cases were in the output folder before, valid after Execute().
        """
    def GetNumberOfStarts(self) -> int:
        """
        Returns the number of starts a case and jaw in the study of the capture range; 100 by default.
        """
    def GetOutputDirectory(self) -> str:
        """
        Returns the folder that everything is written to. It is made where it is missing, and an experiment that was stopped goes on from it.
        """
    def GetSeed(self) -> int:
        """
        Returns the seed of the first case and of the statistics; 1 by default.
        """
    def GetStudy(self) -> ExperimentStudy:
        """
        Returns the study that is run; Tables by default.
        """
    def GetWrittenFiles(self) -> list[str]:
        """
        Names in the output folder, after Execute().
        """
    def SetCaseDirectory(self, folder: str) -> None:
        """
        Sets the folder whose cases are used instead of simulated ones, by the studies Tables and Capture.
        """
    def SetDrawFigures(self, value: bool) -> None:
        """
        Sets whether the study Tables draws the figure of representative cases. On by default.
        """
    def SetLevel(self, level: PhantomCohort | str) -> None:
        """
        Sets the level of difficulty of the simulated cases; Typical by default. Some studies have levels of their own.
        """
    def SetMethods(self, names: typing.Sequence[str]) -> None:
        """
        Sets the names of methods and of groups of them that are compared; see experiment_methods().
        """
    def SetNumberOfCases(self, value: int) -> None:
        """
        Sets the number of simulated cases; 34 by default, the paper's.
        """
    def SetNumberOfStarts(self, value: int) -> None:
        """
        Sets the number of starts a case and jaw in the study of the capture range; 100 by default.
        """
    def SetOutputDirectory(self, folder: str) -> None:
        """
        Sets the folder that everything is written to. It is made where it is missing, and an experiment that was stopped goes on from it.
        """
    def SetSeed(self, value: int) -> None:
        """
        Sets the seed of the first case and of the statistics; 1 by default.
        """
    def SetStudy(self, study: ExperimentStudy | str) -> None:
        """
        Sets the study that is run; Tables by default.
        """
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
        """
        The value as a number.
        """
class _Case:
    @staticmethod
    def _Read(fileName: str, exclude: typing.Sequence[str], fix: typing.Sequence[str], init: str, initText: str, landmarks: str = '') -> _Case:
        ...
    @staticmethod
    def _ReadOfResult(result: str, exclude: typing.Sequence[str], fix: typing.Sequence[str], init: str, initText: str) -> _Case:
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
    def _GetInputs(self) -> list[tuple[str, str]]:
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
    def _StartFrom(self, init: str, initText: str) -> None:
        ...
    def __init__(self, upper: Mesh | None, lower: Mesh | None, upperContour: Contour | None, lowerContour: Contour | None, geometry: CephalometricGeometry | None, image: Image | None, imageSize: typing.Sequence[int], principalPointKnown: bool, tracedSide: str | None, occlusion: str, cephalometricLandmarks: typing.Any, stockOutlines: typing.Sequence[Contour], landmarks3D: typing.Any, landmarks2D: typing.Any, exclude: typing.Sequence[str], fix: typing.Sequence[str]) -> None:
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
        """
        What runs now, in words: "upper: registration".
        """
    def GetNumberOfLowerContourPoints(self) -> int:
        """
        Returns the number of points that the lower silhouette is resampled to, in the paper's presets: 439 by default.
        """
    def GetNumberOfUpperContourPoints(self) -> int:
        """
        Returns the number of points that the upper silhouette is resampled to, in the paper's presets: 441 by default.
        """
    def GetPoseOptions(self) -> PoseRegistrationOptions:
        """
        A copy.
        """
    def GetPreset(self) -> Preset:
        """
        Returns the chain that runs: Robust (the default) or one of the paper's.
        """
    def GetRefineMidline(self) -> bool:
        """
        Returns whether preset Robust moves the midline plane of the dental axis to the scan's mirror plane. On by default.
        """
    def GetUseSurfaceDRR(self) -> bool:
        """
        Returns whether the paper's presets take the silhouette from the surface DRR (the default) or exactly from the mesh.
        """
    def RefineMidlineOff(self) -> None:
        """
        The same as SetRefineMidline(False). It sets whether preset Robust moves the midline plane of the dental axis to the scan's mirror plane. On by default.
        """
    def RefineMidlineOn(self) -> None:
        """
        The same as SetRefineMidline(True). It sets whether preset Robust moves the midline plane of the dental axis to the scan's mirror plane. On by default.
        """
    def SetNumberOfLowerContourPoints(self, value: int) -> None:
        """
        Sets the number of points that the lower silhouette is resampled to, in the paper's presets: 439 by default.
        """
    def SetNumberOfUpperContourPoints(self, value: int) -> None:
        """
        Sets the number of points that the upper silhouette is resampled to, in the paper's presets: 441 by default.
        """
    def SetOption(self, assignment: str) -> None:
        """
        One ingredient of preset Robust, "NAME=VALUE" (Documentation/Robust.md).
        """
    def SetPoseOptions(self, options: PoseRegistrationOptions) -> None:
        """
        Ingredients of preset Robust.
        """
    def SetPreset(self, preset: Preset | str) -> None:
        """
        Sets the chain that runs: Robust (the default) or one of the paper's.
        """
    def SetRefineMidline(self, value: bool) -> None:
        """
        Sets whether preset Robust moves the midline plane of the dental axis to the scan's mirror plane. On by default.
        """
    def SetUseSurfaceDRR(self, value: bool) -> None:
        """
        Sets whether the paper's presets take the silhouette from the surface DRR (the default) or exactly from the mesh.
        """
    def UseSurfaceDRROff(self) -> None:
        """
        The same as SetUseSurfaceDRR(False). It sets whether the paper's presets take the silhouette from the surface DRR (the default) or exactly from the mesh.
        """
    def UseSurfaceDRROn(self) -> None:
        """
        The same as SetUseSurfaceDRR(True). It sets whether the paper's presets take the silhouette from the surface DRR (the default) or exactly from the mesh.
        """
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
        """
        Returns the name of the case file.
        """
    def SetFileName(self, fileName: str) -> None:
        """
        Sets the name of the case file.
        """
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
        """
        The same as SetAnonymous(False). It sets whether paths and names are left out of all files. Off by default.
        """
    def AnonymousOn(self) -> None:
        """
        The same as SetAnonymous(True). It sets whether paths and names are left out of all files. Off by default.
        """
    def GetAnonymous(self) -> bool:
        """
        Returns whether paths and names are left out of all files. Off by default.
        """
    def GetFolderName(self) -> str:
        """
        Returns the folder that is written to. It is made where it is not there, and files of an earlier result in it are replaced.
        """
    def GetWritePage(self) -> bool:
        """
        Returns whether report.html is written where what is for people is. On by default.
        """
    def GetWriteReport(self) -> bool:
        """
        Returns whether what is for people is written as well: overlays, the scans in the cephalostat frame, the page. On by default.
        """
    def SetAnonymous(self, value: bool) -> None:
        """
        Sets whether paths and names are left out of all files. Off by default.
        """
    def SetFolderName(self, folderName: str) -> None:
        """
        Sets the folder that is written to. It is made where it is not there, and files of an earlier result in it are replaced.
        """
    def SetWritePage(self, value: bool) -> None:
        """
        Sets whether report.html is written where what is for people is. On by default.
        """
    def SetWriteReport(self, value: bool) -> None:
        """
        Sets whether what is for people is written as well: overlays, the scans in the cephalostat frame, the page. On by default.
        """
    def WritePageOff(self) -> None:
        """
        The same as SetWritePage(False). It sets whether report.html is written where what is for people is. On by default.
        """
    def WritePageOn(self) -> None:
        """
        The same as SetWritePage(True). It sets whether report.html is written where what is for people is. On by default.
        """
    def WriteReportOff(self) -> None:
        """
        The same as SetWriteReport(False). It sets whether what is for people is written as well: overlays, the scans in the cephalostat frame, the page. On by default.
        """
    def WriteReportOn(self) -> None:
        """
        The same as SetWriteReport(True). It sets whether what is for people is written as well: overlays, the scans in the cephalostat frame, the page. On by default.
        """
    def _SetInput(self, result: _CaseResult) -> None:
        ...
    def __init__(self) -> None:
        ...
def ReadTransform(fileName: str) -> Transform:
    """
    Reads a transform of any kind that the package knows from an ITK transform file (.tfm, .txt).
    """
def WriteTransform(transform: Transform, fileName: str) -> None:
    """
    Writes a transform to an ITK transform file (.tfm, .txt).
    """
def _FindBatchCases(input: str) -> list[tuple[str, str]]:
    """
    Names and files of the cases of a folder, a table of case files, a case file or a pattern.
    """
def _Main(arguments: typing.Sequence[str]) -> int:
    ...
def _ReadContinuation(result: str, needsCase: bool) -> dict[str, typing.Any]:
    """
    What an earlier result was registered with; see register_from().
    """
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
