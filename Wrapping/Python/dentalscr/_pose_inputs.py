"""What is found in scans and drawings before a registration of the pose: teeth, landmarks, the side that was traced."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, NamedTuple, Optional, Tuple

from . import _core
from ._filters import as_rigid
from ._inputs import (
    Array,
    ContourLike,
    LandmarksLike,
    MeshLike,
    TransformLike,
    as_cephalometric_landmarks,
    as_contour,
    as_landmarks,
    as_mesh,
)
from ._io import ReadCephalometricLandmarks
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings


def read_landmarks(value: Any) -> Optional[Dict[str, Dict[str, Any]]]:
    """Landmarks of an analysis from what ``Case`` takes: a dictionary, the path of a file, or None."""
    given = None if value is None else as_cephalometric_landmarks(value)
    return ReadCephalometricLandmarks(given) if isinstance(given, str) else given


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
        self._SetCephalometricLandmarks(read_landmarks(cephalometricLandmarks))
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
    #: How it was found: "landmarks_3d", "tooth labels", "the traced tooth", "its place on the other side", "its place along
    #: the arch".
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
        solution: Optional[_core.PoseSolution] = None,
        upperTracing: Optional[ContourLike] = None,
        lowerTracing: Optional[ContourLike] = None,
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
        solution : PoseSolution, optional
            Of :func:`PoseRegistration`. With it and a tracing a premolar or molar is found by the traced tooth of its code.
        upperTracing, lowerTracing : contour-like, optional
            The tracings of that registration, pixels; ``BisectedOn`` where they are the middle between both sides.
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
        self._SetSolution(solution)
        self._SetUpperTracing(None if upperTracing is None else as_contour(upperTracing, "upper"))
        self._SetLowerTracing(None if lowerTracing is None else as_contour(lowerTracing, "lower"))
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
