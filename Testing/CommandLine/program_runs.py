"""Registrations by the built program for the tests that need many of them: each is made once a session, two at a time."""
import collections
import concurrent.futures
import dataclasses
import json
import pathlib
import subprocess
import threading

import numpy

# Binary STL, a triangle a record.
STL_RECORD = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])

Outcome = collections.namedtuple("Outcome", "exit_code result errors")


@dataclasses.dataclass(frozen=True)
class Phantom:
    """A case that the program makes; `options` are further ones of its verb. Coarser than the verb's own and without a
    picture, which nothing here looks at: a third of the time."""

    seed: int
    level: str = "typical"
    options: tuple = ()
    triangles: int = 30000

    def arguments(self):
        standard = ("--level", self.level, "--seed", self.seed, "--triangles", self.triangles, "--no-radiograph")
        return (*standard, *self.options)


@dataclasses.dataclass(frozen=True)
class Shared:
    """A sample case beside the project."""

    name: str
    file: str = "case.json"


@dataclasses.dataclass(frozen=True)
class Run:
    """What is registered, what is changed in the case before, and how; perhaps with the scans of another case."""

    case: object
    change: object = None
    arguments: tuple = ()
    scans_of: object = None


class EditableCase:
    """A case whose files are where they were until one of them is changed: the changed ones go to `folder`."""

    def __init__(self, file, folder):
        self.folder = folder
        self.content = json.loads(file.read_text())
        self.truth = file.parent / "truth.json"
        for field in ("upper", "lower", "contours", "cephalometric_landmarks", "landmarks_3d", "landmarks_2d"):
            if field in self.content:
                self.content[field] = str(file.parent / self.content[field])
        image = self.content.get("cephalogram", {}).get("image")
        if image:
            self.content["cephalogram"]["image"] = str(file.parent / image)

    def save(self):
        path = self.folder / "case.json"
        path.write_text(json.dumps(self.content))
        return path

    def load(self, field):
        return json.loads(pathlib.Path(self.content[field]).read_text())

    def replace(self, field, content):
        path = self.folder / f"{field}.json"
        path.write_text(json.dumps(content))
        self.content[field] = str(path)

    def change_tracing(self, function, jaws=("upper", "lower")):
        """Puts function(list of outlines) in the place of a jaw's outlines."""
        tracing = self.load("contours")
        for jaw in jaws:
            tracing["contours"][jaw] = function(tracing["contours"][jaw])
        self.replace("contours", tracing)

    def corners(self, jaw):
        data = pathlib.Path(self.content[jaw]).read_bytes()
        return numpy.frombuffer(data, STL_RECORD, offset=84)["corners"].astype(float)

    def change_scan(self, jaw, function):
        """Puts function(corners of shape triangles x 3 x 3) in the place of a scan in binary STL."""
        data = pathlib.Path(self.content[jaw]).read_bytes()
        triangles = numpy.frombuffer(data, STL_RECORD, offset=84).copy()
        triangles["corners"] = function(self.corners(jaw))
        path = self.folder / f"{jaw}.stl"
        path.write_bytes(data[:84] + triangles.tobytes())
        self.content[jaw] = str(path)


class ProgramRuns:
    """Starts runs of the program. A run or a phantom that was asked for before is not made again."""

    def __init__(self, program, folder, shared_cases):
        self._program = program
        self._folder = folder
        self._shared_cases = shared_cases
        # One thread each: two processes use two cores better than two threads of one process.
        self._pool = concurrent.futures.ThreadPoolExecutor(2)
        self._runs = {}
        self._phantoms = {}
        self._lock = threading.Lock()

    def close(self):
        self._pool.shutdown(cancel_futures=True)

    def start(self, run, threads=1, again=False):
        """A future of the Outcome."""
        with self._lock:
            key = (run, threads, again)
            if key not in self._runs:
                self._runs[key] = self._pool.submit(self._register, run, threads, self._folder / f"run-{len(self._runs)}")
            return self._runs[key]

    def _call(self, *arguments):
        return subprocess.run([str(self._program), *map(str, arguments)], capture_output=True, text=True, timeout=300)

    def _register(self, run, threads, folder):
        folder.mkdir()
        case = EditableCase(self._case_file(run.case), folder)
        if run.scans_of:
            other = EditableCase(self._case_file(run.scans_of), folder)
            case.content.update({field: other.content[field] for field in ("upper", "lower", "landmarks_3d")})
        if run.change:
            run.change(case)
        output = folder / "out"
        done = self._call(
            "--threads", threads, "register", case.save(), "--output", output, "--no-report", *run.arguments
        )
        file = output / "result.json"
        return Outcome(done.returncode, json.loads(file.read_text()) if file.exists() else None, done.stderr)

    def _case_file(self, case):
        if isinstance(case, Shared):
            return self._shared_cases / case.name / case.file
        with self._lock:
            lock, folder = self._phantoms.setdefault(
                case, (threading.Lock(), self._folder / f"phantom-{len(self._phantoms)}")
            )
        with lock:
            if not folder.exists():
                done = self._call("--threads", 1, "phantom", *case.arguments(), "--output", folder)
                assert done.returncode == 0, done.stderr
        return folder / "case.json"
