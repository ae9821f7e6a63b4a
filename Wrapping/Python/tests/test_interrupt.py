"""Ctrl-C ends every call that takes long, soon: in processor time, so that a busy machine fails nothing."""
import os
import signal
import subprocess
import sys
import time

import pytest

#: s of processor time from the signal to the exception.
LIMIT = 0.3
SETUP = """
import signal, sys, time
signal.signal(signal.SIGINT, signal.default_int_handler)
import dentalscr as ds
ds.ProcessObject.SetGlobalDefaultNumberOfThreads(1)
folder, output = sys.argv[1:]
def meshes():
    return [ds.ReadMesh(f"{folder}/{jaw}.stl") for jaw in ("upper", "lower")]
"""
#: What is made before, and what is interrupted.
CALLS = {
    "ReadCase": ("", "ds.ReadCase(f'{folder}/case.json')"),
    "ReadMesh": ("", "meshes()"),
    "WriteMesh": ("upper, _ = meshes()", "ds.WriteMesh(upper, output + '.stl')"),
    "UMidlineDentalAxis": ("upper, lower = meshes()", "ds.UMidlineDentalAxis(upper, lower, refineMidline=True)"),
    "MidsagittalPlane": ("upper, lower = meshes()", "ds.MidsagittalPlane(upper, lower)"),
    "ScanCheck": ("upper, lower = meshes(); axes = ds.UMidlineDentalAxis(upper, lower)", "ds.ScanCheck(axes, upper, lower)"),
    "CrownRegionMesh": (
        "upper, _ = meshes(); frame = ds.UMidlineDentalAxis(upper).upperTransform",
        "ds.CrownRegionMesh(upper, frameTransform=frame)",
    ),
    "SurfaceDRR": (
        "upper, _ = meshes(); upper = ds.UMidlineDentalAxis(upper).upper",
        "ds.SurfaceDRR(upper, ds.CephalometricGeometry(pixelSpacing=0.02))",
    ),
    "MeshSilhouetteContour": (
        "upper, _ = meshes(); upper = ds.UMidlineDentalAxis(upper).upper",
        "ds.MeshSilhouetteContour(upper, ds.CephalometricGeometry(pixelSpacing=0.1))",
    ),
    "register": ("case = ds.ReadCase(f'{folder}/case.json')", "ds.register(case, threads=1)"),
    "batch": ("", "list(ds.batch([f'{folder}/case.json'], output, jobs=1, processes=False))"),
    "batch in processes": ("", "list(ds.batch([f'{folder}/case.json'], output, jobs=1))"),
    "Write": ("result = ds.register(f'{folder}/case.json', threads=1)", "result.Write(output)"),
    "WriteReportPage": (
        "ds.register(f'{folder}/case.json', output, threads=1)", "ds.WriteReportPage(output, output + '.html')"
    ),
    "DentalPhantomMesh": ("", "ds.DentalPhantomMesh(seed=3)"),
    "DentalPhantomCase": ("", "ds.DentalPhantomCase(seed=3, numberOfTriangles=200000)"),
    "RunCohortExperiment": ("", "ds.RunCohortExperiment(output, numberOfCases=2, methods=['robust'], drawFigures=False)"),
}


#: s of processor time after which the call is interrupted: those of many stages in a later one, too.
MOMENTS = [(name, 0.03) for name in CALLS] + [
    (name, after) for name in ("register", "batch", "DentalPhantomCase", "RunCohortExperiment") for after in (0.35, 0.6)
]


@pytest.fixture(scope="module")
def folder(ds, tmp_path_factory):
    """A case of scans as large as scanners give them."""
    source = ds.DentalPhantomCaseSource()
    source.SetSeed(3)
    source.SetNumberOfTriangles(200000)
    folder = tmp_path_factory.mktemp("large")
    source.Write(str(folder))
    return folder


def processor_seconds(pid):
    fields = open(f"/proc/{pid}/stat").read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@pytest.mark.skipif(not os.path.exists("/proc/self/stat"), reason="processor time of another process is read from /proc")
@pytest.mark.parametrize("name, after", MOMENTS)
def test_ctrl_c_ends_it_soon(folder, tmp_path, name, after):
    before, call = CALLS[name]
    code = f"""{SETUP}
{before}
print(time.process_time(), flush=True)
try:
    {call}
    print("finished", time.process_time())
except KeyboardInterrupt:
    print("interrupted", time.process_time())
"""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    process = subprocess.Popen(
        [sys.executable, "-c", code, str(folder), str(tmp_path / "out")],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment,
    )
    try:
        line = process.stdout.readline()
        # The call is under way: a clock of 100 Hz has seen it.
        while line and process.poll() is None and processor_seconds(process.pid) < float(line) + after:
            time.sleep(0.002)
        sent = processor_seconds(process.pid) if process.poll() is None else None
        process.send_signal(signal.SIGINT)
        out, errors = process.communicate(timeout=300)
    finally:
        process.kill()
    words = out.split()
    if sent is None or words[:1] == ["finished"]:
        # Done before the signal was looked for: soon, if it was.
        assert words[:1] == ["finished"] and (sent is None or float(words[1]) - sent < LIMIT), (out, errors)
        return
    if not words and "KeyboardInterrupt" in errors:
        # It came after the call.
        return
    assert words[:1] == ["interrupted"], out + errors
    assert float(words[1]) - sent < LIMIT, f"{float(words[1]) - sent:.2f} s of processor time"
