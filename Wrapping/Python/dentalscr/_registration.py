"""Registration of contours, and of scans by their pose."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Dict, Optional, Tuple, Union, cast

import numpy as np

from . import _core
from ._errors import ArgumentError
from ._filters import as_rigid, as_similarity
from ._inputs import (
    Array,
    ContourLike,
    ImageLike,
    MeshLike,
    TransformLike,
    as_contour,
    as_geometry,
    as_image,
    as_mesh,
)
from ._process import ProcessObject, apply_settings


class SilhouetteToContourRegistrationMethod(ProcessObject, _core.SilhouetteToContourRegistrationMethod):
    """Aligns a projected silhouette with a tracing by a 2-D similarity, coarse to fine: the paper's method.

    ``SetMetricAs...`` and ``SetOptimizerAs...`` choose the parts; stages are levels (``SetNumberOfLevels``,
    ``SetLevel``). In a command: ``GetCurrentLevel``, ``GetOptimizerIteration``, ``GetMetricValue``,
    ``GetOptimizerPosition``, ``GetOptimizerStopConditionDescription``.
    """

    def SetInitialTransform(self, transform: Optional[TransformLike]) -> None:
        """Start from this similarity (moving to fixed) instead of the bounding boxes; None for these."""
        self._SetInitialTransform(as_similarity(transform))

    def Execute(self, fixed: ContourLike, moving: ContourLike) -> _core.Similarity2DTransform:
        """Registers.

        Parameters
        ----------
        fixed : contour-like
            The tracing, pixels of the radiograph.
        moving : contour-like
            The silhouette, pixels.

        Returns
        -------
        Similarity2DTransform
            Maps moving to fixed.
        """
        fixed_contour, moving_contour = as_contour(fixed), as_contour(moving)
        self._SetFixedContour(fixed_contour)
        self._SetMovingContour(moving_contour)
        self._Update()
        self.__dict__["_contours"] = (fixed_contour, moving_contour)
        return self._GetTransform()

    def MetricEvaluate(
        self, fixed: ContourLike, moving: ContourLike, transform: Optional[TransformLike] = None
    ) -> float:
        """The metric's value where the transform (moving to fixed; the initial bounding-box one without) puts it."""
        fixed_contour, moving_contour = as_contour(fixed), as_contour(moving)
        similarity = as_similarity(transform)
        if similarity is None:
            similarity = self.ComputeBoundingBoxTransform(fixed_contour, moving_contour)
        return self._MetricEvaluate(fixed_contour, moving_contour, similarity)

    @staticmethod
    def ComputeBoundingBoxTransform(fixed: ContourLike, moving: ContourLike) -> _core.Similarity2DTransform:
        """The start: scale by the bounding boxes, translation by the centroids."""
        return _core.SilhouetteToContourRegistrationMethod._ComputeBoundingBoxTransform(
            as_contour(fixed), as_contour(moving)
        )

    def GetResidualDistances(self) -> Array:
        """Distance of every point of the tracing to the registered silhouette, px, after ``Execute``."""
        contours = self.__dict__.get("_contours")
        if contours is None:
            raise ArgumentError("there is no registration yet; call Execute()")
        distance = _core.ContourDistanceFilter()
        distance._SetFixedContour(contours[0])
        distance._SetMovingContour(contours[1])
        distance._SetTransform(self._GetTransform())
        distance._Update()
        return distance.GetFixedToMovingDistances()


def SilhouetteToContourRegistration(
    fixed: ContourLike,
    moving: ContourLike,
    pixelSpacing: float = 0.25,
    initialTransform: Optional[TransformLike] = None,
    **settings: Any,
) -> _core.Similarity2DTransform:
    """The paper's registration of contours; see :class:`SilhouetteToContourRegistrationMethod`.

    Parameters
    ----------
    fixed, moving : contour-like
        Tracing and silhouette, pixels.
    pixelSpacing : float, optional
        mm, turns the bounds on the shift into pixels.
    initialTransform : transform-like, optional
        Moving to fixed.

    Returns
    -------
    Similarity2DTransform
        Maps moving to fixed.
    """
    process = SilhouetteToContourRegistrationMethod()
    process.SetPixelSpacing(pixelSpacing)
    process.SetInitialTransform(initialTransform)
    apply_settings(process, settings)
    return process.Execute(fixed, moving)


