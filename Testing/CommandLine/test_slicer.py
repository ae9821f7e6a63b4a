"""The modules for 3D Slicer: their descriptions, and the calls that Slicer's logic makes of them with temporary files.

Slicer itself is not here. What it does was read in its sources (Base/QTCLI/vtkSlicerCLIModuleLogic.cxx): nodes that were chosen are
written to temporary files, of the first of fileExtensions or of the default of their kind; then come --returnparameterfile, all
parameters with flags, and those with an index in their order; what is on standard output between the tags of progress is shown, and
outputs are read from the files that were named.
"""
import ast
import json
import os
import pathlib
import re
import subprocess
import sys
import types
import xml.etree.ElementTree as ElementTree

import numpy
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Slicer"
MODULES = sorted(path.stem for path in FOLDER.glob("DentalSCR*.xml"))

# Elements of a parameter group (ModuleDescription.xsd, and pointfile, which Slicer reads as well), and what Slicer gives to each.
DEFAULTS = {"image": ".nrrd", "geometry": ".vtp", "transform": ".h5", "table": ".tsv", "pointfile": ".fcsv"}
SIMPLE = {"integer", "double", "boolean", "string", "string-enumeration", "double-vector", "file", "directory"}
# By index Slicer wants a value of these.
NO_DEFAULT = {"image", "geometry", "transform", "table", "pointfile", "file", "directory", "string"}


@pytest.fixture(scope="module")
def lib():
    sys.path.insert(0, str(FOLDER))
    try:
        import DentalSCRLib

        yield DentalSCRLib
    finally:
        sys.path.remove(str(FOLDER))


def parameters_of(root):
    return [item for item in root.iterfind("parameters/*") if item.tag not in ("label", "description")]


def read_description(name):
    return ElementTree.parse(FOLDER / f"{name}.xml").getroot()


def check_description(root):
    assert root.tag == "executable"
    order = ["category", "title", "description", "version", "documentation-url", "license", "contributor", "acknowledgements"]
    found = [child.tag for child in root if child.tag != "parameters"]
    assert found == [tag for tag in order if tag in found] and {"category", "title", "description", "version"} <= set(found)
    assert root.findall("parameters")
    names, flags, indices = [], [], []
    for group in root.iterfind("parameters"):
        assert [child.tag for child in group][:2] == ["label", "description"]
    for item in parameters_of(root):
        name = item.findtext("name")
        names.append(name)
        assert item.tag in SIMPLE | set(DEFAULTS), item.tag
        assert item.findtext("label") and item.findtext("description"), name
        flag, index = item.findtext("longflag"), item.findtext("index")
        channel = item.findtext("channel")
        assert channel in (None, "input", "output")
        returned = channel == "output" and item.tag in ("string", "double", "integer")
        # Slicer reads a simple output from the file of returned parameters, and gives it no flag.
        assert returned == (flag is None and index is None), name
        if item.tag in DEFAULTS or item.tag in ("file", "directory"):
            assert channel, name
        if flag:
            assert re.fullmatch(r"--[a-zA-Z]\w*", flag), flag
            flags.append(flag)
        if index:
            indices.append(int(index))
        if item.tag.endswith("-enumeration"):
            assert item.findtext("default") in [element.text for element in item.iterfind("element")], name
        elif item.tag == "boolean":
            assert item.findtext("default") in ("true", "false"), name
        if item.tag == "pointfile":
            assert item.get("coordinateSystem") == "lps" and item.get("fileExtensions") == ".mrk.json", name
        if item.get("reference"):
            assert item.get("reference") in [other.findtext("name") for other in parameters_of(root)], name
    assert len(names) == len(set(names)) and len(flags) == len(set(flags))
    assert sorted(indices) == list(range(len(indices)))


@pytest.mark.parametrize("name", MODULES)
def test_description_is_one_of_the_execution_model(name):
    check_description(read_description(name))
    script = (FOLDER / f"{name}.py").read_text()
    # By this line Slicer tells a command-line module from a scripted one.
    assert script.startswith("#!") and os.access(FOLDER / f"{name}.py", os.X_OK)


