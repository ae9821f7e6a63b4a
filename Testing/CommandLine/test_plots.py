"""The plots of experiments: what a person could not read, as Utilities/plot-experiment.py drew it once. Each figure is kept as
matplotlib's objects, and looked at there."""
import csv
import importlib.util
import pathlib
import re

import pytest

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed in this Python")
SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "plot-experiment.py"
METHODS = "bounding-box single-stage paper robust icp-rigid icp icp-trimmed cpd-rigid cpd no-umda one-sided parallel".split()


@pytest.fixture(scope="module")
def script():
    specification = importlib.util.spec_from_file_location("plot_experiment", SCRIPT)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


@pytest.fixture
def draw(script, monkeypatch, tmp_path):
    """Draws the tables of a folder, and returns the figures by name; each is drawn as it is saved."""

    def call(tables, function):
        for name, (header, *rows) in tables.items():
            with open(tmp_path / name, "w", newline="") as file:
                csv.writer(file).writerows([header.split(","), *rows])
        figures = {}
        monkeypatch.setattr(script, "save", lambda figure, folder, name: figures.setdefault(name, figure))
        function(tmp_path, tmp_path / "plots")
        for figure in figures.values():
            figure.canvas.draw()
        return figures

    yield call
    matplotlib.pyplot.close("all")


def success_table(methods):
    return {"sdr.csv": ["jaw,method,sdr_2mm,sdr_2_5mm,sdr_3mm,sdr_4mm"]
            + [[jaw, method, *((0.0, 0.0, 0.0, 0.0) if i == 0 else (1, 1, 1, 1) if i == 1 else (0.2, 0.4, 0.5, 0.9))]
               for jaw in ("upper", "lower") for i, method in enumerate(methods)]}


def capture_table(methods):
    return {"capture.csv": ["method,from_mm,to_mm,starts,accurate,converged"]
            + [[method, low, low + 2, 100, "" if low > 12 else max(0, 1 - low / 20), 1.0] for method in methods for low in range(0, 20, 2)]}


def sensitivity_table(methods):
    return {"sensitivity.csv": ["factor,level,method,mean_px"]
            + [[factor, level, method, 0.4 * (i + 1) * (1 + 3 * k)]
               for factor in ("noise", "roll", "missing teeth", "spacing", "yaw") for k, level in enumerate(("none", "some", "much"))
               for i, method in enumerate(methods)]}


def texts_of(axis):
    """Labels of an axis that are seen: those within its limits."""
    low, high = sorted(axis.get_view_interval())
    return [label for label, place in zip(axis.get_ticklabels(which="both"), [*axis.get_majorticklocs(), *axis.get_minorticklocs()])
            if label.get_text() and low <= place <= high]


def overlap(texts):
    boxes = [text.get_window_extent() for text in texts]
    return any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])


