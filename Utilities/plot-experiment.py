#!/usr/bin/env python3
"""Draws the plots of an experiment from its CSV files: plot-experiment.py FOLDER

Needs matplotlib. Writes PNG files into FOLDER/plots.
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def save(figure, folder, name):
    folder.mkdir(exist_ok=True)
    figure.tight_layout()
    # No date in the file: the same data give the same bits.
    figure.savefig(folder / name, dpi=150, metadata={"Software": None})
    plt.close(figure)


def errors(folder, plots):
    """Case means of every method, with the paper's figure where it prints one."""
    cases = rows(folder / "cases.csv")
    printed = rows(folder / "table1_landmarks.csv")
    figure, axes = plt.subplots(1, 2, figsize=(11, 0.35 * len(printed) / 2 + 2), sharey=True)
    for axis, jaw in zip(axes, ("upper", "lower")):
        methods = [row["method"] for row in printed if row["jaw"] == jaw]
        values = [
            [float(row["mean_px"]) for row in cases if row["jaw"] == jaw and row["method"] == method and row["mean_px"]]
            for method in methods
        ]
        axis.boxplot(values, vert=False, whis=(0, 100), medianprops={"color": "black"})
        axis.set_yticks(range(1, len(methods) + 1), methods)
        papers = [
            (float(row["paper_mean_px"]), i)
            for i, row in enumerate((row for row in printed if row["jaw"] == jaw), start=1)
            if row["paper_mean_px"]
        ]
        if papers:
            axis.plot(*zip(*papers), "D", color="tab:orange", label="printed in the paper (other, private data)")
            axis.legend(fontsize=7)
        axis.set_xscale("log")
        axis.set_xlabel("mean landmark error of a case, px")
        axis.set_title(f"{jaw} jaw")
        axis.invert_yaxis() if axis is axes[0] else None
        axis.grid(axis="x", alpha=0.3)
    save(figure, plots, "landmark_errors.png")


def calibration(folder, plots):
    """Observed against nominal probability, a panel each for jaws, tooth groups and cohorts."""
    data = rows(folder / "calibration.csv")
    overall = [row for row in data if row["by"] == "all"]
    panels = [by for by in dict.fromkeys(row["by"] for row in data) if by != "all"]
    figure, axes = plt.subplots(1, len(panels), figsize=(4.5 * len(panels), 4.5), sharey=True, squeeze=False)
    for axis, by in zip(axes[0], panels):
        for i, stratum in enumerate(dict.fromkeys(row["stratum"] for row in data if row["by"] == by)):
            chosen = [row for row in data if row["by"] == by and row["stratum"] == stratum]
            axis.plot(
                [float(row["nominal"]) for row in chosen],
                [float(row["observed"]) for row in chosen],
                "-" if i < 10 else "--",
                linewidth=1,
                label=stratum,
            )
        axis.plot(
            [float(row["nominal"]) for row in overall],
            [float(row["observed"]) for row in overall],
            "k.-",
            label="all landmarks",
        )
        axis.plot([0, 1], [0, 1], "k:", linewidth=0.8)
        axis.set_xlabel("nominal probability of the region")
        axis.set_title(f"by {by}")
        axis.legend(fontsize=6)
    axes[0][0].set_ylabel("share of landmarks inside")
    save(figure, plots, "calibration.png")


def verdict(folder, plots):
    data = rows(folder / "verdict.csv")
    if not data:
        return
    inputs = list(dict.fromkeys(row.get("input", "") for row in data))
    columns = [key for key in data[0] if key not in ("input", "verdict")]
    figure, axes = plt.subplots(1, len(inputs), figsize=(4.5 * len(inputs) + 0.5, 3), sharey=True, squeeze=False)
    for axis, name in zip(axes[0], inputs):
        chosen = [row for row in data if row.get("input", "") == name]
        counts = [[int(row[key]) for key in columns] for row in chosen]
        axis.imshow(counts, cmap="Blues")
        for i, line in enumerate(counts):
            for j, count in enumerate(line):
                axis.text(j, i, count, ha="center", va="center", color="tab:red")
        axis.set_xticks(range(len(columns)), [key.replace("_", " ") for key in columns], fontsize=7)
        axis.set_yticks(range(len(chosen)), [row["verdict"] for row in chosen])
        axis.set_title(name, fontsize=9)
    save(figure, plots, "verdict.png")


