"""Each damaged file of damaged_files.py is read or refused as it says there: with words that name the file, what is wrong
in it and what to do. All of them by one process a reader (dentalscr-fuzz), and some of each by the program."""
import pathlib
import subprocess
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "CommandLine"))

import damaged_files  # noqa: E402

TARGETS = [
    "batch", "case", "cephalometric", "contours", "image", "labelmap", "landmarks2d", "landmarks3d", "mask", "result", "scan",
    "toothlabels", "transform",
]


@pytest.fixture(scope="module")
def damaged(run, tmp_path_factory):
    """By reader: (what is wrong, path, words or READ)."""
    folder = tmp_path_factory.mktemp("damaged")
    assert run("phantom", "--triangles", 3000, "--no-radiograph", "--seed", 3, "--output", folder / "case").returncode == 0
    run("register", folder / "case" / "case.json", "--no-report", "--output", folder / "result")
    made = {}
    for target, files in damaged_files.damaged((folder / "result" / "result.json").read_text(), folder / "case").items():
        made[target] = []
        for number, (what, name, content, expected) in enumerate(files):
            path = folder / "files" / target / str(number) / name
            path.parent.mkdir(parents=True)
            path.write_bytes(content.encode() if isinstance(content, str) else content)
            made[target].append((what, path, expected))
    return made


def test_there_are_many_of_them(damaged):
    assert sorted(damaged) == TARGETS
    assert sum(map(len, damaged.values())) >= 400
    assert all(expected is None or expected for files in damaged.values() for _, _, expected in files)


@pytest.mark.parametrize("target", TARGETS)
def test_damaged_files_are_refused_with_words(build_dir, damaged, target):
    files = damaged[target]
    done = subprocess.run(
        [str(build_dir / "bin" / "dentalscr-fuzz"), target, "--tell", *(str(path) for _, path, _ in files)],
        capture_output=True, text=True, errors="replace", timeout=300,
    )
    told = {line.split("\t")[0]: line.split("\t")[1:] for line in done.stdout.splitlines()}
    wrong = []
    for what, path, expected in files:
        outcome, *words = told[str(path)]
        if expected is damaged_files.READ:
            if outcome != "read":
                wrong.append((what, "is refused", words))
            continue
        if outcome != "refused":
            wrong.append((what, outcome, words))
            continue
        file, field, problem, remedy = words
        said = " | ".join((field, problem, remedy))
        if path.parent.name not in file or not problem:
            wrong.append((what, "names another file", words))
        if any(part not in said for part in expected):
            wrong.append((what, "says", said, "not", expected))
    assert not wrong, "\n".join(map(str, wrong))
    assert done.returncode == 0, done.stdout
