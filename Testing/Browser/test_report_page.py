"""The report page in a real browser: what a person can do with it, by mouse and by keyboard, at two widths.

Needs what conftest.py says, and matplotlib."""
import io
import json
import os
import pathlib
import shutil

import pytest

plt = pytest.importorskip("matplotlib.pyplot", reason="matplotlib, which reads screenshots, is not installed in this Python")

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


def test_flicker_compares_silhouettes_where_no_outline_was_matched_as_a_whole(browser, run, tmp_path):
    """A standard tracing: whole teeth, of which the crowns alone are compared. A stage is drawn of the silhouette, and the result's
    takes turns with it."""
    assert run("phantom", "--level", "standard", "--seed", 1, "--output", tmp_path / "case").returncode == 0
    done = run("register", tmp_path / "case" / "case.json", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    made = Opened(browser, tmp_path / "out" / "report.html", WIDTHS["wide"])
    made.page.emulate_media(reduced_motion="no-preference")
    whole, start = (made.page.locator(f'g.layer[data-layer="{key}"]') for key in ("whole", "stage-start"))
    # Of both jaws.
    assert start.locator("path").count() == 2
    assert (whole.is_visible(), start.is_visible()) == (False, False)
    made.page.locator("[data-action=flicker]").click()
    for state in ((False, True), (True, False), (False, True)):
        made.page.wait_for_function(
            """([whole, start]) => ["whole", "stage-start"].every((key, i) =>
              document.querySelector(`g.layer[data-layer="${key}"]`).hasAttribute("hidden") !== [whole, start][i])""",
            arg=state,
        )
    made.page.locator("[data-action=flicker]").click()
    assert (whole.is_visible(), start.is_visible()) == (False, False)
    assert said(made) == []
    made.context.close()


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
    for camera in ("front", "side", "source-0", "above", "all"):
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


# Pixels of the scene by what is shown of it: where a scan is (two, a jaw each), and where the outline that was matched is drawn on
# the detector. Then, of each pixel of the outline, how far the nearest edge of a scan is, as a share of those within `near`.
OUTLINE_ON_EDGES = """near => {
  const canvas = document.getElementById("scene-canvas"), copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d", { willReadFrequently: true });
  const show = parts => {
    for (const input of document.querySelectorAll("input[data-part]"))
      if (input.checked !== parts.includes(input.dataset.part)) input.click();
    context.drawImage(canvas, 0, 0);
    return context.getImageData(0, 0, copy.width, copy.height).data;
  };
  const width = copy.width, height = copy.height, edges = [], outline = [];
  for (const jaw of ["upper", "lower"]) {
    const data = show([jaw]), inside = i => data[4 * i] + data[4 * i + 1] + data[4 * i + 2] > 0x10 + 0x11 + 0x14 + 30;
    for (let v = 1; v + 1 < height; ++v)
      for (let u = 1; u + 1 < width; ++u) {
        const i = v * width + u;
        if (inside(i) && !(inside(i - 1) && inside(i + 1) && inside(i - width) && inside(i + width))) edges.push([u, v]);
      }
  }
  const data = show(["detector"]);
  for (let i = 0; i < width * height; ++i)
    if (data[4 * i] > 150 && data[4 * i + 1] > 90 && data[4 * i + 2] < 60) outline.push([i % width, Math.floor(i / width)]);
  const isNear = ([u, v]) => edges.some(([x, y]) => Math.hypot(x - u, y - v) <= near);
  return [edges.length, outline.length, outline.filter(isNear).length / Math.max(1, outline.length)];
}"""


def test_scans_lie_on_their_shadows_seen_from_the_source(page, has_bundle):
    """Seen from the source a scan's edge is where its outline is drawn on the detector, in pixels of the canvas: source, detector
    and scans are in one frame. Half a millimetre on the detector is two to four of them."""
    if not has_bundle:
        pytest.skip("this build has no scene: npm or its registry was missing")
    check_shadows(page, 0)


def check_shadows(page, view):
    page.locator(f'button[data-camera="source-{view}"]').click()
    page.locator("input[data-scene=opacity]").fill("1")
    edges, outline, share = page.evaluate(OUTLINE_ON_EDGES, 4)
    assert edges > 500 and outline > 150
    # Lines of both jaws are drawn, and where they cross one hides the other.
    assert share > 0.75, share
    # The measure tells: from a place beside the source it is another picture.
    page.locator("#scene-canvas").focus()
    page.keyboard.press("ArrowUp")
    assert page.evaluate(OUTLINE_ON_EDGES, 4)[2] < 0.4


def test_a_detector_hides_nothing_from_behind(page, has_bundle):
    """From there it is a frame: of a view with the source behind the head it stands before the face."""
    if not has_bundle:
        pytest.skip("this build has no scene: npm or its registry was missing")
    page.locator('button[data-camera="source-0"]').click()
    for part in page.locator("input[data-part]").all():
        part.set_checked(part.get_attribute("data-part") == "detector")
    assert scene_pixels(page)[0] > 50
    page.locator("#scene-canvas").focus()
    # Half a turn, by tenths of a radian.
    for _ in range(31):
        page.keyboard.press("ArrowRight")
    # The frame may be around what the lens takes in.
    assert scene_pixels(page)[0] < 20


# The scan as a radiograph, and the outlines of the whole scans: how well what is bright fills them, and how little is outside; and
# the same for outlines that are moved aside.
DRR_AND_OUTLINE = """async ([name, aside]) => {
  const view = [...document.querySelectorAll(".view")].find(one => one.dataset.view === name);
  const drawn = view.querySelector("image.drr"), size = [drawn.width.baseVal.value, drawn.height.baseVal.value];
  const image = new Image();
  image.src = drawn.href.baseVal;
  await image.decode();
  const make = draw => {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = size;
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.translate(0.5, 0.5);
    draw(context);
    const data = context.getImageData(0, 0, ...size).data;
    return Array.from({ length: size[0] * size[1] }, (_, i) => data[4 * i]);
  };
  const bright = make(context => context.drawImage(image, -0.5, -0.5, ...size));
  const inside = make(context => {
    context.fillStyle = "#fff";
    context.translate(aside, 0);
    for (const path of view.querySelectorAll('g[data-layer="whole"] path, g[data-layer="matched"] path'))
      if (path.classList.contains("whole") || !view.querySelector("path.whole")) context.fill(new Path2D(path.getAttribute("d")));
  });
  let both = 0, either = 0;
  for (let i = 0; i < bright.length; ++i) {
    both += bright[i] > 16 && inside[i] > 127;
    either += bright[i] > 16 || inside[i] > 127;
  }
  return both / either;
}"""


def check_drr(page, name):
    view = page.locator(f'.view[data-view="{name}"]')
    box, pane = view.locator('input[data-layer="drr"]'), view.locator(".pane")
    assert not box.is_checked()
    assert page.evaluate(DRR_AND_OUTLINE, [name, 0]) > 0.93
    # The measure tells: twenty pixels aside, 5 mm, are seen.
    assert page.evaluate(DRR_AND_OUTLINE, [name, 20]) < 0.9
    pane.scroll_into_view_if_needed()
    without = pixels_of(pane)
    box.focus()
    page.keyboard.press("Space")
    assert box.is_checked()
    view.locator("[data-action=drr]").fill("1")
    # Of nothing but the scan: where it is not it is black, and more than half of the pane is not of the scan.
    covered = pixels_of(pane)
    assert changed_share(without, covered) > 0.3
    view.locator("[data-action=drr]").fill("0")
    assert changed_share(without, pixels_of(pane)) < 0.001
    view.locator("[data-action=drr]").fill("0.5")
    faint = changed_share(without, pixels_of(pane))
    assert 0.1 < faint
    # With the radiograph alone there is none.
    view.locator("[data-action=peek]").click()
    assert view.locator("image.drr").evaluate("element => getComputedStyle(element).visibility") == "hidden"
    view.locator("[data-action=peek]").click()
    box.focus()
    page.keyboard.press("Space")
    assert changed_share(without, pixels_of(pane)) < 0.001


def pixels_of(locator):
    """Rows of (r, g, b) as the screen has them; the focus' frame is around, not inside."""
    return plt.imread(io.BytesIO(locator.screenshot()), format="png")[4:-4, 4:-4, :3]


def changed_share(before, after):
    return float((abs(before - after).max(axis=2) > 0.04).mean())


def test_what_the_scan_would_look_like_is_a_layer_on_its_outline(page):
    check_drr(page, "lateral")


def test_a_further_view_has_its_own(browser, run, has_bundle, tmp_path):
    parameters = tmp_path / "parameters.json"
    parameters.write_text('{"level": "typical", "frontal": {"given": true}}')
    assert run("phantom", "--parameters", parameters, "--seed", 12, "--output", tmp_path / "case").returncode == 0
    # What is traced from the front are borders of teeth, which are no edges of the scans: without them the detector shows
    # the outlines of the scans alone.
    case = json.loads((tmp_path / "case" / "case.json").read_text())
    del case["views"][0]["contours"]
    (tmp_path / "case" / "case.json").write_text(json.dumps(case))
    done = run("register", tmp_path / "case" / "case.json", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    made = Opened(browser, tmp_path / "out" / "report.html", WIDTHS["wide"])
    for name in ("lateral", "frontal"):
        check_drr(made.page, name)
    if has_bundle:
        for view in range(2):
            check_shadows(made.page, view)
    assert said(made) == []
    made.context.close()


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

    def open_it(file):
        context = browser.new_context()
        opened, dialogs = context.new_page(), []
        opened.on("dialog", lambda dialog: (dialogs.append(dialog.message), dialog.dismiss()))
        opened.goto(file.as_uri())
        opened.wait_for_timeout(500)
        title = opened.locator("h1").first.inner_text()
        context.close()
        return title, dialogs

    page_file = tmp_path / "out/report.html"
    assert open_it(page_file) == ("<script>alert(2)<", [])
    made = Opened(browser, page_file, WIDTHS["wide"])
    assert said(made) == []
    made.context.close()
    # The same page with the name as it is would run it, and that would be found here.
    text, escaped = page_file.read_text(), "&lt;img src=x onerror=alert(1)&gt;"
    assert escaped in text, "the name is not on the page: nothing is tested"
    spoilt = tmp_path / "spoilt.html"
    spoilt.write_text(text.replace(escaped, "<img src=x onerror=alert(1)>"))
    assert "1" in open_it(spoilt)[1]


@pytest.mark.skipif("DENTALSCR_SCREENSHOTS" not in os.environ, reason="pictures for Documentation/: set DENTALSCR_SCREENSHOTS to a folder")
def test_take_screenshots(browser, page_file):
    folder = pathlib.Path(os.environ["DENTALSCR_SCREENSHOTS"])
    for name, size in WIDTHS.items():
        for scheme in ("light", "dark"):
            made = Opened(browser, page_file, size, scheme)
            made.page.screenshot(path=folder / f"{name}-{scheme}.png", full_page=True)
            made.context.close()
