"""Inputs by duck type: what other packages make is taken by what it has, none of them is imported here."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Optional, Tuple, Union, cast

import numpy as np
import numpy.typing

from . import _core
from ._errors import ArgumentError

#: An array of any kind of number.
Array = numpy.typing.NDArray[Any]
#: A file name.
PathLike = Union[str, "os.PathLike[str]"]
#: Mesh, file, (points, triangles), trimesh, Open3D (both kinds), vtkPolyData, pyvista, meshio, itk.Mesh as a dictionary.
MeshLike = Any
#: Contour, file, polylines, (N, 2) array.
ContourLike = Any
#: Image, file, SimpleITK, itk, 2-D array.
ImageLike = Any
#: Similarity2DTransform, VersorRigid3DTransform, those of SimpleITK and itk, file.
TransformLike = Any
#: {"UR1_tip": (u, v)} or file.
LandmarksLike = Any
#: A jaw or its name.
JawLike = Union[str, _core.Jaw]


def as_path(value: PathLike) -> str:
    """A file name as text."""
    return os.fspath(value)


def is_path(value: object) -> bool:
    return isinstance(value, (str, os.PathLike))


def describe(value: object) -> str:
    kind = type(value)
    return f"{kind.__module__}.{kind.__qualname__}"


def _triangles_of_polydata(polydata: Any) -> Array:
    cells = polydata.GetPolys()
    if polydata.GetNumberOfStrips() > 0:
        raise ArgumentError("the vtkPolyData has triangle strips; run vtkTriangleFilter (or .triangulate()) first")
    if cells.GetNumberOfCells() == 0:
        return np.zeros((0, 3), np.int64)
    if cells.GetMaxCellSize() != 3:
        raise ArgumentError("the vtkPolyData has polygons; run vtkTriangleFilter (or .triangulate()) first")
    connectivity = cells.GetConnectivityArray()
    return _from_vtk_array(connectivity).reshape(-1, 3)


def _from_vtk_array(array: Any) -> Array:
    """A vtkDataArray through the buffer protocol that it has."""
    values = np.asarray(memoryview(array)) if _has_buffer(array) else None
    if values is None:
        count = array.GetNumberOfTuples() * array.GetNumberOfComponents()
        values = np.array([array.GetValue(i) for i in range(count)])
    return values.reshape(array.GetNumberOfTuples(), -1)


def _has_buffer(value: object) -> bool:
    try:
        memoryview(cast(Any, value))
    except TypeError:
        return False
    return True


def as_mesh(value: MeshLike) -> _core.Mesh:
    """A mesh from whatever holds one.

    Parameters
    ----------
    value
        :class:`Mesh` (taken as it is), a file name, ``(points, triangles)``, or an object of trimesh, Open3D, vtk,
        pyvista, meshio, or the dictionary of ``itk.dict_from_mesh``. All but a :class:`Mesh` are copied.
    """
    if isinstance(value, _core.Mesh):
        return value
    if is_path(value):
        return _core._ReadMesh(as_path(value))
    if isinstance(value, tuple) and len(value) == 2:
        return _core.Mesh(value[0], value[1])
    if isinstance(value, Mapping) and "points" in value and "cells" in value:
        return _mesh_of_itk(value)
    if hasattr(value, "GetPolys") and hasattr(value, "GetPoints"):
        points = value.GetPoints()
        coordinates = np.zeros((0, 3)) if points is None else _from_vtk_array(points.GetData())
        mesh = _core.Mesh(coordinates, _triangles_of_polydata(value))
        labels = value.GetPointData().GetArray("Universal_ID") if hasattr(value, "GetPointData") else None
        if labels is not None:
            mesh.labels = universal_to_fdi(_from_vtk_array(labels).reshape(-1))
        return mesh
    if hasattr(value, "cells_dict") and hasattr(value, "points"):
        cells = value.cells_dict
        others = [name for name in cells if name not in ("triangle", "line", "vertex")]
        if others or "triangle" not in cells:
            raise ArgumentError(f"the meshio mesh has cells {sorted(cells)}; only triangles are a surface")
        return _core.Mesh(np.asarray(value.points)[:, :3], cells["triangle"])
    if hasattr(value, "vertex") and hasattr(value, "triangle") and "positions" in value.vertex:
        # Open3D's tensors, which may be a GPU's.
        return _core.Mesh(value.vertex["positions"].cpu().numpy(), value.triangle["indices"].cpu().numpy())
    for points_name, triangles_name in (("vertices", "faces"), ("vertices", "triangles"), ("points", "triangles")):
        if hasattr(value, points_name) and hasattr(value, triangles_name):
            return _core.Mesh(np.asarray(getattr(value, points_name)), np.asarray(getattr(value, triangles_name)))
    raise TypeError(
        f"{describe(value)} is no mesh; give a Mesh, a file name, (points, triangles), or an object of trimesh, "
        "Open3D, vtk, pyvista or meshio"
    )


def _mesh_of_itk(value: Mapping[str, Any]) -> _core.Mesh:
    """The dictionary of itk.dict_from_mesh: cells are (type, count, ids...) in one flat array."""
    points = np.asarray(value["points"]).reshape(-1, 3)
    cells = np.asarray(value["cells"]).reshape(-1)
    triangles = cells.reshape(-1, 5) if cells.size % 5 == 0 else np.zeros((0, 5), cells.dtype)
    if len(triangles) * 5 != cells.size or (len(triangles) and not (triangles[:, 1] == 3).all()):
        raise ArgumentError("the mesh has cells that are not triangles; triangulate it first")
    return _core.Mesh(points, triangles[:, 2:])


def universal_to_fdi(labels: Any) -> Array:
    """Universal tooth numbers 1 to 32 as FDI; 0 and 33 are gingiva."""
    table = np.zeros(34, np.uint8)
    for number in range(1, 33):
        quadrant, place = divmod(number - 1, 8)
        table[number] = (18 - place, 21 + place, 38 - place, 41 + place)[quadrant]
    values = np.asarray(labels).astype(np.int64)
    if values.size and (values.min() < 0 or values.max() > 33):
        raise ArgumentError("Universal_ID has numbers outside 0 to 33")
    return table[values]


def as_image(
    value: ImageLike,
    spacing: Optional[Union[float, Sequence[float]]] = None,
) -> _core.Image:
    """A grey 2-D image from whatever holds one.

    Parameters
    ----------
    value
        :class:`Image` (taken as it is), a file name (see ``ReadCephalogram``), a SimpleITK or itk image, or a 2-D
        array of rows and columns. All but an :class:`Image` are copied and become 32-bit floats.
    spacing : float or pair of float, optional
        mm a pixel, for what has none of its own.
    """
    pair = None if spacing is None else as_pair(spacing)
    if isinstance(value, _core.Image):
        return value
    if is_path(value):
        reader = _core.CephalogramFileReader()
        reader.SetFileName(as_path(value))
        if pair is not None:
            reader.SetUserPixelSpacing(pair)
        reader._Update()
        return reader._TakeOutput()
    if hasattr(value, "GetSpacing") and hasattr(value, "GetOrigin") and hasattr(value, "GetDirection"):
        array = _array_of_image(value)
        direction = _direction_of(value)
        own = as_pair(value.GetSpacing())
        return _core.Image(array, pair or own, as_pair(value.GetOrigin()), direction)
    array = np.asarray(value)
    if array.dtype == object or array.ndim != 2:
        raise TypeError(
            f"{describe(value)} is no grey 2-D image; give an Image, a file name, a SimpleITK or itk image, or a "
            "2-D array"
        )
    return _core.Image(array, pair or (1.0, 1.0))


def as_pair(value: Any) -> Tuple[float, float]:
    if isinstance(value, (int, float)):
        return (float(value), float(value))
    numbers = [float(number) for number in value]
    if len(numbers) != 2:
        raise ArgumentError(f"two numbers (u, v) are needed, not {len(numbers)}")
    return (numbers[0], numbers[1])


def _array_of_image(image: Any) -> Array:
    module = type(image).__module__.split(".")[0]
    if module == "SimpleITK":
        import SimpleITK

        array = SimpleITK.GetArrayViewFromImage(image)
    elif module == "itk":
        import itk

        array = itk.array_view_from_image(image)
    else:
        array = np.asarray(image)
    if array.ndim == 3 and array.shape[0] == 1:
        array = array[0]
    if array.ndim != 2:
        raise ArgumentError(f"the image has {array.ndim} dimensions or several components; a grey 2-D one is needed")
    return cast(Array, array)


def _direction_of(image: Any) -> list[float]:
    direction = image.GetDirection()
    if hasattr(direction, "GetVnlMatrix"):
        matrix = direction.GetVnlMatrix()
        return [float(matrix.get(row, column)) for row in range(2) for column in range(2)]
    values = [float(number) for number in np.asarray(direction).reshape(-1)]
    return values if len(values) == 4 else [values[0], values[1], values[3], values[4]]


def as_contour(value: ContourLike, jaw: Optional[str] = None) -> _core.Contour:
    """A contour from whatever holds one.

    Parameters
    ----------
    value
        :class:`Contour` (taken as it is), a file name (then ``jaw`` says which of the two it is), an (N, 2) array (one
        polyline without a code) or its numbers in a row (u0, v0, u1, v1, ...), a sequence of :class:`Polyline` or
        arrays, or ``{"UR1": (N, 2) array}``.
    jaw : "upper" or "lower", optional
    """
    if isinstance(value, _core.Contour):
        return value
    if is_path(value):
        if jaw not in ("upper", "lower"):
            raise ArgumentError(f"{value} holds two jaws; use ReadContours()")
        reader = _core.DentalContourFileReader()
        reader.SetFileName(as_path(value))
        reader._Update()
        return reader._TakeOutputs()[0 if jaw == "upper" else 1]
    contour = _core.Contour()
    if isinstance(value, Mapping):
        for code, points in value.items():
            contour.AddPolyline(points, code)
        return contour
    if isinstance(value, np.ndarray) and value.dtype != object and value.ndim == 2:
        contour.AddPolyline(value)
        return contour
    if isinstance(value, (np.ndarray, Sequence)) and len(value) > 0 and all(np.ndim(item) == 0 for item in value):
        flat = np.asarray(value)
        if flat.dtype.kind in "iuf":
            if flat.size % 2:
                raise ArgumentError(f"{flat.size} numbers in a row are no points (u0, v0, u1, v1, ...)")
            contour.AddPolyline(flat.reshape(-1, 2))
            return contour
    if isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
        if len(value) > 0 and all(np.ndim(cast(Any, item)) == 1 and len(item) == 2 for item in value):
            contour.AddPolyline(np.asarray(value, dtype=np.float64))
            return contour
        polylines = [item if isinstance(item, _core.Polyline) else _core.Polyline(item) for item in value]
        return _core.Contour(polylines)
    raise TypeError(f"{describe(value)} is no contour; give a Contour, a file name, an (N, 2) array or polylines")


def as_landmarks(value: LandmarksLike, dimension: int) -> dict[str, Array]:
    """Named points from a dictionary or a file, as a new dictionary of arrays."""
    if is_path(value):
        reader = _core.DentalLandmarkFileReader2D() if dimension == 2 else _core.DentalLandmarkFileReader3D()
        reader.SetFileName(as_path(value))
        reader._Update()
        return cast("dict[str, Array]", reader._GetOutput())
    if isinstance(value, Mapping):
        return {str(name): np.asarray(point, dtype=np.float64) for name, point in value.items()}
    raise TypeError(f"{describe(value)} holds no landmarks; give a dictionary from name to point, or a file name")


def as_cephalometric_landmarks(value: Any) -> Union[str, dict[str, dict[str, Any]]]:
    """Landmarks to register with: a file's name, or each as a dictionary with its position."""
    if is_path(value):
        return as_path(value)
    if not isinstance(value, Mapping):
        raise TypeError(f"{describe(value)} holds no landmarks; give a dictionary from name to point, or a file name")
    landmarks = {}
    for name, entry in value.items():
        entry = entry if isinstance(entry, Mapping) else {"position": entry}
        unknown = set(entry) - {"position", "sigma_px", "confidence"}
        if unknown or "position" not in entry:
            raise ArgumentError(
                f"landmark {name} is no (u, v) and no dictionary of position, sigma_px and confidence"
                + (f": it has {sorted(map(str, unknown))[0]}" if unknown else "")
            )
        landmarks[str(name)] = {**entry, "position": np.asarray(entry["position"], dtype=np.float64)}
    return landmarks