class IterativeClosestPointContourRegistrationMethod(
    ProcessObject, _core.IterativeClosestPointContourRegistrationMethod
):
    """Iterative closest points between two contours, rigid or similarity, plain or trimmed."""

    def SetInitialTransform(self, transform: Optional[TransformLike]) -> None:
        """Start from this similarity (moving to fixed); None for the method's own start."""
        self._SetInitialTransform(as_similarity(transform))

    def Execute(self, fixed: ContourLike, moving: ContourLike) -> _core.Similarity2DTransform:
        """Registers: the similarity that maps moving to fixed."""
        self._SetFixedContour(as_contour(fixed))
        self._SetMovingContour(as_contour(moving))
        self._Update()
        return self._GetTransform()


def IterativeClosestPointContourRegistration(
    fixed: ContourLike, moving: ContourLike, trimmedFraction: float = 0.0, **settings: Any
) -> _core.Similarity2DTransform:
    """ICP; see :class:`IterativeClosestPointContourRegistrationMethod`. Maps moving to fixed."""
    process = IterativeClosestPointContourRegistrationMethod()
    process.SetTrimmedFraction(trimmedFraction)
    apply_settings(process, settings)
    return process.Execute(fixed, moving)


class CoherentPointDriftContourRegistrationMethod(ProcessObject, _core.CoherentPointDriftContourRegistrationMethod):
    """Coherent point drift between two contours, rigid or similarity."""

    def SetInitialTransform(self, transform: Optional[TransformLike]) -> None:
        """Start from this similarity (moving to fixed); None for the method's own start."""
        self._SetInitialTransform(as_similarity(transform))

    def Execute(self, fixed: ContourLike, moving: ContourLike) -> _core.Similarity2DTransform:
        """Registers: the similarity that maps moving to fixed."""
        self._SetFixedContour(as_contour(fixed))
        self._SetMovingContour(as_contour(moving))
        self._Update()
        return self._GetTransform()


def CoherentPointDriftContourRegistration(
    fixed: ContourLike, moving: ContourLike, outlierWeight: float = 0.0, **settings: Any
) -> _core.Similarity2DTransform:
    """CPD; see :class:`CoherentPointDriftContourRegistrationMethod`. Maps moving to fixed."""
    process = CoherentPointDriftContourRegistrationMethod()
    process.SetOutlierWeight(outlierWeight)
    apply_settings(process, settings)
    return process.Execute(fixed, moving)


class IntensityRegistrationMethod(ProcessObject, _core.IntensityRegistrationMethod):
    """Aligns a DRR with the radiograph by their grey values."""

    def SetInitialTransform(self, transform: Optional[TransformLike]) -> None:
        """Start from this similarity (moving to fixed); None for the contours' start."""
        self._SetInitialTransform(as_similarity(transform))

    def Execute(
        self, fixedImage: ImageLike, movingImage: ImageLike, fixed: ContourLike, moving: ContourLike
    ) -> _core.Similarity2DTransform:
        """Registers: the similarity that maps the DRR's index q to the radiograph's pixel.

        Parameters
        ----------
        fixedImage, movingImage : image-like
            Radiograph and DRR; of both only the index counts.
        fixed, moving : contour-like
            Tracing and silhouette: they give start and region of interest.
        """
        self._SetFixedImage(as_image(fixedImage))
        self._SetMovingImage(as_image(movingImage))
        self._SetFixedContour(as_contour(fixed))
        self._SetMovingContour(as_contour(moving))
        self._Update()
        return self._GetTransform()


def IntensityRegistration(
    fixedImage: ImageLike,
    movingImage: ImageLike,
    fixed: ContourLike,
    moving: ContourLike,
    measure: Union[str, _core.IntensityMeasure] = "MutualInformation",
    **settings: Any,
) -> _core.Similarity2DTransform:
    """Registration by grey values; see :class:`IntensityRegistrationMethod`."""
    process = IntensityRegistrationMethod()
    process.SetMeasure(cast(_core.IntensityMeasure, measure))
    apply_settings(process, settings)
    return process.Execute(fixedImage, movingImage, fixed, moving)


