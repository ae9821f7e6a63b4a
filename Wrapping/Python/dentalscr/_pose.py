"""Registration of scans by their pose: the method."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional, cast

from . import _core
from ._errors import ArgumentError
from ._filters import DentalAxes, as_rigid
from ._inputs import ContourLike, JawLike, MeshLike, TransformLike, as_contour, as_geometry, as_mesh
from ._pose_inputs import LandmarkCounterpart, ToothCrown, read_landmarks
from ._pose_metrics import require_residuals
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings


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
            read_landmarks(cephalometricLandmarks),
            None if counterparts is None else dict(counterparts),
            sameHeadPosition,
            principalPointSigma,
        )

    def AddMetric(self, metric: _core.LeastSquaresMetricv4, jaw: JawLike = _core.Jaw.Unknown) -> None:
        """A further term of the sum that is minimized: a :class:`LeastSquaresMetric` of your own, a prior, another sum.

        It may read the blocks "pose" and "scale", which are those of the dental frame, or have blocks of its own. Jaws that
        stand apart have a sum each: with a jaw it is a term of that jaw's alone. Its robust kernel and noise stay its own.
        The registration works on clones of it. A metric without residuals is a TypeError.
        """
        require_residuals(metric, "AddMetric")
        super().AddMetric(metric, cast(_core.Jaw, jaw))

    def SetOptimizer(self, optimizer: _core.ObjectToObjectOptimizerBase) -> None:
        """A ``LevenbergMarquardtOptimizerv4``, of which candidates take clones, also in other threads.

        ``SetOptimizerAsLBFGSB`` and ``SetOptimizerAsLBFGS2`` choose another, which runs in one thread. Tolerances and numbers of
        iterations are those of the options. Commands of the optimizer are called in the thread that runs ``Execute``; ``StopOptimization()`` in one ends the registration.
        """
        if optimizer is not None and not isinstance(optimizer, _core.ObjectToObjectOptimizerBase):
            raise TypeError(
                f"SetOptimizer() takes a LevenbergMarquardtOptimizerv4, and {type(optimizer).__name__} is no optimizer of this "
                "package; SetOptimizerAsLBFGSB() and SetOptimizerAsLBFGS2() choose another"
            )
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
        self._SetCephalometricLandmarks(read_landmarks(cephalometricLandmarks))
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
    stockOutlines: Optional[ContourLike] = None,
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
    cephalometricLandmarks, counterparts, toothCrowns, stockOutlines
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
        geometry,
        upper,
        upperContour,
        lower,
        lowerContour,
        cephalometricLandmarks,
        counterparts,
        toothCrowns,
        stockOutlines,
    )
