"""What lies between the filters of the paper's chain, and follows from the similarity that it finds."""
from __future__ import annotations

from typing import Any, Dict, NamedTuple, Optional, cast

from . import _core
from ._errors import ArgumentError
from ._filters import as_rigid, as_similarity
from ._inputs import (
    Array,
    ContourLike,
    JawLike,
    LandmarksLike,
    MeshLike,
    TransformLike,
    as_contour,
    as_geometry,
    as_landmarks,
    as_mesh,
)
from ._process import ProcessObject


def _frame(value: TransformLike) -> _core.VersorRigid3DTransform:
    rigid = as_rigid(value)
    if rigid is None:
        raise ArgumentError("frame is needed: mesh to dental frame, of UMidlineDentalAxis()")
    return rigid


def _similarity(value: TransformLike) -> _core.Similarity2DTransform:
    similarity = as_similarity(value)
    if similarity is None:
        raise ArgumentError("transform is needed: a similarity, of SilhouetteToContourRegistration()")
    return similarity


class GeometryPlacementFilter(ProcessObject, _core.GeometryPlacementFilter):
    """A radiograph's geometry with an object in it, whose pose is a transform.

    With ``CentralRayThroughOriginOn()`` pixels are relative to where the frame's origin is seen: the projection on which
    the paper's similarity acts.
    """

    def Execute(self, geometry: Any, frame: TransformLike) -> _core.CephalometricGeometry:
        """A copy of the geometry with the frame, mesh to cephalostat, as its pose."""
        self._SetGeometry(as_geometry(geometry))
        self._SetFrame(_frame(frame))
        self._Update()
        return self._TakeOutput()


def GeometryPlacement(
    geometry: Any, frame: TransformLike, centralRayThroughOrigin: bool = False
) -> _core.CephalometricGeometry:
    """A geometry with an object in it; see :class:`GeometryPlacementFilter`."""
    process = GeometryPlacementFilter()
    process.SetCentralRayThroughOrigin(centralRayThroughOrigin)
    return process.Execute(geometry, frame)


class SurfaceSplatWidthCalculator(ProcessObject, _core.SurfaceSplatWidthCalculator):
    """The width of a surface DRR's splats that closes the surface and no more."""

    def Execute(self, mesh: MeshLike, geometry: Any) -> float:
        """The standard deviation, mm in the detector plane, for ``SurfaceDRRImageSource.SetSigma``."""
        self._SetMesh(as_mesh(mesh))
        self._SetGeometry(as_geometry(geometry))
        self._Update()
        return self.GetSigma()


def SurfaceSplatWidth(mesh: MeshLike, geometry: Any, widthFactor: float = 0.7) -> float:
    """The width of splats, mm; see :class:`SurfaceSplatWidthCalculator`."""
    process = SurfaceSplatWidthCalculator()
    process.SetWidthFactor(widthFactor)
    return process.Execute(mesh, geometry)


class TracingPixelSpacingFilter(ProcessObject, _core.TracingPixelSpacingFilter):
    """A geometry with a pixel spacing that makes scans and tracings equally wide: what is left where none is known."""

    def Execute(
        self,
        geometry: Any,
        upperMesh: Optional[MeshLike] = None,
        upperContour: Optional[ContourLike] = None,
        upperFrame: Optional[TransformLike] = None,
        lowerMesh: Optional[MeshLike] = None,
        lowerContour: Optional[ContourLike] = None,
        lowerFrame: Optional[TransformLike] = None,
    ) -> _core.CephalometricGeometry:
        """A copy of the geometry with the mean over the jaws that are complete."""
        self._SetGeometry(as_geometry(geometry))
        for jaw, mesh, contour, frame in (
            (_core.Jaw.Upper, upperMesh, upperContour, upperFrame),
            (_core.Jaw.Lower, lowerMesh, lowerContour, lowerFrame),
        ):
            self._SetJaw(
                jaw,
                None if mesh is None else as_mesh(mesh),
                None if contour is None else as_contour(contour),
                as_rigid(frame),
            )
        self._Update()
        return self._TakeOutput()


