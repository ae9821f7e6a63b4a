#!/usr/bin/env python3
"""Tables of Documentation/RobustStudies.md from the rows that ArchStudy prints.

    verdict-tables.py OUTPUT_OF_ARCHSTUDY...

Prints two tables in Markdown. The first says of each rule of the verdict how many jaws it flagged by their true error,
and how many of these no other rule flagged. The second is the operating curve: what other limits of the predicted
standard deviation (`uncertain`) would cost, with all other rules as they are. A wrong `ok`, beyond 8 px of 0.25 mm,
counts as much as a hundred jaws that are flagged though within 2 px.
"""

import argparse
import sys

ERRORS = ((0.0, 2.0, "≤ 2 px"), (2.0, 4.0, "2–4 px"), (4.0, 8.0, "4–8 px"), (8.0, float("inf"), "> 8 px"))
LIMITS = (1.6, 1.8, 2.0, 2.2, 2.4, 2.6, 2.8, 3.0, 3.5, 4.0)
# Beside the limit at the tracing, RegistrationVerdict::Thresholds has one for anywhere on the outline: 5.5 to 2.4.
ANYWHERE = 5.5 / 2.4
WRONG_OK = 100


class Jaw:
    """A jaw's row and the row V of what was judged."""

    def __init__(self, error, codes):
        self.error = error
        self.codes = codes
        self.sigmas = (0.0, 0.0)

    def flagged_at(self, limit):
        at_tracing, anywhere = self.sigmas
        return bool(self.codes - {"uncertain"}) or at_tracing > limit or anywhere > limit * ANYWHERE


def read(lines, name):
    """The jaws of one output."""
    jaws = {}
    for number, line in enumerate(lines, 1):
        try:
            if line.startswith("V "):
                fields = line.split()
                jaws[fields[1], fields[2]].sigmas = (float(fields[9]), float(fields[10]))
            elif line[:1].isdigit():
                row, *findings = line.rstrip("\n").split(" | ")
                seed, jaw, error, *_ = fields = row.split()
                if error == "-":
                    continue
                codes = {finding.split(": ", 1)[0] for finding in findings} if fields[6] != "ok" else set()
                jaws[seed, jaw] = Jaw(float(error), codes)
        except (IndexError, KeyError, ValueError) as problem:
            sys.exit(f"{name}: line {number} is no row of ArchStudy ({problem!r}): give what it printed")
    return list(jaws.values())


def rule_table(jaws):
    def count(low, high, code):
        flagged = [jaw for jaw in jaws if low < jaw.error <= high and code in jaw.codes]
        return f"{len(flagged)} / {sum(len(jaw.codes) == 1 for jaw in flagged)}" if flagged else "0"

    heads = [f"{name} (of {sum(low < jaw.error <= high for jaw in jaws)})" for low, high, name in ERRORS]
    print("| rule | " + " | ".join(heads) + " |\n|---|" + "---:|" * len(heads))
    for code in sorted({code for jaw in jaws for code in jaw.codes}):
        print(f"| `{code}` | " + " | ".join(count(low, high, code) for low, high, _ in ERRORS) + " |")


def operating_curve(jaws):
    near = [jaw for jaw in jaws if jaw.error <= 2.0]
    print("| limit of σ at the tracing, px | flagged though ≤ 2 px | ok but > 4 px | ok but > 8 px | cost |\n|---|" + "---:|" * 4)
    for limit in LIMITS:
        false = sum(jaw.flagged_at(limit) for jaw in near)
        beyond = [sum(jaw.error > bound and not jaw.flagged_at(limit) for jaw in jaws) for bound in (4.0, 8.0)]
        print(f"| {limit} | {false} of {len(near)} | {beyond[0]} | {beyond[1]} | {false + WRONG_OK * beyond[1]} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("outputs", nargs="+", metavar="OUTPUT")
    jaws = []
    for name in parser.parse_args().outputs:
        try:
            with open(name, encoding="utf-8") as file:
                jaws += read(file, name)
        except OSError as problem:
            sys.exit(f"{name}: {problem.strerror}")
    if not jaws:
        sys.exit("no jaw in these files: give what ArchStudy printed")
    rule_table(jaws)
    print()
    operating_curve(jaws)


if __name__ == "__main__":
    main()
