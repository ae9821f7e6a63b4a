#!/usr/bin/env python3
"""Applies the mutations of a list one at a time and runs their tests: Utilities/mutate.sh."""
import argparse
import dataclasses
import os
import pathlib
import shlex
import signal
import subprocess
import sys
import time


@dataclasses.dataclass
class Mutation:
    number: int
    file: str
    old: str = ""
    new: str = ""
    tests: list = dataclasses.field(default_factory=list)
    equivalent: str = ""
    library: str = ""

    def __str__(self):
        return f"{self.number}: {self.file}: {self.old}  ->  {self.new}"


def read(path):
    mutations = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if not line.startswith("  "):
            mutations.append(Mutation(number, line.strip()))
            continue
        mark, text = line[2], line[4:]
        mutation = mutations[-1]
        if mark == "-":
            mutation.old = text
        elif mark == "+":
            mutation.new = text
        elif mark == "?":
            mutation.tests.append(tuple(text.split(": ", 1)))
        elif mark == "=":
            mutation.equivalent = text
        elif mark == "@":
            mutation.library = text
        else:
            sys.exit(f"{path}:{number}: no line of a mutation")
    return mutations


def find(tree, mutation):
    """The file, or why the mutation is not true any more."""
    # Of libraries alone: a header is compiled into the tests as well.
    found = list(tree.glob("Modules/*/*/src/" + mutation.file))
    if len(found) != 1:
        return None, f"{len(found)} files of that name"
    count = found[0].read_text().count(mutation.old)
    if not mutation.old or mutation.old == mutation.new or count != 1:
        return None, f"it stands there {count} times"
    if not mutation.tests and not mutation.equivalent:
        return None, "no test is named"
    return found[0], ""


def library(mutation, path):
    """That of a file of Modules/GROUP/LIBRARY/src, where the mutation names no other."""
    return mutation.library or path.parent.parent.name


def times(tree):
    """When each library was made."""
    return {path.name: path.stat().st_mtime_ns for path in (tree / "build" / "test" / "lib").iterdir()}


def build(tree, *targets):
    """\\return whether they are built, and what the build has said."""
    done = subprocess.run(
        ["cmake", "--build", str(tree / "build" / "test"), "--target", *targets], capture_output=True, text=True
    )
    return done.returncode == 0, done.stdout[-3000:] + done.stderr[-1000:]


def restore(tree, targets):
    """Libraries of unmutated files, without which every later verdict would be of another mutation."""
    is_built, said = build(tree, *sorted(targets))
    if not is_built:
        sys.exit(f"{said}\n{' '.join(sorted(targets))} is not built without a mutation")


def run(options, kind, what, limit):
    """\\return whether the tests pass, with the libraries of the tree in the place of their own; one that hangs doesn't."""
    if kind == "pytest":
        command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *shlex.split(what), "--build-dir", str(options.tests)]
    else:
        command = [str(options.tests / "bin" / f"{kind}GTestDriver"), f"--gtest_filter={what}", "--gtest_brief=1"]
    environment = dict(os.environ, LD_LIBRARY_PATH=str(options.tree / "build" / "test" / "lib"))
    process = subprocess.Popen(
        command, cwd=options.tree, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True
    )
    try:
        return process.wait(timeout=limit) == 0
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return False


def is_there(options, kind, what):
    """A filter that chooses nothing passes; of pytest it is an error by itself."""
    if kind == "pytest":
        return True
    program = str(options.tests / "bin" / f"{kind}GTestDriver")
    return b"\n  " in subprocess.run([program, f"--gtest_filter={what}", "--gtest_list_tests"], capture_output=True).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--list", type=pathlib.Path, default=pathlib.Path(__file__).with_name("mutations.txt"))
    parser.add_argument("--tests", type=pathlib.Path, help="build tree whose tests are run, with the libraries of this one")
    parser.add_argument("tree", type=pathlib.Path)
    parser.add_argument("patterns", nargs="*")
    options = parser.parse_args()
    mutations = read(options.list)
    untrue = [(mutation, why) for mutation, why in ((m, find(options.tree, m)[1]) for m in mutations) if why]
    for mutation, why in untrue:
        print(f"not true any more: {mutation}: {why}")
    if untrue or options.check:
        print(f"{len(mutations)} mutations, {len(untrue)} of them not true")
        return 1 if untrue else 0
    chosen = [m for m in mutations if not options.patterns or any(p in str(m) for p in options.patterns)]
    caught, survivors = 0, []
    # What no test stands beside need not be built: nobody would look at it.
    equivalent = [m for m in chosen if not m.tests]
    chosen = [m for m in chosen if m.tests]
    for mutation in equivalent:
        print(f"equal     {mutation}", flush=True)
    files = {mutation.number: find(options.tree, mutation)[0] for mutation in chosen}
    # Those of the mutations, too: of a run that was killed they may be mutated still.
    restore(options.tree, {"dentalscr", "dentalscr-decode", *(library(m, files[m.number]) for m in chosen)})
    limits = {}
    for test in dict.fromkeys(test for mutation in chosen for test in mutation.tests):
        # Unmutated it is there and passes, or it would notice nothing, or everything.
        start = time.monotonic()
        if not is_there(options, *test) or not run(options, *test, 1800):
            print(f"no test, or it fails without a mutation: {': '.join(test)}")
            return 1
        limits[test] = 60 + 10 * (time.monotonic() - start)
    # Libraries of which the files are as they were and the builds are not: the next build takes them with it.
    stale = set()
    for mutation in chosen:
        path = files[mutation.number]
        whole = path.read_text()
        start = time.monotonic()
        own = library(mutation, path)
        stale.add(own)
        before = times(options.tree)
        try:
            path.write_text(whole.replace(mutation.old, mutation.new))
            is_built, _ = build(options.tree, *sorted(stale))
            # A file of a library beside that of its module: the tests would run without the mutation, and nobody notice.
            changed = {name for name, time in times(options.tree).items() if before.get(name) != time}
            is_own = not is_built or any(own in name for name in changed)
            is_caught, how = False, ""
            for test in mutation.tests if is_built and is_own else ():
                if not run(options, *test, limits[test]):
                    is_caught, how = True, ": ".join(test)
                    break
        finally:
            path.write_text(whole)
        if not is_built:
            # No test has noticed it, and none could; unless it is the tree that isn't built.
            restore(options.tree, stale)
            stale = set()
            untrue.append((mutation, "is no program"))
            print(f"NO PROGRAM {mutation}", flush=True)
            continue
        stale = {own}
        if not is_own:
            # Told and passed over: the hour of the others is not lost by it.
            why = f"{own} is not made of it; name the library that is, after @"
            untrue.append((mutation, why))
            print(f"NOT TRUE  {mutation}: {why}", flush=True)
            continue
        seconds = time.monotonic() - start
        if is_caught:
            caught += 1
            print(f"caught    {mutation}   [{how}, {seconds:.0f} s]", flush=True)
            if mutation.equivalent:
                print(f"          but it is told to be equivalent: {mutation.equivalent}", flush=True)
        else:
            (equivalent if mutation.equivalent else survivors).append(mutation)
            print(f"{'equal    ' if mutation.equivalent else 'SURVIVES '} {mutation}   [{seconds:.0f} s]", flush=True)
    if stale:
        restore(options.tree, stale)
    counted = caught + len(survivors)
    print(f"{caught} of {counted} caught ({100.0 * caught / max(1, counted):.0f} %), {len(equivalent)} equivalent")
    for mutation in survivors:
        print(f"SURVIVES  {mutation}")
    return 1 if survivors or untrue else 0


if __name__ == "__main__":
    sys.exit(main())