def contrast(text, face):
    """Of WCAG 2: 21 of black on white, 1 of a colour on itself."""

    def luminance(colour):
        parts = [x / 12.92 if x <= 0.03928 else ((x + 0.055) / 1.055) ** 2.4 for x in matplotlib.colors.to_rgb(colour)]
        return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]

    high, low = sorted((luminance(text), luminance(face)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def check_cells(axes):
    """Figures on cells are read: enough contrast, and each within its own cell's height."""
    (image,) = axes.images
    assert axes.texts
    for text in axes.texts:
        u, v = text.get_position()
        value = image.get_array()[int(v), int(u)]
        assert contrast(text.get_color(), image.cmap(image.norm(value))) > 4.5, (text.get_text(), value)
    assert not overlap(axes.texts)
    assert not overlap(texts_of(axes.xaxis)) and not overlap(texts_of(axes.yaxis))


def test_words_of_columns(script):
    assert script.label("up_to_0_5mm") == "up to 0.5 mm"
    assert script.label("above_2mm") == "above 2 mm"
    assert script.label("within 2_5mm") == "within 2.5 mm"
    assert script.label("no_error_known") == "no error known"


def test_shares_end_at_a_hundred_per_cent_and_every_method_has_its_name(script, draw):
    (figure,) = draw(success_table(METHODS), script.success).values()
    for axes in figure.axes:
        assert axes.get_xlim() == (0, 100)
        assert not overlap(texts_of(axes.xaxis)) and not overlap(texts_of(axes.yaxis))
        for line in axes.lines:
            # What lies at an end is drawn whole.
            assert not line.get_clip_on()
    assert [text.get_text() for text in figure.axes[0].get_yticklabels()] == METHODS
    (legend,) = figure.legends
    words = [text.get_text() for text in legend.get_texts()]
    assert "within 2.5 mm" in words and len(words) == 4
    assert not legend.get_window_extent().overlaps(figure.axes[0].xaxis.label.get_window_extent())


@pytest.mark.parametrize("methods", [METHODS, METHODS[:3]], ids=["many", "few"])
def test_curves_are_few_or_a_table(script, draw, methods):
    figures = {**draw(capture_table(methods), script.capture), **draw(sensitivity_table(methods), script.sensitivity)}
    assert set(figures) == {"capture_accurate.png", "capture_converged.png", "sensitivity.png"}
    for name, figure in figures.items():
        for axes in (one for one in figure.axes if one.axison):
            if axes.images:
                assert len(methods) > 6
                check_cells(axes)
                continue
            curves = [line for line in axes.lines if len(line.get_xdata()) > 2]
            assert 1 <= len(curves) <= 6
            assert len({line.get_color() for line in curves}) == len({line.get_marker() for line in curves}) == len(curves)
            assert not overlap(texts_of(axes.xaxis)) and not overlap(texts_of(axes.yaxis))
            if name.startswith("capture"):
                assert axes.get_ylim() == (0, 100)
            else:
                # Logarithmic, with numbers and no powers.
                assert axes.get_yscale() == "log"
                assert all(re.fullmatch(r"[0-9.]+", text.get_text()) for text in texts_of(axes.yaxis))


@pytest.mark.parametrize("methods", [METHODS, METHODS[:3]], ids=["many", "few"])
def test_what_is_known_of_no_method_is_no_figure(script, draw, methods):
    tables = {**capture_table(methods), **sensitivity_table(methods)}
    for table, columns in (("capture.csv", ("accurate",)), ("sensitivity.csv", ("mean_px",))):
        header, *lines = tables[table]
        for column in columns:
            for line in lines:
                line[header.split(",").index(column)] = ""
    assert set(draw(tables, script.capture)) == {"capture_converged.png"}
    assert draw(tables, script.sensitivity) == {}


@pytest.mark.parametrize("mean", [0.02, 0.1, 3.0])
def test_means_that_are_all_alike_have_colours(script, draw, mean):
    """Also where all are below the scale's lower end, 0.1 px."""
    table = sensitivity_table(METHODS)
    for line in table["sensitivity.csv"][1:]:
        line[-1] = mean
    (figure,) = draw(table, script.sensitivity).values()
    for axes in (one for one in figure.axes if one.axison):
        check_cells(axes)
        (image,) = axes.images
        assert image.norm.vmin < image.norm.vmax


def test_verdicts_are_read_on_dark_and_on_light(script, draw):
    rows = ["input,verdict,up_to_0_5mm,up_to_2mm,above_2mm,no_error_known"]
    rows += [[kind, verdict, 0, 9 * i, 20 * i, 40 * i] for kind in ("none", "turned", "other_patient") for i, verdict in enumerate(("ok", "suspect", "failed"))]
    (figure,) = draw({"verdict.csv": rows}, script.verdict).values()
    for axes in (one for one in figure.axes if one.axison):
        check_cells(axes)
    assert "up to 0.5 mm" in [text.get_text() for text in figure.axes[0].get_xticklabels()]


def test_errors_on_a_logarithmic_axis_have_numbers_that_do_not_collide(script, draw):
    printed = "jaw,method,mean_px,paper_mean_px"
    cases = [[jaw, method, 0.4 * 2**i * (1 + 0.1 * k)] for jaw in ("upper", "lower") for i, method in enumerate(METHODS[:8]) for k in range(3)]
    tables = {
        "cases.csv": ["jaw,method,mean_px", *cases],
        "table1_landmarks.csv": [printed, *([jaw, method, 1, 17.5 if i == 2 else ""] for jaw in ("upper", "lower") for i, method in enumerate(METHODS[:8]))],
    }
    (figure,) = draw(tables, script.errors).values()
    for axes in figure.axes:
        shown = texts_of(axes.xaxis)
        assert len(shown) >= 3 and not overlap(shown)
        assert all(re.fullmatch(r"[0-9.]+", text.get_text()) for text in shown), [text.get_text() for text in shown]
        assert axes.get_xlim()[0] <= 0.4 and axes.get_xlim()[1] >= 0.4 * 2**7 * 1.2


def test_calibration_stays_within_a_hundred_per_cent_and_its_legends_hide_nothing(script, draw):
    rows = ["by,stratum,nominal,observed"]
    for by, strata in (("all", ["all"]), ("jaw", ["upper", "lower"]), ("cohort", [f"cohort {i}" for i in range(14)])):
        rows += [[by, stratum, n / 20, min(1, n / 20 * (0.8 + i / 20))] for i, stratum in enumerate(strata) for n in range(1, 20)]
    (figure,) = draw({"calibration.csv": rows}, script.calibration).values()
    for axes in figure.axes:
        assert axes.get_xlim() == (0, 100) and axes.get_ylim() == (0, 100)
        legend = axes.get_legend().get_window_extent()
        assert not legend.overlaps(axes.xaxis.label.get_window_extent()) and not legend.overlaps(axes.get_window_extent())
        curves = [(line.get_color(), line.get_linestyle()) for line in axes.lines if line.get_label().startswith("cohort")]
        assert len(set(curves)) == len(curves)


def test_ablation_has_numbers_on_its_logarithmic_axis(script, draw):
    rows = ["variant,level,jaw,mean_px,worst_case_px"]
    rows += [[variant, level, jaw, 1.2, 80 if variant == "no kernel" else 2.5] for variant in ("robust", "no kernel") for level in ("typical", "hard") for jaw in ("upper", "lower")]
    (figure,) = draw({"ablation.csv": rows}, script.ablation).values()
    for axes in figure.axes:
        shown = texts_of(axes.xaxis)
        assert len(shown) >= 3 and not overlap(shown) and all(re.fullmatch(r"[0-9.]+", text.get_text()) for text in shown)
