"""Manual pages and completion say what --help says: both are written from the parser, and read here as their readers read them."""
import json
import re
import shutil
import subprocess

import pytest


@pytest.fixture(scope="module")
def description(run):
    done = run("--describe")
    assert done.returncode == 0 and done.stderr == ""
    return json.loads(done.stdout)


def read_help(text):
    """Names of options and of arguments by position, as --help lists them."""
    options = set()
    for names in re.findall(r"^  (-[\w-]+(?:,-[\w-]+)*)", text, re.M):
        options |= set(names.split(","))
    positionals = re.search(r"^Positionals:\n((?:  .*\n| +.*\n)+)", text, re.M)
    return options, set(re.findall(r"^  (\w+)", positionals.group(1), re.M)) if positionals else set()


def names_of(verb, positional):
    return {name for option in verb["options"] if option["positional"] == positional for name in option["names"]}


def test_description_has_what_help_has(run, description):
    text = run("--help").stdout
    listed = re.findall(r"^  ([a-z]+) {2,}\S", text.split("Subcommands:")[1].split("\nExample")[0], re.M)
    assert listed == [verb["name"] for verb in description["verbs"]] and len(listed) > 10
    assert read_help(text)[0] == names_of(description, False)
    assert description["version"] in run("--version").stdout
    common = names_of({"options": [option for option in description["options"] if option["group"] == "Options of every verb"]}, False)
    assert common == {"--threads", "--quiet"}
    for verb in description["verbs"]:
        text = run(verb["name"], "--help").stdout
        assert read_help(text) == (names_of(verb, False) | common, names_of(verb, True)), verb["name"]
        assert verb["notes"].strip() in text
        for option in verb["options"]:
            # CLI11 breaks lines at its own width.
            assert " ".join(option["help"].split()) in " ".join(text.split()), option["names"]
            for choice in option["choices"]:
                assert choice in text


def test_manual_pages_have_every_option_and_groff_takes_them(run, description):
    groff = shutil.which("groff")
    for verb in [None, *description["verbs"]]:
        done = run("--man", *([verb["name"]] if verb else []))
        assert done.returncode == 0, done.stderr
        page = done.stdout.replace("\\-", "-").replace("\\fB", "").replace("\\fI", "").replace("\\fR", "")
        for option in (verb or description)["options"]:
            assert ("\n.TP\n" + ", ".join(option["names"])) in page, option["names"]
        for option in description["options"]:
            assert (option["names"][-1] in page) or (verb and option["group"] != "Options of every verb")
        if groff:
            done = subprocess.run([groff, "-man", "-ww", "-Tutf8", "-z"], input=done.stdout, capture_output=True, text=True)
            assert done.returncode == 0 and done.stderr == ""
    for name in (other["name"] for other in description["verbs"]):
        assert f"dentalscr\\-{name}" in run("--man").stdout


@pytest.mark.parametrize("question", [("--man", "nothing"), ("--completion", "csh"), ("--completion",)])
def test_what_can_not_be_written_is_said(run, question):
    done = run(*question)
    assert done.returncode == 2 and done.stdout == ""
    assert question[0] == "--man" or all(shell in done.stderr for shell in ("bash", "zsh", "fish"))


@pytest.mark.parametrize("question", ["--describe", "--xml", "--completion=bash"])
def test_what_the_program_says_of_itself_is_said_anywhere_and_ends_it(run, question, tmp_path):
    first = run(question)
    assert first.returncode == 0 and len(first.stdout) > 1000
    # Behind a verb as well, which does not run.
    later = run("phantom", "--output", tmp_path / "case", question)
    assert later.returncode == 0 and later.stdout == first.stdout and not (tmp_path / "case").exists()


def complete_bash(script, *words):
    code = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _dentalscr 2>/dev/null; printf "%s\\n" "${COMPREPLY[@]}"'
    done = subprocess.run(["bash", "--norc", "-c", code, "bash", script, "dentalscr", *words], capture_output=True, text=True)
    assert done.stderr == ""
    return set(done.stdout.split())


def complete_fish(script, *words):
    line = " ".join(["dentalscr", *words])
    done = subprocess.run(
        ["fish", "--no-config", "-c", f"source {script}; complete -C '{line}'"], capture_output=True, text=True
    )
    assert done.stderr == ""
    return {row.split("\t")[0] for row in done.stdout.splitlines()}


def complete_zsh(script, *words):
    """Zsh completes in its line editor alone: it is asked in a terminal of its own what it would list."""
    code = r"""
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PROMPT='' ; unsetopt beep; autoload -Uz compinit && compinit -D -u; source $1; bindkey '^I' list-choices
zstyle ':completion:*' list-separator '#'; LISTMAX=1000; stty rows 200 cols 300; print -r -- READY"
zpty -r -m shell out '*READY'$'\r'$'\n''*'
zpty -w -n shell "$2"$'\t'
sleep 2
zpty -w -n shell $'\x15''print -r -- OVER'$'\r'
zpty -r -m shell out '*OVER'$'\r'$'\n''*'
print -r -- "$out"
"""
    done = subprocess.run(
        ["zsh", "-f", "-c", code, "zsh", str(script), " ".join(["dentalscr", *words])], capture_output=True, text=True, timeout=60
    )
    return set(re.findall(r"[\w-]+", re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", " ", done.stdout)))


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_shells_complete_what_the_program_takes(run, description, tmp_path, shell):
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    script = tmp_path / ("_dentalscr" if shell == "zsh" else "dentalscr")
    done = run("--completion", shell)
    assert done.returncode == 0, done.stderr
    script.write_text(done.stdout)
    assert subprocess.run([shell, "-n", script], capture_output=True, text=True).stderr == ""
    complete = {"bash": complete_bash, "zsh": complete_zsh, "fish": complete_fish}[shell]
    verbs = {verb["name"] for verb in description["verbs"]}
    assert verbs <= complete(script, "") | ({""} if shell != "zsh" else set())
    for verb in description["verbs"] if shell != "zsh" else description["verbs"][:2]:
        found = complete(script, verb["name"], "--")
        for option in verb["options"]:
            longs = {name for name in option["names"] if name.startswith("--")}
            assert longs <= found, (verb["name"], longs - found)
        assert {"--threads", "--quiet"} <= found
        for option in verb["options"]:
            if option["choices"] and not option["positional"] and shell != "zsh":
                assert complete(script, verb["name"], option["names"][-1], "") == set(option["choices"])
    assert {"drr", "mesh"} <= complete(script, "register", "--silhouette", "")
