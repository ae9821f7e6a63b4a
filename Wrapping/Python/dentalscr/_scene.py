"""A registered case in space, for VTK and PyVista, which are imported only when asked for."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._inputs import Array


@dataclass(frozen=True)
class ScenePart:
    """A named piece of a scene: triangles or lines in the cephalostat frame, mm (Documentation/Scene.md)."""

    #: "upper scan", "lateral detector", "lateral upper tracing".
    name: str
    #: "scan", "axis", "plane", "source", "central ray", "rays", "detector", "tracing" or "silhouette".
    kind: str
    #: (N, 3), mm.
    points: Array
    #: (M, 2): indices into the points.
    lines: Array
    #: (M, 3): indices into the points.
    triangles: Array
    #: Red, green, blue, 0 to 1.
    color: Tuple[float, float, float]
    opacity: float
    #: Pixels of the screen.
    lineWidth: float
    #: (N,) FDI numbers, 0 for none; None where the points belong to no teeth.
    teeth: Optional[Array] = None
    #: (height, width) of a detector with a radiograph: what it shows, 0 to 255.
    picture: Optional[Array] = None
    #: (N, 2): where each point is in the picture, from (0, 0) at its upper left corner to (1, 1).
    pictureCoordinates: Optional[Array] = None


def parts_of(scene: Dict[str, Any]) -> List[ScenePart]:
    """What the compiled part gives, as objects."""
    return [ScenePart(**part) for part in scene["parts"]]


def to_multiblock(parts: List[ScenePart]) -> Any:
    """The blocks that ``dentalscr view --export scene.vtm`` writes, made by the VTK that is installed for this Python."""
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet

    blocks = vtkMultiBlockDataSet()

    def add(name: str, block: Any) -> None:
        number = blocks.GetNumberOfBlocks()
        blocks.SetBlock(number, block)
        blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)

    for part in parts:
        add(part.name, _to_polydata(part))
        if part.picture is not None:
            add(part.name.rpartition(" ")[0] + " radiograph", _to_image(part))
    return blocks


def _to_polydata(part: ScenePart) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    def cells_of(corners: Array) -> Any:
        cells = vtkCellArray()
        offsets = np.arange(0, corners.size + 1, corners.shape[1], dtype=np.int64)
        cells.SetData(
            numpy_to_vtkIdTypeArray(offsets, deep=True),
            numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners.reshape(-1), np.int64), deep=True),
        )
        return cells

    polydata = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(part.points, deep=True))
    polydata.SetPoints(points)
    if len(part.lines):
        polydata.SetLines(cells_of(part.lines))
    if len(part.triangles):
        polydata.SetPolys(cells_of(part.triangles))
    if part.teeth is not None:
        teeth = numpy_to_vtk(part.teeth, deep=True)
        teeth.SetName("FDI")
        polydata.GetPointData().AddArray(teeth)
    if part.pictureCoordinates is not None:
        # VTK counts from the lower left corner.
        places = part.pictureCoordinates.copy()
        places[:, 1] = np.float32(1.0) - places[:, 1]
        coordinates = numpy_to_vtk(places, deep=True)
        coordinates.SetName("TextureCoordinates")
        polydata.GetPointData().SetTCoords(coordinates)
    color = numpy_to_vtk(np.array([[*part.color, part.opacity]]), deep=True)
    color.SetName("Color")
    polydata.GetFieldData().AddArray(color)
    return polydata


def _to_image(part: ScenePart) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    assert part.picture is not None and part.pictureCoordinates is not None
    height, width = part.picture.shape
    corners = part.points.astype(np.float64)
    # A whole pixel to the right, and one down.
    right = (corners[1] - corners[0]) / float(part.pictureCoordinates[2, 0]) / width
    down = (corners[3] - corners[0]) / float(part.pictureCoordinates[2, 1]) / height
    spacing = np.linalg.norm(right), np.linalg.norm(down)
    axes = np.stack([right / spacing[0], down / spacing[1]])
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.SetOrigin(*(corners[0] + right / 2 + down / 2))
    image.SetSpacing((float(spacing[0]), float(spacing[1]), 1.0))
    image.SetDirectionMatrix(*np.column_stack([*axes, np.cross(axes[0], axes[1])]).reshape(-1))
    pixels = numpy_to_vtk(part.picture.reshape(-1), deep=True)
    pixels.SetName("radiograph")
    image.GetPointData().SetScalars(pixels)
    return image
