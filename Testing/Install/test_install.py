"""The install tree serves a project that knows nothing of the build tree."""
import json
import os
import pathlib
import re
import shlex
import subprocess

import pytest

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLE = HERE.parent.parent / "Examples" / "InstalledPackage"


def call(*arguments, **keywords):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, timeout=900, **keywords)
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    return done


@pytest.fixture(scope="module")
def prefix(build_dir, tmp_path_factory):
    prefix = tmp_path_factory.mktemp("prefix")
    call("cmake", "--install", build_dir, "--prefix", prefix)
    return prefix


def test_installed_program_runs(prefix):
    environment = {k: v for k, v in os.environ.items() if k != "LD_LIBRARY_PATH"}
    assert "dentalscr" in call(prefix / "bin" / "dentalscr", "--version", env=environment).stdout


def test_config_names_no_path_of_the_build(prefix, build_dir):
    for path in prefix.rglob("*.cmake"):
        text = path.read_text()
        assert str(build_dir) not in text, path
        assert str(HERE.parent.parent) not in text, path


def test_every_module_is_exported(prefix):
    text = next(prefix.rglob("DentalSCRTargets.cmake")).read_text()
    exported = set(re.findall(r"add_library\(DentalSCR::(\w+)", text))
    modules = {path.parent.name for path in (HERE.parent.parent / "Modules").glob("*/*/itk-module.cmake")}
    assert modules == exported


def test_example_builds_against_it_and_finds_the_known_answer(prefix, tmp_path):
    call(
        "cmake", "-S", EXAMPLE, "-B", tmp_path / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
        "-DCMAKE_BUILD_TYPE=Release",
    )
    call("cmake", "--build", tmp_path / "build")
    assert "shift" in call(tmp_path / "build" / "InstalledPackage").stdout


def test_program_of_the_readme_compiles_as_shown_and_runs(prefix, run, tmp_path):
    text = (HERE.parent.parent / "README.md").read_text()
    for language, name in (("cmake", "CMakeLists.txt"), ("cpp", "mine.cxx")):
        (block,) = re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)
        (tmp_path / name).write_text(block)
    call(
        "cmake", "-S", tmp_path, "-B", tmp_path / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
        "-DCMAKE_BUILD_TYPE=Release",
    )
    call("cmake", "--build", tmp_path / "build")
    # The case that the README's first command makes; the program's numbers are those of its second.
    commands = re.findall(r"^    dentalscr (.*)$", text, re.MULTILINE)
    for command in commands[:2]:
        done = run(*shlex.split(command, comments=True), cwd=tmp_path)
        assert done.returncode == 0, done.stderr
    jaws = json.loads((tmp_path / "result" / "result.json").read_text())["jaws"]
    printed = call(tmp_path / "build" / "mine", cwd=tmp_path).stdout.split()
    for jaw in ("upper", "lower"):
        assert printed.pop(0) == jaws[jaw]["status"] == "ok"
        for row in jaws[jaw]["projection_3x4"]:
            for value in row:
                # As many digits as a stream prints by default.
                assert float(printed.pop(0)) == pytest.approx(value, rel=1e-5)
    assert not printed
