"""
Further keywords of the procedural twins; made by Wrapping/Python/settings_stub.py.
"""
import typing
from typing import Any, Mapping, Optional, TypedDict, Union
from ._case_result import CaseResult
from ._inputs import ContourLike, ImageLike, LandmarksLike, MeshLike, PathLike, TransformLike
from collections.abc import Sequence
from . import _core

class CoherentPointDriftContourRegistrationSettings(TypedDict, total=False):
    initialTransform: Optional[TransformLike]
    maximumNumberOfIterations: int
    motion: _core.Motion | str
    numberOfWorkUnits: int
    tolerance: float

class ContourDistanceSettings(TypedDict, total=False):
    distance: _core.ContourPointDistance | str
    numberOfWorkUnits: int

class ContourOverlapSettings(TypedDict, total=False):
    gapLength: float
    maximumDistance: float
    numberOfWorkUnits: int

class CrownRegionMeshSettings(TypedDict, total=False):
    keepWholeMesh: bool
    labelNumbering: _core.Numbering | str
    maximumCrownHeight: float
    minimumCrownHeight: float
    numberOfWorkUnits: int
    useLabels: bool

class DentalPhantomCaseSettings(TypedDict, total=False):
    additionalRoll: float
    additionalYaw: float
    buccalOutline: bool
    dropOutFraction: float
    facing: _core.CephalometricGeometry.Facing | str
    frame: _core.PhantomFrame | str
    imageSize: typing.Sequence[int]
    lowerNumberOfPoints: int
    makeRadiograph: bool
    missingTeeth: typing.Sequence[int]
    numberOfTriangles: int
    numberOfWorkUnits: int
    sourceSide: _core.CephalometricGeometry.SourceSide | str
    stoneBase: bool
    toothBias: float
    tracedSide: _core.TracedSide | str
    upperNumberOfPoints: int

class FindLandmarkCounterpartsSettings(TypedDict, total=False):
    direction: Any
    lowerFrame: Optional[TransformLike]
    lowerMesh: Optional[MeshLike]
    lowerTracing: Optional[ContourLike]
    scanLandmarks: Optional[LandmarksLike]
    solution: Optional[_core.PoseSolution]
    upperFrame: Optional[TransformLike]
    upperMesh: Optional[MeshLike]
    upperTracing: Optional[ContourLike]

class FindToothCrownsSettings(TypedDict, total=False):
    lowerContour: Optional[ContourLike]
    lowerFrame: Optional[TransformLike]
    lowerMesh: Optional[MeshLike]
    scanLandmarks: Optional[LandmarksLike]
    upperContour: Optional[ContourLike]
    upperFrame: Optional[TransformLike]
    upperMesh: Optional[MeshLike]

class FindTracedSideSettings(TypedDict, total=False):
    codesHaveSides: bool
    numberOfWorkUnits: int
    tracedSide: _core.TracedSide | str
    tracedSideIsGiven: bool

class IntensityRegistrationSettings(TypedDict, total=False):
    initialTransform: Optional[TransformLike]
    margin: float
    maximumNumberOfIterations: int
    motion: _core.Motion | str
    numberOfWorkUnits: int

class IterativeClosestPointContourRegistrationSettings(TypedDict, total=False):
    direction: _core.ContourDirection | str
    initialTransform: Optional[TransformLike]
    maximumNumberOfIterations: int
    motion: _core.Motion | str
    numberOfWorkUnits: int
    tolerance: float

class LandmarkErrorSettings(TypedDict, total=False):
    bisectSides: bool
    jaw: _core.Jaw | str
    numberOfWorkUnits: int

class OpenSilhouetteContourSettings(TypedDict, total=False):
    numberOfWorkUnits: int
    spacing: float
    useLabels: bool

class PoseRegistrationSettings(TypedDict, total=False):
    covarianceNoiseModel: _core.ResidualNoiseModel | None
    initialGeometry: Optional[Any]
    jointFrame: Optional[TransformLike]
    lowerFrame: Optional[TransformLike]
    noiseModel: _core.ResidualNoiseModel | None
    numberOfWorkUnits: int
    optimizer: _core.ObjectToObjectOptimizerBase
    principalPointKnown: bool
    robustKernel: _core.RobustKernel | None
    spacingSource: _core.SpacingSource | str
    start: _core.PoseStart
    tracedSide: _core.TracedSide | str
    upperFrame: Optional[TransformLike]

