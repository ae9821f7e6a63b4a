"""Files in and out."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Tuple, Union, cast

import numpy as np

from . import _core
from ._errors import ArgumentError, InputError
from ._inputs import (
    Array,
    ContourLike,
    LandmarksLike,
    MeshLike,
    PathLike,
    TransformLike,
    as_contour,
    as_landmarks,
    as_mesh,
    as_pair,
    as_path,
    as_transform,
)
from ._process import ProcessObject, apply_settings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings


def ReadMesh(fileName: PathLike) -> _core.Mesh:
    """Reads a scan: STL, PLY, OBJ or OFF, in the file's own unit.

    Raises
    ------
    InputError
        For whatever is not a whole mesh of finite points; the message names the file, the place and the remedy.
    """
    return _core._ReadMesh(as_path(fileName))


def WriteMesh(mesh: MeshLike, fileName: PathLike) -> None:
    """Writes a mesh as its extension says, whole or not at all."""
    _core._WriteMesh(as_mesh(mesh), as_path(fileName))


class Contours(NamedTuple):
    """The tracing of both jaws; a jaw without one is an empty contour."""

    upper: _core.Contour
    lower: _core.Contour
    imageSize: Tuple[int, int]
    warnings: Tuple[str, ...]


class DentalContourFileReader(ProcessObject, _core.DentalContourFileReader):
    """Reads a tracing: contours.json, the files of labelme, CVAT, COCO, VIA, Label Studio, Supervisely, 3D Slicer, CSV,
    label maps."""

    def Execute(self, fileName: Optional[PathLike] = None) -> Contours:
        """Reads the file.

        Returns
        -------
        Contours
            ``upper``, ``lower``, ``imageSize``, ``warnings``.
        """
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._Update()
        upper, lower = self._TakeOutputs()
        return Contours(upper, lower, self.GetReadImageSize(), tuple(self.GetWarnings()))


def ReadContours(
    fileName: Union[PathLike, Mapping[str, PathLike]],
    imageSize: Optional[Tuple[int, int]] = None,
    **settings: Unpack[_settings.ReadContoursSettings],
) -> Contours:
    """Reads the tracing on a radiograph; points are continuous pixel indices.

    Parameters
    ----------
    fileName : path, or a dictionary of paths
        contours.json, files of labelme, CVAT, COCO, VIA, Label Studio, Supervisely or 3D Slicer, a .csv of
        ``label,x,y``, or a label map of FDI numbers. A dictionary names files of one tooth or jaw each,
        masks, drawn lines or what a program drew: ``{"UR1": "mask_ur1.png"}``, ``{"UR1": "UR1.mrk.json"}``.
    imageSize : (width, height), optional
        Of the radiograph, for files that do not say it.
    **settings
        ``numbering``, ``pixelOrigin``, ``markupsSpacing``, ``imageFileName``, ... of :class:`DentalContourFileReader`.
    """
    reader = DentalContourFileReader()
    if imageSize is not None:
        reader.SetImageSize(imageSize)
    apply_settings(reader, settings)
    if isinstance(fileName, Mapping):
        reader.SetClassFiles([(code, as_path(path)) for code, path in fileName.items()])
        return reader.Execute()
    return reader.Execute(fileName)


class DentalContourFileWriter(ProcessObject, _core.DentalContourFileWriter):
    """Writes contours.json."""

    def Execute(
        self,
        upper: Optional[ContourLike] = None,
        lower: Optional[ContourLike] = None,
        fileName: Optional[PathLike] = None,
    ) -> None:
        """Writes one jaw or both; ``SetImageSize`` is needed."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._SetUpper(None if upper is None else as_contour(upper))
        self._SetLower(None if lower is None else as_contour(lower))
        self._Update()


def WriteContours(
    fileName: PathLike,
    imageSize: Tuple[int, int],
    upper: Optional[ContourLike] = None,
    lower: Optional[ContourLike] = None,
    **settings: Unpack[_settings.WriteContoursSettings],
) -> None:
    """Writes contours.json, whole or not at all.

    Parameters
    ----------
    fileName : path
    imageSize : (width, height)
        Of the radiograph.
    upper, lower : contour-like, optional
        At least one.
    """
    writer = DentalContourFileWriter()
    writer.SetImageSize(imageSize)
    apply_settings(writer, settings)
    writer.Execute(upper, lower, fileName)


class DentalLandmarkFileReader2D(ProcessObject, _core.DentalLandmarkFileReader2D):
    """Reads landmarks in a radiograph."""

    def Execute(self, fileName: Optional[PathLike] = None) -> dict[str, Array]:
        """Reads the file: ``{"UR1_tip": array([u, v])}``."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._Update()
        return cast("dict[str, Array]", self._GetOutput())


class DentalLandmarkFileReader3D(ProcessObject, _core.DentalLandmarkFileReader3D):
    """Reads landmarks on a scan."""

    def Execute(self, fileName: Optional[PathLike] = None) -> dict[str, Array]:
        """Reads the file: ``{"UR1_tip": array([x, y, z])}``."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._Update()
        return cast("dict[str, Array]", self._GetOutput())


def ReadLandmarks(
    fileName: PathLike,
    dimension: Optional[int] = None,
    **settings: Unpack[_settings.ReadLandmarksSettings],
) -> dict[str, Array]:
    """Reads named landmarks.

    Parameters
    ----------
    fileName : path
        landmarks3d.json, landmarks2d.json, Slicer fiducials, CSV; in 2-D also points of labelme, CVAT, COCO, VIA, Label
        Studio and Supervisely.
    dimension : 2 or 3, optional
        Found out unless given.

    Returns
    -------
    dict
        ``{"UR1_tip": array([x, y, z])}``, in the file's order, in the mesh file's unit or in pixels.
    """
    if dimension not in (None, 2, 3):
        raise ArgumentError(f"landmarks have 2 or 3 dimensions, not {dimension}")
    first = 3 if dimension is None else dimension
    try:
        return _read_landmarks(fileName, first, settings)
    except InputError:
        if dimension is not None:
            raise
    return _read_landmarks(fileName, 2, settings)


