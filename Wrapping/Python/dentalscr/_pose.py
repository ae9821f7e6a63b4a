"""Registration of scans by their pose: the method, what lies downstream of it, and metrics of one's own."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Dict, NamedTuple, Optional, Tuple, Union, cast

from . import _core
from ._errors import ArgumentError
from ._filters import DentalAxes, as_rigid
from ._inputs import (
    Array,
    ContourLike,
    ImageLike,
    LandmarksLike,
    MeshLike,
    TransformLike,
    as_cephalometric_landmarks,
    as_contour,
    as_geometry,
    as_image,
    as_landmarks,
    as_mesh,
)
from ._io import ReadCephalometricLandmarks
from ._process import Observable, ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings

#: A jaw or its name.
JawLike = Union[str, _core.Jaw]


def _read_landmarks(value: Any) -> Optional[Dict[str, Dict[str, Any]]]:
    """Landmarks of an analysis from what ``Case`` takes: a dictionary, the path of a file, or None."""
    given = None if value is None else as_cephalometric_landmarks(value)
    return ReadCephalometricLandmarks(given) if isinstance(given, str) else given


class LevenbergMarquardtOptimizerv4(Observable, _core.LevenbergMarquardtOptimizerv4):
    """Levenberg-Marquardt for metrics that are, or are majorised by, sums of squares.

    ``SetMetric``, ``StartOptimization``; commands ask ``GetCurrentIteration``, ``GetCurrentMetricValue``,
    ``GetCurrentPosition``, ``GetStepAccepted``, ``GetStepLength``. An exception in a command or in a metric of yours
    comes out of ``StartOptimization``, with the metric back at the best position.
    """


class SilhouettePoseMetricv4(_core.SilhouettePoseMetricv4):
    """A scan's silhouette against a tracing of it: the term of a jaw in a registration of its pose.

    Reads the blocks "pose" (pitch, roll, yaw, tx, ty, tz) and "scale" (kappa), or as named by ``SetPoseBlock`` and
    ``SetScaleBlock``.
    """

    def SetMovingMesh(self, mesh: MeshLike) -> None:
        """The scan in its dental frame, mm: ``UMidlineDentalAxis(...).upper``."""
        self._SetMovingMesh(as_mesh(mesh))

    def SetMovingContour(self, contour: Optional[ContourLike]) -> None:
        """In place of a scan: an outline as it is seen with the transform as it stands, continuous pixel indices.

        It moves as a drawing on the midsagittal plane does: by a similarity, where ``SetBlockFree("pose", [True, False,
        False, True, False, True])`` holds roll, yaw and ty.
        """
        self._SetMovingContour(None if contour is None else as_contour(contour))

    def SetFixedContour(self, contour: ContourLike) -> None:
        """The tracing of this jaw, continuous pixel indices."""
        self._SetFixedContour(as_contour(contour))


class LandmarkPoseMetricv4(_core.LandmarkPoseMetricv4):
    """Landmarks of a scan against landmarks of the radiograph: a term of a registration of the scan's pose.

    Landmarks of the same name belong together. The errors of the marks are ``SetSigma``, for all of them, or
    ``SetCovariance``. Landmarks are never used unless you add this term.
    """

    def SetMovingLandmarks(self, landmarks: LandmarksLike) -> None:
        """Of the scan in its dental frame, mm: ``{"UR1_tip": (x, y, z)}`` or a file."""
        self._SetMovingLandmarks(as_landmarks(landmarks, 3))

    def SetFixedLandmarks(self, landmarks: LandmarksLike) -> None:
        """Of the radiograph, continuous pixel indices: ``{"UR1_tip": (u, v)}`` or a file."""
        self._SetFixedLandmarks(as_landmarks(landmarks, 2))


class OutlineResidual(NamedTuple):
    """How the outline of a tooth is explained."""

    #: "U1", "L6"; of a frontal radiograph "UR1".
    name: str
    #: (2,), how far the hand has shifted it, as far as can be told: drawn minus projected, pixels.
    shift: Array
    #: Of shift, turn and size together, in standard deviations of a shift: 1.4 on average.
    distance: float
    #: What the robust kernel leaves of it, 1 to 0.
    weight: float
    #: Share of its points that lie on the crown, after shift, turn and size.
    matchedShare: float
    #: Its shape is a stock template's, not the tooth's own.
    isTemplate: bool
    #: (n, 2), the projected outline of the crown that it was compared with, pixels.
    crown: Array


class ToothOutlinePoseMetricv4(_core.ToothOutlinePoseMetricv4):
    """Crowns of a scan against outlines of whole teeth, as an analysis draws them: a term of the scan's pose.

    Each tooth has errors of its own as a whole (``SetErrors``), and its points have a hand's. ``Initialize`` and
    ``UpdateNoiseCorrelation`` settle, at the position as it is, what of each outline counts; call the latter between
    runs of an optimizer.
    """

    def SetCrowns(self, crowns: Dict[str, "ToothCrown"]) -> None:
        """Crowns in the dental frame, mm: those of :func:`FindToothCrowns`, their points moved by the frame."""
        self._SetCrowns({name: tuple(crown) for name, crown in crowns.items()})

    def SetFixedContour(self, contour: ContourLike) -> None:
        """The outlines of this jaw's teeth, polylines with their codes, continuous pixel indices."""
        self._SetFixedContour(as_contour(contour))

    def GetOutlineResiduals(self) -> Tuple[OutlineResidual, ...]:
        """How each outline is explained where the state stands; after ``Initialize``."""
        return tuple(OutlineResidual(*values) for values in self._GetOutlineResiduals())