def test_descriptions_are_true_to_the_program(run):
    assert len(MODULES) == 5
    verbs = {verb["name"]: verb for verb in json.loads(run("--describe").stdout)["verbs"]}
    version = run("--version").stdout.split()[1]
    for name in MODULES:
        root = read_description(name)
        assert root.findtext("version") == version
        options = {option["names"][-1]: option for option in verbs[name.removeprefix("DentalSCR").lower()]["options"]}
        for item in parameters_of(root):
            option = options.get(item.findtext("longflag") or "")
            if option and option["choices"] and item.tag == "string-enumeration":
                elements = [element.text for element in item.iterfind("element")]
                assert [word for word in elements if word != "by name"] == option["choices"], item.findtext("name")


class Slicer:
    """Does what Slicer's logic does: `given` has a file for each node that was chosen, and a value for each that was typed."""

    def __init__(self, program, folder):
        self.environment = dict(os.environ, DENTALSCR_PROGRAM=str(program))
        self.folder = folder

    def apply(self, name, **given):
        root = read_description(name)
        self.outputs = {}
        flags, indexed = [], {}
        for item in parameters_of(root):
            parameter, flag, index = (item.findtext(tag) for tag in ("name", "longflag", "index"))
            if flag is None and index is None:
                continue
            value = given.pop(parameter, None)
            if item.tag in DEFAULTS:
                if value is True:
                    extension = (item.get("fileExtensions") or DEFAULTS[item.tag]).split(",")[0]
                    value = self.outputs[parameter] = self.folder / f"ABCD_{parameter}{extension}"
                words = [] if value is None else [str(value)]
            elif item.tag == "boolean":
                words = None if (value or item.findtext("default") == "true") else []
            else:
                value = item.findtext("default") if value is None else str(value)
                words = [value] if value else []
            if index:
                assert words or item.tag not in NO_DEFAULT, f"Slicer stops: no value for {parameter}"
                indexed[int(index)] = words
            elif words is None:
                flags.append(flag)
            elif words:
                flags += [flag, *words]
        assert not given, f"no parameters: {given}"
        command = [sys.executable, str(FOLDER / f"{name}.py")]
        returned = self.folder / "returned.params"
        if any(item.findtext("channel") == "output" and item.find("longflag") is None and item.find("index") is None for item in parameters_of(root)):
            command += ["--returnparameterfile", str(returned)]
        command += [*flags, *(word for key in sorted(indexed) for word in indexed[key])]
        done = subprocess.run(command, capture_output=True, text=True, env=self.environment, timeout=300)
        self.progress = [float(text) for text in re.findall(r"<filter-progress>(.*?)</filter-progress>", done.stdout)]
        self.comments = re.findall(r"<filter-comment>(.*?)</filter-comment>", done.stdout)
        self.returned = dict(line.split(" = ", 1) for line in returned.read_text().splitlines()) if returned.exists() else {}
        return done


@pytest.fixture
def slicer(program_of_slicer, tmp_path):
    return Slicer(program_of_slicer, tmp_path)


