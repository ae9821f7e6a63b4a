"""What --help says is what it was: a text that changes is read by the person who changed it.

    /usr/bin/python3 -m pytest -q Testing/CommandLine/test_help.py --build-dir build/test --refreeze

writes Help/*.txt anew; their difference is part of what is reviewed.
"""
import json
import pathlib
import re

import pytest

FOLDER = pathlib.Path(__file__).resolve().parent / "Help"

VERBS = (
    "register", "trace", "new", "batch", "axis", "render", "contour", "project", "report", "evaluate", "phantom", "experiment", "view",
)


def test_every_verb_has_its_copy(run):
    assert [verb["name"] for verb in json.loads(run("--describe").stdout)["verbs"]] == list(VERBS)
    assert {path.stem for path in FOLDER.glob("*.txt")} == {"dentalscr", *VERBS}


@pytest.mark.parametrize("verb", [None, *VERBS])
def test_help_is_the_copy(run, request, verb):
    done = run(*([verb] if verb else []), "--help")
    assert done.returncode == 0 and done.stderr == ""
    # Some lines end in spaces of CLI11's own.
    text = re.sub(r" +$", "", done.stdout, flags=re.M).rstrip("\n") + "\n"
    file = FOLDER / f"{verb or 'dentalscr'}.txt"
    if request.config.getoption("--refreeze"):
        FOLDER.mkdir(exist_ok=True)
        file.write_text(text)
        pytest.skip("written anew, compared with nothing")
    assert text == file.read_text()


@pytest.mark.parametrize("verb", VERBS)
def test_help_of_every_verb_has_the_options_of_every_verb(run, verb):
    text = run(verb, "--help").stdout
    assert "--threads" in text and "--quiet" in text
    # Both are taken behind the verb, where one looks for them; what is missing else is named, and not they.
    done = run(verb, "--threads", "1", "--quiet", "--no-such-option")
    assert done.returncode == 2 and "--threads" not in done.stderr and "--quiet" not in done.stderr
    assert "--threads" in run(verb, "--threads", "nonsense").stderr


# What means the same has one name. A word is added here where a verb needs another thing, and not another name for it.
NAMES = {
    "anonymous", "attenuation", "buccal", "camera", "case", "cases", "cephalometric-landmarks", "collect", "contours", "count", "crowns",
    "csv", "distances", "drop-out", "embed-axes", "exclude", "export", "facing", "fix", "force", "frame", "from", "help", "image",
    "image-size", "init", "jaw", "jobs", "labels", "landmarks", "landmarks-2d", "landmarks-3d", "level", "lower", "lower-labels",
    "markups-spacing", "mesh-unit", "methods", "mode", "no-figures", "no-page", "no-radiograph", "no-report", "normalization",
    "numbering", "occlusion", "option", "output", "page", "parameters", "points", "port", "preset", "preview", "principal-point", "range",
    "refine-midline", "result", "resume", "seed", "show-parameters", "sigma", "silhouette", "size", "snapshot", "source-side", "spacing",
    "spacing-plane", "starts", "stock-outlines", "stone-base", "strict", "study", "tooth-bias", "traced-side", "triangles", "upper", "upper-labels",
    "view", "wait", "whole",
}
# Values of one kind have one type in all verbs, but where the thing itself is another.
SAME_TYPE = {"case", "facing", "source-side", "spacing", "distances", "mesh-unit", "occlusion", "preset", "strict", "upper", "lower", "sigma", "traced-side"}


def test_options_are_named_alike_in_all_verbs(run):
    description = json.loads(run("--describe").stdout)
    types = {}
    for verb in description["verbs"]:
        for option in verb["options"]:
            if option["positional"]:
                continue
            name = option["names"][-1].removeprefix("--")
            assert name in NAMES, f"{verb['name']} --{name} is a new name"
            types.setdefault(name, set()).add((option["value"], tuple(option["choices"])))
            # A file, a folder, a number, a word of a list: nothing is a mere TEXT, for which a shell can offer nothing.
            assert option["type"] != "TEXT", f"{verb['name']} --{name}"
    assert {name for name in SAME_TYPE if len(types[name]) != 1} == set()
    assert NAMES == set(types)


@pytest.mark.parametrize("words, said", [
    ("", "name a verb, such as register; see dentalscr --help"),
    ("regster case.json", 'there is no verb "regster"; see dentalscr --help'),
    ("register case.json --outptu result", 'there is no option "--outptu"; see dentalscr register --help'),
    ("register case.json", "--output is required; see dentalscr register --help"),
    ("register case.json --output result --frobnicate", "--frobnicate; see dentalscr register --help"),
    ("phantom --level weird --output case", "practice}; see dentalscr phantom --help"),
])
def test_mistaken_words_are_named_with_the_help_to_read(run, tmp_path, words, said):
    done = run(*words.split(), cwd=tmp_path)
    assert done.returncode == 2
    assert said in done.stderr, done.stderr
    assert not list(tmp_path.iterdir())
