"""Numbers and names that the documentation repeats from the code."""
import math
import pathlib
import re
import shutil
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def verdict_thresholds(verdict="RegistrationVerdict"):
    header = ROOT / f"Modules/Registration/PoseRegistration/include/itk{verdict}.h"
    body = re.search(r"struct Thresholds\n *{(.*?)\n *};", header.read_text(), re.S).group(1)
    return {name: float(value) for name, value in re.findall(r"double\s+(\w+)\{\s*(-?[\d.]+)\s*\}", body)}


def test_verdicts_table_has_the_codes_thresholds():
    """Each rule of the table as it stands there, with the header's number in its place."""
    rules = (ROOT / "Documentation/Robust.md").read_text().split("## Verdict")[1]
    rules = dict(re.findall(r"^\| `([\w-]+)`(?:, `facing`)? \| (.*?) \|", rules, re.M))
    t = verdict_thresholds()
    written = {
        "no-fit": [f"cost > {t['failedCost']:.2f} or < {100 * t['failedInlierShare']:.0f} % of the tracing within 4 px"],
        "poor-fit": [
            f"cost > {t['suspectCost']:.2f}",
            f"p90 > {t['suspectP90']:g}",
            f"median > {t['suspectMedian']:g}",
            f"inliers < {100 * t['suspectInlierShare']:.0f} %",
            f"its own cost ≤ {t['borneOutPoorCost']:g} and inliers ≥ {100 * t['borneOutInlierShare']:.0f} %",
            f"cost of the other ≤ {t['borneOutOtherCost']:g}, drift of both s_c ≤ {t['borneOutSmoothSigma']:g}",
            f"margin ≥ {t['borneOutMargin']:g}",
        ],
        "rough-tracing": [f"drift s_c > {t['suspectSmoothSigma']:g}"],
        "uncertain": [
            f"predicted σ > {t['suspectPredictedSigma']:g} at the tracing or > {t['suspectExtrapolatedSigma']:g} anywhere",
            f"> {t['suspectMiddleSigma']:g} or > {t['suspectLargestMiddleSigma']:g} at the worse",
        ],
        "upside-down": [f"pitch > {t['failedPitch']:g} rad (90°)"],
        "landmark-apart": [f"> {t['landmarkApart']:g} sd"],
        "landmarks-rough": [f"> {t['suspectLandmarkRatio']:g} sd"],
        "outlines-contradict": [f"> {t['suspectOutlineRatio']:g} sd"],
        "bite": [f"> {t['suspectBite']:g} sd", f"{-t['biteMean']:g} mm", f"{t['biteSigma']:g} mm"],
        "ambiguous": [f"margin < {t['suspectMargin']:g}"],
        "prior-tension": [
            f"κ or ty > {t['suspectPriorTension']:g} sd, roll or yaw > {t['suspectRotationTension']:g} sd (17.5°)"
        ],
        "other-side": [f"lower by {-t['suspectOtherSideDeviance']:g}"],
        "inward-winding": [f"< −{-t['suspectWinding']:g} of the area"],
        "film-size": [f"> {t['suspectFilmLength']:g} mm long", f"failed: > {t['failedFilmLength']:g} mm", f"< {t['shortestFilm']:g} mm"],
        "pixel-spacing": [
            f"better by {t['hypothesisGain']:g}",
            f"score ≤ {t['spacingScore']:g}",
            f"{t['spacingDifference']:g} in its logarithm",
            f"at most {t['spacingShare']:g} of what it is",
        ],
        "arch-width": [f"not {t['minimumArchWidth']:g}–{t['maximumArchWidth']:g} mm"],
        "undetermined": [f"> {t['failedPredictedSigma']:g} "],
        "code-offset": [f"> {t['suspectCodeOffset']:g} mm along the arch"],
        "drafts-unmended": [f"> {100 * t['suspectDraftedShare']:.0f} % of the tracing"],
        "search-limit": [f"pitch > {t['suspectPitch']:g} rad ({math.degrees(t['suspectPitch']):.1f}°)"],
        "jaws-exchanged": [f"scores better by {t['hypothesisGain']:g}"],
        "unsure-axis": [f"cost ≤ {t['borneOutCost']:g}", f"margin ≥ {t['borneOutMargin']:g}"],
    }
    for rule, parts in written.items():
        for part in parts:
            assert part in rules[rule], rule
    # None of the thresholds is left out above.
    assert len(t) == 42


