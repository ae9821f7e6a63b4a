"""Plots what OptimizerAndObserver recorded: plot.py convergence.csv convergence.png."""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def plot(rows, file_name):
    """rows: (optimizer, level, step, value)."""
    figure, axes = plt.subplots(figsize=(7, 3.5), constrained_layout=True)
    for optimizer in dict.fromkeys(row[0] for row in rows):
        mine = [row for row in rows if row[0] == optimizer]
        values = [row[3] for row in mine]
        best = [min(values[: i + 1]) for i in range(len(values))]
        (line,) = axes.plot(best, label=optimizer, linewidth=2)
        axes.plot(values, color=line.get_color(), linewidth=0.7, alpha=0.4)
        levels = [i for i in range(1, len(mine)) if mine[i][1] != mine[i - 1][1]]
        axes.plot(levels, [best[i] for i in levels], "*", color=line.get_color(), markersize=10)
    axes.set_xlabel("step")
    axes.set_ylabel("metric, px")
    axes.set_title("thick: best so far, thin: each step, stars: a new level begins", fontsize="small", loc="left")
    axes.legend()
    figure.savefig(file_name, dpi=120)


if __name__ == "__main__":
    with open(sys.argv[1], newline="") as table:
        plot([(r["optimizer"], int(r["level"]), int(r["step"]), float(r["value"])) for r in csv.DictReader(table)], sys.argv[2])