class LeastSquaresMetric(_core._LeastSquaresMetric):
    """A metric of your own: derive from it and say which parameters it reads and what its residuals are.

    Give it to ``PoseRegistrationMethod.AddMetric``, to a ``LeastSquaresSumMetricv4`` or to an optimizer. It may read
    the blocks "pose" and "scale" of a registration, which are those of the dental frame, or blocks of its own, which
    are then estimated as well::

        class IncisorPlane(ds.LeastSquaresMetric):
            def blocks(self):
                return ["pose"]

            def residuals(self, values):
                pitch, roll, yaw, tx, ty, tz = values["pose"]
                return [(tz - 3.0) / 0.5]

    A registration clones metrics into other threads. Clones share the Python object: its methods are called with the
    interpreter taken, one at a time, but from several threads in turn, so they should change nothing in the object. An
    exception in them ends what runs and comes out of ``Execute`` or ``StartOptimization`` unchanged. A class with an
    ``__init__`` of its own calls ``super().__init__()``.
    """

    def __init__(self) -> None:
        super().__init__()
        self._Bind(self)

    def blocks(self) -> Union[str, _core.StateBlock, Sequence[Union[str, _core.StateBlock]]]:
        """What the metric reads: "pose", "scale", :class:`StateBlock` objects; asked for once."""
        raise NotImplementedError(f"{type(self).__name__} needs blocks(): the names of what it reads")

    def residuals(self, values: Dict[str, Array]) -> Any:
        """(N,) numbers, each divided by its standard deviation; the criterion is the sum of their squares.

        Parameters
        ----------
        values : dict
            From the name of a block to the values of its parameters, rad and mm.
        """
        raise NotImplementedError(f"{type(self).__name__} needs residuals(values)")

    def jacobian(self, values: Dict[str, Array]) -> Any:
        """Derivatives of the residuals by the values; None, as here: they are found by differences.

        Returns
        -------
        dict or array
            From the name of a block to (N, M), M its parameters; blocks that are left out have none. Or (N, M) for the
            parameters of all blocks one beside the other.
        """
        return None


