"""Outlines of whole teeth: what is no whole tooth, and what nobody drew."""
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
