"""The scripts of Utilities/ say what they do, from wherever they are called, and do nothing when they are asked."""
import os
import pathlib
import re
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = sorted(path.name for path in (ROOT / "Utilities").glob("*.sh"))


@pytest.mark.parametrize("name", SCRIPTS)
def test_help_is_the_text_at_the_top(name, tmp_path):
    script = os.path.relpath(ROOT / "Utilities" / name, tmp_path)
    done = subprocess.run([script, "--help"], capture_output=True, text=True, cwd=tmp_path, timeout=20)
    assert done.returncode == 0 and done.stderr == ""
    lines = (ROOT / "Utilities" / name).read_text().splitlines()[1:]
    top = lines[: next(number for number, line in enumerate(lines) if not line.startswith("#"))]
    # All of it, and nothing of what comes after.
    assert done.stdout.splitlines() == [re.sub(r"^# ?", "", line) for line in top]


@pytest.mark.parametrize("name", SCRIPTS)
def test_no_check_of_a_script_is_one_that_can_not_fail(name):
    """Under "set -e" a command behind "!" never ends a script, whatever it finds."""
    text = (ROOT / "Utilities" / name).read_text()
    assert "set -euo pipefail" in text
    loose = [line for line in text.splitlines() if re.match(r"\s*! ", line) and "||" not in line and "&&" not in line]
    assert not loose