class PoseRegistrationMethod(ProcessObject, _core.PoseRegistrationMethod):
    """The robust registration: scans and tracing to pose, scale and uncertainty.

    In a command, ``GetCurrentIteration()`` says what is tried: level, stage, candidate, pose, value, whether the step
    was accepted and how long it is, kernel width, noise. ``Abort()`` there ends the run.
    """

    def SetUpperFrame(self, transform: Optional[TransformLike]) -> None:
        """Mesh to dental frame (midline refined) of the upper scan instead of an estimated one; None for that."""
        self._SetUpperFrame(as_rigid(transform))

    def SetLowerFrame(self, transform: Optional[TransformLike]) -> None:
        """Mesh to dental frame (midline refined) of the lower scan instead of an estimated one; None for that."""
        self._SetLowerFrame(as_rigid(transform))

    def SetJointFrame(self, transform: Optional[TransformLike]) -> None:
        """One frame for both scans, which are in occlusion: they get one pose. None where they are not."""
        self._SetJointFrame(as_rigid(transform))

    def SetFrames(self, axes: Optional[DentalAxes]) -> None:
        """All three frames as ``UMidlineDentalAxis(..., refineMidline=True)`` has them; None: estimate them."""
        self.SetUpperFrame(None if axes is None else axes.upperTransform)
        self.SetLowerFrame(None if axes is None else axes.lowerTransform)
        self.SetJointFrame(None if axes is None else axes.jointTransform)

    def SetInitialTransform(self, jaw: JawLike, transform: TransformLike, scaleFactor: float = 1.0) -> None:
        """Which place of the jaw is meant: what the search finds elsewhere is left out.

        The answer is the one without a start, wherever in its place the start is; where the search finds nothing there,
        or something is held, the registration goes on from the start itself.

        Parameters
        ----------
        jaw : "Upper" or "Lower"
        transform : transform-like
            Mesh frame to cephalostat frame, mm.
        scaleFactor : float, optional
            On the magnification.
        """
        rigid = as_rigid(transform)
        if rigid is None:
            raise ArgumentError("an initial transform maps the mesh to the cephalostat; ClearInitialTransforms()")
        self._SetInitialTransform(cast(_core.Jaw, jaw), rigid, scaleFactor)

    def SetInitialGeometry(self, geometry: Optional[Any]) -> None:
        """The geometry that the initial transforms are of, where it is another than the radiograph's: they are converted.

        Parameters
        ----------
        geometry : CephalometricGeometry, dict or None
            That of an earlier registration. A pixel spacing that this radiograph does not have is estimated as without
            a start, or is this one's where a part of the pose is held. None: they are of the radiograph's own.
        """
        self._SetInitialGeometry(None if geometry is None else as_geometry(geometry))

    def AddView(
        self,
        geometry: Any,
        upperContour: Optional[ContourLike] = None,
        lowerContour: Optional[ContourLike] = None,
        cephalometricLandmarks: Optional[Any] = None,
        counterparts: Optional[Dict[str, LandmarkCounterpart]] = None,
        name: str = "frontal",
        sameHeadPosition: bool = True,
        principalPointSigma: float = 4.0,
    ) -> None:
        """A further radiograph of the patient, as evidence beside the lateral one (Documentation/Views.md).

        Parameters
        ----------
        geometry : CephalometricGeometry or dict
            Of this radiograph, ``direction="Frontal"`` for one from the front; with pixel spacing and principal point.
        upperContour, lowerContour : contour-like, optional
            Drawn on it, continuous pixel indices: of a frontal one single teeth with the codes of their sides.
        cephalometricLandmarks : dict or path, optional
            Marked on it, with their sides: ``{"UR1_tip": (u, v)}``.
        counterparts : dict, optional
            Of ``FindLandmarkCounterparts()``.
        name : str, optional
            What results call it.
        sameHeadPosition : bool, optional
            Whether both were taken at once. If not, small rotations and shifts of the head are estimated along.
        principalPointSigma : float, optional
            How well the principal point is known, pixels, 1 sd an axis.
        """
        self._AddView(
            name,
            as_geometry(geometry),
            None if upperContour is None else as_contour(upperContour, "upper"),
            None if lowerContour is None else as_contour(lowerContour, "lower"),
            _read_landmarks(cephalometricLandmarks),
            None if counterparts is None else dict(counterparts),
            sameHeadPosition,
            principalPointSigma,
        )

    def SetOptimizer(self, optimizer: _core.ObjectToObjectOptimizerBase) -> None:
        """A ``LevenbergMarquardtOptimizerv4``, of which candidates take clones, also in other threads.

        ``SetOptimizerAsLBFGSB`` and ``SetOptimizerAsLBFGS2`` choose another, which runs in one thread. Tolerances and numbers of iterations are those of the options. Commands of the optimizer are called in the
        thread that runs ``Execute``; ``StopOptimization()`` in one ends the registration.
        """
        super().SetOptimizer(optimizer)
        # Its commands are the Python object's.
        self.__dict__["_optimizer"] = optimizer

    def Execute(
        self,
        geometry: Any,
        upper: Optional[MeshLike] = None,
        upperContour: Optional[ContourLike] = None,
        lower: Optional[MeshLike] = None,
        lowerContour: Optional[ContourLike] = None,
        cephalometricLandmarks: Optional[Any] = None,
        counterparts: Optional[Dict[str, LandmarkCounterpart]] = None,
        toothCrowns: Optional[Dict[str, ToothCrown]] = None,
        stockOutlines: Optional[ContourLike] = None,
    ) -> _core.PoseSolution:
        """Registers one jaw or both.

        Parameters
        ----------
        geometry : CephalometricGeometry or dict
            Nominal, without a pose; without a pixel spacing the scale is estimated.
        upper, lower : mesh-like, optional
            mm, any orientation.
        upperContour, lowerContour : contour-like, optional
            The tracing of each jaw, continuous pixel indices.
        cephalometricLandmarks : dict or path, optional
            Marked on the radiograph, as the argument of :class:`Case`; they need ``counterparts``.
        counterparts : dict, optional
            Of ``FindLandmarkCounterparts()``.
        toothCrowns : dict, optional
            Of ``FindToothCrowns()``: outlines of whole teeth (traced side "standard") are compared with them.
        stockOutlines : contour-like, optional
            Closed outlines that the reader's software offers, of any size: outlines that are one of them, moved, are
            templates, of which tip and axis count.
        """
        if (cephalometricLandmarks is None) != (counterparts is None):
            raise ArgumentError(
                "landmarks and where they are on the scans belong together: give cephalometricLandmarks and the "
                "counterparts that FindLandmarkCounterparts() finds"
            )
        self._SetCephalometricLandmarks(_read_landmarks(cephalometricLandmarks))
        self._SetLandmarkCounterparts(None if counterparts is None else dict(counterparts))
        self._SetToothCrowns(None if toothCrowns is None else dict(toothCrowns))
        self._SetStockOutlines(None if stockOutlines is None else as_contour(stockOutlines))
        self._SetGeometry(as_geometry(geometry))
        self._SetUpperMesh(None if upper is None else as_mesh(upper))
        self._SetLowerMesh(None if lower is None else as_mesh(lower))
        self._SetUpperContour(None if upperContour is None else as_contour(upperContour, "upper"))
        self._SetLowerContour(None if lowerContour is None else as_contour(lowerContour, "lower"))
        self._Update()
        return self._GetSolution()

    def TryHypothesis(self, hypothesis: _core.PoseHypothesis, jaw: JawLike) -> _core.PoseHypothesisOutcome:
        """Runs a hypothesis alone beside what :meth:`Execute` found, however good the fit is.

        What comes out is what would stand in the solution's ``GetOutcomes(jaw)``. Commands see the steps of the trial.

        Parameters
        ----------
        hypothesis : PoseHypothesis
            ``OtherSideHypothesis()``, ``OtherFacingHypothesis()``, ``ExchangedJawsHypothesis()``; it need not have been
            added.
        jaw : "Upper" or "Lower"
            Of the group of jaws, with one pose, that is asked about.
        """
        return self._TryHypothesis(hypothesis, cast(_core.Jaw, jaw))


