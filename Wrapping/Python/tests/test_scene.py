"""scene(): the same in this Python's VTK as what the program's own VTK exports."""
import pathlib
import subprocess
import sys

import numpy as np
import pytest


@pytest.fixture(scope="module")
def parts(result):
    return {part.name: part for part in result.scene("arrays")}


def blocks_of(multiblock):
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

    numbers = range(multiblock.GetNumberOfBlocks())
    return {multiblock.GetMetaData(i).Get(vtkCompositeDataSet.NAME()): multiblock.GetBlock(i) for i in numbers}


def test_arrays_need_no_vtk(ds, result, parts, case):
    assert all(isinstance(part, ds.ScenePart) for part in parts.values())
    upper = parts["upper scan"]
    assert upper.kind == "scan" and np.array_equal(upper.triangles, case.upper.triangles)
    place = result.upper.T_cephalostat_from_mesh
    expected = case.upper.points.astype(float) @ place[:3, :3].T + place[:3, 3]
    assert np.allclose(upper.points, expected, atol=1e-4)
    assert parts["lateral detector"].picture.shape == (case.imageSize[1], case.imageSize[0])
    assert set(parts["lateral upper tracing"].teeth) == {line.fdi for line in case.upperContour.polylines}
    assert len(parts["lateral upper tracing"].points) == case.upperContour.GetNumberOfPoints()


def test_rays_go_through_scan_and_landmarks_image(result, parts):
    source = parts["lateral central ray"].points[0]
    rays = parts["lateral upper rays"].points.reshape(-1, 3, 3).astype(float)
    assert len(rays) == len(result.upper.landmarks)
    assert np.allclose(rays[:, 0], source, atol=1e-3)
    along = (rays[:, 1] - rays[:, 0]) / np.linalg.norm(rays[:, 1] - rays[:, 0], axis=1)[:, None]
    bend = np.linalg.norm(np.cross(along, rays[:, 2] - rays[:, 0]), axis=1)
    assert bend.max() < 2e-3
    # A tracing's points lie on the detector's plane, a little before it.
    corners = parts["lateral detector"].points.astype(float)
    normal = np.cross(corners[1] - corners[0], corners[3] - corners[0])
    normal /= np.linalg.norm(normal)
    distance = np.abs((parts["lateral upper tracing"].points - corners[0]) @ normal)
    assert np.all((distance > 0.5) & (distance < 0.7))


def test_vtk_blocks_are_those_of_the_program(ds, result, tmp_path, request):
    pytest.importorskip("vtkmodules")
    viewer = pathlib.Path(request.config.getoption("--build-dir")).resolve() / "bin" / "dentalscr"
    if not viewer.with_name("dentalscr-view").exists():
        pytest.skip("the program was built without VTK")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

    result.Write(tmp_path / "result")
    done = subprocess.run(
        [str(viewer), "view", str(tmp_path / "result"), "--export", str(tmp_path / "scene.vtm")],
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0 and done.stderr == "", done.stderr
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(str(tmp_path / "scene.vtm"))
    reader.Update()
    theirs, ours = blocks_of(reader.GetOutput()), blocks_of(result.scene())
    assert list(theirs) == list(ours) and len(ours) > 15
    for name, block in ours.items():
        other = theirs[name]
        assert block.GetBounds() == pytest.approx(other.GetBounds(), abs=1e-6), name
        assert block.GetClassName() == other.GetClassName(), name
        if block.GetClassName() == "vtkImageData":
            assert block.GetDimensions() == other.GetDimensions()
            assert np.allclose(list(block.GetDirectionMatrix().GetData()), list(other.GetDirectionMatrix().GetData()), atol=1e-6)
            assert np.allclose(block.GetSpacing(), other.GetSpacing(), atol=1e-6)
            one, two = (vtk_to_numpy(b.GetPointData().GetScalars()) for b in (block, other))
            assert np.array_equal(one, two)
            continue
        assert np.array_equal(vtk_to_numpy(block.GetPoints().GetData()), vtk_to_numpy(other.GetPoints().GetData())), name
        for cells in ("GetPolys", "GetLines"):
            one, two = (vtk_to_numpy(getattr(b, cells)().GetConnectivityArray()) for b in (block, other))
            assert np.array_equal(one, two), name
        one, two = (vtk_to_numpy(b.GetFieldData().GetArray("Color")) for b in (block, other))
        assert np.array_equal(one, two), name
        for array in ("FDI", "TextureCoordinates"):
            one, two = (b.GetPointData().GetArray(array) for b in (block, other))
            assert (one is None) == (two is None), (name, array)
            assert one is None or np.array_equal(vtk_to_numpy(one), vtk_to_numpy(two)), (name, array)


def test_pyvista_blocks_have_their_names_and_radiograph(result, case):
    pyvista = pytest.importorskip("pyvista")
    blocks = result.scene("pyvista")
    assert isinstance(blocks, pyvista.MultiBlock)
    radiograph = blocks["lateral radiograph"]
    assert radiograph.dimensions == (*case.imageSize, 1)
    # Its corner pixels are half a pixel from the detector's corners.
    corners = blocks["lateral detector"].points
    pixel = np.linalg.norm(corners[1] - corners[0]) / case.imageSize[0]
    assert np.linalg.norm(radiograph.points[0] - corners[0]) == pytest.approx(pixel / 2**0.5, rel=1e-3)
    assert np.linalg.norm(radiograph.points[-1] - corners[2]) == pytest.approx(pixel / 2**0.5, rel=1e-3)


def test_what_cannot_be_shown_is_said(ds, result):
    import pickle

    with pytest.raises(ds.ArgumentError, match='"vtk", "pyvista" or "arrays"'):
        result.scene("blender")
    with pytest.raises(ds.ArgumentError, match="pickled"):
        pickle.loads(pickle.dumps(result)).scene()


def test_a_package_that_is_missing_is_named(ds, result, monkeypatch):
    for package, kind in (("vtkmodules.vtkCommonDataModel", "vtk"), ("pyvista", "pyvista")):
        if kind == "pyvista":
            pytest.importorskip("vtkmodules")
        monkeypatch.setitem(sys.modules, package, None)
        with pytest.raises(ds.ArgumentError, match=f"pip install {kind}"):
            result.scene(kind)
        monkeypatch.undo()


def test_vtk_is_not_imported_with_the_package():
    done = subprocess.run(
        [sys.executable, "-c", "import sys, dentalscr; print([m for m in sys.modules if m.startswith(('vtk', 'pyvista'))])"],
        capture_output=True, text=True, env={**__import__("os").environ, "PYTHONPATH": ":".join(filter(None, sys.path))},
    )
    assert done.stdout.strip() == "[]", done.stdout + done.stderr
