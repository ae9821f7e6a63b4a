"""Errors of landmarks, and the picture to judge by."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, Union, cast

from . import _core
from ._inputs import (
    ContourLike,
    ImageLike,
    LandmarksLike,
    PathLike,
    as_contour,
    as_image,
    as_landmarks,
    as_pair,
    as_path,
)
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings


@dataclass(frozen=True)
class LandmarkErrors:
    """Distances between predicted and marked landmarks."""

    #: px by name, "UR6_MB+UL6_MB" for a bisected pair.
    errors: Dict[str, float]
    #: count, mean, rmse, std, maximum (px), groups, and with a pixel spacing mean_mm, success_detection_rate, ...
    statistics: Dict[str, Any]
    unpaired: Tuple[str, ...]


class LandmarkErrorFilter(ProcessObject, _core.LandmarkErrorFilter):
    """Distances between predicted landmarks and those marked on the radiograph."""

    def Execute(self, predicted: LandmarksLike, reference: LandmarksLike) -> LandmarkErrors:
        """Measures.

        Parameters
        ----------
        predicted, reference : landmarks-like
            ``{"UR1_tip": (u, v)}`` or files.
        """
        self._SetPredictedLandmarks(as_landmarks(predicted, 2))
        self._SetReferenceLandmarks(as_landmarks(reference, 2))
        self._Update()
        return LandmarkErrors(self._GetErrors(), self._GetStatistics(), tuple(self.GetUnpairedLandmarks()))


def LandmarkError(
    predicted: LandmarksLike,
    reference: LandmarksLike,
    pixelSpacing: Optional[Any] = None,
    **settings: Unpack[_settings.LandmarkErrorSettings],
) -> LandmarkErrors:
    """Landmark errors; see :class:`LandmarkErrorFilter`.

    Parameters
    ----------
    predicted, reference : landmarks-like
    pixelSpacing : float or pair of float, optional
        mm, for figures in mm too.
    **settings
        ``jaw``, ``bisectSides``.
    """
    process = LandmarkErrorFilter()
    if pixelSpacing is not None:
        process.SetPixelSpacing(as_pair(pixelSpacing))
    apply_settings(process, settings)
    return process.Execute(predicted, reference)


class RegistrationOverlayFilter(ProcessObject, _core.RegistrationOverlayFilter):
    """Radiograph, tracing, aligned contours, landmarks and errors in one picture. Needs no screen."""

    def Execute(
        self,
        image: Optional[ImageLike] = None,
        fixed: Optional[ContourLike] = None,
        moving: Optional[Union[ContourLike, Dict[str, ContourLike]]] = None,
        predicted: Optional[LandmarksLike] = None,
        reference: Optional[LandmarksLike] = None,
    ) -> _core.Picture:
        """Draws; everything is optional.

        Parameters
        ----------
        image : image-like, optional
            The radiograph.
        fixed : contour-like, optional
            The tracing.
        moving : contour-like or dict, optional
            Aligned contours of the scan, a dictionary with their labels; the first is drawn bold.
        predicted, reference : landmarks-like, optional
            As the registration has them, and as they were marked.
        """
        self._SetRadiograph(None if image is None else as_image(image))
        self._SetFixedContour(None if fixed is None else as_contour(fixed))
        contours = moving if isinstance(moving, dict) else {} if moving is None else {"aligned contour": moving}
        for number in reversed(range(len(contours), self._GetNumberOfMovingContours())):
            self._SetMovingContour(number, None, "")
        for number, (label, contour) in enumerate(contours.items()):
            self._SetMovingContour(number, as_contour(contour), label)
        self._SetPredictedLandmarks({} if predicted is None else as_landmarks(predicted, 2))
        self._SetReferenceLandmarks({} if reference is None else as_landmarks(reference, 2))
        self._Update()
        return self._TakeOutput()


def RegistrationOverlay(
    image: Optional[ImageLike] = None,
    fixed: Optional[ContourLike] = None,
    moving: Optional[Union[ContourLike, Dict[str, ContourLike]]] = None,
    predicted: Optional[LandmarksLike] = None,
    reference: Optional[LandmarksLike] = None,
    title: str = "",
    **settings: Unpack[_settings.RegistrationOverlaySettings],
) -> _core.Picture:
    """The picture to judge a registration by; see :class:`RegistrationOverlayFilter`."""
    process = RegistrationOverlayFilter()
    process.SetTitle(title)
    apply_settings(process, settings)
    return process.Execute(image, fixed, moving, predicted, reference)


class CohortExperiment(ProcessObject, _core.CohortExperiment):
    """Methods on a cohort of cases: tables, statistics and plot data in a folder. A run goes on where one stopped."""

    def Execute(self, output: Optional[PathLike] = None) -> list[str]:
        """Runs; returns the names of the files in the output folder."""
        if output is not None:
            self.SetOutputDirectory(as_path(output))
        self._Update()
        return list(self.GetWrittenFiles())


def RunCohortExperiment(
    output: PathLike,
    numberOfCases: int = 34,
    level: Union[str, _core.PhantomCohort] = "Typical",
    caseDirectory: Optional[PathLike] = None,
    **settings: Unpack[_settings.RunCohortExperimentSettings],
) -> list[str]:
    """An experiment; see :class:`CohortExperiment`.

    Parameters
    ----------
    output : path
        Folder for everything.
    numberOfCases : int, optional
    level : "Ideal", "Typical" or "Hard"
        Of simulated cases.
    caseDirectory : path, optional
        A folder of cases, used instead of simulated ones.
    **settings
        ``seed``, ``methods``, ``study``, ``numberOfStarts``, ``drawFigures``.
    """
    process = CohortExperiment()
    process.SetNumberOfCases(numberOfCases)
    process.SetLevel(cast(_core.PhantomCohort, level))
    if caseDirectory is not None:
        process.SetCaseDirectory(as_path(caseDirectory))
    apply_settings(process, settings)
    return process.Execute(output)