def PoseRegistration(
    geometry: Any,
    upper: Optional[MeshLike] = None,
    upperContour: Optional[ContourLike] = None,
    lower: Optional[MeshLike] = None,
    lowerContour: Optional[ContourLike] = None,
    frames: Optional[DentalAxes] = None,
    options: Optional[_core.PoseRegistrationOptions] = None,
    cephalometricLandmarks: Optional[Any] = None,
    counterparts: Optional[Dict[str, LandmarkCounterpart]] = None,
    toothCrowns: Optional[Dict[str, ToothCrown]] = None,
    **settings: Unpack[_settings.PoseRegistrationSettings],
) -> _core.PoseSolution:
    """The robust registration; see :class:`PoseRegistrationMethod`.

    Parameters
    ----------
    geometry : CephalometricGeometry or dict
    upper, lower : mesh-like, optional
    upperContour, lowerContour : contour-like, optional
    frames : DentalAxes, optional
        Of ``UMidlineDentalAxis(upper, lower, refineMidline=True)``; estimated without it.
    options : PoseRegistrationOptions, optional
    cephalometricLandmarks, counterparts, toothCrowns
        As those of :meth:`PoseRegistrationMethod.Execute`.
    **settings
        ``tracedSide``, ``principalPointKnown``, ...
    """
    process = PoseRegistrationMethod()
    process.SetFrames(frames)
    if options is not None:
        process.SetOptions(options)
    apply_settings(process, settings)
    return process.Execute(
        geometry, upper, upperContour, lower, lowerContour, cephalometricLandmarks, counterparts, toothCrowns
    )


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

    def Execute(self, solution: _core.PoseSolution, landmarks: LandmarksLike) -> LandmarkProjections:
        """Projects the landmarks of the jaws that were registered.

        Parameters
        ----------
        solution : PoseSolution
        landmarks : landmarks-like
            ``{"UR1_tip": (x, y, z)}`` or a file, in the frame of the mesh files; ``SetMillimetresPerUnit`` says in what
            unit.
        """
        self._SetSolution(solution)
        self._SetLandmarks(as_landmarks(landmarks, 3))
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


