"""The install tree serves a project that knows nothing of the build tree."""
import gzip
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tomllib

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


def test_install_tree_has_manuals_completion_licence_and_examples(prefix, run):
    verbs = [verb["name"] for verb in json.loads(run("--describe").stdout)["verbs"]]
    pages = {path.name for path in (prefix / "share/man/man1").iterdir()}
    view = set() if (prefix / "bin/dentalscr-view").exists() else {"dentalscr-view.1.gz"}
    assert pages == {"dentalscr.1.gz", "dentalscr-decode.1.gz"} | {f"dentalscr-{verb}.1.gz" for verb in verbs} - view
    packed = (prefix / "share/man/man1/dentalscr-register.1.gz").read_bytes()
    assert gzip.decompress(packed).decode() == run("--man", "register").stdout
    for shell, place in (
        ("bash", "share/bash-completion/completions/dentalscr"),
        ("zsh", "share/zsh/site-functions/_dentalscr"),
        ("fish", "share/fish/vendor_completions.d/dentalscr.fish"),
    ):
        assert (prefix / place).read_text() == run("--completion", shell).stdout
    assert "Apache License" in (prefix / "share/doc/dentalscr/LICENSE").read_text()
    # All of the repository, and nothing else.
    examples = prefix / "share/doc/dentalscr/examples"
    ours = {path.relative_to(EXAMPLE.parent) for path in EXAMPLE.parent.rglob("*") if path.is_file() and "__pycache__" not in path.parts}
    assert {path.relative_to(examples) for path in examples.rglob("*") if path.is_file()} == ours


def test_whatever_is_missing_is_named_at_once_with_its_package(tmp_path):
    missing = {"OpenMesh": "libopenmesh-dev", "CLI11": "libcli11-dev", "meshoptimizer": "libmeshoptimizer-dev"}
    done = subprocess.run(
        ["cmake", "-S", HERE.parent.parent, "-B", tmp_path, "-G", "Ninja", "-DDENTALSCR_BUILD_TESTING=OFF",
         *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in missing)],
        capture_output=True, text=True, timeout=300,
    )
    assert done.returncode != 0
    text = " ".join(done.stderr.split())
    assert "apt-get install " + " ".join(missing.values()) + " " in text
    for name, package in missing.items():
        assert re.search(rf"{name}[ \d.]* \(Debian: {package}\)", text), text


def test_pip_builds_in_a_folder_of_its_own_and_ends_at_no_warning():
    """A folder that is kept would have the paths of an environment that is gone, and another compiler warns of more."""
    settings = tomllib.loads((HERE.parent.parent / "pyproject.toml").read_text())["tool"]["scikit-build"]
    assert "build-dir" not in settings
    assert settings["cmake"]["define"]["DENTALSCR_WARNINGS_AS_ERRORS"] == "OFF"


@pytest.mark.skipif(shutil.which("ccache") is None, reason="without ccache nothing is found again")
def test_pip_finds_its_objects_again_in_a_folder_of_another_name(tmp_path):
    """What `pip install .` compiled is taken from the compiler cache, though both its folders have new names each time."""
    source = tmp_path / "source"
    source.mkdir()
    (source / "part.cxx").write_text('#include "generated.h"\nint Part() { return GENERATED; }\n')
    (source / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(Trial LANGUAGES CXX)\n"
        f'include("{HERE.parent.parent}/CMake/DentalSCRBuildSettings.cmake")\n'
        'file(WRITE "${PROJECT_BINARY_DIR}/include/generated.h" "#define GENERATED 1\\n")\n'
        "add_library(part STATIC part.cxx)\n"
        'target_include_directories(part PRIVATE "${PROJECT_BINARY_DIR}/include")\ndentalscr_target_settings(part)\n'
    )
    environment = {k: v for k, v in os.environ.items() if not k.startswith("CCACHE_")}
    environment["CCACHE_DIR"] = str(tmp_path / "cache")
    for name in ("a9x2", "k3f7"):
        build = tmp_path / name / "build"
        for command in (
            ["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DSKBUILD=2", "-DCMAKE_UNITY_BUILD=ON"],
            ["cmake", "--build", build],
        ):
            subprocess.run(command, env=environment, capture_output=True, check=True, timeout=300)
    said = subprocess.run(
        ["ccache", "--print-stats"], env=environment, capture_output=True, text=True, check=True
    ).stdout
    counts = dict(line.split("\t") for line in said.splitlines())
    assert int(counts["cache_miss"]) == 1
    assert int(counts["direct_cache_hit"]) + int(counts["preprocessed_cache_hit"]) == 1


def test_config_names_no_path_of_the_build(prefix, build_dir):
    for path in prefix.rglob("*.cmake"):
        text = path.read_text()
        assert str(build_dir) not in text, path
        assert str(HERE.parent.parent) not in text, path


def test_every_module_is_exported(prefix):
    text = next(prefix.rglob("DentalSCRTargets.cmake")).read_text()
    exported = set(re.findall(r"add_library\(DentalSCR::(\w+)", text))
    modules = {path.parent.name for path in (HERE.parent.parent / "Modules").glob("*/*/itk-module.cmake")}
    assert modules | {"DentalSCR"} == exported


def test_example_builds_against_it_and_finds_the_known_answer(prefix, tmp_path):
    call(
        "cmake", "-S", EXAMPLE, "-B", tmp_path / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
        "-DCMAKE_BUILD_TYPE=Release",
    )
    call("cmake", "--build", tmp_path / "build")
    assert "shift" in call(tmp_path / "build" / "InstalledPackage").stdout


