"""The stub is that of the compiled part, and the package is typed throughout."""
import os
import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = ROOT / "Wrapping" / "Python" / "dentalscr"

SAMPLE = '''
import dentalscr as ds
import numpy as np


def run(case_file: str) -> float:
    result = ds.register(case_file, preset="robust")
    jaw: ds.JawResult = result.upper
    geometry = ds.CephalometricGeometry(pixelSpacing=0.25, facing="left")
    axes = ds.UMidlineDentalAxis("upper.stl")
    assert axes.upper is not None
    drr = ds.SurfaceDRR(axes.upper, geometry)
    contour = ds.SilhouetteContour(drr, levelValue=0.5)
    method = ds.SilhouetteToContourRegistrationMethod()
    method.SetMetricAsChamfer("symmetric", truncation=20.0)
    method.SetOptimizerAsLBFGSB(numberOfIterations=50)
    method.SetLevel(0, ds.RegistrationLevel(scaleBound=0.2))
    method.AddCommand(ds.sitkIterationEvent, lambda: print(method.GetMetricValue()))
    transform = method.Execute(contour, np.zeros((3, 2)))
    matrix = transform.matrix
    return float(matrix[0, 0]) + transform.GetScale() + float(jaw.landmarks["UR1_tip"][0])
'''

#: Each line that says "no" is an error, and no other is.
WRONG = '''
import dentalscr as ds

ds.Mesh([[0, 0, 0]]).labelz  # no
geometry = ds.CephalometricGeometry(pixelSpacing=0.25)
ds.SurfaceDRR("upper.stl", geometry, outputMode="SummedIntensity", attenuation=0.1)
ds.SurfaceDRR("upper.stl", geometry, attenuatoin=0.1)  # no
ds.SurfaceDRR("upper.stl", geometry, attenuation="much")  # no
ds.ReadContours("contours.json", numbering="FDI", markupsSpacing=(0.1, 0.1))
ds.ReadContours("contours.json", numberring="FDI")  # no
ds.RunCohortExperiment("out", seed=2, methods=["robust"])
ds.RunCohortExperiment("out", seeds=2)  # no
ds.FindToothCrowns(upperMesh="upper.stl")
ds.FindToothCrowns(uperMesh="upper.stl")  # no
list(ds.batch("cases", "out", preset="paper", threads=2))
list(ds.batch("cases", "out", presett="paper"))  # no
'''


def test_stub_is_that_of_the_compiled_part(tmp_path):
    pytest.importorskip("pybind11_stubgen")
    import dentalscr

    output = tmp_path / "_core.pyi"
    done = subprocess.run(
        [ROOT / "Utilities" / "python-stubs.sh", output], capture_output=True, text=True, timeout=300,
        env={**os.environ, "PYTHON": sys.executable, "BUILD_DIR": str(pathlib.Path(dentalscr.__file__).parents[2])},
    )
    assert done.returncode == 0, done.stderr
    assert output.read_text() == (PACKAGE / "_core.pyi").read_text(), "run Utilities/python-stubs.sh"


def test_keywords_of_the_twins_are_those_of_the_setters():
    done = subprocess.run(
        [sys.executable, PACKAGE.parent / "settings_stub.py", PACKAGE], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout == (PACKAGE / "_settings.pyi").read_text(), "run Utilities/python-stubs.sh"


def test_no_twin_takes_keywords_of_any_kind():
    for file in PACKAGE.glob("*.py"):
        assert not re.findall(r"\*\*(\w+): (?!Unpack\[_settings)", file.read_text()), file


def mypy(*arguments, **keywords):
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", *arguments], capture_output=True, text=True, timeout=600, **keywords
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_package_is_strictly_typed():
    pytest.importorskip("mypy")
    mypy(cwd=ROOT)


def test_users_code_is_checked_against_the_types(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "sample.py").write_text(SAMPLE)
    mypy("--follow-imports=silent", "sample.py", cwd=tmp_path, env={**os.environ, "MYPYPATH": str(PACKAGE.parent)})
    (tmp_path / "wrong.py").write_text(WRONG)
    with pytest.raises(AssertionError) as error:
        mypy("--follow-imports=silent", "wrong.py", cwd=tmp_path, env={**os.environ, "MYPYPATH": str(PACKAGE.parent)})
    lines = [number for number, line in enumerate(WRONG.splitlines(), 1) if "# no" in line]
    assert sorted({int(number) for number in re.findall(r"wrong.py:(\d+): error", str(error.value))}) == lines, error.value


def test_package_says_that_it_is_typed():
    assert (PACKAGE / "py.typed").exists()
