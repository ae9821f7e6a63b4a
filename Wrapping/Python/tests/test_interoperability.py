"""With the real SimpleITK, itk, vtk, pyvista, trimesh and meshio, in one process with Debian's ITK."""
import subprocess
import sys

import numpy as np
import pytest

CENTRE = (12.0, -7.0)


@pytest.fixture(scope="module")
def similarity(ds):
    return ds.Similarity2DTransform(1.07, 0.21, (33.5, -12.25), center=CENTRE)


@pytest.fixture(scope="module")
def rigid(ds):
    a, b = 0.3, -0.5
    rotation = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]]) @ np.array(
        [[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]]
    )
    return ds.VersorRigid3DTransform(np.vstack([np.c_[rotation, [4.0, 5.0, 6.0]], [0, 0, 0, 1]]))


def test_simpleitk_moves_points_alike(ds, similarity, rigid):
    pytest.importorskip("SimpleITK")
    random = np.random.default_rng(1)
    for transform, dimension in ((similarity, 2), (rigid, 3)):
        theirs = ds.to_sitk(transform)
        assert theirs.GetName() == transform.GetName()
        assert theirs.GetParameters() == transform.GetParameters()
        points = random.normal(0, 50, (20, dimension))
        moved = [theirs.TransformPoint(point.tolist()) for point in points]
        # The same formula in another compiler's order.
        assert np.allclose(moved, transform.TransformPoints(points), rtol=0, atol=1e-11)
        assert ds.from_sitk(theirs) == transform


def test_simpleitk_reads_what_is_written(ds, similarity, rigid, tmp_path):
    sitk = pytest.importorskip("SimpleITK")
    for transform in (similarity, rigid):
        ds.WriteTransform(transform, tmp_path / "t.tfm")
        theirs = sitk.ReadTransform(str(tmp_path / "t.tfm"))
        assert np.allclose(theirs.GetParameters(), transform.GetParameters(), rtol=0, atol=1e-12)
        sitk.WriteTransform(theirs, str(tmp_path / "u.tfm"))
        assert np.allclose(ds.ReadTransform(tmp_path / "u.tfm").matrix, transform.matrix, rtol=0, atol=1e-12)


def test_image_keeps_values_and_places_in_simpleitk(ds):
    sitk = pytest.importorskip("SimpleITK")
    image = ds.Image(np.arange(12.0).reshape(3, 4), spacing=(0.25, 0.5), origin=(7.0, 8.0), index=(-2, 5))
    theirs = ds.to_sitk(image)
    assert theirs.GetSize() == (4, 3) and theirs.GetPixel(3, 1) == 7.0
    first = image.TransformContinuousIndexToPhysicalPoint((-2.0, 5.0))
    assert theirs.TransformIndexToPhysicalPoint((0, 0)) == pytest.approx(first)
    back = ds.from_sitk(theirs)
    assert np.array_equal(np.asarray(back), np.asarray(image)) and back.GetSpacing() == image.GetSpacing()
    assert ds.as_image(sitk.Cast(theirs, sitk.sitkUInt8)).GetSize() == (4, 3)


def test_label_image_of_simpleitk_becomes_a_contour(ds):
    """A disc, threshold and connected components by SimpleITK; whole, and tooth by label value."""
    sitk = pytest.importorskip("SimpleITK")
    grey = sitk.GaussianSource(sitk.sitkFloat32, size=[200, 160], sigma=[40, 40], mean=[90, 70], scale=100.0)
    level = 100.0 * np.exp(-(30.0**2) / (2 * 40.0**2))
    labels = sitk.ConnectedComponent(sitk.BinaryThreshold(grey, lowerThreshold=level, upperThreshold=1e9))
    whole = ds.SilhouetteContour(labels, content="MergedLabels")
    radii = np.linalg.norm(whole.points - [90, 70], axis=1)
    # Outlines of labels run half-way between pixel centres.
    assert abs(radii - 30.0).max() < 0.8 and len(whole) == 1 and whole.polylines[0].closed
    teeth = sitk.Cast(labels, sitk.sitkUInt8) * 11
    assert [polyline.code for polyline in ds.SilhouetteContour(teeth, content="ToothLabels").polylines] == ["UR1"]
    smooth = ds.SilhouetteContour(labels, content="MergedLabels", labelSmoothing=1.5)
    # A third of the staircase of a pixel is left.
    assert abs(np.linalg.norm(smooth.points - [90, 70], axis=1) - 30.0).max() < 0.4


