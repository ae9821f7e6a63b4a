"""What a registration of the pose minimizes: its metrics, one of your own, and the optimizer."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Dict, NamedTuple, Optional, Tuple, Union

from . import _core
from ._inputs import Array, ContourLike, LandmarksLike, MeshLike, as_contour, as_landmarks, as_mesh
from ._pose_inputs import ToothCrown
from ._process import Observable


def require_residuals(metric: object, call: str) -> None:
    """Says in words what the binding would say by signatures."""
    if metric is not None and not isinstance(metric, _core.LeastSquaresMetricv4):
        raise TypeError(
            f"{call}() takes a metric that has residuals, as SilhouettePoseMetricv4, LandmarkPoseMetricv4, a LeastSquaresMetric "
            f"of your own or a LeastSquaresSumMetricv4, and {type(metric).__name__} has none; metrics between two contours go to "
            "SilhouetteToContourRegistrationMethod.SetMetric()"
        )


class LevenbergMarquardtOptimizerv4(Observable, _core.LevenbergMarquardtOptimizerv4):
    """Levenberg-Marquardt for metrics that are, or are majorised by, sums of squares.

    ``SetMetric``, ``StartOptimization``; commands ask ``GetCurrentIteration``, ``GetCurrentMetricValue``,
    ``GetCurrentPosition``, ``GetStepAccepted``, ``GetStepLength``. An exception in a command or in a metric of yours
    comes out of ``StartOptimization``, with the metric back at the best position.
    """

    def SetMetric(self, metric: _core.LeastSquaresMetricv4) -> None:
        """Sets the sum of squares that is minimized; TypeError where a metric has no residuals."""
        require_residuals(metric, "SetMetric")
        super().SetMetric(metric)


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
