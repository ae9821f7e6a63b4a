"""The commands of the README work as they are shown, one after the other in one folder."""
import pathlib
import re
import shlex
import signal
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_commands_of_the_readme_run_in_their_order(program, tmp_path):
    commands = re.findall(r"^    dentalscr (.*)$", (ROOT / "README.md").read_text(), re.MULTILINE)
    assert len(commands) >= 5
    for command in commands:
        if command.startswith("trace "):
            # It answers a browser until somebody ends it.
            serving = subprocess.Popen(
                [program, *shlex.split(command, comments=True)], cwd=tmp_path, stdout=subprocess.PIPE, text=True
            )
            assert serving.stdout.readline().startswith("http://127.0.0.1:")
            serving.send_signal(signal.SIGINT)
            assert serving.wait(timeout=60) == 0
            continue
        done = subprocess.run(
            [program, *shlex.split(command, comments=True)], cwd=tmp_path, capture_output=True, text=True, timeout=300
        )
        assert done.returncode == 0, command + done.stderr
    for name in ("result/result.json", "result/overlay_upper.png", "drr.png", "silhouettes.json"):
        assert (tmp_path / name).stat().st_size > 0, name