class LandmarkCounterpart(NamedTuple):
    """Where a landmark of a cephalometric analysis is on a scan."""

    #: (1 or 2, 3), mesh frame, mm: one point, or one of each side.
    points: Array
    #: What is imaged of two points: "middle" or "foremost".
    rule: str
    #: Standard deviation of the counterpart along the occlusal plane, mm.
    sigmaAlong: float
    #: Standard deviation across it, mm.
    sigmaAcross: float
    #: How it was found: "landmarks_3d", "tooth labels", "its place along the arch".
    source: str


class LandmarkCounterpartFilter(ProcessObject, _core.LandmarkCounterpartFilter):
    """Finds on the scans what a cephalometric analysis has marked on the radiograph."""

    def Execute(
        self,
        landmarks: Any,
        upperMesh: Optional[MeshLike] = None,
        lowerMesh: Optional[MeshLike] = None,
        upperFrame: Optional[TransformLike] = None,
        lowerFrame: Optional[TransformLike] = None,
        scanLandmarks: Optional[LandmarksLike] = None,
        direction: Any = None,
    ) -> Dict[str, LandmarkCounterpart]:
        """Finds a counterpart of each landmark; ``GetUnused`` lists those without one, and why.

        Parameters
        ----------
        landmarks : dict or path
            As the argument cephalometricLandmarks of :class:`Case`.
        upperMesh, lowerMesh : mesh-like, optional
            Scans, mm. A jaw without one has no counterparts.
        upperFrame, lowerFrame : transform-like, optional
            Mesh to dental frame, of :func:`UMidlineDentalAxis`. Without it only ``scanLandmarks`` are found.
        scanLandmarks : landmarks-like, optional
            Landmarks of the scans in the frame of the mesh files; ``SetMillimetresPerUnit`` says in what unit.
        direction : Direction or str, optional
            Of the radiograph, "Lateral" or "Frontal"; as it was set where it is not given.
        """
        if direction is not None:
            self.SetDirection(direction)
        given = as_cephalometric_landmarks(landmarks)
        self._SetCephalometricLandmarks(ReadCephalometricLandmarks(given) if isinstance(given, str) else given)
        self._SetScanLandmarks({} if scanLandmarks is None else as_landmarks(scanLandmarks, 3))
        self._SetUpperMesh(None if upperMesh is None else as_mesh(upperMesh))
        self._SetLowerMesh(None if lowerMesh is None else as_mesh(lowerMesh))
        self._SetUpperFrame(as_rigid(upperFrame))
        self._SetLowerFrame(as_rigid(lowerFrame))
        self._Update()
        return {name: LandmarkCounterpart(*found) for name, found in self._GetCounterparts().items()}


def FindLandmarkCounterparts(
    landmarks: Any,
    **inputs: Unpack[_settings.FindLandmarkCounterpartsSettings],
) -> Dict[str, LandmarkCounterpart]:
    """Where an analysis's landmarks are on the scans; see :class:`LandmarkCounterpartFilter`."""
    return LandmarkCounterpartFilter().Execute(landmarks, **inputs)


class ToothCrown(NamedTuple):
    """The crown of one tooth, cut out of a scan."""

    #: (n, 3), mesh frame, mm.
    points: Array
    #: (m, 3) indices into the points.
    triangles: Array
    #: How far the cut may be from the crown along the arch, standard deviation, mm.
    sigmaAlong: float
    #: How far its ends may be from the crown's, mm.
    sigmaWidth: float
    #: How it was found: "tooth labels", "landmarks_3d", "its place along the arch".
    source: str


