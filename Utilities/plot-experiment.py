#!/usr/bin/env python3
"""Draws the plots of an experiment from its CSV files: plot-experiment.py FOLDER

Needs matplotlib. Writes PNG files into FOLDER/plots.
"""
import csv
import math
import pathlib
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.colors
import matplotlib.pyplot as plt
import matplotlib.ticker

# Okabe and Ito's, which are told apart with any colour vision. Beyond these nobody tells curves apart: what has more
# than so many is drawn as a table of colours with its figures in it.
COLOURS = ["#0072B2", "#E69F00", "#009E73", "#CC79A7", "#D55E00", "#56B4E9"]
MARKERS = "osv^DX"


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def save(figure, folder, name):
    folder.mkdir(exist_ok=True)
    # No date in the file: the same data give the same bits.
    figure.savefig(folder / name, dpi=150, metadata={"Software": None}, bbox_inches="tight")
    plt.close(figure)


def label(key):
    """The words of a column: "up_to_0_5mm" is up to 0.5 mm."""
    return re.sub(r"(\d)mm\b", r"\1 mm", re.sub(r"(\d)_(\d)", r"\1.\2", key)).replace("_", " ")


def logarithmic(axis):
    """Of an axis: figures at 1, 2 and 5 of each decade, as numbers, and none between them to collide with."""
    axis.axes.set(**{f"{axis.axis_name}scale": "log"})
    low, high = axis.get_view_interval()
    decades = math.log10(high / low)
    axis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5) if decades < 2.5 else (1,), numticks=20))
    axis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def percent(axis):
    """Of an axis: 0 to 100 % and no further; what lies at an end is drawn whole all the same (clip_on=False)."""
    axis.axes.set(**{f"{axis.axis_name}lim": (0, 100)})
    axis.set_major_locator(matplotlib.ticker.MultipleLocator(20))


def cells(axes, values, rows, columns, words, colours="Blues", norm=None):
    """A table of colours with a figure in each cell, black or white, whichever is read better on it."""
    shown = axes.imshow([[float("nan") if v is None else v for v in line] for line in values], cmap=colours, norm=norm, aspect="auto")
    for i, line in enumerate(values):
        for j, value in enumerate(line):
            if value is not None:
                red, green, blue, _ = shown.cmap(shown.norm(value))
                light = 0.2126 * red**2.2 + 0.7152 * green**2.2 + 0.0722 * blue**2.2
                # The luminance at which black and white have the same contrast.
                axes.text(j, i, words(value), ha="center", va="center", fontsize=7, color="black" if light > 0.18 else "white")
    axes.set_xticks(range(len(columns)), columns, fontsize=7)
    axes.set_yticks(range(len(rows)), rows, fontsize=8)
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)


def shared_legend(figure, axes, columns=4):
    """One legend for all panels, below them."""
    handles, labels = {}, []
    for one in axes:
        for handle, name in zip(*one.get_legend_handles_labels()):
            if name not in handles:
                handles[name] = handle
                labels.append(name)
    figure.legend([handles[name] for name in labels], labels, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=columns, fontsize=8)


def errors(folder, plots):
    """Case means of every method, with the paper's figure where it prints one."""
    cases = rows(folder / "cases.csv")
    printed = rows(folder / "table1_landmarks.csv")
    figure, axes = plt.subplots(1, 2, figsize=(11, 0.35 * len(printed) / 2 + 2), sharex=True, sharey=True)
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
            axis.plot(*zip(*papers), "D", color=COLOURS[1], label="printed in the paper (other, private data)")
        axis.set_xlabel("mean landmark error of a case, px")
        axis.set_title(f"{jaw} jaw")
        axis.grid(axis="x", alpha=0.3)
    axes[0].invert_yaxis()
    logarithmic(axes[0].xaxis)
    figure.tight_layout()
    shared_legend(figure, axes)
    save(figure, plots, "landmark_errors.png")


def calibration(folder, plots):
    """Observed against nominal probability, a panel each for jaws, tooth groups and cohorts."""
    data = rows(folder / "calibration.csv")
    overall = [row for row in data if row["by"] == "all"]
    panels = [by for by in dict.fromkeys(row["by"] for row in data) if by != "all"]
    figure, axes = plt.subplots(1, len(panels), figsize=(4.5 * len(panels), 4.5), sharey=True, squeeze=False)
    for axis, by in zip(axes[0], panels):
        strata = list(dict.fromkeys(row["stratum"] for row in data if row["by"] == by))
        for i, stratum in enumerate(strata):
            chosen = [row for row in data if row["by"] == by and row["stratum"] == stratum]
            axis.plot(
                [100 * float(row["nominal"]) for row in chosen],
                [100 * float(row["observed"]) for row in chosen],
                # So many colours, and a kind of line for each round of them.
                ("-", "--", ":")[i // len(COLOURS) % 3],
                color=COLOURS[i % len(COLOURS)],
                linewidth=1.2,
                label=stratum,
                clip_on=False,
            )
        axis.plot(
            [100 * float(row["nominal"]) for row in overall],
            [100 * float(row["observed"]) for row in overall],
            "k.-",
            label="all landmarks",
            clip_on=False,
        )
        axis.plot([0, 100], [0, 100], color="0.5", linewidth=0.8, label="as promised")
        axis.set_xlabel("nominal probability of the region, %")
        axis.set_title(f"by {by}")
        axis.grid(alpha=0.3)
        percent(axis.xaxis)
        percent(axis.yaxis)
    axes[0][0].set_ylabel("landmarks inside, %")
    figure.tight_layout()
    # Afterwards: room is made for what is below by saving, and not taken from the panels.
    for axis in axes[0]:
        axis.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.15), ncol=2)
    save(figure, plots, "calibration.png")