def write_vtp(file, corners):
    """As Slicer's writer does it, but as text."""
    points = numpy.asarray(corners).reshape(-1, 3)
    count = len(points) // 3
    numbers = " ".join(f"{value:.9g}" for value in points.reshape(-1))
    connectivity = " ".join(map(str, range(3 * count)))
    offsets = " ".join(str(3 * i + 3) for i in range(count))
    file.write_text(
        f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt32">
<PolyData><Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{count}">
<Points><DataArray type="Float32" Name="Points" NumberOfComponents="3" format="ascii">{numbers}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">{connectivity}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{offsets}</DataArray></Polys>
</Piece></PolyData></VTKFile>
"""
    )
    return file


def write_nrrd(file, pixels, spacing=(1.0, 1.0), origin=(0.0, 0.0, 0.0)):
    """A radiograph as Slicer writes a volume of one slice that it has read from a PNG."""
    height, width = pixels.shape
    kind = {"uint8": "unsigned char", "uint16": "unsigned short"}[str(pixels.dtype)]
    head = (
        f"NRRD0004\n# Complete NRRD file format specification at:\n# http://teem.sourceforge.net/nrrd/format.html\ntype: {kind}\n"
        f"dimension: 3\nspace: left-posterior-superior\nsizes: {width} {height} 1\n"
        f"space directions: ({spacing[0]},0,0) (0,{spacing[1]},0) (0,0,1)\nkinds: domain domain domain\nendian: little\n"
        f"encoding: raw\nspace origin: ({','.join(map(str, origin))})\n\n"
    )
    file.write_bytes(head.encode() + pixels.tobytes())
    return file


SPACING, ORIGIN = (0.5, 0.75), (-12.0, 30.0, 0.0)


@pytest.fixture(scope="module")
def inputs(sample, lib, tmp_path_factory):
    """The nodes that a user of Slicer has: two models, a volume, markups on the scans."""
    folder = tmp_path_factory.mktemp("nodes")
    case = json.loads((sample / "case.json").read_text())
    tracing = json.loads((sample / "contours.json").read_text())
    width, height = tracing["image_size"]
    pixels = numpy.arange(height * width, dtype=numpy.uint64).reshape(height, width) % 251
    names = json.loads((sample / "landmarks3d.json").read_text())
    lib.write_markups(folder / "scan.mrk.json", "Fiducial", [(name, place) for name, place in names.items()])
    return types.SimpleNamespace(
        case=case,
        folder=folder,
        upper=write_vtp(folder / "upper.vtp", lib.read_stl(sample / "upper.stl")),
        lower=write_vtp(folder / "lower.vtp", lib.read_stl(sample / "lower.stl")),
        image=write_nrrd(folder / "image.nrrd", pixels.astype(numpy.uint8), SPACING, ORIGIN),
        contours=sample / "contours.json",
        scanLandmarks=folder / "scan.mrk.json",
        spacing=",".join(map(str, case["cephalogram"]["pixel_spacing_mm"])),
        principalPoint=",".join(map(str, case["geometry"]["principal_point_px"])),
    )


def test_register_with_nodes_of_slicer(slicer, inputs, lib, sample, run, tmp_path):
    done = slicer.apply(
        "DentalSCRRegister", upper=inputs.upper, lower=inputs.lower, image=inputs.image, contours=inputs.contours,
        scanLandmarks=inputs.scanLandmarks, spacing=inputs.spacing, facing=inputs.case["cephalogram"]["facing"],
        principalPoint=inputs.principalPoint, output=tmp_path / "result", upperMoved=True, lowerMoved=True,
        upperTransform=True, lowerTransform=True, predicted=True,
    )
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "result" / "result.json").read_text())
    assert slicer.returned["status"] == result["status"]
    assert float(slicer.returned["upperExpectedError"]) == pytest.approx(result["jaws"]["upper"]["expected_error_px"], abs=0.005)
    # Progress as Slicer reads it: rising, to the end, with words.
    assert slicer.progress == sorted(slicer.progress) and slicer.progress[-1] == 1.0 and len(slicer.progress) > 5
    assert any("registration" in comment or "upper" in comment for comment in slicer.comments)
    # The same case by the shell: the answer is that of the program, to the VTP's digits.
    assert run("register", sample / "case.json", "--output", tmp_path / "shell", "--no-page").returncode == 0
    shell = json.loads((tmp_path / "shell" / "result.json").read_text())
    for jaw in ("upper", "lower"):
        matrix = lib.read_transform(slicer.outputs[f"{jaw}Transform"])
        scan = lib.read_stl(sample / f"{jaw}.stl")
        # The transform moves the model of the scan to where the moved model is: L = y, P = -x, S = z of the cephalostat.
        moved = lib.read_stl(slicer.outputs[f"{jaw}Moved"])
        numpy.testing.assert_allclose(lib.move(scan, matrix), moved, atol=2e-3)
        cephalostat = lib.read_stl(tmp_path / "shell" / f"{jaw}_ceph.stl")
        numpy.testing.assert_allclose(moved[..., 0], cephalostat[..., 1], atol=0.05)
        numpy.testing.assert_allclose(moved[..., 1], -cephalostat[..., 0], atol=0.05)
        numpy.testing.assert_allclose(moved[..., 2], cephalostat[..., 2], atol=0.05)
        assert b"SPACE=LPS" in slicer.outputs[f"{jaw}Moved"].read_bytes()[:80]
    # Markups on the volume, mm: where the program says in pixels.
    (name, kind, points), = lib.read_markups(slicer.outputs["predicted"])
    assert kind == "Fiducial" and points
    for label, place in points:
        pixel = next(entry["landmarks_px"][label] for entry in shell["jaws"].values() if label in entry["landmarks_px"])
        expected = [pixel[0] * SPACING[0] + ORIGIN[0], pixel[1] * SPACING[1] + ORIGIN[1], ORIGIN[2]]
        numpy.testing.assert_allclose(place, expected, atol=0.2)


def test_register_with_landmarks_that_were_marked_in_slicer(slicer, lib, run, tmp_path):
    """Without any tracing; the volume has a spacing and an origin of its own, which are not the radiograph's."""
    assert run("phantom", "--level", "standard", "--seed", 2, "--triangles", 12000, "--output", tmp_path / "case").returncode == 0
    case = json.loads((tmp_path / "case" / "case.json").read_text())
    marked = json.loads((tmp_path / "case" / case["cephalometric_landmarks"]).read_text())
    marked = marked.get("landmarks", marked)
    places = {name: entry["position"] if isinstance(entry, dict) else entry for name, entry in marked.items() if isinstance(entry, (dict, list))}
    width, height = json.loads((tmp_path / "case" / "case.json").read_text())["cephalogram"].get("image_size") or (900, 900)
    image = write_nrrd(tmp_path / "image.nrrd", numpy.zeros((height, width), numpy.uint8) + 7, SPACING, ORIGIN)
    grid = lib.ImageGrid.read(image)
    numpy.testing.assert_allclose(grid.to_pixels(grid.from_pixels([[12.5, 80.25]])), [[12.5, 80.25]])
    # Slicer writes markups in LPS where it is asked to, and RAS by older versions.
    points = [(name, grid.from_pixels(place)[0]) for name, place in places.items()]
    lib.write_markups(tmp_path / "marked.mrk.json", "Fiducial", points)
    scans = {jaw: write_vtp(tmp_path / f"{jaw}.vtp", lib.read_stl(tmp_path / "case" / case[jaw])) for jaw in ("upper", "lower")}
    names = json.loads((tmp_path / "case" / case["landmarks_3d"]).read_text())
    lib.write_markups(tmp_path / "scan.mrk.json", "Fiducial", list(names.items()))
    done = slicer.apply(
        "DentalSCRRegister", **scans, image=image, landmarks=tmp_path / "marked.mrk.json", scanLandmarks=tmp_path / "scan.mrk.json",
        spacing=",".join(map(str, case["cephalogram"]["pixel_spacing_mm"])), output=tmp_path / "result",
    )
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "result" / "result.json").read_text())
    used = json.loads((tmp_path / "result" / "report.json").read_text())["views"][0]["jaws"]["upper"]["landmarks_used_px"]
    assert used and slicer.returned["status"] in ("ok", "suspect")
    assert result["jaws"]["upper"]["status"] != "failed"


