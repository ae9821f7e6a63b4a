"""Executes the notebook of Examples/Notebook and reads its last figures."""
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]

EXECUTE = """
import pathlib, sys
import nbclient, nbformat
notebook = nbformat.read(sys.argv[1], as_version=4)
nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": sys.argv[2]}}).execute()
pictures = sum("image/png" in o.get("data", {}) for c in notebook.cells for o in c.get("outputs", []))
text = "".join(o.get("text", "") for o in [c for c in notebook.cells if c.cell_type == "code"][-1].outputs)
print("pictures", pictures)
print(text)
"""


def test_tour_runs_from_top_to_bottom(build_dir, tmp_path):
    candidates = [build_dir.parent / "python-venv" / "bin" / "python", pathlib.Path(sys.executable)]
    for python in candidates:
        if python.exists():
            done = subprocess.run([str(python), "-c", "import nbclient, ipykernel"], capture_output=True)
            if done.returncode == 0:
                break
    else:
        pytest.skip("nbclient and ipykernel are not installed")
    environment = dict(os.environ)
    environment["PYTHONPATH"] = str(build_dir / "python")
    # Jupyter's own files stay out of the home folder.
    environment["JUPYTER_RUNTIME_DIR"] = environment["IPYTHONDIR"] = str(tmp_path)
    done = subprocess.run(
        [str(python), "-c", EXECUTE, str(ROOT / "Examples" / "Notebook" / "Tour.ipynb"), str(tmp_path)],
        capture_output=True, text=True, timeout=300, env=environment,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    values = dict(line.split() for line in done.stdout.splitlines() if line.strip())
    assert int(values["pictures"]) >= 3
    # The robust registration of a typical case.
    assert float(values["upper"]) < 2.0 and float(values["lower"]) < 2.0