def ablation(folder, plots):
    """Mean and worst case of each variant."""
    data = rows(folder / "ablation.csv")
    variants = list(dict.fromkeys(row["variant"] for row in data))
    levels = list(dict.fromkeys(row["level"] for row in data))
    figure, axes = plt.subplots(1, len(levels), figsize=(5 * len(levels), 0.3 * len(variants) + 1.5), sharey=True)
    for axis, level in zip(axes, levels):
        for offset, jaw, colour in ((-0.15, "upper", "tab:blue"), (0.15, "lower", "tab:orange")):
            chosen = [row for row in data if row["level"] == level and row["jaw"] == jaw and row["mean_px"]]
            places = [variants.index(row["variant"]) + offset for row in chosen]
            means = [float(row["mean_px"]) for row in chosen]
            worst = [float(row["worst_case_px"]) for row in chosen]
            axis.hlines(places, means, worst, color=colour, linewidth=0.8)
            axis.plot(means, places, "o", color=colour, markersize=4, label=f"{jaw}, mean")
            axis.plot(worst, places, "|", color=colour, markersize=8, label=f"{jaw}, worst case")
        # Logarithmic where a variant loses cases altogether.
        if max(float(row["worst_case_px"]) for row in data if row["worst_case_px"]) > 16:
            axis.set_xscale("log")
        else:
            axis.set_xlim(left=0)
        axis.set_xlabel("landmark error, px")
        axis.set_title(level)
        axis.set_yticks(range(len(variants)), variants, fontsize=7)
        axis.grid(axis="x", alpha=0.3)
    axes[0].invert_yaxis()
    axes[-1].legend(fontsize=6)
    save(figure, plots, "ablation.png")


def success(folder, plots):
    data = rows(folder / "sdr.csv")
    limits = [2.0, 2.5, 3.0, 4.0]
    keys = ["sdr_2mm", "sdr_2_5mm", "sdr_3mm", "sdr_4mm"]
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), sharey=True)
    for axis, jaw in zip(axes, ("upper", "lower")):
        for i, row in enumerate(row for row in data if row["jaw"] == jaw):
            if row[keys[0]]:
                axis.plot(
                    limits, [100 * float(row[key]) for key in keys], "osv^Dx*"[i % 7] + "-", label=row["method"]
                )
        axis.set_xlabel("limit, mm")
        axis.set_title(f"{jaw} jaw")
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("landmarks within, %")
    axes[1].legend(fontsize=6, loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, plots, "success_rate.png")


def capture(folder, plots):
    data = rows(folder / "capture.csv")
    for key, title in (("accurate", "ends within 2 mm of the truth"), ("converged", "ends where the best start ends")):
        figure, axis = plt.subplots(figsize=(8.5, 4))
        for i, method in enumerate(dict.fromkeys(row["method"] for row in data)):
            chosen = [row for row in data if row["method"] == method and row[key]]
            axis.plot(
                [0.5 * (float(row["from_mm"]) + float(row["to_mm"])) for row in chosen],
                [100 * float(row[key]) for row in chosen],
                "osv^Dx*"[i % 7] + "-",
                label=method,
            )
        axis.axhline(95, color="black", linewidth=0.8, linestyle="--")
        axis.set_xlabel("displacement of the start, mean over the landmarks, mm")
        axis.set_ylabel("success, %")
        axis.set_title(title)
        axis.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
        save(figure, plots, f"capture_{key}.png")


def sensitivity(folder, plots):
    data = rows(folder / "sensitivity.csv")
    factors = list(dict.fromkeys(row["factor"] for row in data))
    width = 4
    height = -(-len(factors) // width)
    figure, axes = plt.subplots(height, width, figsize=(4 * width, 3.2 * height), squeeze=False)
    for axis, factor in zip(axes.flat, factors):
        chosen = [row for row in data if row["factor"] == factor]
        levels = list(dict.fromkeys(row["level"] for row in chosen))
        for i, method in enumerate(dict.fromkeys(row["method"] for row in chosen)):
            points = [
                (levels.index(row["level"]), float(row["mean_px"]))
                for row in chosen
                if row["method"] == method and row["mean_px"]
            ]
            if points:
                axis.plot(*zip(*points), "osv^Dx*"[i % 7] + "-", label=method)
        axis.set_xticks(range(len(levels)), levels, fontsize=7)
        axis.set_yscale("log")
        axis.set_title(factor, fontsize=9)
        axis.grid(alpha=0.3)
    for axis in list(axes.flat)[len(factors) :]:
        axis.axis("off")
    axes[0][0].set_ylabel("mean landmark error, px")
    axes[0][0].legend(fontsize=6)
    save(figure, plots, "sensitivity.png")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    plots = folder / "plots"
    drawn = 0
    for name, draw in (
        ("cases.csv", errors),
        ("sdr.csv", success),
        ("calibration.csv", calibration),
        ("verdict.csv", verdict),
        ("capture.csv", capture),
        ("sensitivity.csv", sensitivity),
        ("ablation.csv", ablation),
    ):
        if (folder / name).exists():
            draw(folder, plots)
            drawn += 1
    if drawn == 0:
        sys.exit(f"{folder} holds no CSV file of an experiment")


if __name__ == "__main__":
    main()