@pytest.mark.parametrize("wrong, words", [
    ({}, "no radiograph was chosen"),
    ({"case": "nowhere.json"}, "there is no such file"),
    ({"case": "nowhere.json", "upper": "a.vtp"}, "take one or the other"),
])
def test_what_is_missing_is_said_in_one_line_that_slicer_shows(slicer, wrong, words):
    done = slicer.apply("DentalSCRRegister", **wrong)
    assert done.returncode == 1 and words in done.stderr.strip().splitlines()[-1]
    assert "Traceback" not in done.stderr


def test_axis_and_render_and_project(slicer, inputs, lib, tmp_path):
    done = slicer.apply("DentalSCRAxis", upper=inputs.upper, lower=inputs.lower, upperMoved=True, upperTransform=True)
    assert done.returncode == 0, done.stderr
    scan = lib.read_stl(inputs.contours.parent / "upper.stl")
    moved = lib.read_stl(slicer.outputs["upperMoved"])
    numpy.testing.assert_allclose(lib.move(scan, lib.read_transform(slicer.outputs["upperTransform"])), moved, atol=2e-3)
    done = slicer.apply("DentalSCRRender", upper=inputs.upper, spacing=inputs.spacing, output=True)
    assert done.returncode == 0, done.stderr
    assert lib.ImageGrid.read(slicer.outputs["output"]).size > (50, 50)