def _read_landmarks(fileName: PathLike, dimension: int, settings: Mapping[str, object]) -> dict[str, Array]:
    reader: Union[DentalLandmarkFileReader2D, DentalLandmarkFileReader3D]
    reader = DentalLandmarkFileReader2D() if dimension == 2 else DentalLandmarkFileReader3D()
    apply_settings(reader, settings)
    return reader.Execute(fileName)


class CephalometricLandmarkFileReader(ProcessObject, _core.CephalometricLandmarkFileReader):
    """Reads the dental landmarks of a cephalometric analysis, to register with."""

    def Execute(self, fileName: Optional[PathLike] = None) -> dict[str, dict[str, Any]]:
        """Reads the file: ``{"U1_tip": {"position": array([u, v])}}``, with sigma_px and confidence where known."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._Update()
        return cast("dict[str, dict[str, Any]]", self._GetOutput())


def ReadCephalometricLandmarks(
    fileName: PathLike,
    **settings: Unpack[_settings.ReadCephalometricLandmarksSettings],
) -> dict[str, dict[str, Any]]:
    """Reads the dental landmarks of a cephalometric analysis (Documentation/FileFormats.md): what ``Case`` takes.

    Parameters
    ----------
    fileName : path
        Own JSON, Aariz, CEPHA29, landmark detectors, CL-Detection, ISBI 2015, labelme, Slicer, CSV.

    Returns
    -------
    dict
        ``{"U1_tip": {"position": array([u, v])}}``, pixels; ``sigma_px`` and ``confidence`` where the file has them.
    """
    reader = CephalometricLandmarkFileReader()
    apply_settings(reader, settings)
    return reader.Execute(fileName)


class DentalLandmarkFileWriter2D(ProcessObject, _core.DentalLandmarkFileWriter2D):
    """Writes landmarks2d.json."""

    def Execute(self, landmarks: LandmarksLike, fileName: Optional[PathLike] = None) -> None:
        """Writes ``{"UR1_tip": (u, v)}``."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._SetInput(as_landmarks(landmarks, 2))
        self._Update()


class DentalLandmarkFileWriter3D(ProcessObject, _core.DentalLandmarkFileWriter3D):
    """Writes landmarks3d.json."""

    def Execute(self, landmarks: LandmarksLike, fileName: Optional[PathLike] = None) -> None:
        """Writes ``{"UR1_tip": (x, y, z)}``."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._SetInput(as_landmarks(landmarks, 3))
        self._Update()


def WriteLandmarks(landmarks: LandmarksLike, fileName: PathLike) -> None:
    """Writes named landmarks, 2-D or 3-D as they are."""
    if not hasattr(landmarks, "values") or not landmarks:
        raise ArgumentError("there are no landmarks to write; give a dictionary from name to point")
    if len(next(iter(landmarks.values()))) == 2:
        DentalLandmarkFileWriter2D().Execute(landmarks, fileName)
    else:
        DentalLandmarkFileWriter3D().Execute(landmarks, fileName)


class CephalogramFileReader(ProcessObject, _core.CephalogramFileReader):
    """Reads a radiograph and says what its pixel spacing is worth (``GetPixelSpacingVerdict``)."""

    def Execute(self, fileName: Optional[PathLike] = None) -> _core.Image:
        """Reads the file; dense is bright."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._Update()
        return self._TakeOutput()


def ReadCephalogram(fileName: PathLike, spacing: Optional[Any] = None) -> _core.Image:
    """Reads a radiograph: PNG, JPEG, TIFF, BMP, NRRD, MetaImage, NIfTI or DICOM.

    Parameters
    ----------
    fileName : path
    spacing : float or pair of float, optional
        mm a pixel in the detector plane, which overrides the file's.

    Returns
    -------
    Image
        Its spacing is 1 where none is known: ask :class:`CephalogramFileReader` for the verdict.
    """
    reader = CephalogramFileReader()
    if spacing is not None:
        reader.SetUserPixelSpacing(as_pair(spacing))
    return reader.Execute(fileName)


class ToothLabelFileReader(ProcessObject, _core.ToothLabelFileReader):
    """Reads the tooth labels of a mesh's points (Teeth3DS, 3DTeethSeg22)."""

    def Execute(self, fileName: Optional[PathLike] = None) -> Array:
        """Reads the file: one FDI number a point, 0 for gingiva."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._Update()
        return self._GetOutput()


def ReadToothLabels(fileName: PathLike, **settings: Unpack[_settings.ReadToothLabelsSettings]) -> Array:
    """Reads tooth labels: one FDI number a point, 0 for gingiva; assign them to ``mesh.labels``."""
    reader = ToothLabelFileReader()
    apply_settings(reader, settings)
    return reader.Execute(fileName)


def ReadTransform(fileName: PathLike) -> _core.Transform:
    """Reads a transform that ITK's text files (.tfm) hold. Which way it maps is what its maker said."""
    return _core.ReadTransform(as_path(fileName))


def WriteTransform(transform: TransformLike, fileName: PathLike) -> None:
    """Writes a transform as ITK's text file (.tfm). A 2-D one is for ITK, not for Slicer."""
    _core.WriteTransform(as_transform(transform), as_path(fileName))
