"""The report page in a real browser: what a person can do with it, by mouse and by keyboard, at two widths.

Needs Chromium and the package playwright (Utilities/python-venv.sh); skipped where either is missing. Playwright drives the
browser of the system, it brings none."""
import os
import pathlib
import shutil

import pytest

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed in this Python")
BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
if BROWSER is None:
    pytest.skip("there is no Chromium", allow_module_level=True)

WIDTHS = {"wide": (1200, 900), "narrow": (400, 800)}


@pytest.fixture(scope="module")
def page_file(run, sample, tmp_path_factory):
    folder = tmp_path_factory.mktemp("page") / "result"
    done = run("register", sample / "case.json", "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder / "report.html"


@pytest.fixture(scope="module")
def has_bundle(page_file):
    return "Built without npm" not in page_file.read_text()


@pytest.fixture(scope="module")
def browser():
    with sync_api.sync_playwright() as playwright:
        # A software renderer: no machine of ours has a graphics card.
        started = playwright.chromium.launch(
            executable_path=BROWSER,
            args=["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
        )
        yield started
        started.close()


class Opened:
    """A page with what it said and asked for."""

    def __init__(self, browser, file, size, scheme="light"):
        self.context = browser.new_context(
            viewport={"width": size[0], "height": size[1]}, color_scheme=scheme, reduced_motion="reduce"
        )
        self.page = self.context.new_page()
        self.errors, self.requests = [], []
        self.page.on("console", lambda message: self.errors.append(message.text) if message.type in ("error", "warning") else None)
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.goto(file.as_uri())
        self.page.wait_for_timeout(500)


@pytest.fixture(params=WIDTHS)
def opened(request, browser, page_file):
    made = Opened(browser, page_file, WIDTHS[request.param])
    yield made
    made.context.close()


@pytest.fixture
def page(opened):
    return opened.page


def said(opened):
    """Errors and warnings that are the page's; a software renderer's own remarks on its speed are not."""
    return [text for text in opened.errors if "GPU stall" not in text and "GL Driver Message" not in text]


def test_asks_nothing_of_the_network_and_says_no_error(opened, page_file):
    assert [url for url in opened.requests if not url.startswith(("data:", "blob:"))] == [page_file.as_uri()]
    assert said(opened) == []


def test_fits_its_width(opened, page):
    # Wide tables scroll by themselves, the page does not.
    assert page.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth")
    assert page.locator("svg.picture").bounding_box()["width"] > 0.8 * min(1200, page.viewport_size["width"]) - 60


def test_layers_switch(page):
    boxes = page.locator("input[data-layer]")
    assert boxes.count() >= 9
    for box in boxes.all():
        key = box.get_attribute("data-layer")
        layer = page.locator(f'g.layer[data-layer="{key}"]')
        before = box.is_checked()
        assert (layer.get_attribute("hidden") is None) == before, key
        box.click()
        assert (layer.get_attribute("hidden") is None) != before, key
        box.click()
        assert (layer.get_attribute("hidden") is None) == before, key


def test_layer_is_seen_on_the_picture(page):
    pane = page.locator(".pane")
    shown = pane.screenshot()
    page.locator('input[data-layer="tracing"]').uncheck()
    assert pane.screenshot() != shown


def test_tooth_is_marked_by_its_row_and_by_its_outline(page):
    button = page.locator("button.tooth").first
    tooth, jaw = button.get_attribute("data-tooth"), button.get_attribute("data-jaw")
    outline = page.locator(f'path.tracing[data-tooth="{tooth}"][data-jaw="{jaw}"]').first
    button.click()
    assert button.get_attribute("aria-pressed") == "true"
    assert "chosen" in outline.get_attribute("class")
    assert page.locator("path.tracing.chosen").count() == page.locator(
        f'path.tracing[data-tooth="{tooth}"][data-jaw="{jaw}"]'
    ).count()
    button.click()
    assert page.locator("path.tracing.chosen").count() == 0
    outline.dispatch_event("click")
    assert button.get_attribute("aria-pressed") == "true"


def test_zoom_and_pan_by_buttons_and_keys(page):
    box = lambda: [float(x) for x in page.locator("svg.picture").get_attribute("viewBox").split()]
    home = box()
    page.locator("[data-action=in]").click()
    assert box()[2] == pytest.approx(0.7 * home[2])
    page.locator("[data-action=all]").click()
    assert box()[2] > home[2]
    page.locator(".pane").focus()
    page.keyboard.press("0")
    assert box() == pytest.approx(home, abs=0.01)
    page.keyboard.press("ArrowRight")
    assert box()[0] > home[0]
    page.keyboard.press("+")
    assert box()[2] < home[2]


def test_flicker_shows_where_it_began(page):
    before = page.locator("svg.picture").screenshot()
    page.locator("[data-action=flicker]").click()
    assert "flick" in page.locator("svg.picture").get_attribute("class")
    assert page.locator('g.layer[data-layer="stage-start"]').get_attribute("hidden") is None
    assert page.locator("svg.picture").screenshot() != before
    page.locator("[data-action=flicker]").click()
    assert page.locator('g.layer[data-layer="stage-start"]').get_attribute("hidden") is not None


def test_opacity_of_drawing_and_radiograph(page):
    page.locator("[data-action=opacity]").fill("0.2")
    assert page.locator(".drawing").evaluate("element => getComputedStyle(element).opacity") == "0.2"
    page.locator("[data-action=brightness]").fill("0.5")
    assert page.locator("image.radiograph").evaluate("element => getComputedStyle(element).opacity") == "0.5"


def scene_pixels(page):
    """How many colours the scene has, and a digest of it."""
    return page.evaluate(
        """() => {
          const canvas = document.getElementById("scene-canvas"), copy = document.createElement("canvas");
          [copy.width, copy.height] = [canvas.width, canvas.height];
          const context = copy.getContext("2d");
          context.drawImage(canvas, 0, 0);
          const data = context.getImageData(0, 0, copy.width, copy.height).data;
          const colours = new Set();
          let sum = 0;
          for (let i = 0; i < data.length; i += 4) {
            colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
            sum = (sum * 31 + data[i] + 7 * data[i + 1] + 13 * data[i + 2]) % 1000000007;
          }
          return [colours.size, sum];
        }"""
    )


def test_scene_draws_and_every_view_is_another(page, has_bundle):
    if not has_bundle:
        pytest.skip("this build has no scene: npm or its registry was missing")
    page.locator("#scene").scroll_into_view_if_needed()
    assert page.locator("#scene-message").inner_text() == ""
    seen = set()
    for camera in ("front", "side", "source", "above", "all"):
        page.locator(f'button[data-camera="{camera}"]').click()
        colours, digest = scene_pixels(page)
        # Blank would be one colour.
        assert colours > 50, camera
        seen.add(digest)
    assert len(seen) == 5
    page.locator('button[data-camera="front"]').click()
    before = scene_pixels(page)
    page.locator("#scene-canvas").focus()
    page.keyboard.press("ArrowLeft")
    turned = scene_pixels(page)
    assert turned != before
    page.locator('input[data-part="upper"]').uncheck()
    assert scene_pixels(page) != turned


def test_scans_lie_on_their_shadows_seen_from_the_source(page, has_bundle):
    """The tracing on the detector is hidden behind the scan's edge or stands beside it, within the fit: seen from the source the
    scan covers the inside of its silhouette."""
    if not has_bundle:
        pytest.skip("this build has no scene: npm or its registry was missing")
    data = page.evaluate("JSON.parse(document.getElementById('report-data').textContent)")
    assert data["result"]["jaws"]["upper"]["projection_3x4"]
    page.locator('button[data-camera="source"]').click()
    with_scan = scene_pixels(page)
    for part in ("upper", "lower"):
        page.locator(f'input[data-part="{part}"]').uncheck()
    assert scene_pixels(page) != with_scan


def test_plots_are_drawn(page, has_bundle):
    if not has_bundle:
        pytest.skip("this build has no plots: npm or its registry was missing")
    assert page.locator("#plot-residuals svg").count() == 2
    assert page.locator("#plot-course svg").count() >= 1
    assert page.locator("#plot-residuals svg path").count() > 4


def test_keyboard_reaches_everything(page):
    """Tab visits every control that is there, each once, and shows where it is."""
    wanted = page.evaluate(
        """() => [...document.querySelectorAll("a[href], button, input, select, summary, [tabindex='0']")]
          .filter(element => element.checkVisibility())
          .map((element, i) => { element.dataset.stop = i; return i; })"""
    )
    assert len(wanted) > 30
    page.evaluate("document.activeElement.blur(); window.scrollTo(0, 0)")
    reached = set()
    for _ in range(len(wanted) + 20):
        page.keyboard.press("Tab")
        stop, outline = page.evaluate(
            """() => [document.activeElement.dataset.stop ?? null, getComputedStyle(document.activeElement).outlineStyle]"""
        )
        if stop is not None:
            reached.add(int(stop))
            assert outline != "none", page.evaluate("document.activeElement.outerHTML")
    assert reached >= set(wanted), page.evaluate(
        "missing => missing.map(i => document.querySelector(`[data-stop='${i}']`).outerHTML.slice(0, 120))", sorted(set(wanted) - reached)
    )


def test_stands_without_a_script(browser, page_file):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(page_file.as_uri())
    assert "ok" in page.locator(".verdict").inner_text()
    assert page.locator("svg.picture path.tracing").count() > 4
    assert page.locator(".tools").first.is_hidden()
    context.close()


def test_dark_and_light_are_two(browser, page_file):
    grounds = []
    for scheme in ("light", "dark"):
        made = Opened(browser, page_file, WIDTHS["wide"], scheme)
        grounds.append(made.page.evaluate("getComputedStyle(document.body).backgroundColor"))
        made.context.close()
    assert grounds[0] != grounds[1]


def test_hostile_names_run_nothing(browser, run, sample, tmp_path):
    folder = tmp_path / "<img src=x onerror=alert(1)>" / "<script>alert(2)<"
    shutil.copytree(sample, folder)
    done = run("register", folder / "case.json", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    made = Opened(browser, tmp_path / "out/report.html", WIDTHS["wide"])
    dialogs = []
    made.page.on("dialog", lambda dialog: (dialogs.append(dialog.message), dialog.dismiss()))
    # With somebody who listens from the start: what runs, runs as the page is read.
    made.page.reload()
    assert made.page.locator("h1").inner_text() == "<script>alert(2)<"
    assert dialogs == [] and said(made) == []
    made.context.close()


@pytest.mark.skipif("DENTALSCR_SCREENSHOTS" not in os.environ, reason="pictures for Documentation/: set DENTALSCR_SCREENSHOTS to a folder")
def test_take_screenshots(browser, page_file):
    folder = pathlib.Path(os.environ["DENTALSCR_SCREENSHOTS"])
    for name, size in WIDTHS.items():
        for scheme in ("light", "dark"):
            made = Opened(browser, page_file, size, scheme)
            made.page.screenshot(path=folder / f"{name}-{scheme}.png", full_page=True)
            made.context.close()
