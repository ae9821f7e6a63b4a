"""The steps from scans and pictures to contours."""
from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple, Union, cast

import numpy as np

from . import _core
from ._errors import ArgumentError
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
    as_transform,
)
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings


def as_rigid(value: Optional[TransformLike]) -> Optional[_core.VersorRigid3DTransform]:
    """A rigid transform of space, or None."""
    if value is None:
        return None
    transform = as_transform(value)
    if not isinstance(transform, _core.VersorRigid3DTransform):
        raise TypeError(f"a rigid transform of space is needed, not {transform!r}")
    return transform


class DentalAxes(NamedTuple):
    """What :class:`UMidlineDentalAxisFilter` finds; None where a jaw was not given, or has no arch and needs none."""

    #: Scans in their UMDA frames: x anterior, y to the patient's left, z superior, mm. None with TransformMeshesOff.
    upper: Optional[_core.Mesh]
    lower: Optional[_core.Mesh]
    #: Maps points of the scan as it was given to its UMDA frame.
    upperTransform: Optional[_core.VersorRigid3DTransform]
    lowerTransform: Optional[_core.VersorRigid3DTransform]
    #: The same for both jaws where they share a frame, in occlusion; None where they don't.
    jointTransform: Optional[_core.VersorRigid3DTransform]
    #: Everything that was found, for :class:`ScanCheckFilter` to judge.
    frames: Optional[_core.DentalFrames] = None

    def __repr__(self) -> str:
        found = (("upper", self.upperTransform), ("lower", self.lowerTransform), ("joint", self.jointTransform))
        return f"<dentalscr.DentalAxes {', '.join(name for name, transform in found if transform is not None)}>"


class UMidlineDentalAxisFilter(ProcessObject, _core.UMidlineDentalAxisFilter):
    """The anatomical frame of dental arches, from their shape alone."""

    def Execute(self, upper: Optional[MeshLike] = None, lower: Optional[MeshLike] = None) -> DentalAxes:
        """Finds the frames of one scan or both.

        Parameters
        ----------
        upper, lower : mesh-like, optional
            At least one; mm, any orientation, triangles wound outward.
        """
        self._SetUpperMesh(None if upper is None else as_mesh(upper))
        self._SetLowerMesh(None if lower is None else as_mesh(lower))
        self._Update()
        transforms = [self._GetTransform(jaw) for jaw in (_core.Jaw.Upper, _core.Jaw.Lower, _core.Jaw.Unknown)]
        meshes = [self._TakeMesh(jaw) for jaw in (_core.Jaw.Upper, _core.Jaw.Lower)]
        return DentalAxes(
            None if transforms[0] is None or not self.GetTransformMeshes() else meshes[0],
            None if transforms[1] is None or not self.GetTransformMeshes() else meshes[1],
            transforms[0],
            transforms[1],
            transforms[2],
            self._GetFrames(),
        )


def UMidlineDentalAxis(
    upper: Optional[MeshLike] = None,
    lower: Optional[MeshLike] = None,
    refineMidline: bool = False,
    **settings: Unpack[_settings.UMidlineDentalAxisSettings],
) -> DentalAxes:
    """The anatomical frames of one scan or both; see :class:`UMidlineDentalAxisFilter`.

    Parameters
    ----------
    upper, lower : mesh-like, optional
    refineMidline : bool, optional
        Take the mirror plane's normal as the lateral axis.
    **settings
        Further ``Set...`` of the class: ``jawsShareFrame``, ``crownFraction``, ...
    """
    process = UMidlineDentalAxisFilter()
    process.SetRefineMidline(refineMidline)
    apply_settings(process, settings)
    return process.Execute(upper, lower)


class MirrorPlane(NamedTuple):
    """The plane dot(normal, p) = offset, in the scans' frame."""

    normal: Tuple[float, float, float]
    offset: float
    #: Mean mirror distance, mm.
    residual: float
    #: Share of the crowns that have a mirror image.
    inlierFraction: float
    #: mm to the next best plane; below 0.1 another is nearly as good.
    margin: float


class MidsagittalPlaneFilter(ProcessObject, _core.MidsagittalPlaneFilter):
    """The plane about which one dental arch, or a pair in occlusion, is its own mirror image."""

    def Execute(self, upper: Optional[MeshLike] = None, lower: Optional[MeshLike] = None) -> MirrorPlane:
        """Finds the plane.

        Parameters
        ----------
        upper, lower : mesh-like, optional
            At least one; both in one frame.
        """
        self._SetUpperMesh(None if upper is None else as_mesh(upper))
        self._SetLowerMesh(None if lower is None else as_mesh(lower))
        self._Update()
        plane = self._GetPlane()
        return MirrorPlane(
            self.GetNormal(), self.GetOffset(), plane["residual"], plane["inlierFraction"], plane["margin"]
        )