def test_views_table_has_the_codes_thresholds():
    rows = (ROOT / "Documentation/Findings.md").read_text().split("## Further views")[1].split("\n## ")[0]
    seen = dict(re.findall(r"^\| `([a-z-]+)` \| suspect \| (.*?) \|", rows, re.M))
    t = verdict_thresholds("ViewVerdict")
    for code, end in {
        "view-disagrees": f"> {t['landmarkApart']:g} sd",
        "view-landmark-apart": f"> {t['landmarkApart']:g} sd",
        "view-landmarks-rough": f"> {t['suspectLandmarkRatio']:g} sd",
        "view-poor-fit": f"cost > {t['suspectCost']:g}",
        "view-head-moved": f"> {t['suspectPriorTension']:g} sd",
    }.items():
        assert seen[code].endswith(end), code
    assert f"lower by {-t['suspectDeviance']:g}, " in seen["view-sides"]
    each = f"by {-t['suspectDevianceOfLandmark']:g} for each landmark and {-t['suspectDevianceOfOutline']:g} for each outline"
    assert each in seen["view-sides"]
    assert f"lower by {-t['suspectMoveDeviance']:g}" in seen["view-head-moved"]
    assert f"turned by > {t['suspectHeadMove']:g} sd" in seen["view-head-moved"]
    assert len(t) == 9


def test_every_finding_is_listed():
    """Every code that any part of the chain gives, with its severity, and no other."""
    severities = {}
    for source in ROOT.glob("Modules/*/*/src/*.cxx"):
        found = re.findall(r'(Suspect|Failed|verdicts\[other\]\.status),\s*"([a-z-]+)"', source.read_text())
        for severity, code in found:
            severities.setdefault(code, set()).add(severity.lower())
    # The film's is chosen by its length, the other jaw's is that jaw's.
    severities["film-size"].add("failed")
    severities["placed-by-other"] = set()
    rows = re.findall(r"^\| `([a-z-]+)` \| (.*?) \|", (ROOT / "Documentation/Findings.md").read_text(), re.M)
    assert sorted(code for code, _ in rows) == sorted(severities)
    for code, severity in rows:
        assert set(re.findall(r"suspect|failed", severity)) == severities[code], code


def test_limits_of_a_principal_point_are_those_of_the_code():
    source = (ROOT / "Modules/Application/CaseRegistration/src/itkPrincipalPointCheck.cxx").read_text()
    limits = dict(re.findall(r"constexpr double (\w+) = (-?[0-9.]+);", source))
    (row,) = re.findall(r"^\| `principal-point` \| .*$", (ROOT / "Documentation/Findings.md").read_text(), re.M)
    for name, words in (
        ("FarthestDistance", "more than {:g} mm from"),
        ("NearDistance", "from {:g} mm on"),
        ("SteepestDirection", "more than {:g}° below"),
        ("SteepestToOcclusal", "({:g}° against the occlusal plane)"),
        ("HighestDirection", "or {:g}° above"),
        ("HighestToOcclusal", "above it ({:g}°)"),
    ):
        assert words.format(abs(float(limits[name]))) in row, name