@dataclass(frozen=True)
class PoseJaw:
    """What :class:`PoseRegistrationMethod` finds for a jaw."""

    #: "ok", "suspect" or "failed".
    status: str
    #: (code, text) each.
    reasons: Tuple[Tuple[str, str], ...]
    registered: bool
    #: Scan to cephalostat frame, mm.
    transform: Optional[_core.VersorRigid3DTransform]
    #: Projects the scan's points into the radiograph.
    geometry: Optional[_core.CephalometricGeometry]
    #: (3, 4): scan (mm) to homogeneous pixel index.
    P_pixel_from_mesh: Optional[Array]
    #: (N, 2): the moving contour at the solution, pixels, and its points on the scan, (N, 3).
    contour: Optional[Array] = field(repr=False)
    contourPoints: Optional[Array] = field(repr=False)
    #: How well the tracing is explained, px of 0.25 mm.
    fit: Dict[str, float] = field(repr=False)


@dataclass(frozen=True)
class PoseResult:
    """Both jaws; None where one was not given."""

    upper: Optional[PoseJaw]
    lower: Optional[PoseJaw]
    #: Whether one pose was fitted to both.
    jawsShareFrame: bool


class PoseRegistrationMethod(ProcessObject, _core.PoseRegistrationMethod):
    """The robust registration: scans and tracing to pose, scale, uncertainty and verdict."""

    def SetFrames(
        self,
        upper: TransformLike,
        lower: Optional[TransformLike] = None,
        jawsShareFrame: bool = False,
    ) -> None:
        """Dental frames of the scans (mesh to UMDA, midline refined) instead of estimated ones.

        Give the same frame for both where the jaws are in occlusion.
        """
        first = as_rigid(upper)
        second = first if lower is None else as_rigid(lower)
        if first is None or second is None:
            raise ArgumentError("a frame is a transform from mesh to UMDA")
        self._SetFrames(first, second, jawsShareFrame)

    def Execute(
        self,
        geometry: Any,
        upper: Optional[MeshLike] = None,
        upperContour: Optional[ContourLike] = None,
        lower: Optional[MeshLike] = None,
        lowerContour: Optional[ContourLike] = None,
    ) -> PoseResult:
        """Registers one jaw or both.

        Parameters
        ----------
        geometry : CephalometricGeometry or dict
            Nominal, without a pose; without a pixel spacing the scale is estimated.
        upper, lower : mesh-like, optional
            mm, any orientation.
        upperContour, lowerContour : contour-like, optional
            The tracing of each jaw, continuous pixel indices.
        """
        self._SetGeometry(as_geometry(geometry))
        self._SetUpperMesh(None if upper is None else as_mesh(upper))
        self._SetLowerMesh(None if lower is None else as_mesh(lower))
        self._SetUpperContour(None if upperContour is None else as_contour(upperContour, "upper"))
        self._SetLowerContour(None if lowerContour is None else as_contour(lowerContour, "lower"))
        self._Update()
        return PoseResult(
            self._make(_core.Jaw.Upper), self._make(_core.Jaw.Lower), self.GetJawsShareFrame()
        )

    def _make(self, jaw: _core.Jaw) -> Optional[PoseJaw]:
        values = self._GetJaw(jaw)
        if not values:
            return None
        return PoseJaw(
            status=values["status"],
            reasons=tuple(values["reasons"]),
            registered=values["registered"],
            transform=values.get("transform"),
            geometry=values.get("geometry"),
            P_pixel_from_mesh=values.get("projection"),
            contour=values.get("contour"),
            contourPoints=values.get("contourPoints"),
            fit=values.get("fit", {}),
        )


def PoseRegistration(
    geometry: Any,
    upper: Optional[MeshLike] = None,
    upperContour: Optional[ContourLike] = None,
    lower: Optional[MeshLike] = None,
    lowerContour: Optional[ContourLike] = None,
    tracedSide: Union[str, _core.TracedSide] = "Right",
    **settings: Any,
) -> PoseResult:
    """The robust registration; see :class:`PoseRegistrationMethod`."""
    process = PoseRegistrationMethod()
    process.SetTracedSide(cast(_core.TracedSide, tracedSide))
    apply_settings(process, settings)
    return process.Execute(geometry, upper, upperContour, lower, lowerContour)


MetricFunction = Callable[[Array, Array], Any]
