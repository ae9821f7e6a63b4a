"""Runs every example in C++ and in Python, and holds what it prints against the expected.json beside it.

expected.json: {"arguments": [...], "values": {"name": [value, tolerance]}, "files": [...]}; {case} is a sample case, {out} an
empty folder. "upper" and "lower" bounds may stand in for a value: {"name": {"upper": 3}}.
"""
import json
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = sorted(path.parent for path in (ROOT / "Examples").glob("*/expected.json"))


def twins_of(folder):
    return [path for path in folder.glob("*.py") if path.stem not in ("plot", "measure")]


@pytest.fixture(scope="session")
def phantom(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("phantom") / "case"
    done = run("phantom", "--level", "typical", "--seed", 7, "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder


def read_values(text):
    values = {}
    for line in text.splitlines():
        name, colon, value = line.rpartition(": ")
        if colon:
            try:
                values[name.strip()] = float(value)
            except ValueError:
                values[name.strip()] = value.strip()
    return values


def check(folder, command, phantom, out, environment=None):
    expected = json.loads((folder / "expected.json").read_text())
    arguments = [a.format(case=phantom, out=out) for a in expected["arguments"]]
    done = subprocess.run(
        [*map(str, command), *arguments], capture_output=True, text=True, timeout=300, cwd=out, env=environment
    )
    assert done.returncode == 0, done.stdout + done.stderr
    values = read_values(done.stdout)
    for name, wanted in expected["values"].items():
        assert name in values, f"{name!r} was not printed:\n{done.stdout}"
        if isinstance(wanted, list):
            assert values[name] == pytest.approx(wanted[0], abs=wanted[1]), name
        elif isinstance(wanted, dict):
            assert wanted.get("lower", -1e300) <= values[name] <= wanted.get("upper", 1e300), (name, values[name])
        else:
            assert values[name] == wanted, name
    for name in expected.get("files", []):
        assert (out / name).stat().st_size > 0, name


@pytest.fixture
def inputs(phantom, tmp_path):
    """What single examples need beside the sample case."""
    (tmp_path / "cases.csv").write_text(
        "CaseID,Upper,Lower,Cephalogram,Contour,Spacing,PrincipalU,PrincipalV,Landmarks3D,Landmarks2D,Operator\n"
        f"good,{phantom}/upper.stl,{phantom}/lower.stl,{phantom}/ceph.png,{phantom}/contours.json,,,,"
        f"{phantom}/landmarks3d.json,{phantom}/landmarks2d.json,anna\n"
        f"gone,{phantom}/nothing.stl,,{phantom}/ceph.png,{phantom}/contours.json,,,,,,ben\n"
        f"word,{phantom}/upper.stl,,{phantom}/ceph.png,{phantom}/contours.json,quarter,,,,,ben\n"
    )
    return tmp_path


@pytest.mark.parametrize("folder", EXAMPLES, ids=lambda path: path.name)
def test_cxx_example_gives_what_is_expected(folder, build_dir, phantom, inputs):
    program = build_dir / "bin" / folder.name
    assert program.exists(), f"{program} is not built"
    check(folder, [program], phantom, inputs)


def test_robust_by_hand_has_the_bits_of_the_program(build_dir, run, phantom, tmp_path):
    done = run("register", phantom / "case.json", "--output", tmp_path / "result", "--no-report")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "result" / "result.json").read_text())
    expected = json.loads((ROOT / "Examples" / "RobustByHand" / "expected.json").read_text())
    arguments = [a.format(case=phantom, out=tmp_path) for a in expected["arguments"]]
    done = subprocess.run(
        [str(build_dir / "bin" / "RobustByHand"), *arguments], capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    values = read_values(done.stdout)
    for name, jaw in result["jaws"].items():
        assert values[f"{name} verdict"] == jaw["status"]
        assert jaw["landmarks_px"]
        for landmark, (u, v) in jaw["landmarks_px"].items():
            assert (values[f"{landmark} u"], values[f"{landmark} v"]) == (u, v), landmark
            assert values[f"{landmark} sigma px"] == jaw["landmark_sigma_px"][landmark], landmark


@pytest.fixture(scope="session")
def python(build_dir):
    """The interpreter of the tests' virtual environment, where there is one, else this one."""
    candidates = [build_dir.parent / "python-venv" / "bin" / "python", pathlib.Path(sys.executable)]
    return next(path for path in candidates if path.exists())


@pytest.mark.parametrize("folder", list(filter(twins_of, EXAMPLES)), ids=lambda path: path.name)
def test_python_twin_gives_the_same(folder, build_dir, phantom, inputs, python):
    scripts = twins_of(folder)
    assert len(scripts) == 1, scripts
    if "import SimpleITK" in scripts[0].read_text():
        done = subprocess.run([str(python), "-c", "import SimpleITK"], capture_output=True)
        if done.returncode != 0:
            pytest.skip("SimpleITK is not installed")
    environment = dict(os.environ)
    environment["PYTHONPATH"] = str(build_dir / "python")
    check(folder, [python, scripts[0]], phantom, inputs, environment)