def test_every_option_is_listed_with_its_default():
    module = ROOT / "Modules/Registration/PoseRegistration"
    table = (module / "src/itkPoseRegistrationOptionTable.cxx").read_text()
    names = re.findall(r"&Options::(\w+)", table)
    assert len(names) > 40
    header = (module / "include/itkPoseRegistrationTypes.h").read_text()
    header = re.search(r"struct PoseRegistrationOptions\n{(.*?)\n};", header, re.S).group(1)
    text = (ROOT / "Documentation/Robust.md").read_text().split("## Options")[1].split("## Verdict")[0]
    for name in names:
        default = re.search(rf"\b{name}{{ *(.*?) *}};", header).group(1)
        if default in ("true", "false"):
            assert (default == "false") == (name == "gateByTooth"), "the page names the switches that are off by default"
            assert f"\n| `{name}` |" in text, name
            continue
        row = re.search(rf"\n\| `{name}` \| (.*?) \|", text)
        assert row, name
        written = [float(number) for number in row.group(1).split(",")]
        assert written == pytest.approx([float(number) for number in default.split(",")], rel=1e-3), name
    listed = re.findall(r"\n\| `(\w+)` \|", text)
    assert sorted(listed) == sorted([*names, "refineMidline"])


def test_fixed_constants_of_robust_are_those_of_the_code():
    """The rows of the page's table that are no options: file of the module, pattern of its number, factor, row."""
    text = (ROOT / "Documentation/Robust.md").read_text().split("## Options")[1].split("## Verdict")[0]
    rows = dict(re.findall(r"^\| ([a-zEP][\w' ,]*) \| (.*? \| .*? \| .*?) \|", text, re.M))
    degrees = 180 / math.pi
    written = {
        "samples of the outline": [("PoseMetric/include/itkPoseContourModel.h", r"double Spacing = (.*?);", 1)],
        "smoothing of the outline's directions": [("PoseMetric/include/itkPoseContourIndex.h", r"Reach = (.*?);", 0.5)],
        "fade of directions": [("PoseMetric/src/itkPoseMatching.h", r"cosine - (.*?)\) /", 1)],
        "usual error, largest weight": [("PoseMetric/src/itkPoseTracing.cxx", r"UsualSigma = (.*?);", 1),
                                        ("PoseMetric/src/itkPoseTracing.cxx", r"LargestWeight = (.*?);", 1)],
        "priors of the levels": [("RegistrationCommon/src/itkContourNoiseModel.cxx", rf"Prior{name} = (.*?);", 1)
                                 for name in ("Smooth", "White", "LogSigma")],
        "scale prior of a DICOM file": [("RegistrationCommon/src/itkScalePrior.cxx", r"Dicom:\s+return (.*?);", 1)],
        "landmark's kernel": [("PoseMetric/include/itkLandmarkPoseMetricv4.h", r"m_KernelWidthInSigmas\{ (.*?) \}", 1),
                              ("PoseMetric/src/itkToothOutlinePoseMetricv4.cxx", r"ToothWidthInSigmas = (.*?);", 1)],
        "template's penalty": [("PoseMetric/src/itkToothOutlinePoseMetricv4.cxx", r"TemplatePenalty = (.*?);", 1)],
        "range and step of rotation": [("PoseRegistration/include/itkPoseStartSearch.h", rf"m_Rotation{name}\{{ (.*?) \}}", degrees)
                                       for name in ("Range", "Step")],
        "range and step of shifts": [("PoseRegistration/include/itkPoseStartSearch.h", rf"m_{name}\{{ (.*?) \}}", 1)
                                     for name in ("HorizontalRange", "VerticalRange", "ShiftStep")],
        "range and step of scale": [("PoseRegistration/include/itkPoseStartSearch.h", r"m_Kappas\{.*, (\S+) \};", 1),
                                    ("PoseRegistration/include/itkPoseStartSearch.h", r"m_Kappas\{.*-(\S+), 0\.07", 1)],
        "truncation and table": [("PoseRegistration/src/itkPoseStartSearch.cxx", rf"{name} = (.*?);", 1)
                                 for name in ("Truncation", "Cell", "Directions")],
        "arm": [("PoseMetric/include/itkPoseStateBlocks.h", r"Arm = (.*?);", 1)],
        "longest step": [("PoseMetric/src/itkPoseStateBlocks.cxx", rf'"{name}", 0.0, \S+, (.*?), true', 1)
                         for name in ("pitch", "roll", "yaw", "tx", "ty", "tz", "kappa")],
        "width at which fits are judged": [("PoseMetric/include/itkPoseSilhouetteKernel.h", r"FitWidth = (.*?);", 1)],
        "shares of E and P": [("PoseRegistration/src/itkCandidatePosterior.cxx", rf"{name}Share = (.*?);", 1)
                              for name in ("Evidence", "Known")],
        "smallest share, same minimum": [("PoseRegistration/src/itkCandidatePosterior.cxx", r"smallestShare = (.*?);", 1),
                                         ("PoseRegistration/src/itkCandidatePosterior.h", r"SameMinimum = (.*?);", 1)],
        "precise drawing": [("PoseRegistration/src/itkPoseGroupRegistration.cxx", r"PreciseFactor = (.*?);", 1)],
    }
    for row, sources in written.items():
        numbers = [float(number) for number in re.findall(r"(?<![\w.])\d+(?:\.\d+)?", rows[row])]
        for file, pattern, factor in sources:
            found = re.search(pattern, (ROOT / "Modules/Registration" / file).read_text())
            assert found, (file, pattern)
            value = factor * float(found.group(1))
            assert any(number == pytest.approx(value, rel=1e-6) for number in numbers), (row, value)
    weights = [(ROOT / "Modules/Registration" / file).read_text() for file in
               ("PoseMetric/src/itkSilhouettePoseMetricv4.cxx", "PoseRegistration/src/itkCandidatePosterior.cxx")]
    assert [re.search(r"SmallestWeight = (.*?);", text).group(1) for text in weights] == ["1e-6", "1e-3"]
    assert rows["smallest weight"].startswith("10⁻⁶; 10⁻³")
    # No row is left out above.
    assert set(rows) - {"constant", "switch"} == {*written, "smallest weight"}


