"""The commands of the README work as they are shown, one after the other in one folder."""
import pathlib
import re
import shlex
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_commands_of_the_readme_run_in_their_order(program, tmp_path):
    commands = re.findall(r"^    dentalscr (.*)$", (ROOT / "README.md").read_text(), re.MULTILINE)
    assert len(commands) >= 5
    for command in commands:
        done = subprocess.run(
            [program, *shlex.split(command, comments=True)], cwd=tmp_path, capture_output=True, text=True, timeout=300
        )
        assert done.returncode == 0, command + done.stderr
    for name in ("result/result.json", "result/overlay_upper.png", "drr.png", "silhouettes.json"):
        assert (tmp_path / name).stat().st_size > 0, name
