"""The package as a whole: what it has, what it imports, its version."""
import json
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]


def in_new_process(code):
    done = subprocess.run(
        [sys.executable, "-c", f"import sys; sys.path[:0] = {sys.path!r}\n{code}"],
        capture_output=True, text=True, timeout=120,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_import_brings_no_heavy_package():
    loaded = in_new_process("import dentalscr; print(*sys.modules)").split()
    heavy = {"SimpleITK", "itk", "vtk", "vtkmodules", "pyvista", "trimesh", "open3d", "meshio", "scipy", "matplotlib"}
    assert not heavy & {name.split(".")[0] for name in loaded}


def test_one_version_for_project_package_and_program(ds):
    stated = re.search(r"^\s+VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text(), re.M).group(1)
    assert ds.__version__ == stated
    done = subprocess.run(
        [sys.executable, "-c", f"import sys; sys.path[:0] = {sys.path!r}\nsys.argv[1:] = ['--version']\n"
         "from dentalscr.__main__ import main; sys.exit(main())"],
        capture_output=True, text=True, timeout=60,
    )
    assert done.stdout.startswith(f"dentalscr {stated} "), done.stdout + done.stderr


def process_objects():
    """Concrete classes of the modules that are process objects, by their headers."""
    bases = {}
    abstract = set()
    for header in sorted((ROOT / "Modules").glob("*/*/include/itk*.h")):
        text = header.read_text()
        for match in re.finditer(r"^class (?:\w+_EXPORT |ITK_TEMPLATE_EXPORT )?(\w+)\s*\n?\s*:\s*public (\w+)", text, re.M):
            bases[match.group(1)] = match.group(2)
            if "itkNewMacro" not in text:
                abstract.add(match.group(1))
    roots = {
        "ProcessObject", "MeshSource", "ImageSource", "ImageToMeshFilter", "MeshToMeshFilter", "GenerateImageSource",
    }

    def derives(name):
        while name in bases:
            name = bases[name]
        return name in roots

    # batch() runs in workers of Python's own; a result that is read back is json.load() of a file, or a start (init=).
    # The page of a result on disk: WriteReportPage(). Its scene: CaseResult.scene(), and dentalscr view of one on disk.
    elsewhere = {"BatchRunner", "CaseResultFileReader", "CaseSceneFileReader", "ReportPageWriter"}
    # The package links no VTK: its scenes are made of PyPI's, by CaseResult.scene(); meshes go there by to_vtk().
    elsewhere |= {"MeshToVTKPolyDataFilter", "RegistrationSceneSource", "VTKPolyDataToMeshFilter"}
    return [name for name in bases if derives(name) and name not in abstract | elsewhere]


def test_every_process_object_is_wrapped(ds):
    names = process_objects()
    assert len(names) >= 20
    variants = {
        "DentalLandmarkFileReader": ["DentalLandmarkFileReader2D", "DentalLandmarkFileReader3D"],
        "DentalLandmarkFileWriter": ["DentalLandmarkFileWriter2D", "DentalLandmarkFileWriter3D"],
    }
    for name in names:
        for variant in variants.get(name, [name]):
            wrapped = getattr(ds, variant, None)
            assert wrapped is not None, f"{variant} is not wrapped"
            assert callable(wrapped.Execute) and callable(wrapped.AddCommand), variant
            assert wrapped().GetName() == name
            assert wrapped.__doc__ and wrapped.Execute.__doc__, variant


def test_every_process_object_has_its_procedural_twin(ds):
    others = {
        "CaseRegistration": "register", "CaseResultFolderWriter": "WriteCaseResult", "DentalCaseReader": "ReadCase",
        "CephalogramFileReader": "ReadCephalogram", "CaseLandmarkErrorFilter": "MeasureCaseLandmarkErrors",
        "LandmarkCounterpartFilter": "FindLandmarkCounterparts", "ToothCrownFilter": "FindToothCrowns",
        "CephalometricLandmarkFileReader": "ReadCephalometricLandmarks",
        "CohortExperiment": "RunCohortExperiment", "DentalContourFileReader": "ReadContours",
        "SurfaceSplatWidthCalculator": "SurfaceSplatWidth",
        "DentalContourFileWriter": "WriteContours", "DentalLandmarkFileReader": "ReadLandmarks",
        "DentalLandmarkFileWriter": "WriteLandmarks", "ToothLabelFileReader": "ReadToothLabels",
    }
    for name in process_objects():
        twin = others.get(name) or re.sub("(ImageSource|Source|Filter|Method)$", "", name)
        assert twin != name and callable(getattr(ds, twin, None)), f"{name} has no {twin}()"
        assert getattr(ds, twin).__doc__, twin


def test_setters_of_the_toolkit_are_there(ds):
    """A member that C++ sets by itkSetMacro and the like is set in Python, or is an input of Execute()."""
    missing = []
    inputs = {"CaseSource", "DirectoryName", "MeshExtension"}
    for name in process_objects():
        header = next((ROOT / "Modules").glob(f"*/*/include/itk{name}.h")).read_text()
        members = re.findall(r"itkSet(?:Clamp|Enum|String|)Macro\((\w+)", header)
        variants = [name] if hasattr(ds, name) else [name + "2D", name + "3D"]
        for variant in variants:
            missing += [
                f"{variant}.Set{member}" for member in members
                if member not in inputs and not hasattr(getattr(ds, variant), "Set" + member)
            ]
    assert not missing


def test_unknown_setting_of_a_twin_names_the_setter(ds):
    with pytest.raises(TypeError, match="SetSigmma"):
        ds.SurfaceDRR((np.eye(3), [[0, 1, 2]]), ds.CephalometricGeometry(pixelSpacing=0.25), sigmma=1.0)


def test_enumerations_are_taken_by_name_in_any_case(ds):
    process = ds.CrownRegionMeshFilter()
    process.SetJaw("lower")
    assert process.GetJaw() == ds.Jaw.Lower
    with pytest.raises(ds.Error, match="Upper, Lower"):
        ds.Jaw("middle")


def test_names_of_cephalometric_landmarks_are_those_of_the_page(ds, tmp_path):
    """Names of one line of the table are one point, of two lines two; and the code knows no alias that is not there."""
    page = (ROOT / "Documentation/FileFormats.md").read_text()
    table = page.split("One line is one point:")[1].split("Other teeth")[0]
    rows = [re.findall(r"`([^`]+)`", row) for row in re.findall(r"^(\| `.*?\|.*?\|)", table, re.M)]
    assert len(rows) == 14

    def read(names):
        (tmp_path / "names.json").write_text(json.dumps({name: [1, 2] for name in names}))
        return ds.ReadCephalometricLandmarks(tmp_path / "names.json")

    assert list(read([names[0] for names in rows])) == [names[0] for names in rows]
    for first, *others in rows:
        for other in others:
            with pytest.raises(ds.InputError, match="same point"):
                read([first, other])
    source = (ROOT / "Modules/Core/DentalContour/src/itkCephalometricLandmarkSet.cxx").read_text()
    aliases = re.findall(r'{ "(\w+)", JawEnum::', source)
    assert len(aliases) > 20
    listed = {name.lower().replace(" ", "") for names in rows for name in names}
    assert set(aliases) <= listed