def as_transform(value: TransformLike) -> _core.Transform:
    """A transform from one of ours, SimpleITK's, itk's (copied by their parameters), or a file."""
    if isinstance(value, _core.Transform):
        return value
    if is_path(value):
        return _core.ReadTransform(as_path(value))
    if hasattr(value, "GetParameters") and hasattr(value, "GetFixedParameters"):
        if hasattr(value, "GetName") and value.GetName() == "Transform" and hasattr(value, "Downcast"):
            value = value.Downcast()
        name = value.GetName() if hasattr(value, "GetName") else value.GetNameOfClass()
        transform: Any
        if name.startswith("Similarity2DTransform"):
            transform = _core.Similarity2DTransform()
        elif name.startswith("VersorRigid3DTransform"):
            transform = _core.VersorRigid3DTransform()
        else:
            raise TypeError(f"{name} is neither a Similarity2DTransform nor a VersorRigid3DTransform")
        transform.SetFixedParameters([float(number) for number in value.GetFixedParameters()])
        transform.SetParameters([float(number) for number in value.GetParameters()])
        return cast(_core.Transform, transform)
    array = np.asarray(value)
    if array.dtype != object and array.ndim == 2 and array.shape[1] == 4 and array.shape[0] in (3, 4):
        return _core.VersorRigid3DTransform(array)
    raise TypeError(f"{describe(value)} is no transform; give one of ours, SimpleITK's or itk's, or a file name")


def as_geometry(value: Any) -> _core.CephalometricGeometry:
    """A geometry, also from the keywords of its constructor in a dictionary."""
    if isinstance(value, _core.CephalometricGeometry):
        return value
    if isinstance(value, Mapping):
        return _core.CephalometricGeometry(**value)
    raise TypeError(f"{describe(value)} is no CephalometricGeometry")