def MidsagittalPlane(upper: Optional[MeshLike] = None, lower: Optional[MeshLike] = None) -> MirrorPlane:
    """The mirror plane of one arch or a pair; see :class:`MidsagittalPlaneFilter`."""
    return MidsagittalPlaneFilter().Execute(upper, lower)


class SurfaceDRRImageSource(ProcessObject, _core.SurfaceDRRImageSource):
    """Digitally reconstructed radiograph of scans as hollow shells.

    The picture's indices are those of the cephalogram. It covers the scans and ``SetCoverMargin`` mm around them, with a
    first index that may be negative, unless it has a size of its own by ``SetSize`` or a reference image.
    """

    def SetReferenceImage(self, image: Optional[ImageLike]) -> None:
        """The picture gets the pixels of this one; None for none."""
        self._SetReferenceImage(None if image is None else as_image(image))

    def _SetInputs(self, mesh: Union[MeshLike, Sequence[MeshLike]], geometry: Any) -> None:
        meshes = mesh if isinstance(mesh, list) else [mesh]
        for number in reversed(range(len(meshes), self._GetNumberOfMeshes())):
            self._SetInput(number, None)
        for number, item in enumerate(meshes):
            self._SetInput(number, as_mesh(item))
        self._SetGeometry(as_geometry(geometry))

    def Execute(self, mesh: Union[MeshLike, Sequence[MeshLike]], geometry: Any) -> _core.Image:
        """Renders.

        Parameters
        ----------
        mesh : mesh-like, or list of them
            mm, in the frame of the geometry's pose.
        geometry : CephalometricGeometry or dict
        """
        self._SetInputs(mesh, geometry)
        self._Update()
        return self._TakeOutput()

    def ExecuteInStrips(
        self, mesh: Union[MeshLike, Sequence[MeshLike]], geometry: Any, numberOfStrips: int
    ) -> Iterator[_core.Image]:
        """Renders strip by strip, from the top: for pictures larger than memory. Together they are the same bits.

        Each strip's ``GetIndex()`` says where it is.
        """
        if numberOfStrips < 1:
            raise ArgumentError(f"there is no picture in {numberOfStrips} strips")
        self._SetInputs(mesh, geometry)
        (u, v), (width, height) = self._UpdateOutputInformation()
        edges = [height * i // numberOfStrips for i in range(numberOfStrips + 1)]
        for first, last in zip(edges, edges[1:]):
            if last > first:
                yield self._UpdateRegion((u, v + first), (width, last - first))


def SurfaceDRR(
    mesh: Union[MeshLike, Sequence[MeshLike]],
    geometry: Any,
    sigma: float = 0.5,
    size: Optional[Tuple[int, int]] = None,
    margin: Optional[float] = None,
    **settings: Unpack[_settings.SurfaceDRRSettings],
) -> _core.Image:
    """A DRR of scans; see :class:`SurfaceDRRImageSource`.

    Parameters
    ----------
    mesh : mesh-like, or list of them
    geometry : CephalometricGeometry or dict
    sigma : float, optional
        Width of the splats, mm in the detector plane.
    size : (width, height), optional
        Of the picture; without it, it covers the scans and ``margin`` around them.
    margin : float, optional
        mm; four times ``sigma`` where it is not given.
    **settings
        ``outputMode``, ``normalization``, ``referenceImage``, ...
    """
    process = SurfaceDRRImageSource()
    process.SetSigma(sigma)
    if size is not None:
        process.SetSize(size)
    if margin is not None:
        process.SetCoverMargin(margin)
    apply_settings(process, settings)
    return process.Execute(mesh, geometry)


class SilhouetteContourFilter(ProcessObject, _core.SilhouetteContourFilter):
    """The outer silhouette in a picture at sub-pixel precision, or the outlines in a label map."""

    def Execute(self, image: ImageLike) -> _core.Contour:
        """Traces closed polylines.

        Parameters
        ----------
        image : image-like
            Grey values, or labels under ``SetContent``. Of an image that begins elsewhere than at (0, 0) mm, as a DRR does
            that came back from SimpleITK, pixels are ambiguous: a warning says how to tell.
        """
        picture = as_image(image)
        if (
            self.GetContent() == _core.SilhouetteContent.Intensity
            and self.GetOutputCoordinates() == _core.SilhouetteCoordinates.Index
            and tuple(picture.GetIndex()) == (0, 0)
            and any(picture.GetOrigin())
        ):
            warnings.warn(
                f"the image begins at {picture.GetOrigin()} mm, and the contour is in the image's own pixels; those of the radiograph "
                'for a DRR of to_sitk() or to_itk() come with outputCoordinates="PhysicalOverSpacing"',
                stacklevel=3,
            )
        self._SetInput(picture)
        self._Update()
        return self._TakeOutput()


def SilhouetteContour(
    image: ImageLike,
    levelValue: Optional[float] = None,
    content: Union[str, _core.SilhouetteContent] = "Intensity",
    **settings: Unpack[_settings.SilhouetteContourSettings],
) -> _core.Contour:
    """The silhouette in a picture; see :class:`SilhouetteContourFilter`.

    Parameters
    ----------
    image : image-like
    levelValue : float, optional
        Grey value of the contour; found from the picture where it is not given.
    content : "Intensity", "ToothLabels" or "MergedLabels"
        ToothLabels: each FDI number becomes a contour with its code. MergedLabels: one contour around all labels.
    **settings
        ``largestPartOnly``, ``minimumArea``, ``labelSmoothing``, ``objectIsDark``, ``outputCoordinates``, ...
    """
    process = SilhouetteContourFilter()
    process.SetContent(cast(_core.SilhouetteContent, content))
    if levelValue is not None:
        process.SetLevel(_core.SilhouetteLevel.Absolute)
        process.SetLevelValue(levelValue)
    apply_settings(process, settings)
    return process.Execute(image)


class SilhouetteSamples(NamedTuple):
    """For each point of a mesh's silhouette."""

    #: (N, 2): outward unit normal in the picture.
    normals: Array
    #: (N, 3): the point of the surface that projects there, object frame, mm.
    rim: Array
    #: (N,): arc length within its part, px.
    arcLength: Array


class MeshSilhouetteContourSource(ProcessObject, _core.MeshSilhouetteContourSource):
    """The exact outer silhouette of a scan in a cephalogram."""

    def Execute(self, mesh: MeshLike, geometry: Any) -> _core.Contour:
        """Traces closed polylines in continuous pixel indices.

        Parameters
        ----------
        mesh : mesh-like
            mm, in the frame of the geometry's pose.
        geometry : CephalometricGeometry or dict
        """
        self._SetInput(as_mesh(mesh))
        self._SetGeometry(as_geometry(geometry))
        self._Update()
        return self._TakeOutput()

    def GetSamples(self) -> SilhouetteSamples:
        """Normals and surface points of the last contour's points; copies."""
        return SilhouetteSamples(*self._GetSamples())


def MeshSilhouetteContour(
    mesh: MeshLike, geometry: Any, numberOfPoints: int = 0, largestPartOnly: bool = True
) -> _core.Contour:
    """The exact silhouette of a scan; see :class:`MeshSilhouetteContourSource`.

    Parameters
    ----------
    mesh : mesh-like
    geometry : CephalometricGeometry or dict
    numberOfPoints : int, optional
        At equal distances; 0: the silhouette's corners.
    largestPartOnly : bool, optional
    """
    process = MeshSilhouetteContourSource()
    process.SetNumberOfPoints(numberOfPoints)
    process.SetLargestPartOnly(largestPartOnly)
    return process.Execute(mesh, geometry)


class OpenSilhouetteContourSource(ProcessObject, _core.OpenSilhouetteContourSource):
    """The part of a jaw's outline that a tracing can lie on, as an open contour."""

    def Execute(
        self, mesh: MeshLike, geometry: Any, frameTransform: Optional[TransformLike] = None
    ) -> _core.Contour:
        """Traces open polylines in continuous pixel indices.

        Parameters
        ----------
        mesh : mesh-like
            One side of a jaw, mm.
        geometry : CephalometricGeometry or dict
        frameTransform : transform-like, optional
            Mesh to UMDA frame; without it the mesh's own axes are the dental ones.
        """
        self._SetInput(as_mesh(mesh))
        self._SetGeometry(as_geometry(geometry))
        self._SetFrameTransform(as_rigid(frameTransform))
        self._Update()
        return self._TakeOutput()


def OpenSilhouetteContour(
    mesh: MeshLike,
    geometry: Any,
    frameTransform: Optional[TransformLike] = None,
    jaw: Union[str, _core.Jaw] = "Upper",
    **settings: Unpack[_settings.OpenSilhouetteContourSettings],
) -> _core.Contour:
    """The open outline of one side of a jaw; see :class:`OpenSilhouetteContourSource`."""
    process = OpenSilhouetteContourSource()
    process.SetJaw(cast(_core.Jaw, jaw))
    apply_settings(process, settings)
    return process.Execute(mesh, geometry, frameTransform)


class ContourMaskFilter(ProcessObject, _core.ContourMaskFilter):
    """The stretches of a contour that run through a mask, as polylines of their own."""

    def Execute(self, contour: ContourLike, mask: ImageLike) -> _core.Contour:
        """Keeps the points whose pixel in the mask is not 0.

        Parameters
        ----------
        contour : contour-like
        mask : image-like
            Of it only the indices count.
        """
        self._SetInput(as_contour(contour))
        self._SetMaskImage(as_image(mask))
        self._Update()
        return self._TakeOutput()


def ContourMask(contour: ContourLike, mask: ImageLike, minimumNumberOfPoints: int = 2) -> _core.Contour:
    """The part of a contour that a mask lets through; see :class:`ContourMaskFilter`."""
    process = ContourMaskFilter()
    process.SetMinimumNumberOfPoints(minimumNumberOfPoints)
    return process.Execute(contour, mask)


class ContourResampleFilter(ProcessObject, _core.ContourResampleFilter):
    """Points at equal distances along every polyline."""

    def Execute(self, contour: ContourLike) -> _core.Contour:
        """Resamples by ``NumberOfPoints``, or by ``Spacing`` where that is 0."""
        self._SetInput(as_contour(contour))
        self._Update()
        return self._TakeOutput()


def ContourResample(contour: ContourLike, numberOfPoints: int = 0, spacing: float = 1.0) -> _core.Contour:
    """Resamples a contour; see :class:`ContourResampleFilter`.

    Parameters
    ----------
    contour : contour-like
    numberOfPoints : int, optional
        In total, shared out by length; 0: by ``spacing``.
    spacing : float, optional
        px.
    """
    process = ContourResampleFilter()
    process.SetNumberOfPoints(numberOfPoints)
    process.SetSpacing(spacing)
    return process.Execute(contour)


class ContourDistances(NamedTuple):
    """Distances between two contours, px of the fixed one."""

    movingToFixed: float
    fixedToMoving: float
    #: The average of the two.
    chamfer: float
    hausdorff: float


class ContourDistanceFilter(ProcessObject, _core.ContourDistanceFilter):
    """The paper's figures for two contours: directed means, averaged Chamfer, Hausdorff."""

    def Execute(
        self, fixed: ContourLike, moving: ContourLike, transform: Optional[TransformLike] = None
    ) -> ContourDistances:
        """Measures.

        Parameters
        ----------
        fixed, moving : contour-like
        transform : transform-like, optional
            Maps moving to fixed; without it they share a frame.
        """
        self._SetFixedContour(as_contour(fixed))
        self._SetMovingContour(as_contour(moving))
        self._SetTransform(as_similarity(transform))
        self._Update()
        return ContourDistances(
            self.GetMovingToFixedMean(), self.GetFixedToMovingMean(), self.GetChamfer(), self.GetHausdorff()
        )


def as_similarity(value: Optional[TransformLike]) -> Optional[_core.Similarity2DTransform]:
    """A similarity of the plane, or None."""
    if value is None:
        return None
    transform = as_transform(value)
    if not isinstance(transform, _core.Similarity2DTransform):
        raise TypeError(f"a similarity of the plane is needed, not {transform!r}")
    return transform


def ContourDistance(
    fixed: ContourLike,
    moving: ContourLike,
    transform: Optional[TransformLike] = None,
    **settings: Unpack[_settings.ContourDistanceSettings],
) -> ContourDistances:
    """Distances between two contours; see :class:`ContourDistanceFilter`. ``distance="PointToSegment"`` is a setting."""
    process = ContourDistanceFilter()
    apply_settings(process, settings)
    return process.Execute(fixed, moving, transform)


class ContourOverlaps(NamedTuple):
    """How much of two contours lies together, and how closely."""

    #: Share of the tracing, by weight, and of the outline, by length.
    fixedShare: float
    movingShare: float
    #: Root mean square and largest distance of the tracing's share, px.
    rootMeanSquare: float
    largestDistance: float


class ContourOverlapFilter(ProcessObject, _core.ContourOverlapFilter):
    """How much of an open tracing and of a contour lies together, and how closely."""

    def Execute(
        self, fixed: ContourLike, moving: ContourLike, transform: Optional[TransformLike] = None
    ) -> ContourOverlaps:
        """Measures.

        Parameters
        ----------
        fixed : contour-like
            The tracing.
        moving : contour-like
            The outline.
        transform : transform-like, optional
            Maps moving to fixed; without it they share a frame.
        """
        self._SetFixedContour(as_contour(fixed))
        self._SetMovingContour(as_contour(moving))
        self._SetTransform(as_similarity(transform))
        self._Update()
        return ContourOverlaps(
            self.GetFixedShare(),
            self.GetMovingShare(),
            self.GetRootMeanSquare(),
            self.GetLargestDistance(),
        )


def ContourOverlap(
    fixed: ContourLike,
    moving: ContourLike,
    transform: Optional[TransformLike] = None,
    **settings: Unpack[_settings.ContourOverlapSettings],
) -> ContourOverlaps:
    """Overlap of two contours; see :class:`ContourOverlapFilter`. ``maximumDistance=3.0`` is a setting."""
    process = ContourOverlapFilter()
    apply_settings(process, settings)
    return process.Execute(fixed, moving, transform)


class CrownRegionMeshFilter(ProcessObject, _core.CrownRegionMeshFilter):
    """The crowns of a scan, without gingiva, palate and plaster base."""

    def Execute(self, mesh: MeshLike, frameTransform: Optional[TransformLike] = None) -> _core.Mesh:
        """Cuts the crowns out.

        Parameters
        ----------
        mesh : mesh-like
            mm. Its ``labels`` are used where it has any.
        frameTransform : transform-like, optional
            Mesh to UMDA frame, of :func:`UMidlineDentalAxis`; estimated from the mesh without it.
        """
        self._SetInput(as_mesh(mesh))
        self._SetFrameTransform(as_rigid(frameTransform))
        self._Update()
        return self._TakeOutput()


def CrownRegionMesh(
    mesh: MeshLike,
    jaw: Union[str, _core.Jaw] = "Upper",
    frameTransform: Optional[TransformLike] = None,
    **settings: Unpack[_settings.CrownRegionMeshSettings],
) -> _core.Mesh:
    """The crowns of a scan; see :class:`CrownRegionMeshFilter`.

    Parameters
    ----------
    mesh : mesh-like
    jaw : "Upper" or "Lower"
    frameTransform : transform-like, optional
        Mesh to UMDA frame.
    **settings
        ``useLabels``, ``keepWholeMesh``, ``minimumCrownHeight``, ...
    """
    process = CrownRegionMeshFilter()
    process.SetJaw(cast(_core.Jaw, jaw))
    apply_settings(process, settings)
    return process.Execute(mesh, frameTransform)


class MidlineSideMeshFilter(ProcessObject, _core.MidlineSideMeshFilter):
    """The part of a jaw on one side of the midline plane."""

    def Execute(self, mesh: MeshLike, frameTransform: TransformLike) -> _core.Mesh:
        """Keeps the triangles of the side.

        Parameters
        ----------
        mesh : mesh-like
        frameTransform : transform-like
            Mesh to UMDA frame, of :func:`UMidlineDentalAxis` with ``refineMidline``.
        """
        rigid = as_rigid(frameTransform)
        if rigid is None:
            raise ArgumentError("frameTransform is needed: mesh to UMDA frame, of UMidlineDentalAxis()")
        self._SetInput(as_mesh(mesh))
        self._SetFrameTransform(rigid)
        self._Update()
        return self._TakeOutput()


def MidlineSideMesh(
    mesh: MeshLike, frameTransform: TransformLike, side: Union[str, _core.Side] = "Right", margin: float = -0.5
) -> _core.Mesh:
    """One side of a jaw; see :class:`MidlineSideMeshFilter`.

    Parameters
    ----------
    mesh : mesh-like
    frameTransform : transform-like
        Mesh to UMDA frame.
    side : "Right" or "Left"
        The patient's.
    margin : float, optional
        mm of the other side that stay; negative: so much of this side goes, too.
    """
    process = MidlineSideMeshFilter()
    process.SetSide(cast(_core.Side, side))
    process.SetMargin(margin)
    return process.Execute(mesh, frameTransform)
