"""How the report page's script is bundled when the toolkit is built: with npm and node, and with such as fail. A bundle is
whole or there is none, and then the library knows it."""
import json
import os
import pathlib
import shutil
import stat
import subprocess

import pytest

MODULE = pathlib.Path(__file__).resolve().parents[2] / "Modules" / "Visualization" / "ReportPage"

NPM = 'mkdir -p node_modules && echo "$@" > node_modules/asked'
NODE = """
printf 'console.log("whole");' > "$2/report.js"
printf '[{"name": "three", "licence": "MIT"}]' > "$2/licences.json"
"""


@pytest.fixture
def bundle(tmp_path):
    """Runs the script of the build with programs of a few lines of shell in the place of npm and node."""

    def call(npm=NPM, node=NODE, enabled="ON"):
        programs = []
        for name, lines in (("npm", npm), ("node", node)):
            program = tmp_path / name
            program.write_text(f"#!/bin/sh\n{lines}\n")
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
            programs.append(program)
        done = subprocess.run(
            ["cmake", f"-DPAGE={MODULE / 'page'}", f"-DOUTPUT={tmp_path / 'bundle'}", f"-DENABLED={enabled}",
             f"-DNPM={programs[0]}", f"-DNODE={programs[1]}", "-P", str(MODULE / "src" / "BundlePage.cmake")],
            capture_output=True, text=True, timeout=300,
        )
        # It never ends a build.
        assert done.returncode == 0, done.stderr
        output = tmp_path / "bundle"
        return (
            (output / "report.js").read_text(),
            json.loads((output / "licences.json").read_text()),
            (output / "failed").read_text() if (output / "failed").exists() else None,
            done.stderr,
        )

    return call


def test_a_bundle_is_whole(bundle):
    script, licences, failed, said = bundle()
    assert script == 'console.log("whole");' and licences[0]["name"] == "three"
    assert failed is None and said == ""


@pytest.mark.parametrize(
    "programs",
    [
        {"npm": "echo registry unreachable >&2; exit 1"},
        {"npm": "kill -9 $$"},
        # It says that all went well and has installed nothing.
        {"npm": "true"},
        {"node": NODE + "echo no licence >&2; exit 1"},
        {"node": "true"},
        {"node": ': > "$2/report.js"; echo "[]" > "$2/licences.json"'},
        {"node": 'echo script > "$2/report.js"'},
        {"node": 'echo script > "$2/report.js"; echo "[]" > "$2/licences.json"'},
    ],
    ids=lambda programs: "-".join(f"{name}_{lines[:30]}" for name, lines in programs.items()),
)
def test_what_fails_leaves_no_bundle_and_says_so(bundle, tmp_path, programs):
    # Also where there was one before: it would be of other sources.
    assert bundle()[0] != ""
    shutil.rmtree(tmp_path / "bundle" / "bundling" / "node_modules")
    script, licences, failed, said = bundle(**programs)
    assert script == "" and licences == [], "nothing, or all of it"
    assert failed and "without plots and scene" in said
    # The next one that can is none the worse for it.
    script, licences, failed, said = bundle()
    assert script == 'console.log("whole");' and licences and failed is None


def test_without_npm_there_is_no_bundle_and_no_word(bundle):
    assert bundle(enabled="OFF") == ("", [], None, "")


def test_configuring_asks_again_for_what_failed(tmp_path):
    """The build tree's own rule: what failed is forgotten when CMake configures, so that the next build tries it again."""
    text = (MODULE / "src" / "CMakeLists.txt").read_text()
    start = text.index('if(EXISTS "${_bundle}/failed")')
    rule = text[start : text.index("endif()", start) + len("endif()")]
    for name in ("report.js", "licences.json", "failed"):
        (tmp_path / name).write_text("")
    (tmp_path / "rule.cmake").write_text(f'set(_bundle "{tmp_path}")\n{rule}\n')
    subprocess.run(["cmake", "-P", str(tmp_path / "rule.cmake")], check=True, capture_output=True)
    assert sorted(os.listdir(tmp_path)) == ["failed", "rule.cmake"]
    (tmp_path / "failed").unlink()
    (tmp_path / "report.js").write_text("whole")
    subprocess.run(["cmake", "-P", str(tmp_path / "rule.cmake")], check=True, capture_output=True)
    assert (tmp_path / "report.js").read_text() == "whole"
