"""What lies downstream of a registration of the pose: verdict, landmarks, checks of the inputs, other views of the result."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, NamedTuple, Optional, Tuple, cast

from . import _core
from ._errors import ArgumentError
from ._filters import DentalAxes, as_rigid
from ._inputs import (
    Array,
    ContourLike,
    ImageLike,
    JawLike,
    LandmarksLike,
    MeshLike,
    TransformLike,
    as_contour,
    as_geometry,
    as_image,
    as_landmarks,
    as_mesh,
)
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings
    from ._pose_inputs import LandmarkCounterpart


class RegistrationFinding(NamedTuple):
    """Why a jaw is not simply ok; Documentation/Findings.md lists the codes with what to do about each."""

    #: "suspect" or "failed".
    severity: str
    #: Short and stable, for programs: "poor-fit".
    code: str
    #: For a person.
    text: str
    #: What was measured; None where no number decides.
    value: Optional[float] = None
    #: What it is beyond.
    limit: Optional[float] = None
    #: Of both: "px" (of 0.25 mm), "mm", "deg", "sd" (standard deviations), "" (none).
    unit: str = ""


class JawVerdict(NamedTuple):
    """The verdict on one jaw."""

    #: "ok", "suspect" (a person should look) or "failed".
    status: str
    findings: Tuple[RegistrationFinding, ...]

    @property
    def reasons(self) -> Tuple[str, ...]:
        """The findings' sentences."""
        return tuple(finding.text for finding in self.findings)


class RegistrationVerdicts(NamedTuple):
    """The verdict on both jaws; None where one had no input."""

    upper: Optional[JawVerdict]
    lower: Optional[JawVerdict]
    #: What the data could not tell, as sentences.
    notCheckable: Tuple[str, ...]
    #: The verdict on each further view, by its name. One that is not ok makes the jaws suspect.
    views: Dict[str, JawVerdict] = {}

    @property
    def status(self) -> str:
        """The worst of the jaws."""
        order = ("ok", "suspect", "failed")
        return max((jaw.status for jaw in (self.upper, self.lower) if jaw is not None), key=order.index, default="failed")


class RegistrationVerdictFilter(ProcessObject, _core.RegistrationVerdictFilter):
    """Judges a pose registration: ok, suspect (a person should look) or failed, a jaw each, with findings."""

    def Execute(self, solution: _core.PoseSolution) -> RegistrationVerdicts:
        """Judges what :class:`PoseRegistrationMethod` returned."""
        self._SetSolution(solution)
        self._Update()
        return RegistrationVerdicts(
            self._make(self._GetVerdict(_core.Jaw.Upper)),
            self._make(self._GetVerdict(_core.Jaw.Lower)),
            tuple(self.GetNotCheckable()),
            {name: self._make(found) for name, found in self._GetViewVerdicts().items()},
        )

    @staticmethod
    def _make(found: Any) -> Any:
        return None if found is None else JawVerdict(found[0], tuple(RegistrationFinding(*each) for each in found[1]))


def RegistrationVerdict(
    solution: _core.PoseSolution,
    **settings: Unpack[_settings.RegistrationVerdictSettings],
) -> RegistrationVerdicts:
    """Judges a pose registration; see :class:`RegistrationVerdictFilter`. ``thresholds`` is a setting."""
    process = RegistrationVerdictFilter()
    apply_settings(process, settings)
    return process.Execute(solution)


class LandmarkProjections(NamedTuple):
    """Landmarks of the scans on the radiograph, by name."""

    #: (u, v), pixels.
    positions: Dict[str, Array]
    #: (2, 2), square pixels.
    covariances: Dict[str, Array]
    #: Standard deviation an axis, pixels.
    sigmas: Dict[str, float]
    #: (2, 2): of the middle between a right landmark and its left one, which a bisected tracing determines.
    middleCovariances: Dict[str, Array]

    def __repr__(self) -> str:
        return f"<dentalscr.LandmarkProjections of {len(self.positions)} landmarks, {len(self.middleCovariances)} middles>"