def configure_consumer(prefix, folder, *options):
    return subprocess.run(
        ["cmake", "-S", HERE / "Consumer", "-B", folder, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
         "-DCMAKE_BUILD_TYPE=Release", *options],
        capture_output=True, text=True, timeout=300,
    )


@pytest.mark.parametrize(
    "options",
    [
        ("-DITK_FIRST=ON",),
        ("-DITK_FIRST=OFF", "-DCOMPONENTS=SurfaceDRR;RegistrationReport", "-DLINK=DentalSCR::DentalSCR"),
    ],
    ids=["itk-first", "umbrella"],
)
def test_consumer_with_itk_modules_of_its_own_reads_and_writes_by_itk(prefix, tmp_path, options):
    """The consumer's CMakeLists.txt checks that no ITK_ variable of its own changes."""
    done = configure_consumer(prefix, tmp_path / "build", *options)
    assert done.returncode == 0, done.stderr
    call("cmake", "--build", tmp_path / "build")
    # Sides of 10 mm and four sigma of 2 mm around: 10 * 1674 / 1524 / 0.25 + 2 * 32 pixels, and whole pixels around them.
    assert "size 109 109" in call(tmp_path / "build" / "Consumer", tmp_path / "a.png", tmp_path / "a.mha").stdout
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


def test_a_missing_component_is_named_and_so_are_those_that_are_there(prefix, tmp_path):
    done = configure_consumer(prefix, tmp_path / "build", "-DCOMPONENTS=SurfaceDRR;Orthodontics")
    assert done.returncode != 0
    text = " ".join(done.stderr.split())
    assert 'no component "Orthodontics"' in text and "SilhouetteContour" in text


def test_scene_example_builds_against_it_and_only_that_component_looks_for_vtk(prefix, tmp_path):
    if not (prefix / "bin" / "dentalscr-view").exists():
        pytest.skip("DentalSCR was built without VTK")
    folder = HERE.parent.parent / "Examples" / "SceneInSpace"
    options = ["-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release"]
    call("cmake", "-S", folder, "-B", tmp_path / "build", *options)
    call("cmake", "--build", tmp_path / "build")
    assert (tmp_path / "build" / "SceneInSpace").exists()
    # Who asks for other modules does not need to have VTK.
    done = configure_consumer(prefix, tmp_path / "other", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON")
    assert done.returncode == 0, done.stderr
    environment = {k: v for k, v in os.environ.items() if k != "LD_LIBRARY_PATH"}
    assert "--snapshot" in call(prefix / "bin" / "dentalscr-view", "--help", env=environment).stdout


def test_tests_include_public_headers_only():
    """A test is the first user of a header; one that reaches into src/ tests what no user can reach."""
    root = HERE.parent.parent
    private = {path.name for path in root.glob("Modules/*/*/src/*.h")}
    found = {
        (path.name, name)
        for folder in ("Modules/*/*/test/*", "Testing/*/*")
        for path in root.glob(folder)
        if path.suffix in (".h", ".cxx")
        for name in re.findall(r'^#include ".*?([^"/]+)"', path.read_text(), re.MULTILINE)
        if name in private
    }
    # Kernels behind an object that offers no way to see them.
    assert found <= {("itkCaseRegistrationGTest.cxx", "itkCasePoseRegistration.h")}


def write_projects(page, folder):
    """The files of a page: a code block behind a line with its name alone."""
    blocks = re.findall(r"^`([\w/.]+)`:\n```\w+\n(.*?)^```$", page.read_text(), re.DOTALL | re.MULTILINE)
    for name, text in blocks:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return [name for name, _ in blocks]


def test_projects_of_the_cookbook_build_as_shown_and_run(prefix, sample, tmp_path):
    names = write_projects(HERE.parent.parent / "Documentation" / "OwnProject.md", tmp_path)
    assert len([name for name in names if name.endswith("CMakeLists.txt")]) == 4

    def build(name, *more):
        call("cmake", "-S", tmp_path / name, "-B", tmp_path / name / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             f"-DCMAKE_PREFIX_PATH={prefix};{tmp_path / 'own'}", *more)
        call("cmake", "--build", tmp_path / name / "build")
        return tmp_path / name / "build"

    upper, lower = sample / "upper.stl", sample / "lower.stl"
    widths = [float(line.split()[0]) for line in call(build("program") / "arches", upper, lower).stdout.splitlines()]
    # Between the outer sides of the last molars.
    assert len(widths) == 2 and all(45 < width < 85 for width in widths)
    missing = subprocess.run([tmp_path / "program/build/arches", "nowhere.stl", lower], capture_output=True, text=True)
    assert missing.returncode == 1 and "nowhere.stl" in missing.stderr
    call("cmake", "--install", build("library"), "--prefix", tmp_path / "own")
    length = float(call(build("user") / "user", upper).stdout.split()[0])
    assert 200 < length < 2000
    out = call(build("filter") / "filter", upper, tmp_path / "drr.mha").stdout
    assert re.fullmatch(r"\[\d+, \d+\]\n", out) and (tmp_path / "drr.mha").stat().st_size > 1000


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
                # The program's bits, in 17 digits.
                assert float(printed.pop(0)) == value
    assert not printed
    for name in ("upper.png", "lower.png"):
        # The first bytes of a PNG.
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")