@pytest.mark.parametrize("kind", ["sitkUInt8", "sitkInt16", "sitkUInt16", "sitkInt32", "sitkFloat32", "sitkFloat64", "sitkInt64"])
@pytest.mark.parametrize("end", [".nii", ".nii.gz"])
def test_label_map_that_simpleitk_writes_as_nifti_is_that_of_the_picture(ds, tmp_path, kind, end):
    """Read from a PNG and written again, in two dimensions and as one slice, which is what nnU-Net works with."""
    sitk = pytest.importorskip("SimpleITK")
    labels = np.zeros((60, 50), np.uint8)
    labels[5:20, 8:16] = 11
    labels[30:52, 21:40] = 46
    labels[30:34, 21:25] = 0
    sitk.WriteImage(sitk.GetImageFromArray(labels), str(tmp_path / "labels.png"))
    expected = ds.ReadContours(tmp_path / "labels.png")
    picture = sitk.Cast(sitk.ReadImage(str(tmp_path / "labels.png")), getattr(sitk, kind))
    slice_ = sitk.JoinSeries(picture)
    slice_.SetSpacing((1, 1, 999))
    placed = sitk.Image(picture)
    placed.SetSpacing((0.1, 0.2))
    placed.SetOrigin((-12.0, 7.0))
    for image in (picture, slice_, placed):
        sitk.WriteImage(image, str(tmp_path / ("labels" + end)))
        contours = ds.ReadContours(tmp_path / ("labels" + end))
        assert contours.imageSize == (50, 60)
        for jaw in ("upper", "lower"):
            assert np.array_equal(getattr(contours, jaw).points, getattr(expected, jaw).points)
            assert [line.code for line in getattr(contours, jaw).polylines] == [line.code for line in getattr(expected, jaw).polylines]
    # The same as SimpleITK's own reader has the pixels, and so as a radiograph, whose spacing counts.
    reader = ds.CephalogramFileReader()
    image = reader.Execute(tmp_path / ("labels" + end))
    assert reader.GetFileFormat() == "NIfTI"
    assert np.array_equal(np.asarray(image), labels) and image.GetSpacing() == pytest.approx((0.1, 0.2), rel=1e-6)


def test_simpleitks_event_constants_serve(ds, case):
    sitk = pytest.importorskip("SimpleITK")
    method = ds.SilhouetteToContourRegistrationMethod()
    levels = []
    method.AddCommand(sitk.sitkMultiResolutionIterationEvent, lambda: levels.append(method.GetCurrentLevel()))
    method.Execute(case.upperContour, case.upperContour)
    assert levels == [0, 1, 2]
    for event in ds.EventEnum:
        assert int(event) == getattr(sitk, event.name)


def test_trimesh_registers_like_its_stl(ds, sample, case, result):
    trimesh = pytest.importorskip("trimesh")
    memory = ds.Case(
        upper=trimesh.load(sample / "upper.stl"), lower=trimesh.load(sample / "lower.stl"),
        contours=sample / "contours.json", geometry=case.geometry, landmarks3D=sample / "landmarks3d.json",
    )
    other = ds.register(memory)
    for name, jaw in result.jaws.items():
        for landmark, place in jaw.landmarks.items():
            # trimesh numbers the points anew, which moves sums by rounding.
            assert np.allclose(other.jaws[name].landmarks[landmark], place, atol=1e-3)


def test_trimesh_there_and_back_is_the_same(ds, case):
    pytest.importorskip("trimesh")
    theirs = ds.to_trimesh(case.upper)
    back = ds.as_mesh(theirs)
    assert np.array_equal(back.points, case.upper.points) and np.array_equal(back.triangles, case.upper.triangles)
    assert theirs.area == pytest.approx(area_of(case.upper), rel=1e-6)


def area_of(mesh):
    a, b, c = (mesh.points[mesh.triangles[:, i]].astype(float) for i in range(3))
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()


def test_vtk_there_and_back_is_the_same(ds, case):
    pytest.importorskip("vtkmodules")
    mesh = ds.Mesh(case.upper.points, case.upper.triangles, labels=np.full(case.upper.GetNumberOfPoints(), 11))
    polydata = ds.to_vtk(mesh)
    assert polydata.GetNumberOfPolys() == mesh.GetNumberOfTriangles()
    assert polydata.GetPointData().GetArray("FDI").GetValue(0) == 11
    back = ds.as_mesh(polydata)
    assert np.array_equal(back.points, mesh.points) and np.array_equal(back.triangles, mesh.triangles)
    lines = ds.to_vtk(case.upperContour)
    assert lines.GetNumberOfLines() == len(case.upperContour)
    picture = ds.to_vtk(ds.Image(np.arange(6.0).reshape(2, 3)))
    assert picture.GetDimensions() == (3, 2, 1) and picture.GetPointData().GetScalars().GetValue(4) == 4.0


def test_pyvista_is_taken_and_its_teeth_are_labels(ds):
    pyvista = pytest.importorskip("pyvista")
    sphere = pyvista.Sphere(radius=10.0)
    sphere.point_data["Universal_ID"] = np.full(sphere.n_points, 8)
    mesh = ds.as_mesh(sphere)
    assert mesh.GetNumberOfTriangles() == sphere.n_cells and set(mesh.labels) == {11}
    with pytest.raises(ds.ArgumentError, match="triangulate"):
        ds.as_mesh(pyvista.Cube())
    assert pyvista.wrap(ds.to_vtk(mesh)).area == pytest.approx(area_of(mesh), rel=1e-6)