class LandmarkProjectionFilter(ProcessObject, _core.LandmarkProjectionFilter):
    """Landmarks of the scans as a pose registration places them on the radiograph, with their uncertainty."""

    def Execute(
        self,
        solution: _core.PoseSolution,
        landmarks: Optional[LandmarksLike] = None,
        counterparts: Optional[Dict[str, LandmarkCounterpart]] = None,
    ) -> LandmarkProjections:
        """Projects the landmarks of the jaws that were registered.

        Parameters
        ----------
        solution : PoseSolution
        landmarks : landmarks-like, optional
            ``{"UR1_tip": (x, y, z)}`` or a file, in the frame of the mesh files; ``SetMillimetresPerUnit`` says in what
            unit.
        counterparts : dict, optional
            Of ``FindLandmarkCounterparts()``: points found on the scans, of which ``GetMiddles()`` tells too where
            ``landmarks`` has none of that name. One of both must be given.
        """
        if landmarks is None and counterparts is None:
            raise ArgumentError("there is nothing to project: give landmarks, or counterparts of FindLandmarkCounterparts()")
        self._SetSolution(solution)
        self._SetLandmarks({} if landmarks is None else as_landmarks(landmarks, 3))
        self._SetCounterparts(None if counterparts is None else dict(counterparts))
        self._Update()
        positions = cast("Dict[str, Array]", self._GetOutput())
        return LandmarkProjections(
            positions,
            {name: self.GetCovariance(name) for name in positions},
            {name: self.GetSigma(name) for name in positions},
            {name: self.GetMiddleCovariance(name) for name in positions if self.HasMiddleCovariance(name)},
        )


def LandmarkProjection(
    solution: _core.PoseSolution, landmarks: LandmarksLike, millimetresPerUnit: float = 1.0
) -> LandmarkProjections:
    """Landmarks on the radiograph; see :class:`LandmarkProjectionFilter`."""
    process = LandmarkProjectionFilter()
    process.SetMillimetresPerUnit(millimetresPerUnit)
    return process.Execute(solution, landmarks)


class ScanFindings(NamedTuple):
    """What :class:`ScanCheckFilter` says of each scan; nothing where it is as it should be."""

    upper: Tuple[RegistrationFinding, ...]
    lower: Tuple[RegistrationFinding, ...]
    #: What the data could not tell, as sentences.
    notCheckable: Tuple[str, ...]


class ScanCheckFilter(ProcessObject, _core.ScanCheckFilter):
    """What can be said of the scans before anything is registered: unit, both jaws in one, a quadrant, mirrored, ..."""

    def Execute(
        self,
        axes: DentalAxes,
        upperMesh: Optional[MeshLike] = None,
        lowerMesh: Optional[MeshLike] = None,
        landmarks: Optional[LandmarksLike] = None,
    ) -> ScanFindings:
        """Judges one scan or both.

        Parameters
        ----------
        axes : DentalAxes
            What ``UMidlineDentalAxis(upper, lower, requireArches=False)`` found of the same scans.
        upperMesh, lowerMesh : mesh-like, optional
            The scans, mm; at least one.
        landmarks : landmarks-like, optional
            Of the scans, in their frame; ``SetMillimetresPerUnit`` says in what unit.
        """
        if axes.frames is None:
            raise ArgumentError("these axes were made by hand: give those of UMidlineDentalAxis(), which keep what it found")
        self._SetFrames(axes.frames)
        self._SetUpperMesh(None if upperMesh is None else as_mesh(upperMesh))
        self._SetLowerMesh(None if lowerMesh is None else as_mesh(lowerMesh))
        self._SetLandmarks({} if landmarks is None else as_landmarks(landmarks, 3))
        self._Update()
        found = [
            tuple(RegistrationFinding(*each) for each in self._GetFindings(jaw))
            for jaw in (_core.Jaw.Upper, _core.Jaw.Lower)
        ]
        return ScanFindings(found[0], found[1], tuple(self.GetNotCheckable()))


def ScanCheck(
    axes: DentalAxes,
    upperMesh: Optional[MeshLike] = None,
    lowerMesh: Optional[MeshLike] = None,
    landmarks: Optional[LandmarksLike] = None,
    **settings: Unpack[_settings.ScanCheckSettings],
) -> ScanFindings:
    """Judges scans before a registration; see :class:`ScanCheckFilter`."""
    process = ScanCheckFilter()
    apply_settings(process, settings)
    return process.Execute(axes, upperMesh, lowerMesh, landmarks)


class PictureFindings(NamedTuple):
    """What :class:`PictureCheckFilter` says of a radiograph; nothing where what was drawn lies on its edges."""

    findings: Tuple[RegistrationFinding, ...]
    #: What the data could not tell, as sentences.
    notCheckable: Tuple[str, ...]


