#!/usr/bin/env python3
"""Draws what RegistrationIterationCommand::WriteTable() writes: plot.py TITLE=table.csv ... picture.png

Needs matplotlib. A column a level, a colour a candidate; above the metric's value, below the length of each step. Levels
in which no candidate has a second step are left out, and so is the uncertainty of preset robust, whose hypotheses begin
with starts of its own.
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# What PoseRegistrationMethod's levels are, group after group of jaws with a pose of their own.
STAGES = ("starts", "candidates", "refinement", "uncertainty")


def read(path):
    """Steps by level and candidate, each in the order in which they were tried."""
    levels = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            steps = levels.setdefault(int(row["level"]), {}).setdefault(int(row["candidate"]), [])
            steps.append((float(row["value"]), float(row["step_length"]), row["accepted"] == "1"))
    return levels


def draw(axes, candidates, best):
    """axes: that of the value and that of the step length."""
    for candidate, steps in sorted(candidates.items()):
        colour = f"C{candidate % 10}"
        style = {"color": colour, "linewidth": 1.8 if candidate == best else 0.8, "alpha": 0.9}
        numbers = range(1, len(steps) + 1)
        axes[0].plot(numbers, [value for value, _, _ in steps], **style)
        axes[1].plot(numbers, [length for _, length, _ in steps], **style)
        refused = [(number, step[1]) for number, step in zip(numbers, steps) if not step[2]]
        if refused:
            axes[1].plot(*zip(*refused), "x", color=colour, markersize=4)
    for axis in axes:
        axis.grid(alpha=0.3)
        low, high = axis.dataLim.intervaly
        if high > 5 * low:
            axis.set_yscale("log")


def plot(tables, picture):
    """tables: (title, levels) pairs."""
    columns = [(title, level, levels[level]) for title, levels in tables for level in sorted(levels)]
    columns = [
        (title, level, candidates)
        for title, level, candidates in columns
        if max(map(len, candidates.values())) > 1 and not (title == "robust" and level % 4 == 3)
    ]
    figure, axes = plt.subplots(2, len(columns), figsize=(2.8 * len(columns), 5), sharex="col", squeeze=False)
    for column, (title, level, candidates) in enumerate(columns):
        best = min(candidates, key=lambda candidate: candidates[candidate][-1][0])
        draw(axes[:, column], candidates, best)
        name = STAGES[level % 4] if title == "robust" else f"level {level}"
        axes[0, column].set_title(f"{title}: {name}", fontsize="medium")
        axes[1, column].set_xlabel("step tried")
        axes[0, column].tick_params(which="both", labelsize="small")
        axes[1, column].tick_params(which="both", labelsize="small")
    axes[0, 0].set_ylabel("value of the metric")
    axes[1, 0].set_ylabel("length of the step, px (x: refused)")
    figure.tight_layout()
    # No date in the file: the same data give the same bits.
    figure.savefig(picture, dpi=75, metadata={"Software": None})


if __name__ == "__main__":
    plot([(title, read(path)) for title, path in (text.split("=", 1) for text in sys.argv[1:-1])], sys.argv[-1])
