"""The list of mistakes on purpose (Utilities/mutate.sh) is true of the code: each stands in its file once. To run them takes hours."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(folder):
    return subprocess.run(
        ["/usr/bin/python3", ROOT / "Utilities/mutate.py", "--check", folder], capture_output=True, text=True, timeout=120
    )


def test_every_mutation_stands_in_its_file_once():
    done = subprocess.run([ROOT / "Utilities/mutate.sh", "--check"], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_mutation_of_code_that_is_gone_is_named(tmp_path):
    """The check can fail: a tree without the code has none of it."""
    (tmp_path / "Utilities").mkdir()
    (tmp_path / "Utilities" / "mutations.txt").write_text((ROOT / "Utilities" / "mutations.txt").read_text())
    done = check(tmp_path)
    assert done.returncode != 0 and "0 files of that name" in done.stdout + done.stderr
