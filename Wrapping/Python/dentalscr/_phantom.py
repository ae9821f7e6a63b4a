"""Simulated jaws and cases with known answers."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Dict, Optional, Union, cast

import numpy as np

from . import _core
from ._case import Case
from ._inputs import Array, PathLike, as_path
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings

_UPPER = _core.Jaw.Upper
_LOWER = _core.Jaw.Lower


@dataclass(frozen=True)
class PhantomJaw:
    """A simulated scan; the labels of its points are FDI numbers."""

    mesh: _core.Mesh
    #: In the mesh's frame, mm.
    landmarks: Dict[str, Array]


class DentalPhantomMeshSource(ProcessObject, _core.DentalPhantomMeshSource):
    """A pair of parametric dental arches in occlusion, with tooth labels and landmarks."""

    def Execute(self) -> Dict[str, PhantomJaw]:
        """Makes ``{"upper": PhantomJaw, "lower": PhantomJaw}``."""
        self._Update()
        landmarks = [cast("Dict[str, Array]", self._GetLandmarks(jaw)) for jaw in (_UPPER, _LOWER)]
        meshes = [self._TakeMesh(jaw) for jaw in (_UPPER, _LOWER)]
        return {"upper": PhantomJaw(meshes[0], landmarks[0]), "lower": PhantomJaw(meshes[1], landmarks[1])}


def DentalPhantomMesh(
    seed: Optional[int] = None, parameters: Optional[_core.DentalPhantomParameters] = None
) -> Dict[str, PhantomJaw]:
    """A pair of jaws, average or drawn for a seed; see :class:`DentalPhantomMeshSource`."""
    process = DentalPhantomMeshSource()
    if parameters is not None:
        process.SetParameters(parameters)
    if seed is not None:
        process.DrawParameters(seed)
    return process.Execute()


@dataclass(frozen=True)
class PhantomCaseJaw:
    """One jaw of a simulated case."""

    #: mm, in the scanner's frame.
    mesh: _core.Mesh
    #: Pixels of the radiograph, and the same before the hand's noise.
    tracing: _core.Contour
    trueTracing: _core.Contour
    landmarks3D: Dict[str, Array]
    #: Their true projections.
    landmarks2D: Dict[str, Array]
    #: Maps the mesh to the radiograph exactly.
    trueGeometry: _core.CephalometricGeometry = field(repr=False)


@dataclass(frozen=True)
class PhantomCase:
    """A simulated case with the truth."""

    upper: PhantomCaseJaw
    lower: PhantomCaseJaw
    #: What a clinic would know.
    geometry: _core.CephalometricGeometry
    #: None with ``makeRadiograph=False``.
    image: Optional[_core.Image]
    imageSize: tuple[int, int]
    tracedSide: str
    #: What an analysis marked, with its errors: ``{"U1_tip": (u, v), ...}``; None where the level has no analysis.
    cephalometricLandmarks: Optional[Dict[str, tuple[float, float]]] = None

    def to_case(self, withLandmarks2D: bool = True) -> Case:
        """As :func:`register` takes it."""
        return Case(
            upper=self.upper.mesh,
            lower=self.lower.mesh,
            upperContour=self.upper.tracing,
            lowerContour=self.lower.tracing,
            geometry=self.geometry,
            image=self.image,
            imageSize=self.imageSize,
            principalPointKnown=True,
            tracedSide=self.tracedSide,
            cephalometricLandmarks=self.cephalometricLandmarks,
            landmarks3D={**self.upper.landmarks3D, **self.lower.landmarks3D},
            landmarks2D={**self.upper.landmarks2D, **self.lower.landmarks2D} if withLandmarks2D else None,
        )


class DentalPhantomCaseSource(ProcessObject, _core.DentalPhantomCaseSource):
    """A simulated case for a seed: two scans, a radiograph, a tracing on it, and the truth."""

    def Execute(self) -> PhantomCase:
        """Makes the case."""
        self._Update()
        image = self._GetRadiograph()
        jaws = []
        for jaw in (_UPPER, _LOWER):
            jaws.append(
                PhantomCaseJaw(
                    landmarks3D=cast("Dict[str, Array]", self._GetLandmarks3D(jaw)),
                    landmarks2D=cast("Dict[str, Array]", self._GetLandmarks2D(jaw)),
                    trueGeometry=self._GetTrueGeometry(jaw),
                    trueTracing=self._TakeTrueTracing(jaw),
                    tracing=self._TakeTracing(jaw),
                    mesh=self._TakeMesh(jaw),
                )
            )
        return PhantomCase(
            upper=jaws[0],
            lower=jaws[1],
            geometry=self._GetNominalGeometry(),
            image=image,
            imageSize=self.GetImageSize(),
            tracedSide=self.GetTracedSide().name.lower(),
            cephalometricLandmarks=cast("Optional[Dict[str, tuple[float, float]]]", self._GetCephalometricLandmarks()),
        )

    def Write(self, folder: PathLike, meshExtension: str = "stl") -> None:
        """Writes a folder that ``register`` reads: case.json and all that it names, truth.json beside it."""
        self._Write(as_path(folder), meshExtension)


def DentalPhantomCase(
    seed: int = 1,
    cohort: Union[str, _core.PhantomCohort] = "Typical",
    **settings: Unpack[_settings.DentalPhantomCaseSettings],
) -> PhantomCase:
    """A simulated case; see :class:`DentalPhantomCaseSource`.

    Parameters
    ----------
    seed : int
        The same seed, the same case.
    cohort : "ideal", "typical", "hard", "real", "real-hard", "standard" or "practice"
        The level, as ``dentalscr phantom --level`` has it. Of "practice" and "standard" an analysis has drawn whole
        teeth and marked landmarks.
    **settings
        ``tracedSide``, ``facing``, ``numberOfTriangles``, ``makeRadiograph``, ...
    """
    process = DentalPhantomCaseSource()
    process.SetSeed(seed)
    process.SetCohort(_core.PhantomCohort(cohort.replace("-", "")) if isinstance(cohort, str) else cohort)
    apply_settings(process, settings)
    return process.Execute()
