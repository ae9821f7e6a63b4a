"""To and from the types of other packages, which are imported only when asked for. All of these copy."""
from __future__ import annotations

from typing import Any, Tuple

import numpy as np

from . import _core
from ._errors import ArgumentError
from ._inputs import Array, ImageLike, MeshLike, as_image, as_mesh, as_transform


def to_sitk(value: Any) -> Any:
    """An image, picture or transform as SimpleITK's.

    The first index of a DRR, which may be negative, becomes part of the origin: SimpleITK's indices begin at 0, physical
    points stay.
    """
    import SimpleITK

    if isinstance(value, _core.Transform):
        name = _name_elsewhere(value, "SimpleITK")
        transform = getattr(SimpleITK, name)()
        transform.SetFixedParameters(value.GetFixedParameters())
        transform.SetParameters(value.GetParameters())
        return transform
    if isinstance(value, _core.Picture):
        return SimpleITK.GetImageFromArray(np.array(value), isVector=True)
    if not isinstance(value, _core.Image):
        raise TypeError(f"{type(value).__name__} has no counterpart in SimpleITK; meshes and contours have none there")
    image = SimpleITK.GetImageFromArray(np.array(value))
    image.SetSpacing(value.GetSpacing())
    image.SetOrigin(_origin_of_first(value))
    image.SetDirection(value.GetDirection())
    return image


def from_sitk(value: Any) -> Any:
    """A grey 2-D image or a transform of SimpleITK as ours."""
    if hasattr(value, "GetParameters"):
        return as_transform(value)
    return as_image(value)


def to_itk(value: Any) -> Any:
    """An image, a mesh or a transform as one of the Python package itk."""
    import itk

    if isinstance(value, _core.Transform):
        kind = getattr(itk, _name_elsewhere(value, "itk"))[itk.D]
        transform = kind.New()
        fixed = transform.GetFixedParameters()
        parameters = transform.GetParameters()
        fixed.SetSize(len(value.GetFixedParameters()))
        parameters.SetSize(len(value.GetParameters()))
        for i, number in enumerate(value.GetFixedParameters()):
            fixed.SetElement(i, number)
        for i, number in enumerate(value.GetParameters()):
            parameters.SetElement(i, number)
        transform.SetFixedParameters(fixed)
        transform.SetParameters(parameters)
        return transform
    if isinstance(value, _core.Image):
        image = itk.image_from_array(np.array(value))
        image.SetSpacing(value.GetSpacing())
        image.SetOrigin(_origin_of_first(value))
        image.SetDirection(np.array(value.GetDirection()).reshape(2, 2))
        return image
    mesh = as_mesh(value)
    result = itk.Mesh[itk.F, 3].New()
    triangles = mesh.triangles.astype(np.uint64)
    cells = np.empty((len(triangles), 5), np.uint64)
    cells[:, 0] = 2  # a triangle
    cells[:, 1] = 3
    cells[:, 2:] = triangles
    result.SetPoints(itk.vector_container_from_array(np.array(mesh.points, np.float32).reshape(-1)))
    result.SetCellsArray(itk.vector_container_from_array(cells.reshape(-1)))
    return result


def from_itk(value: Any) -> Any:
    """A grey 2-D image, a mesh or a transform of the Python package itk as ours."""
    if hasattr(value, "GetParameters"):
        return as_transform(value)
    if hasattr(value, "GetCellsArray"):
        import itk

        return as_mesh(itk.dict_from_mesh(value))
    return as_image(value)


def to_vtk(value: Any) -> Any:
    """A mesh or contour as vtkPolyData, an image as vtkImageData. pyvista.wrap() takes these."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

    if isinstance(value, _core.Image):
        array = np.array(value)
        picture = vtkImageData()
        picture.SetDimensions(array.shape[1], array.shape[0], 1)
        picture.SetSpacing(*value.GetSpacing(), 1.0)
        picture.SetOrigin(*_origin_of_first(value), 0.0)
        scalars = numpy_to_vtk(array.reshape(-1), deep=True)
        scalars.SetName("values")
        picture.GetPointData().SetScalars(scalars)
        return picture

    def cells_of(connectivity: Array, offsets: Array) -> Any:
        cells = vtkCellArray()
        cells.SetData(
            numpy_to_vtkIdTypeArray(np.ascontiguousarray(offsets, np.int64), deep=True),
            numpy_to_vtkIdTypeArray(np.ascontiguousarray(connectivity, np.int64), deep=True),
        )
        return cells

    polydata = vtkPolyData()
    points = vtkPoints()
    if isinstance(value, _core.Contour):
        coordinates = np.zeros((value.GetNumberOfPoints(), 3))
        coordinates[:, :2] = value.points
        points.SetData(numpy_to_vtk(coordinates, deep=True))
        connectivity: list[int] = []
        offsets = [0]
        codes = np.zeros(len(coordinates), np.uint8)
        first = 0
        for polyline in value.polylines:
            ids = list(range(first, first + len(polyline)))
            codes[ids] = polyline.fdi
            first += len(polyline)
            connectivity += ids + (ids[:1] if polyline.closed else [])
            offsets.append(len(connectivity))
        polydata.SetPoints(points)
        polydata.SetLines(cells_of(np.array(connectivity), np.array(offsets)))
        labels = numpy_to_vtk(codes, deep=True)
        labels.SetName("FDI")
        polydata.GetPointData().AddArray(labels)
        return polydata
    mesh = as_mesh(value)
    triangles = mesh.triangles
    points.SetData(numpy_to_vtk(np.array(mesh.points), deep=True))
    polydata.SetPoints(points)
    polydata.SetPolys(cells_of(triangles.reshape(-1), np.arange(0, triangles.size + 1, 3)))
    tooth_labels = mesh.labels
    if tooth_labels is not None:
        labels = numpy_to_vtk(np.array(tooth_labels), deep=True)
        labels.SetName("FDI")
        polydata.GetPointData().AddArray(labels)
    return polydata


def to_trimesh(value: MeshLike) -> Any:
    """A mesh as trimesh.Trimesh, its points as they are."""
    import trimesh

    mesh = as_mesh(value)
    return trimesh.Trimesh(np.array(mesh.points), np.array(mesh.triangles, np.int64), process=False)


def GetArrayFromImage(image: ImageLike) -> Array:
    """(height, width), a copy."""
    return np.array(as_image(image))


def GetArrayViewFromImage(image: _core.Image) -> Array:
    """(height, width): a read-only view, no copy."""
    if not isinstance(image, _core.Image):
        raise ArgumentError("only a dentalscr.Image has a view")
    return image.array


def GetImageFromArray(array: Any, spacing: Any = None) -> _core.Image:
    """An image from a 2-D array of rows and columns; a copy."""
    return as_image(np.asarray(array), spacing)


def _origin_of_first(image: _core.Image) -> Tuple[float, float]:
    index = image.GetIndex()
    return image.TransformContinuousIndexToPhysicalPoint((float(index[0]), float(index[1])))


def _name_elsewhere(transform: _core.Transform, package: str) -> str:
    name = transform.GetName()
    if name not in ("Similarity2DTransform", "VersorRigid3DTransform"):
        raise TypeError(f"{name} has no counterpart in {package}; GetRigidTransform() has the rigid part of a pose")
    return name