def TracingPixelSpacing(
    geometry: Any,
    upperMesh: Optional[MeshLike] = None,
    upperContour: Optional[ContourLike] = None,
    upperFrame: Optional[TransformLike] = None,
    lowerMesh: Optional[MeshLike] = None,
    lowerContour: Optional[ContourLike] = None,
    lowerFrame: Optional[TransformLike] = None,
    defaultPixelSpacing: float = 0.25,
) -> _core.CephalometricGeometry:
    """A geometry with a rough pixel spacing; see :class:`TracingPixelSpacingFilter`."""
    process = TracingPixelSpacingFilter()
    process.SetDefaultPixelSpacing(defaultPixelSpacing)
    return process.Execute(
        geometry, upperMesh, upperContour, upperFrame, lowerMesh, lowerContour, lowerFrame
    )


class PlacedSimilarity(NamedTuple):
    """Where a similarity puts a scan."""

    #: (3, 4): mesh, in the unit of its file, to homogeneous pixel index.
    projectionMatrix: Array
    #: Mesh, mm, to cephalostat.
    transform: _core.VersorRigid3DTransform


class SimilarityPlacementFilter(ProcessObject, _core.SimilarityPlacementFilter):
    """Where a similarity of a silhouette puts the scan: projection onto the radiograph, and place in the cephalostat."""

    def Execute(self, similarity: TransformLike, frame: TransformLike, geometry: Any) -> PlacedSimilarity:
        """Places the scan.

        Parameters
        ----------
        similarity : transform-like
            Of :func:`SilhouetteToContourRegistration`.
        frame : transform-like
            Mesh to dental frame, of :func:`UMidlineDentalAxis`.
        geometry : CephalometricGeometry
        """
        self._SetSimilarity(_similarity(similarity))
        self._SetFrame(_frame(frame))
        self._SetGeometry(as_geometry(geometry))
        self._Update()
        return PlacedSimilarity(self.GetProjectionMatrix(), cast(_core.VersorRigid3DTransform, self._GetTransform()))


def SimilarityPlacement(
    similarity: TransformLike, frame: TransformLike, geometry: Any, millimetresPerUnit: float = 1.0
) -> PlacedSimilarity:
    """Where a similarity puts the scan; see :class:`SimilarityPlacementFilter`."""
    process = SimilarityPlacementFilter()
    process.SetMillimetresPerUnit(millimetresPerUnit)
    return process.Execute(similarity, frame, geometry)


class ContourTransformFilter(ProcessObject, _core.ContourTransformFilter):
    """A contour whose points a similarity has moved."""

    def Execute(self, contour: ContourLike, transform: TransformLike) -> _core.Contour:
        """Moves the points; codes and weights stay."""
        self._SetInput(as_contour(contour))
        self._SetTransform(_similarity(transform))
        self._Update()
        return self._TakeOutput()


def ContourTransform(contour: ContourLike, transform: TransformLike) -> _core.Contour:
    """A moved contour; see :class:`ContourTransformFilter`."""
    return ContourTransformFilter().Execute(contour, transform)


class LandmarkMatrixProjectionFilter(ProcessObject, _core.LandmarkMatrixProjectionFilter):
    """Landmarks of a scan on the radiograph, by a projection matrix alone."""

    def Execute(self, landmarks: LandmarksLike, matrix: Any) -> Dict[str, Array]:
        """Projects the landmarks of ``SetJaw``, of both jaws without.

        Parameters
        ----------
        landmarks : landmarks-like
        matrix : array-like
            (3, 4): from the landmarks' frame and unit to the homogeneous pixel index.
        """
        self._SetLandmarks(as_landmarks(landmarks, 3))
        self._SetProjectionMatrix(matrix)
        self._Update()
        return cast("Dict[str, Array]", self._GetOutput())


def LandmarkMatrixProjection(landmarks: LandmarksLike, matrix: Any, jaw: JawLike = "Unknown") -> Dict[str, Array]:
    """Landmarks on the radiograph; see :class:`LandmarkMatrixProjectionFilter`."""
    process = LandmarkMatrixProjectionFilter()
    process.SetJaw(cast(_core.Jaw, jaw))
    return process.Execute(landmarks, matrix)