class ReadCephalometricLandmarksSettings(TypedDict, total=False):
    fileFormat: _core.AnnotationFileFormat | str
    imageFileName: str
    markupsOrigin: typing.Sequence[float]
    markupsSpacing: typing.Sequence[float]
    numberOfWorkUnits: int
    numbering: _core.Numbering | str
    pixelOrigin: _core.AnnotationPixelOrigin | str

class ReadContoursSettings(TypedDict, total=False):
    classFiles: typing.Sequence[tuple[str, str]]
    fileFormat: _core.AnnotationFileFormat | str
    imageFileName: str
    markupsOrigin: typing.Sequence[float]
    markupsSpacing: typing.Sequence[float]
    numberOfWorkUnits: int
    numbering: _core.Numbering | str
    pixelOrigin: _core.AnnotationPixelOrigin | str
    sidelessCodesAreLeft: bool

class ReadLandmarksSettings(TypedDict, total=False):
    fileFormat: _core.AnnotationFileFormat | str
    imageFileName: str
    markupsOrigin: typing.Sequence[float]
    markupsSpacing: typing.Sequence[float]
    numberOfWorkUnits: int
    numbering: _core.Numbering | str
    pixelOrigin: _core.AnnotationPixelOrigin | str

class ReadToothLabelsSettings(TypedDict, total=False):
    numberOfPoints: int
    numberOfWorkUnits: int
    numbering: _core.Numbering | str

class RegistrationOverlaySettings(TypedDict, total=False):
    landmarkSigmas: typing.Mapping[str, float]
    margin: float
    numberOfWorkUnits: int
    pixelSpacing: typing.Sequence[float]
    status: str
    textLines: typing.Sequence[str]

class RegistrationVerdictSettings(TypedDict, total=False):
    imageSize: typing.Sequence[int]
    numberOfWorkUnits: int
    thresholds: _core.RegistrationVerdictThresholds

class RunCohortExperimentSettings(TypedDict, total=False):
    drawFigures: bool
    methods: typing.Sequence[str]
    numberOfStarts: int
    numberOfWorkUnits: int
    outputDirectory: str
    seed: int
    study: _core.ExperimentStudy | str

class ScanCheckSettings(TypedDict, total=False):
    millimetresPerUnit: float
    numberOfWorkUnits: int

class SilhouetteContourSettings(TypedDict, total=False):
    labelSmoothing: float
    largestPartOnly: bool
    level: _core.SilhouetteLevel | str
    levelFraction: float
    minimumArea: float
    numberOfStreamDivisions: int
    numberOfWorkUnits: int
    objectIsDark: bool
    outputCoordinates: _core.SilhouetteCoordinates | str
    outputOffset: typing.Sequence[float]

class SilhouetteToContourRegistrationSettings(TypedDict, total=False):
    fixRotation: bool
    fixScale: bool
    fixTranslation: bool
    metric: _core.ContourToContourMetricv4 | None
    numberOfLevels: int
    numberOfWorkUnits: int
    randomSeed: int

class SurfaceDRRSettings(TypedDict, total=False):
    attenuation: float
    coverMargin: float
    coverMeshes: bool
    density: float
    normalization: _core.SurfaceDRRNormalization | str
    numberOfWorkUnits: int
    origin: typing.Sequence[float]
    outputMode: _core.SurfaceDRROutput | str
    referenceImage: Optional[ImageLike]
    sizeToCoverMeshes: float
    sourceIntensity: float
    spacing: typing.Sequence[float]
    startIndex: typing.Sequence[int]
    tolerance: float
    useGeometrySpacing: bool

class UMidlineDentalAxisSettings(TypedDict, total=False):
    axesLength: float
    crownFraction: float
    embedAxes: bool
    jawsShareFrame: _core.JawsShareFrame | str
    maximumIterations: int
    numberOfWorkUnits: int
    requireArches: bool
    transformMeshes: bool

class WriteContoursSettings(TypedDict, total=False):
    numberOfWorkUnits: int
    numbering: _core.Numbering | str

class BatchSettings(TypedDict, total=False):
    anonymous: bool
    exclude: Sequence[str]
    fix: Sequence[str]
    init: Optional[Union[PathLike, CaseResult]]
    options: Optional[Mapping[str, Any]]
    page: bool
    preset: Union[str, _core.Preset]
    silhouette: str
    threads: Optional[int]
