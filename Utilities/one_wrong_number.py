#!/usr/bin/env python3
"""What a single wrong number does that nobody notices: in each file of a case one number is mistaken as people and
programs mistake them, the case is registered, and the landmarks are compared with those of the case as it is.

    one_wrong_number.py CASE... [--program build/test/bin/dentalscr] [--mistakes 200] [--files NAME...] [--seed 1] [--csv FILE]

CASE: folders with a case.json, as `dentalscr phantom` makes them. Told is, of each field, how many mistakes were
refused, how many left a jaw other than ok, and how many were ok with landmarks that moved: these are the silent ones.
"""
import argparse
import collections
import csv
import json
import os
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile

FILES = ("case.json", "contours.json", "landmarks3d.json", "cephalometric.json", "upper.stl", "lower.stl")


def digit(text, random):
    """One digit is another one."""
    places = [k for k, letter in enumerate(text) if letter.isdigit()]
    at = random.choice(places)
    return text[:at] + random.choice([d for d in "0123456789" if d != text[at]]) + text[at + 1 :]


def lost(text, random):
    """A digit before the point is left out."""
    places = [k for k in range(len(text.split(".")[0])) if text[k].isdigit()]
    at = random.choice(places)
    return text[:at] + text[at + 1 :]


def exchanged(text, random):
    """Two digits that follow each other change places."""
    places = [k for k in range(len(text) - 1) if text[k : k + 2].isdigit() and text[k] != text[k + 1]]
    if not places:
        return text
    at = random.choice(places)
    return text[:at] + text[at + 1] + text[at] + text[at + 2 :]


def sign(text, random):
    return text[1:] if text.startswith("-") else "-" + text


def point(text, random):
    """The point stands one digit too far."""
    return repr(float(text) * random.choice((0.1, 10.0)))


MISTAKES = (digit, lost, exchanged, sign, point)


def numbers(node, path=()):
    """Every number of a JSON value: its path."""
    if isinstance(node, dict):
        for key, value in node.items():
            yield from numbers(value, (*path, key))
    elif isinstance(node, list):
        for key, value in enumerate(node):
            yield from numbers(value, (*path, key))
    elif isinstance(node, (int, float)) and not isinstance(node, bool):
        yield path


def field(name, path):
    """The field's name without the names of teeth and without indices."""
    words = [key for key in path if isinstance(key, str) and not re.match(r"[UL][RL][1-8]|[UL][1-8]|upper$|lower$", key)]
    axis = "uvw"[path[-1]] if name == "contours.json" and isinstance(path[-1], int) else "xyz"[path[-1]] if name == "landmarks3d.json" else ""
    return ".".join([name.split(".")[0], *words, *([axis] if axis else [])])


def register(program, case, output):
    done = subprocess.run([program, "register", str(case), "--output", str(output), "--no-report", "--quiet"], capture_output=True, text=True)
    result = output / "result.json"
    return done, json.loads(result.read_text()) if result.exists() else None


def landmarks(result):
    return {name: point for jaw in result["jaws"].values() for name, point in jaw.get("landmarks_px", {}).items()}


def position(point):
    return point["position"] if isinstance(point, dict) else point


def mistaken(text, chance):
    """\\return the name of a mistake, and the number as it is written then; None where that is no other number."""
    mistake = chance.choice(MISTAKES)
    after = mistake(text, chance)
    try:
        value = float(after)
    except ValueError:
        return None
    return None if value == float(text) else (mistake.__name__, after)


def mistaken_json(name, content, chance):
    """\\return the field, the number before, the mistake, the number after, and the file's bytes with it."""
    written = json.loads(content)
    fields = collections.defaultdict(list)
    for path in numbers(written):
        fields[field(name, path)].append(path)
    chosen = chance.choice(sorted(fields))
    path = chance.choice(fields[chosen])
    parent = written
    for key in path[:-1]:
        parent = parent[key]
    before = repr(parent[path[-1]])
    made = mistaken(before, chance)
    if made is None:
        return None
    parent[path[-1]] = float(made[1]) if "." in made[1] or "e" in made[1] else int(made[1])
    return chosen, before, *made, json.dumps(written).encode()