def test_classes_by_concept_are_there():
    """Each class of the index has a header, in the module that stands beside it."""
    text = (ROOT / "Documentation/ClassIndex.md").read_text()
    modules = {path.parent.name: path.parent for path in ROOT.glob("Modules/*/*/itk-module.cmake")}
    everywhere = "\n".join(path.read_text() for path in ROOT.glob("Modules/*/*/include/*.h"))
    for row in re.findall(r"^\| [^|]* \| ([^|]*`[^|]*) \| ([\w, ]+) \|", text, re.M):
        for name in re.findall(r"`(\w+)(?:\(\))?`", row[0]):
            if name == "MeshFileReader":  # ITK's own
                continue
            folders = [modules[module.strip()] for module in row[1].split(",")]
            headers = "\n".join(path.read_text() for folder in folders for path in folder.glob("include/*.h"))
            assert re.search(rf"\b{name}\b", headers), (name, row[1])
    for name in ("PoseRefinement", "PoseEstimator", "PoseRegistrationKernel"):
        assert name not in text and not re.search(rf"class \w+ {name}\b", everywhere)


def test_links_of_the_documentation_lead_somewhere():
    for page in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *ROOT.glob("Documentation/*.md"), *ROOT.glob("Examples/**/*.md")]:
        # A lambda of C++ looks like a link.
        text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.S | re.M)
        for target in re.findall(r"\]\(([^)#\s]+)", text):
            if "://" not in target:
                assert (page.parent / target).exists(), (page.name, target)


def test_phantoms_page_has_every_parameter_with_its_default():
    """The table of Phantom.md against that of the code."""
    source = (ROOT / "Modules/Simulation/DentalPhantom/src/itkDentalPhantomLevel.cxx").read_text()
    header = (ROOT / "Modules/Simulation/DentalPhantom/include/itkDentalPhantomLevel.h").read_text()
    defaults = dict(re.findall(r"^  (?:double|bool|unsigned int|std::string)\s+(\w+)\{ (.*?) \};", header, re.M))
    table = source.split("DentalPhantomLevel::GetEntries() ->")[1].split("return entries")[0]
    sections = "head|machine|arch|traits|scan|tracing|landmarks|frontal|radiograph"
    rows = re.findall(rf'\{{\s*"({sections})",\s*"(\w+)",\s*".*?&L::(\w+),', table, re.S)
    # A member without an entry would be neither written, read nor compared.
    assert {member for _, _, member in rows} == set(defaults) - {"name"}
    page = (ROOT / "Documentation/Phantom.md").read_text()
    for section, key, member in rows:
        found = re.search(rf"^\| `{section}\.{key}` \| (.*?) \|", page, re.M)
        assert found, f"{section}.{key}"
        default = defaults[member].strip('"')
        if default in ("true", "false") or not re.fullmatch(r"[-\d.e]+", default):
            assert found.group(1) == default, key
        else:
            assert float(found.group(1)) == float(default), key


