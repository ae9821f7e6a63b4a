"""Utilities/mutate.py over a tree of three files, with a few lines of shell in the place of cmake and of the tests: each
verdict is of one mutation alone, and a tree that is not built again is no verdict."""
import os
import pathlib
import stat
import subprocess
import sys

import pytest

MUTATE = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "mutate.py"

# A library is its file's text; a file with "error" is no program. What it is asked for is kept.
CMAKE = """
shift 3
echo "$@" >> {folder}/asked
for target in "$@"; do
  for file in {tree}/Modules/*/"$target"/src/*.cxx; do
    [ -e "$file" ] || continue
    ! grep -q error "$file" || exit 1
    cmp -s "$file" {tree}/build/test/lib/"$target" || cp "$file" {tree}/build/test/lib/"$target"
  done
done
"""
# Its filter is the text that has to be in each of the libraries.
DRIVER = """
case "$*" in *--gtest_list_tests*) printf 'Suite.\\n  Name\\n'; exit 0;; esac
filter=${1#--gtest_filter=}
for name in A B; do
  grep -q "$filter" "$LD_LIBRARY_PATH/$name" || exit 1
done
"""
LIST = """
a.cxx
  - one
  + two
  ? T: good
a.cxx
  - good
  + bad
  ? T: good
b.cxx
  - one
  + three
  ? T: good
b.cxx
  - one
  + error
  ? T: good
b.cxx
  - one
  + four
  ? T: good
  = nobody asks for it
c.cxx
  - one
  + error
  = it is never built
"""


@pytest.fixture
def mutate(tmp_path):
    tree = tmp_path / "tree"
    for name in ("A", "B", "C"):
        source = tree / "Modules" / "Group" / name / "src"
        source.mkdir(parents=True)
        (source / f"{name.lower()}.cxx").write_text("good one\n")
        (tree / "build" / "test" / "lib").mkdir(parents=True, exist_ok=True)
        (tree / "build" / "test" / "lib" / name).write_text("good one\n")
    def call(before_cmake="", text=LIST):
        (tmp_path / "list.txt").write_text(text)
        for path, lines in ((tmp_path / "cmake", before_cmake + CMAKE.format(folder=tmp_path, tree=tree)), (tmp_path / "bin" / "TGTestDriver", DRIVER)):
            path.parent.mkdir(exist_ok=True)
            path.write_text(f"#!/bin/sh\n{lines}")
            path.chmod(path.stat().st_mode | stat.S_IXUSR)
        done = subprocess.run(
            [sys.executable, str(MUTATE), "--list", str(tmp_path / "list.txt"), "--tests", str(tmp_path), str(tree)],
            capture_output=True, text=True, timeout=120, env=dict(os.environ, PATH=f"{tmp_path}:{os.environ['PATH']}"),
        )
        for name in ("A", "B", "C"):
            assert (tree / "Modules" / "Group" / name / "src" / f"{name.lower()}.cxx").read_text() == "good one\n"
        return done, tree / "build" / "test" / "lib"

    return call


def test_each_verdict_is_of_one_mutation(mutate, tmp_path):
    done, libraries = mutate()
    said = [line for line in done.stdout.splitlines() if "->" in line]
    found = [(line.split()[0], line.split("->")[1].split("[")[0].strip()) for line in said]
    assert found == [
        ("equal", "error"), ("SURVIVES", "two"), ("caught", "bad"), ("SURVIVES", "three"), ("NO", "error"), ("equal", "four"),
        # Those that survive are named at the end once more.
        ("SURVIVES", "two"), ("SURVIVES", "three"),
    ]
    assert "1 of 3 caught (33 %), 2 equivalent" in done.stdout and done.returncode == 1
    # A mistake that no test stands beside is not built, and what was built with one is built without it.
    assert not any("C" in line.split() for line in (tmp_path / "asked").read_text().splitlines())
    for name in ("A", "B"):
        assert (libraries / name).read_text() == "good one\n"


def test_a_tree_that_is_not_built_again_ends_it(mutate, tmp_path):
    """From the third build on nothing is built: of what follows no verdict would be true."""
    done, _ = mutate(f'[ ! -e {tmp_path}/asked ] || [ "$(wc -l < {tmp_path}/asked)" -lt 2 ] || exit 1\n')
    assert done.returncode == 1 and "is not built without a mutation" in done.stderr, done.stdout + done.stderr
    assert "NO PROGRAM" not in done.stdout and "caught" not in done.stdout


def test_a_library_that_is_not_made_of_the_file_is_told_and_the_others_are_judged(mutate):
    """Its tests would run without the mutation, which would be called one that survives."""
    text = LIST.replace("? T: good\n", "? T: good\n  @ B\n", 1)
    done, _ = mutate(text=text)
    assert done.returncode == 1, done.stdout + done.stderr
    told = [line for line in done.stdout.splitlines() if line.startswith("NOT TRUE")]
    assert len(told) == 1 and "a.cxx: one  ->  two: B is not made of it" in told[0], done.stdout
    assert "a.cxx: one  ->  two" not in "".join(line for line in done.stdout.splitlines() if line not in told)
    # Of the three that count it was one that survives.
    assert "1 of 2 caught (50 %), 2 equivalent" in done.stdout