class PictureCheckFilter(ProcessObject, _core.PictureCheckFilter):
    """Whether a radiograph is the one that was drawn on, as far as its grey values tell."""

    def Execute(
        self,
        radiograph: Optional[ImageLike],
        geometry: Any,
        upperContour: Optional[ContourLike] = None,
        lowerContour: Optional[ContourLike] = None,
    ) -> PictureFindings:
        """Looks for edges of the picture under what was drawn.

        Parameters
        ----------
        radiograph : image-like or None
            The picture; without one nothing can be told.
        geometry : CephalometricGeometry or dict
            Its pixel spacing says how wide an edge is.
        upperContour, lowerContour : contour-like, optional
            What was drawn of each jaw, continuous pixel indices.
        """
        self._SetRadiograph(None if radiograph is None else as_image(radiograph))
        self._SetGeometry(as_geometry(geometry))
        self._SetUpperContour(None if upperContour is None else as_contour(upperContour, "upper"))
        self._SetLowerContour(None if lowerContour is None else as_contour(lowerContour, "lower"))
        self._Update()
        return PictureFindings(
            tuple(RegistrationFinding(*each) for each in self._GetFindings()), tuple(self.GetNotCheckable())
        )


def PictureCheck(
    radiograph: Optional[ImageLike],
    geometry: Any,
    upperContour: Optional[ContourLike] = None,
    lowerContour: Optional[ContourLike] = None,
) -> PictureFindings:
    """Whether a radiograph is the one that was drawn on; see :class:`PictureCheckFilter`."""
    return PictureCheckFilter().Execute(radiograph, geometry, upperContour, lowerContour)


class MatchedContourFilter(ProcessObject, _core.MatchedContourFilter):
    """The part of a moving contour that has a tracing beside it, in pieces."""

    def Execute(self, fixed: ContourLike, moving: ContourLike) -> _core.Contour:
        """Keeps what lies near the tracing.

        Parameters
        ----------
        fixed : contour-like
            The tracing.
        moving : contour-like
            ``PoseSolution.GetMovingContour(jaw)``.
        """
        self._SetFixedContour(as_contour(fixed))
        self._SetMovingContour(as_contour(moving))
        self._Update()
        return self._TakeOutput()


def MatchedContour(
    fixed: ContourLike, moving: ContourLike, maximumDistance: float = 10.0, maximumGap: float = 12.0
) -> _core.Contour:
    """The matched part of a moving contour; see :class:`MatchedContourFilter`. Lengths in pixels."""
    process = MatchedContourFilter()
    process.SetMaximumDistance(maximumDistance)
    process.SetMaximumGap(maximumGap)
    return process.Execute(fixed, moving)


class ProjectedSimilarity(NamedTuple):
    """The similarity nearest to a pose."""

    #: Maps the geometry's own projection of the frame, pixels, to the radiograph.
    transform: _core.Similarity2DTransform
    #: What it leaves, pixels: a pose parallaxes with depth, and a similarity can't.
    rms: float


class ProjectionSimilarityFilter(ProcessObject, _core.ProjectionSimilarityFilter):
    """The 2-D similarity that comes nearest to a registered pose: what the paper's method would have to find."""

    def Execute(self, solution: _core.PoseSolution, mesh: MeshLike, frame: TransformLike) -> ProjectedSimilarity:
        """Fits over the scan's points; ``SetJaw`` says of which jaw.

        Parameters
        ----------
        solution : PoseSolution
        mesh : mesh-like
            The scan, mm.
        frame : transform-like
            Mesh to dental frame, of :func:`UMidlineDentalAxis`.
        """
        rigid = as_rigid(frame)
        if rigid is None:
            raise ArgumentError("frame is needed: mesh to dental frame, of UMidlineDentalAxis()")
        self._SetSolution(solution)
        self._SetMesh(as_mesh(mesh))
        self._SetFrame(rigid)
        self._Update()
        return ProjectedSimilarity(cast(_core.Similarity2DTransform, self._GetTransform()), self.GetRMS())


def ProjectionSimilarity(
    solution: _core.PoseSolution, mesh: MeshLike, frame: TransformLike, jaw: JawLike = "Upper"
) -> ProjectedSimilarity:
    """The similarity nearest to a pose; see :class:`ProjectionSimilarityFilter`."""
    process = ProjectionSimilarityFilter()
    process.SetJaw(cast(_core.Jaw, jaw))
    return process.Execute(solution, mesh, frame)