def test_phantoms_page_shows_every_trait():
    source = (ROOT / "Modules/Simulation/DentalPhantom/src/itkDentalPhantomTraits.cxx").read_text()
    traits = set(re.findall(r'Note\(\{ "(\w+)"', source)) | set(re.findall(r'trait\{ "(\w+)"', source))
    traits |= set(re.findall(r'\{ "(\w+)", scan\.', source))
    assert len(traits) >= 15
    rows = (ROOT / "Documentation/Phantom.md").read_text().split("## Traits")[1].split("\n## ")[0]
    for trait in traits:
        row = re.search(rf"^\|[^|]*`{trait}`[^|]*\| !\[\]\((.*?)\)", rows, re.M)
        assert row, trait
        assert (ROOT / "Documentation" / row.group(1)).is_file(), trait


def test_every_process_object_is_in_the_pipeline():
    """Those that can be made, of all headers that are installed."""
    bases, made = {}, set()
    for header in ROOT.glob("Modules/*/*/include/*.h"):
        text = header.read_text()
        for name, base in re.findall(r"^class\s+(?:\w+_EXPORT\s+)?(\w+)\s*:\s*public\s+(?:itk::)?(\w+)", text, re.M):
            bases[name] = base
        if "itkNewMacro(Self)" in text:
            made.add(header.stem[3:])

    def root_of(name):
        while name in bases:
            name = bases[name]
        return name

    of_itk = {"ProcessObject", "ImageSource", "GenerateImageSource", "MeshSource", "MeshToMeshFilter", "ImageToMeshFilter"}
    objects = {name for name in made if root_of(name) in of_itk}
    assert len(objects) > 50
    page = (ROOT / "Documentation/Pipeline.md").read_text()
    assert sorted(name for name in objects if f"`{name}`" not in page) == []


def test_classes_have_pages_in_a_checkout_below_any_folder(tmp_path):
    """A path with "src" and "test" in it once gave no page, no warning and exit code 0."""
    if shutil.which("doxygen") is None:
        pytest.skip("doxygen is not installed")
    tree = tmp_path / "src" / "test" / "it's mine"
    for file in [*ROOT.glob("Modules/*/*/include/*.h"), *ROOT.glob("Modules/*/*/itk-module.cmake"),
                 *map(ROOT.joinpath, ("CMakeLists.txt", "Documentation/Doxyfile", "Utilities/doxygen.sh",
                                           "Utilities/doxygen_filter.py"))]:
        copy = tree / file.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, copy)
    run = [tree / "Utilities/doxygen.sh"]
    done = subprocess.run(run, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    assert (tree / "build/doxygen/html/classitk_1_1CephalometricGeometry.html").is_file()
    # One member without words is enough, of a structure too.
    for file in tree.glob("Modules/*/*/itk-module.cmake"):
        if file.parent.name != "DentalCommon":
            shutil.rmtree(file.parent)
    surface = tree / "Modules/Core/DentalCommon/include/itkTriangleSurface.h"
    words = re.search(r"std::vector<PointType> +points; +(/\*\*< .*? \*/)", surface.read_text()).group(1)
    surface.write_text(surface.read_text().replace(words, ""))
    done = subprocess.run(run, capture_output=True, text=True, timeout=300)
    assert done.returncode != 0 and "Member points (variable)" in done.stderr, done.stdout + done.stderr
    for file in tree.glob("Modules/*/*/include/*.h"):
        file.write_text("")
    done = subprocess.run(run, capture_output=True, text=True, timeout=300)
    assert done.returncode != 0 and "0 classes" in done.stderr