def test_meshio_is_taken(ds, tmp_path):
    meshio = pytest.importorskip("meshio")
    points, triangles = np.eye(3), np.array([[0, 1, 2]])
    mesh = ds.as_mesh(meshio.Mesh(points, [("triangle", triangles)]))
    assert np.array_equal(mesh.points, points) and np.array_equal(mesh.triangles, triangles)


def test_itk_of_another_version_lives_in_the_same_process(ds, sample, case, result, similarity):
    """Two builds of ITK: values travel, pointers do not, and each goes on working after the other."""
    itk = pytest.importorskip("itk")
    assert not itk.Version.GetITKVersion().startswith("5.2.")
    image = ds.Image(np.arange(12.0).reshape(3, 4), spacing=(0.25, 0.5), origin=(7.0, 8.0))
    theirs = ds.to_itk(image)
    smoothed = itk.median_image_filter(theirs, radius=1)
    back = ds.from_itk(smoothed)
    assert back.GetSpacing() == (0.25, 0.5) and back.GetOrigin() == (7.0, 8.0) and back.GetSize() == (4, 3)
    # A label map of an itk filter is a contour.
    binary = itk.binary_threshold_image_filter(theirs, lower_threshold=5, outside_value=0, inside_value=11)
    assert ds.SilhouetteContour(binary, content="ToothLabels").polylines[0].code == "UR1"
    moved = ds.to_itk(similarity).TransformPoint((3.0, 4.0))
    assert np.allclose(list(moved), similarity.TransformPoint((3.0, 4.0)), atol=1e-12)
    assert ds.from_itk(ds.to_itk(similarity)) == similarity
    mesh = ds.from_itk(ds.to_itk(case.upper))
    assert np.array_equal(mesh.points, case.upper.points) and np.array_equal(mesh.triangles, case.upper.triangles)
    again = ds.register(sample / "case.json")
    for name, jaw in result.jaws.items():
        assert np.array_equal(again.jaws[name].P_pixel_from_mesh, jaw.P_pixel_from_mesh)


@pytest.mark.parametrize("first", ["dentalscr", "others"])
def test_the_order_of_imports_does_not_matter(ds, sample, first):
    pytest.importorskip("itk")
    pytest.importorskip("SimpleITK")
    pytest.importorskip("vtkmodules")
    others = """
import itk, SimpleITK
from vtkmodules.vtkFiltersSources import vtkSphereSource
sphere = vtkSphereSource(); sphere.Update()
grey = itk.image_from_array(np.ones((8, 8), np.float32)); itk.median_image_filter(grey, radius=1)
SimpleITK.SmoothingRecursiveGaussian(SimpleITK.Image(8, 8, SimpleITK.sitkFloat32))
"""
    ours = f"""
import dentalscr as ds
result = ds.register({str(sample / "case.json")!r}, preset="paper")
try:
    ds.ReadMesh("nothing.stl")
except ds.InputError:
    pass
"""
    code = f"import sys; sys.path[:0] = {sys.path!r}\nimport numpy as np\n"
    code += (ours + others + ours) if first == "dentalscr" else (others + ours + others)
    done = subprocess.run([sys.executable, "-c", code + "print('well')"], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0 and done.stdout.strip().endswith("well"), done.stderr[-3000:]


def test_open3d_names_are_taken(ds):
    """Open3D itself is not installed by the tests (its wheel is 400 MB): the names it has."""

    class TriangleMesh:
        vertices = np.eye(3)
        triangles = np.array([[0, 1, 2]], np.int32)

    assert ds.as_mesh(TriangleMesh()).GetNumberOfTriangles() == 1

    class Tensor:
        def __init__(self, values):
            self.values = values

        def cpu(self):
            return self

        def numpy(self):
            return self.values

    class TensorMesh:
        vertex = {"positions": Tensor(np.eye(3, dtype=np.float32))}
        triangle = {"indices": Tensor(np.array([[0, 1, 2]], np.int64))}

    assert np.array_equal(ds.as_mesh(TensorMesh()).points, np.eye(3))


def test_open3d_there_and_back(ds):
    open3d = pytest.importorskip("open3d")
    mesh = ds.DentalPhantomMesh(seed=3)["upper"].mesh
    there = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(mesh.points.astype(float)), open3d.utility.Vector3iVector(mesh.triangles)
    )
    for given in (there, open3d.t.geometry.TriangleMesh.from_legacy(there)):
        back = ds.as_mesh(given)
        assert np.array_equal(back.points, mesh.points) and np.array_equal(back.triangles, mesh.triangles)
    frame = ds.UMidlineDentalAxis(there)
    there.transform(frame.upperTransform.matrix)
    assert np.allclose(np.asarray(there.vertices), frame.upper.points, atol=1e-5)
