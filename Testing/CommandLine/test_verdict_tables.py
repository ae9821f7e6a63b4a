"""Utilities/verdict-tables.py counts what ArchStudy printed."""

import pathlib
import subprocess
import sys

import pytest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "verdict-tables.py"

# seed jaw error_px sigma_px covered landmarks status margin | code: reason; V seed jaw error smooth cost p90 median
# inliers sigma largest ...
ROWS = """# seed jaw error_px sigma_px covered landmarks status margin | code: reason | ...
1 U 1.5 1 8 8 ok 1
V 1 U 1.5 1 0.1 2 1 1 1.7 3 0 1 90 1
1 L 1.5 1 8 8 suspect 1 | uncertain: the tracing does not determine the pose: 2.7 px | poor-fit: poorly
V 1 L 1.5 1 0.1 2 1 1 2.7 3 0 1 90 1
C 1 L 0 1.5 0.1 0
2 U 9.5 1 0 8 suspect 1 | uncertain: the tracing does not determine the pose: 2.7 px
V 2 U 9.5 1 0.1 2 1 1 2.7 3 0 1 90 1
2 L 5.5 1 0 8 ok 1
V 2 L 5.5 1 0.1 2 1 1 1.0 4.5 0 1 90 1
3 U - - - - failed
= U jaws 3, mean 5.5
"""


def run(*arguments):
    return subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True)


def test_rules_and_limits_are_counted_by_the_true_error(tmp_path):
    rows = tmp_path / "rows"
    rows.write_text(ROWS)
    result = run(rows)
    assert result.returncode == 0, result.stderr
    table = {line.split(" | ")[0].strip("| "): line.strip("| ").split(" | ")[1:] for line in result.stdout.splitlines()}
    assert table["`uncertain`"] == ["1 / 0", "0", "0", "1 / 1"]
    assert table["`poor-fit`"] == ["1 / 0", "0", "0", "0"]
    # At 1.6 both near jaws are flagged, one by its sigma and one by its fit, and 4.5 px anywhere is beyond 5.5 / 2.4 of
    # it; from 2.8 on the wrong one is ok, which costs a hundred.
    assert table["1.6"] == ["2 of 2", "0", "0", "2"]
    assert table["2.0"] == ["1 of 2", "1", "0", "1"]
    assert table["2.8"] == ["1 of 2", "2", "1", "101"]


@pytest.mark.parametrize("text, words", [("", "no jaw"), ("1 U 0.5\n", "line 1 is no row of ArchStudy")])
def test_what_arch_study_did_not_print_is_refused(tmp_path, text, words):
    rows = tmp_path / "rows"
    rows.write_text(text)
    result = run(rows)
    assert result.returncode != 0 and words in result.stderr, result.stderr
    assert "Traceback" not in result.stderr
    assert "No such file" in run(tmp_path / "none").stderr
