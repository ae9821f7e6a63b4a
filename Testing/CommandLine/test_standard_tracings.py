"""Outlines of whole teeth: what is no whole tooth, and what nobody drew."""
import csv
import json
import math
import pathlib

import pytest


def outlines_of(case):
    return case.load("outlines.json")


def register(run, case, folder, *options):
    done = run("register", case.file, "--output", folder, "--no-report", *options)
    assert done.returncode in (0, 1), done.stderr
    return json.loads((folder / "result.json").read_text()), done.stderr


@pytest.fixture
def outline_case(standard_case):
    content = standard_case.load()
    content.pop("cephalometric_landmarks", None)
    content.update(contours="outlines.json", traced_side="standard")
    standard_case.save(content)
    return standard_case


def moved(points, scale, degrees, shift, mirrored=False):
    """Under a similarity, and mirrored about the vertical before it where asked."""
    middle = [sum(p[d] for p in points) / len(points) for d in (0, 1)]
    cosine, sine = scale * math.cos(math.radians(degrees)), scale * math.sin(math.radians(degrees))
    out = []
    for u, v in points:
        a, b = (middle[0] - u if mirrored else u - middle[0]), v - middle[1]
        out.append([middle[0] + shift[0] + cosine * a - sine * b, middle[1] + shift[1] + sine * a + cosine * b])
    return out


def used(result):
    return {name: outline for jaw in result["jaws"].values() for name, outline in jaw.get("outlines_used", {}).items()}


def test_outlines_that_a_hand_drew_are_no_templates_of_each_other(run, outline_case, tmp_path):
    result, _ = register(run, outline_case, tmp_path / "out")
    assert set(used(result)) == {"U1", "U6", "L1", "L6"}
    assert not any("template_of" in outline for outline in used(result).values())
    assert not any("moved, turned and scaled" in line for line in result["warnings"])


def test_an_outline_that_is_another_tooths_is_a_template(run, outline_case, tmp_path):
    """The lower incisor is the upper one's outline, upside down, a little smaller, where the lower one was."""
    tracing = outlines_of(outline_case)
    upper = next(p for p in tracing["contours"]["upper"] if p["code"][2] == "1")
    lower = next(p for p in tracing["contours"]["lower"] if p["code"][2] == "1")
    middles = [[sum(p[d] for p in line["points"]) / len(line["points"]) for d in (0, 1)] for line in (upper, lower)]
    shift = [b - a for a, b in zip(*middles)]
    lower["points"] = moved(upper["points"], 0.9, 180.0, shift, mirrored=True)
    outline_case.save(tracing, "outlines.json")
    result, said = register(run, outline_case, tmp_path / "out")
    assert used(result)["U1"]["template_of"] == "L1" and used(result)["L1"]["template_of"] == "U1"
    assert used(result)["L1"]["template_distance_mm"] < 0.01
    assert "template_of" not in used(result)["U6"]
    # By one hand all alike: of none the shape counts.
    assert all(outline["template"] for outline in used(result).values())
    assert "outline U1: it is that of L1, moved, turned and scaled" in said
    # A tooth that is left out is compared with nothing.
    result, said = register(run, outline_case, tmp_path / "without", "--exclude", lower["code"])
    assert not any("template_of" in outline for outline in used(result).values()), said


def test_stock_outlines_tell_templates(run, outline_case, tmp_path):
    tracing = outlines_of(outline_case)
    molar = next(p for p in tracing["contours"]["lower"] if p["code"][2] == "6")
    # Another patient's, who looks the other way, on a picture of another size.
    stock = {
        "image_size": [3000, 3000],
        "contours": {"lower": [{**molar, "points": moved(molar["points"], 2.7, 12.0, (300.0, 200.0), mirrored=True)}]},
    }
    outline_case.save(stock, "stock.json")
    plain, _ = register(run, outline_case, tmp_path / "plain")
    content = outline_case.load()
    content["stock_outlines"] = "stock.json"
    outline_case.save(content)
    result, said = register(run, outline_case, tmp_path / "out")
    assert used(result)["L6"]["template_of"] == f"{molar['code']} of the stock"
    assert [name for name, outline in used(result).items() if "template_of" in outline] == ["L6"]
    assert f"outline L6: it is that of {molar['code']} of the stock" in said
    assert not any("template_of" in outline for outline in used(plain).values())
    assert result["inputs"]["stock_outlines"]["path"].endswith("stock.json")