def mistaken_scan(name, content, chance):
    """The same of a coordinate of one triangle's corner in a binary STL, of which the neighbours keep theirs."""
    (triangles,) = struct.unpack_from("<I", content, 80)
    axis = chance.randrange(3)
    at = 84 + 50 * chance.randrange(triangles) + 12 + 12 * chance.randrange(3) + 4 * axis
    before = f"{struct.unpack_from('<f', content, at)[0]:.4f}"
    made = mistaken(before, chance)
    if made is None:
        return None
    return f"scan.{'xyz'[axis]}", before, *made, content[:at] + struct.pack("<f", float(made[1])) + content[at + 4 :]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="+", type=pathlib.Path)
    parser.add_argument("--program", default="build/test/bin/dentalscr")
    parser.add_argument("--mistakes", type=int, default=200, help="of each case")
    parser.add_argument("--files", nargs="+", default=FILES, help="in which of the case's files")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=float, default=1.0, help="pixels that a landmark may move")
    parser.add_argument("--csv", type=pathlib.Path, help="a row a mistake")
    options = parser.parse_args()
    rows = []
    for folder in options.cases:
        chance = random.Random(f"{options.seed} {folder.name}")
        with tempfile.TemporaryDirectory() as scratch:
            scratch = pathlib.Path(scratch)
            _, whole = register(options.program, folder / "case.json", scratch / "whole")
            if whole is None or any(jaw["status"] != "ok" for jaw in whole["jaws"].values()):
                sys.exit(f"{folder}: is not ok as it is")
            wanted = {name: position(point) for name, point in landmarks(whole).items()}
            for k in range(options.mistakes):
                copy = scratch / "case"
                shutil.rmtree(copy, ignore_errors=True)
                copy.mkdir()
                for file in folder.iterdir():
                    if file.is_file():
                        os.symlink(file.resolve(), copy / file.name)
                # Each file and each field of it as often as any other, however many numbers it has.
                names = [name for name in options.files if (folder / name).exists()]
                name = names[k % len(names)]
                make = mistaken_json if name.endswith(".json") else mistaken_scan
                made = make(name, (folder / name).read_bytes(), chance)
                if made is None:
                    continue
                chosen, before, mistake, after, content = made
                (copy / name).unlink()
                (copy / name).write_bytes(content)
                done, result = register(options.program, copy / "case.json", scratch / "out")
                row = {"case": folder.name, "field": chosen, "mistake": mistake, "before": before, "after": after, "moved_px": "", "findings": ""}
                if result is None:
                    row["outcome"] = "refused" if done.returncode == 2 else f"ended with {done.returncode}"
                else:
                    moved = [
                        max(abs(a - b) for a, b in zip(position(landmarks(result)[mark]), wanted[mark])) for mark in wanted if mark in landmarks(result)
                    ]
                    row["moved_px"] = round(max(moved, default=0.0), 2)
                    findings = sorted({finding["code"] for jaw in result["jaws"].values() for finding in jaw.get("findings", [])})
                    row["findings"] = " ".join(findings)
                    is_ok = all(jaw["status"] == "ok" for jaw in result["jaws"].values())
                    row["outcome"] = "not ok" if not is_ok else "warned" if findings or result.get("warnings", []) != whole.get("warnings", []) else "ok"
                shutil.rmtree(scratch / "out", ignore_errors=True)
                rows.append(row)
    if options.csv:
        with options.csv.open("w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
    print("| field | mistakes | refused | not ok | ok with words | ok | of these moved by more than %g px | worst, px |" % options.limit)
    print("|---|---|---|---|---|---|---|---|")
    for name in [*sorted({row["field"] for row in rows}), None]:
        own = [row for row in rows if name in (None, row["field"])]
        count = collections.Counter(row["outcome"] for row in own)
        silent = [row["moved_px"] for row in own if row["outcome"] == "ok" and row["moved_px"] > options.limit]
        worst = max((row["moved_px"] for row in own if row["outcome"] == "ok"), default=0.0)
        print(f"| {name or 'all'} | {len(own)} | {count['refused']} | {count['not ok']} | {count['warned']} | {count['ok']} | {len(silent)} | {worst:.2f} |")
    strange = [row for row in rows if row["outcome"].startswith("ended")]
    for row in strange:
        print("STRANGE", row)
    return 1 if strange else 0


if __name__ == "__main__":
    sys.exit(main())