def verdict(folder, plots):
    data = rows(folder / "verdict.csv")
    if not data:
        return
    inputs = list(dict.fromkeys(row.get("input", "") for row in data))
    columns = [key for key in data[0] if key not in ("input", "verdict")]
    most = max(int(row[key]) for row in data for key in columns)
    width = min(4, len(inputs))
    height = -(-len(inputs) // width)
    figure, axes = plt.subplots(height, width, figsize=(4.2 * width + 0.5, 2.4 * height), sharey=True, squeeze=False)
    for axis, name in zip(axes.flat, inputs):
        chosen = [row for row in data if row.get("input", "") == name]
        counts = [[int(row[key]) for key in columns] for row in chosen]
        norm = matplotlib.colors.Normalize(0, max(1, most))
        cells(axis, counts, [row["verdict"] for row in chosen], [label(key) for key in columns], str, norm=norm)
        axis.set_title(label(name), fontsize=9)
    for axis in list(axes.flat)[len(inputs) :]:
        axis.axis("off")
    figure.tight_layout()
    save(figure, plots, "verdict.png")


def ablation(folder, plots):
    """Mean and worst case of each variant."""
    data = rows(folder / "ablation.csv")
    variants = list(dict.fromkeys(row["variant"] for row in data))
    levels = list(dict.fromkeys(row["level"] for row in data))
    figure, axes = plt.subplots(
        1, len(levels), figsize=(5 * len(levels), 0.3 * len(variants) + 1.5), sharey=True, squeeze=False
    )
    for axis, level in zip(axes[0], levels):
        for offset, jaw, colour in ((-0.15, "upper", COLOURS[0]), (0.15, "lower", COLOURS[1])):
            chosen = [row for row in data if row["level"] == level and row["jaw"] == jaw and row["mean_px"]]
            places = [variants.index(row["variant"]) + offset for row in chosen]
            means = [float(row["mean_px"]) for row in chosen]
            worst = [float(row["worst_case_px"]) for row in chosen]
            axis.hlines(places, means, worst, color=colour, linewidth=0.8)
            axis.plot(means, places, "o", color=colour, markersize=4, label=f"{jaw}, mean")
            axis.plot(worst, places, "|", color=colour, markersize=8, label=f"{jaw}, worst case")
        # Logarithmic where a variant loses cases altogether.
        if max((float(row["worst_case_px"]) for row in data if row["worst_case_px"]), default=0) > 16:
            logarithmic(axis.xaxis)
        else:
            axis.set_xlim(left=0)
        axis.set_xlabel("landmark error, px")
        axis.set_title(level)
        axis.set_yticks(range(len(variants)), variants, fontsize=7)
        axis.grid(axis="x", alpha=0.3)
    axes[0][0].invert_yaxis()
    figure.tight_layout()
    shared_legend(figure, axes[0])
    save(figure, plots, "ablation.png")


def success(folder, plots):
    """How many landmarks lie within each limit: a line a method, so that each is read by its name."""
    data = rows(folder / "sdr.csv")
    keys = [key for key in data[0] if key.startswith("sdr_")]
    methods = list(dict.fromkeys(row["method"] for row in data))
    figure, axes = plt.subplots(1, 2, figsize=(11, 0.32 * len(methods) + 1.5), sharey=True)
    for axis, jaw in zip(axes, ("upper", "lower")):
        chosen = [row for row in data if row["jaw"] == jaw and row[keys[0]]]
        places = [methods.index(row["method"]) for row in chosen]
        axis.hlines(
            places,
            [100 * float(row[keys[0]]) for row in chosen],
            [100 * float(row[keys[-1]]) for row in chosen],
            color="0.6",
            linewidth=0.8,
        )
        # The widest first: where limits have the same share the strictest is seen.
        for i, key in reversed(list(enumerate(keys))):
            axis.plot(
                [100 * float(row[key]) for row in chosen],
                places,
                MARKERS[i],
                color=COLOURS[i],
                markersize=6,
                label=label(key.replace("sdr_", "within ")),
                clip_on=False,
                zorder=3,
            )
        axis.set_xlabel("landmarks within, %")
        axis.set_title(f"{jaw} jaw")
        axis.set_yticks(range(len(methods)), methods, fontsize=8)
        axis.grid(axis="x", alpha=0.3)
        percent(axis.xaxis)
    axes[0].set_ylim(len(methods) - 0.5, -0.5)
    figure.tight_layout()
    shared_legend(figure, axes)
    save(figure, plots, "success_rate.png")


def capture(folder, plots):
    """Success by the start's displacement: curves where they are few, else a table of colours."""
    data = rows(folder / "capture.csv")
    methods = list(dict.fromkeys(row["method"] for row in data))
    bins = list(dict.fromkeys((float(row["from_mm"]), float(row["to_mm"])) for row in data))
    for key, title in (("accurate", "ends within 2 mm of the truth"), ("converged", "ends where the best start ends")):
        known = {(row["method"], float(row["from_mm"]), float(row["to_mm"])): 100 * float(row[key]) for row in data if row[key]}
        if not known:
            # An empty figure would look like a success of none.
            continue
        shares = [[known.get((method, *place)) for place in bins] for method in methods]
        if len(methods) > len(COLOURS):
            figure, axis = plt.subplots(figsize=(0.62 * len(bins) + 3, 0.3 * len(methods) + 1.5))
            norm = matplotlib.colors.Normalize(0, 100)
            cells(axis, shares, methods, [f"{low:g}–{high:g}" for low, high in bins], lambda v: f"{v:.0f}", norm=norm)
            axis.set_xlabel("displacement of the start, mean over the landmarks, mm")
            axis.set_title(f"success, %: {title}")
        else:
            figure, axis = plt.subplots(figsize=(8.5, 4))
            for i, (method, line) in enumerate(zip(methods, shares)):
                points = [(0.5 * sum(place), share) for place, share in zip(bins, line) if share is not None]
                axis.plot(*zip(*points), MARKERS[i] + "-", color=COLOURS[i], label=method, clip_on=False) if points else None
            axis.axhline(95, color="black", linewidth=0.8, linestyle="--")
            axis.set_xlim(0, bins[-1][1])
            percent(axis.yaxis)
            axis.grid(alpha=0.3)
            axis.set_xlabel("displacement of the start, mean over the landmarks, mm")
            axis.set_ylabel("success, %")
            axis.set_title(title)
            figure.tight_layout()
            shared_legend(figure, [axis])
        save(figure, plots, f"capture_{key}.png")


def sensitivity(folder, plots):
    """Error by the level of each factor: curves where methods are few, else a table of colours a factor."""
    data = rows(folder / "sensitivity.csv")
    factors = list(dict.fromkeys(row["factor"] for row in data))
    methods = list(dict.fromkeys(row["method"] for row in data))
    known = [float(row["mean_px"]) for row in data if row["mean_px"]]
    if not known:
        return
    many = len(methods) > len(COLOURS)
    width = min(4, len(factors))
    height = -(-len(factors) // width)
    size = (4 * width + (1 if many else 0), (0.2 * len(methods) + 1.2 if many else 3) * height)
    figure, axes = plt.subplots(height, width, figsize=size, squeeze=False, sharey=True)
    for axis, factor in zip(axes.flat, factors):
        chosen = [row for row in data if row["factor"] == factor]
        levels = list(dict.fromkeys(row["level"] for row in chosen))
        found = {(row["method"], row["level"]): float(row["mean_px"]) for row in chosen if row["mean_px"]}
        if many:
            means = [[found.get((method, level)) for level in levels] for method in methods]
            lowest, highest = max(0.1, min(known)), max(known)
            # However small or alike all of them are: a scale of no length has no colours.
            norm = matplotlib.colors.LogNorm(lowest, highest if highest > lowest else 2 * lowest)
            cells(axis, means, methods, levels, lambda v: f"{v:.2g}" if v < 10 else f"{v:.0f}", "viridis_r", norm)
        else:
            for i, method in enumerate(methods):
                points = [(x, found[method, level]) for x, level in enumerate(levels) if (method, level) in found]
                axis.plot(*zip(*points), MARKERS[i] + "-", color=COLOURS[i], label=method) if points else None
            axis.set_xticks(range(len(levels)), levels, fontsize=7)
            axis.grid(alpha=0.3)
        axis.set_title(factor, fontsize=9)
    for axis in list(axes.flat)[len(factors) :]:
        axis.axis("off")
    if not many:
        logarithmic(axes[0][0].yaxis)
        for line in axes:
            line[0].set_ylabel("mean landmark error, px")
    else:
        figure.suptitle("mean landmark error, px", y=1.0)
    figure.tight_layout()
    if not many:
        shared_legend(figure, axes.flat)
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