class ToothCrownFilter(ProcessObject, _core.ToothCrownFilter):
    """Cuts the crowns of the teeth that an analysis has outlined out of the scans."""

    def Execute(
        self,
        upperContour: Optional[ContourLike] = None,
        lowerContour: Optional[ContourLike] = None,
        upperMesh: Optional[MeshLike] = None,
        lowerMesh: Optional[MeshLike] = None,
        upperFrame: Optional[TransformLike] = None,
        lowerFrame: Optional[TransformLike] = None,
        scanLandmarks: Optional[LandmarksLike] = None,
    ) -> Dict[str, ToothCrown]:
        """Cuts out each tooth with a code in a contour, and its fellow of the other side.

        Parameters
        ----------
        upperContour, lowerContour : contour-like, optional
            Outlines, of which only the codes of the teeth are read.
        upperMesh, lowerMesh : mesh-like, optional
            Scans, mm.
        upperFrame, lowerFrame : transform-like, optional
            Mesh to dental frame, of :func:`UMidlineDentalAxis`.
        scanLandmarks : landmarks-like, optional
            Landmarks of the scans in the frame of the mesh files; ``SetMillimetresPerUnit`` says in what unit.

        Returns
        -------
        dict
            Name of the tooth to :class:`ToothCrown`; ``GetMissing`` names those that were not found.
        """
        self._SetUpperContour(None if upperContour is None else as_contour(upperContour))
        self._SetLowerContour(None if lowerContour is None else as_contour(lowerContour))
        self._SetUpperMesh(None if upperMesh is None else as_mesh(upperMesh))
        self._SetLowerMesh(None if lowerMesh is None else as_mesh(lowerMesh))
        self._SetUpperFrame(as_rigid(upperFrame))
        self._SetLowerFrame(as_rigid(lowerFrame))
        self._SetScanLandmarks({} if scanLandmarks is None else as_landmarks(scanLandmarks, 3))
        self._Update()
        return {name: ToothCrown(*found) for name, found in self._GetCrowns().items()}


def FindToothCrowns(**inputs: Unpack[_settings.FindToothCrownsSettings]) -> Dict[str, ToothCrown]:
    """The crowns of teeth that an analysis has outlined; see :class:`ToothCrownFilter`."""
    return ToothCrownFilter().Execute(**inputs)


class TracedSides(NamedTuple):
    """What :class:`TracedSideFilter` found out of a drawing."""

    #: Which side was traced.
    side: _core.TracedSide
    #: What that was decided by, as a clause.
    reason: str
    #: The drawing without the teeth of the other side; empty for a jaw without one.
    upper: _core.Contour
    lower: _core.Contour
    #: Names of the teeth that were left out, one a polyline.
    leftOut: Tuple[str, ...]


class TracedSideFilter(ProcessObject, _core.TracedSideFilter):
    """Which side's outlines a drawing shows, where nobody says it, and the drawing without the other side's."""

    def Execute(
        self,
        upperContour: Optional[ContourLike] = None,
        lowerContour: Optional[ContourLike] = None,
        cephalometricLandmarks: Optional[Any] = None,
    ) -> TracedSides:
        """Settles the side; ``SetTracedSide`` and ``TracedSideIsGivenOn`` say one.

        Parameters
        ----------
        upperContour, lowerContour : contour-like, optional
            What was drawn of each jaw, continuous pixel indices.
        cephalometricLandmarks : dict or path, optional
            As the argument of :class:`Case`.
        """
        self._SetUpperContour(None if upperContour is None else as_contour(upperContour, "upper"))
        self._SetLowerContour(None if lowerContour is None else as_contour(lowerContour, "lower"))
        self._SetCephalometricLandmarks(_read_landmarks(cephalometricLandmarks))
        self._Update()
        return TracedSides(
            self.GetSettledSide(),
            self.GetReason(),
            self._TakeOutput(_core.Jaw.Upper),
            self._TakeOutput(_core.Jaw.Lower),
            tuple(self.GetLeftOutTeeth()),
        )


def FindTracedSide(
    upperContour: Optional[ContourLike] = None,
    lowerContour: Optional[ContourLike] = None,
    cephalometricLandmarks: Optional[Any] = None,
    **settings: Unpack[_settings.FindTracedSideSettings],
) -> TracedSides:
    """Which side a drawing shows; see :class:`TracedSideFilter`. Settings: ``tracedSide``, ``codesHaveSides``, ..."""
    process = TracedSideFilter()
    apply_settings(process, settings)
    return process.Execute(upperContour, lowerContour, cephalometricLandmarks)


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