def test_a_stock_without_a_closed_outline_is_refused(run, outline_case, tmp_path):
    stock = outlines_of(outline_case)
    for lines in stock["contours"].values():
        for line in lines:
            line["closed"] = False
            line.pop("outline", None)
            line["points"] = line["points"][: len(line["points"]) // 2]
    outline_case.save(stock, "stock.json")
    content = outline_case.load()
    content["stock_outlines"] = "stock.json"
    outline_case.save(content)
    done = run("register", outline_case.file, "--output", tmp_path / "out")
    assert done.returncode == 2 and "stock.json" in done.stderr and "none of its outlines is closed" in done.stderr
    assert not pathlib.Path(tmp_path / "out" / "result.json").exists()


def test_crowns_without_roots_are_no_whole_teeth(run, outline_case, tmp_path):
    tracing = outlines_of(outline_case)
    shares = {("upper", "1"): 0.45, ("upper", "6"): 0.38, ("lower", "1"): 0.42, ("lower", "6"): 0.35}
    for jaw, lines in tracing["contours"].items():
        for line in lines:
            line.pop("outline", None)
            heights = [p[1] for p in line["points"]]
            share = shares[jaw, line["code"][2]] * (max(heights) - min(heights))
            keep = [p[1] > max(heights) - share if jaw == "upper" else p[1] < min(heights) + share for p in line["points"]]
            # From the neck around to the neck.
            first = next(i for i in range(len(keep)) if keep[i] and not keep[i - 1])
            around = line["points"][first:] + line["points"][:first]
            line["points"] = around[: sum(keep)]
    outline_case.save(tracing, "outlines.json")
    result, said = register(run, outline_case, tmp_path / "out")
    # None is registered with as if it were one: what is left of them is said to be too little.
    assert result["jaws"]["upper"]["status"] == "failed" and result["jaws"]["lower"]["status"] != "ok"
    said += " ".join(result["jaws"]["upper"]["reasons"])
    assert "U1: it is too wide for its length: is it a crown without its root?" in said
    for name in ("U6", "L6"):
        assert f"{name}: its long axis lies along the arch: is it a crown without its root?" in said


def without_scan_landmarks(case):
    content = case.load()
    content.pop("landmarks_3d")
    case.save(content)
    return case


def errors_of(run, result, folder):
    table = folder / "errors.csv"
    done = run("evaluate", result, "--csv", table)
    assert done.returncode == 0, done.stderr
    return {row["jaw"]: row for row in csv.DictReader(table.read_text().splitlines()) if row["case"] != "all"}


def test_middles_and_errors_without_landmarks_of_the_scan(run, outline_case, tmp_path):
    """The points are found by the scan's shape: said, with the sigma of that, and measured by both sides' marks."""
    result, said = register(run, without_scan_landmarks(outline_case), tmp_path / "out")
    marked = outline_case.load("landmarks2d.json")
    assert "landmarks_px" not in result["jaws"]["upper"] or result["jaws"]["upper"]["landmarks_px"] == {}
    for jaw, letter in (("upper", "U"), ("lower", "L")):
        middles = result["jaws"][jaw]["middles"]
        assert list(middles) == [f"{letter}1_tip", f"{letter}6_MB"]
        error = result["jaws"][jaw]["error"]
        for name, middle in middles.items():
            assert middle["found_by"] == "its place along the arch"
            right, left = (marked[f"{letter}{side}{name[1:]}"] for side in "RL")
            distance = math.dist(middle["position"], [0.5 * (a + b) for a, b in zip(right, left)])
            assert distance < 2.448 * middle["sigma_px"], name
            pair = f"{letter}R{name[1:]}+{letter}L{name[1:]}"
            assert error["landmarks"][pair] == pytest.approx(distance)
            assert error["found_by"][pair] == "its place along the arch"
        # A textbook's place of a molar is less sure than an incisal edge.
        assert middles[f"{letter}6_MB"]["sigma_px"] > middles[f"{letter}1_tip"]["sigma_px"]
    rows = errors_of(run, tmp_path / "out", tmp_path)
    for jaw in ("upper", "lower"):
        assert float(rows[jaw]["mean_px"]) == pytest.approx(result["jaws"][jaw]["error"]["mean_px"], abs=1e-5)
        assert rows[jaw]["landmarks"] == "2"


def test_evaluate_leaves_out_what_was_registered_with(run, standard_case, tmp_path):
    """A landmark that was registered with never scores, here nor in the result."""
    result, _ = register(run, standard_case, tmp_path / "out")
    assert set(result["jaws"]["upper"]["landmarks_used"]) == {"U1_tip", "U6_MB"}
    rows = errors_of(run, tmp_path / "out", tmp_path)
    for jaw in ("upper", "lower"):
        error = result["jaws"][jaw]["error"]
        assert not any("1_tip" in name or "6_MB" in name for name in error["landmarks"])
        assert int(rows[jaw]["landmarks"]) == len(error["landmarks"])
        assert float(rows[jaw]["mean_px"]) == pytest.approx(error["mean_px"], abs=1e-5)
        assert "found_by" not in error


@pytest.mark.parametrize("preset", ["paper", "single-stage", "bounding-box"])
def test_presets_of_contours_refuse_to_vouch_for_roots(run, outline_case, tmp_path, preset):
    result, said = register(run, outline_case, tmp_path / "out", "--preset", preset)
    for jaw in ("upper", "lower"):
        finding = result["jaws"][jaw]["findings"][0]
        assert (finding["code"], finding["severity"]) == ("whole-teeth", "failed")
        assert "use preset robust" in finding["text"]
        assert f"{jaw}: failed: the outlines" in said


def test_landmarks_alone_have_nothing_to_say_of_sides(run, standard_case, tmp_path):
    """Names without sides mean one thing, whatever was traced; names with sides beside them are what is ignored."""
    content = standard_case.load()
    for field in ("contours", "traced_side"):
        content.pop(field, None)
    standard_case.save(content)
    result, _ = register(run, standard_case, tmp_path / "plain")
    assert result["traced_side"] == "standard" and not any("traced_side" in line for line in result["warnings"])
    marks = standard_case.load("cephalometric.json")
    marks["UR6_MB"] = marks.pop("U6_MB")
    standard_case.save(marks, "cephalometric.json")
    result, _ = register(run, standard_case, tmp_path / "mixed")
    assert any("traced_side: is not given" in line for line in result["warnings"])


def test_one_landmark_has_no_expected_error(run, standard_case, tmp_path):
    content = standard_case.load()
    for field in ("contours", "traced_side"):
        content.pop(field, None)
    content["cephalometric_landmarks"] = {"U1_tip": standard_case.load("cephalometric.json")["U1_tip"]}
    standard_case.save(content)
    result, said = register(run, standard_case, tmp_path / "out")
    for jaw in ("upper", "lower"):
        assert result["jaws"][jaw]["status"] == "failed"
        assert "undetermined" in [finding["code"] for finding in result["jaws"][jaw]["findings"]]
        assert "expected_error_px" not in result["jaws"][jaw]
    assert "expected error" not in said


@pytest.mark.parametrize("jaw", ["upper", "lower"])
def test_rows_counted_from_below_are_told_by_the_principal_point(run, standard_case, tmp_path, jaw):
    """Two marks of one jaw fit mirrored as well as they are: the jaw lies above the ear rods then, 300 px off."""
    content = standard_case.load()
    content.pop("lower" if jaw == "upper" else "upper")
    marks = json.loads((standard_case.folder / content["cephalometric_landmarks"]).read_text())
    height = 938
    content["cephalogram"].pop("image", None)
    content["cephalogram"]["image_size"] = [703, height]
    for upward in (False, True):
        content["cephalometric_landmarks"] = {
            name: [point[0], height - 1 - point[1] if upward else point[1]]
            for name, mark in marks.items()
            if name[0].lower() == jaw[0]
            for point in [mark["position"] if isinstance(mark, dict) else mark]
        }
        standard_case.save(content)
        result, _ = register(run, standard_case, tmp_path / str(upward))
        findings = {each["code"]: each for each in result["jaws"][jaw]["findings"]}
        assert ("upward-drawing" in findings) == upward, findings
        if upward:
            assert result["jaws"][jaw]["status"] == "suspect"
            assert "above the principal point" in findings["upward-drawing"]["text"]
            assert "Count v from its top" in findings["upward-drawing"]["text"]
