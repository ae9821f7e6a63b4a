"""The tutorials run as they are shown: the commands and the Python of a page, one after the other in one folder."""
import os
import pathlib
import re
import shlex
import subprocess
import sys

import pytest

PAGES = sorted((pathlib.Path(__file__).resolve().parents[3] / "Documentation").glob("Tutorial*.md"))


def script(page):
    """One program of all that stands in the page's fences; a line of it is the line of the page."""
    kind, lines = None, []
    for line in page.read_text().splitlines():
        fence = re.match(r"```(\w*)$", line)
        if fence:
            kind = fence.group(1) if kind is None else None
            assert kind in ("console", "python", None), f"{page.name}: what is ```{kind}?"
            lines.append("")
        elif kind == "python":
            lines.append(line)
        elif kind == "console":
            assert line.startswith("$ dentalscr "), f"{page.name}: {line}"
            lines.append(f"_run({shlex.split(line)[2:]!r})")
        else:
            lines.append("")
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_tutorial_runs(page, tmp_path):
    text = script(page)
    assert text.strip(), "a tutorial has code"
    (tmp_path / "page.py").write_text(text)
    # The page is compiled under its own name, so that a traceback has its lines.
    runner = (
        "import subprocess, sys\n"
        "def _run(words):\n"
        "    done = subprocess.run([sys.executable, '-m', 'dentalscr', *words], capture_output=True, text=True)\n"
        "    assert done.returncode == 0, done.stderr\n"
        f"exec(compile(open('page.py').read(), {page.name!r}, 'exec'), {{'__name__': '__main__', '_run': _run}})\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", runner], cwd=tmp_path, capture_output=True, text=True, timeout=600,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_there_are_tutorials():
    assert len(PAGES) >= 5
