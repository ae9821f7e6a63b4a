"""Registration of contours."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Optional, Union, cast

from . import _core
from ._errors import ArgumentError
from ._filters import as_similarity
from ._inputs import Array, ContourLike, ImageLike, TransformLike, as_contour, as_image
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings


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
    **settings: Unpack[_settings.SilhouetteToContourRegistrationSettings],
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


class _ContourMethod(ProcessObject):
    """What the methods beside the paper's have in common: two contours and a start go in, a similarity comes out."""

    def SetInitialTransform(self: Any, transform: Optional[TransformLike]) -> None:
        """Start from this similarity (moving to fixed); None for the method's own start."""
        self._SetInitialTransform(as_similarity(transform))

    def Execute(self: Any, fixed: ContourLike, moving: ContourLike) -> _core.Similarity2DTransform:
        """Registers: the similarity that maps moving to fixed."""
        self._SetFixedContour(as_contour(fixed))
        self._SetMovingContour(as_contour(moving))
        self._Update()
        similarity: _core.Similarity2DTransform = self._GetTransform()
        return similarity


class IterativeClosestPointContourRegistrationMethod(
    _ContourMethod, _core.IterativeClosestPointContourRegistrationMethod
):
    """Iterative closest points between two contours, rigid or similarity, plain or trimmed."""


def IterativeClosestPointContourRegistration(
    fixed: ContourLike,
    moving: ContourLike,
    trimmedFraction: float = 0.0,
    **settings: Unpack[_settings.IterativeClosestPointContourRegistrationSettings],
) -> _core.Similarity2DTransform:
    """ICP; see :class:`IterativeClosestPointContourRegistrationMethod`. Maps moving to fixed."""
    process = IterativeClosestPointContourRegistrationMethod()
    process.SetTrimmedFraction(trimmedFraction)
    apply_settings(process, settings)
    return process.Execute(fixed, moving)


class CoherentPointDriftContourRegistrationMethod(_ContourMethod, _core.CoherentPointDriftContourRegistrationMethod):
    """Coherent point drift between two contours, rigid or similarity."""


def CoherentPointDriftContourRegistration(
    fixed: ContourLike,
    moving: ContourLike,
    outlierWeight: float = 0.0,
    **settings: Unpack[_settings.CoherentPointDriftContourRegistrationSettings],
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
    **settings: Unpack[_settings.IntensityRegistrationSettings],
) -> _core.Similarity2DTransform:
    """Registration by grey values; see :class:`IntensityRegistrationMethod`."""
    process = IntensityRegistrationMethod()
    process.SetMeasure(cast(_core.IntensityMeasure, measure))
    apply_settings(process, settings)
    return process.Execute(fixedImage, movingImage, fixed, moving)


MetricFunction = Callable[[Array, Array], Any]
