"""Each damaged file of damaged_files.py is read or refused as it says there: with words that name the file, what is wrong
in it and what to do. All of them by one process a reader (dentalscr-fuzz), and some of each by the program."""
import json
import pathlib
import subprocess
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "CommandLine"))

import damaged_files  # noqa: E402
import make_seeds  # noqa: E402
from make_seeds import TARGETS  # noqa: E402


# Of a folder's tables, of what lies in memory and of two files in one there is another name in the words, or none.
NAMELESS = ("archive", "batch", "report", "session")
# What no verb reads by its name alone.
WITHOUT_VERB = ("archive", "folder", "report", "session", "summary", "transform")


@pytest.fixture(scope="module")
def damaged(run, tmp_path_factory):
    """By reader: (what is wrong, path, words or READ)."""
    folder = tmp_path_factory.mktemp("damaged")
    assert run("phantom", "--triangles", 3000, "--no-radiograph", "--seed", 3, "--output", folder / "case").returncode == 0
    run("register", folder / "case" / "case.json", "--output", folder / "result")
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
    assert sum(map(len, damaged.values())) >= 500
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
        if str(path) != file and path.name not in file and target not in NAMELESS:
            wrong.append((what, "names another file", words))
        # ITK's reader of transforms, and of images the decoders, have words of their own for what is wrong.
        if not problem or (not remedy and target != "transform"):
            wrong.append((what, "has no remedy", words))
        if any(part not in said for part in expected):
            wrong.append((what, "says", said, "not", expected))
    assert not wrong, "\n".join(map(str, wrong))
    assert done.returncode == 0, done.stdout


def command(target, path, folder):
    """A call of the program that reads the file."""
    case = folder / "case"

    def changed(**fields):
        content = json.loads((case / "case.json").read_text())
        for field in ("upper", "lower", "contours", "landmarks_3d", "landmarks_2d"):
            content[field] = str(case / content[field])
        content["cephalogram"].pop("image", None)
        content.update(fields)
        if target == "image":
            content["cephalogram"]["image"] = str(path)
        if target == "cephalometric":
            content.pop("contours")
        if target == "mask":
            content["contours"] = {"UR1": str(path)}
        made = path.parent / "changed.json"
        made.write_text(json.dumps(content))
        return ["register", made]

    fields = {"cephalometric": "cephalometric_landmarks", "contours": "contours", "landmarks3d": "landmarks_3d", "landmarks2d": "landmarks_2d",
              "scan": "upper", "toothlabels": "upper_labels"}
    if target in fields:
        return changed(**{fields[target]: str(path)})
    if target in ("image", "mask"):
        return changed()
    radiograph = path.parent / "radiograph.png"
    radiograph.write_bytes(damaged_files.IMAGES["a.png"])
    return {
        "drawing": ["trace", radiograph, "--contours", path, "--page"],
        "level": ["phantom", "--parameters", path],
        "start": ["register", case / "case.json", "--init", path],
        "batch": ["batch", path],
        "case": ["register", path],
        "labelmap": ["contour", "--labels", path],
        "result": ["evaluate", path, "--landmarks", case / "landmarks2d.json", "--csv"],
    }[target]


@pytest.mark.parametrize("target", [target for target in TARGETS if target not in WITHOUT_VERB])
def test_the_program_ends_with_2_and_one_line(run, damaged, target, tmp_path):
    """One of each format, or three of those that have one alone."""
    refused, extensions = [], {}
    for what, path, expected in damaged[target]:
        if expected is not damaged_files.READ:
            extensions.setdefault("".join(path.suffixes), []).append((what, path, expected))
    for files in extensions.values():
        refused += files[: 1 if len(extensions) > 2 else 3]
    folder = damaged["case"][0][1].parent.parent.parent.parent
    for what, path, expected in refused:
        output = tmp_path / "out"
        done = run(*command(target, path, folder), *(() if target in ("result", "drawing") else ("--output",)), output)
        assert done.returncode == 2, (what, done.returncode, done.stderr)
        lines = [line for line in done.stderr.splitlines() if not line.startswith("dentalscr: warning:")]
        assert len(lines) == 1 and lines[0].startswith("dentalscr: "), (what, done.stderr)
        assert path.name in lines[0] and "; " in lines[0], (what, lines)
        # A registration knows how large its radiograph is, and may refuse a tracing for that first.
        if target not in ("contours", "drawing", "landmarks2d", "cephalometric", "toothlabels"):
            assert all(part in lines[0] for part in expected), (what, lines[0], expected)
        assert not output.exists() or not any(output.rglob("result.json")), what


@pytest.mark.parametrize("verb", ["contours", "landmarks", "report", "result", "experiment"])
def test_what_is_nested_deeper_than_a_stack_ends_no_verb(run, damaged, verb, tmp_path):
    """A library that follows values by recursion ended with the stack."""
    deep = make_seeds.nested('{"schema": "dentalscr-report/1", "contours": {"upper": ', "}}")
    file = tmp_path / "deep.json"
    file.write_text(deep)
    output = tmp_path / "out"
    result = damaged["case"][0][1].parents[3] / "result"
    if verb in ("contours", "landmarks"):
        radiograph = tmp_path / "radiograph.png"
        radiograph.write_bytes(damaged_files.IMAGES["a.png"])
        call = ["trace", radiograph, "--contours" if verb == "contours" else "--cephalometric-landmarks", file, "--page", output]
    elif verb in ("report", "result"):
        file = tmp_path / f"{verb}.json"
        for name in ("report.json", "result.json"):
            (tmp_path / name).write_text(deep if name == file.name else (result / name).read_text())
        call = ["report", tmp_path, "--output", output]
    else:
        output.mkdir()
        (output / "cases").mkdir()
        file = output / "experiment.json"
        file.write_text(make_seeds.nested('{"schema": "dentalscr-experiment/1", "software": ', "}"))
        call = ["experiment", "--study", "ablation", "--cases", 1, "--output", output]
    done = run(*call)
    assert done.returncode == 2 and file.name in done.stderr, (done.returncode, done.stderr)
    assert "nested deeper than 64 levels" in done.stderr or (verb == "experiment" and "is not what an experiment writes" in done.stderr), done.stderr