def test_outlines_of_a_label_map(slicer, tmp_path):
    pixels = numpy.zeros((80, 100), numpy.uint16)
    pixels[20:40, 30:60] = 11
    labels = write_nrrd(tmp_path / "labels.nrrd", pixels)
    done = slicer.apply("DentalSCRContour", labels=labels, output=tmp_path / "outlines.json")
    assert done.returncode == 0, done.stderr
    (outline,) = json.loads((tmp_path / "outlines.json").read_text())["contours"]["upper"]
    low, high = numpy.min(outline["points"], axis=0), numpy.max(outline["points"], axis=0)
    numpy.testing.assert_allclose([*low, *high], [29.5, 19.5, 59.5, 39.5], atol=0.01)
    assert outline["code"] == "UR1"


def test_curves_become_the_tracing_that_they_are(lib, tmp_path):
    grid = lib.ImageGrid.read(write_nrrd(tmp_path / "image.nrrd", numpy.zeros((50, 60), numpy.uint8), SPACING, ORIGIN))
    curves = [("UR1", False, grid.from_pixels([[1, 2], [3, 4]])), ("36", True, grid.from_pixels([[5, 6], [7, 8], [9, 6]])), ("lower", False, grid.from_pixels([[1, 1], [2, 2]]))]
    content = lib.contours_from_curves(curves, grid)
    assert content["image_size"] == [60, 50]
    (first,) = content["contours"]["upper"]
    assert first["code"] == "UR1" and "closed" not in first
    numpy.testing.assert_allclose(first["points"], [[1, 2], [3, 4]])
    assert [entry["code"] for entry in content["contours"]["lower"]] == ["36", ""]
    assert lib.is_code("UL4") and lib.is_code("36") and lib.is_code("lower") and not lib.is_code("F") and not lib.is_code("91")


def test_scripted_module_is_python_that_uses_what_there_is(lib):
    """Its form is Slicer's alone to run; every name of the library that it uses is there."""
    tree = ast.parse((FOLDER / "DentalSCR.py").read_text())
    assert {node.name for node in tree.body if isinstance(node, ast.ClassDef)} >= {"DentalSCR", "DentalSCRWidget", "DentalSCRLogic", "DentalSCRTest"}
    used = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "lib"}
    assert used and all(hasattr(lib, name) for name in used)


def test_program_itself_is_a_module_too(run, sample, tmp_path):
    done = run("--xml")
    assert done.returncode == 0 and done.stderr == ""
    root = ElementTree.fromstring(done.stdout)
    check_description(root)
    assert root.find("version").text in run("--version").stdout
    items = parameters_of(root)
    values = {"caseFile": sample / "case.json", "output": tmp_path / "result"}
    call = []
    for item in items:
        value = values.get(item.find("name").text, item.findtext("default"))
        if item.find("longflag") is not None:
            call += [item.find("longflag").text, value]
    indexed = sorted((int(item.find("index").text), item) for item in items if item.find("index") is not None)
    positional = [values.get(item.find("name").text, item.findtext("default")) for _, item in indexed]
    # Slicer puts the flags before the arguments by position.
    done = run("--returnparameterfile", tmp_path / "returned", *call, *positional)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "returned").read_text() in ("status = ok\n", "status = suspect\n")
    assert (tmp_path / "result" / "result.json").exists()
