"""The tracing page in a real browser, used as a person does: by mouse, finger and keyboard, at two widths.

Needs what conftest.py says."""
import base64
import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import time
import zlib

import pytest

WIDTHS = {"wide": (1600, 1000), "narrow": (400, 800)}


class Opened:
    """A tracing page with the hands of a person."""

    def __init__(self, browser, address, size=WIDTHS["wide"], touch=False, context=None):
        self.context = context or browser.new_context(
            viewport={"width": size[0], "height": size[1]}, has_touch=touch, accept_downloads=True
        )
        self.page = self.context.new_page()
        self.page.set_default_timeout(120000)
        self.errors, self.requests, self.answers = [], [], []
        self.page.on("console", lambda m: self.errors.append(m.text) if m.type in ("error", "warning") else None)
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("response", lambda answer: self.answers.append(answer))
        self.page.goto(address)
        self.wait("document.querySelectorAll('#chart button').length > 0")

    def wait(self, expression):
        """Until it is true. Playwright's own wait_for_function() evaluates strings in the page, which its policy forbids."""
        end = time.monotonic() + 120
        while not self.page.evaluate(expression):
            assert time.monotonic() < end, f"{expression}: {self.said()}"
            self.page.wait_for_timeout(20)

    def screen(self, point):
        """Where on the screen a continuous pixel index is, by the picture's own geometry."""
        return self.page.evaluate(
            """([u, v]) => {
              const svg = document.querySelector("svg.picture"), film = svg.querySelector("image");
              const data = JSON.parse(document.getElementById("tracing-data").textContent);
              const at = new DOMPoint(u, v * data.aspect).matrixTransform(svg.getScreenCTM());
              return [at.x, at.y];
            }""",
            list(point),
        )

    def click(self, point):
        self.page.mouse.click(*self.screen(point))

    def look_at(self, point, turns=10):
        """Zooms in on a place with the wheel, as a person who wants to be exact."""
        self.page.locator("[data-action=home]").click()
        for _ in range(turns):
            self.page.mouse.move(*self.screen(point))
            self.page.mouse.wheel(0, -200)
            self.settle()

    def settle(self):
        self.page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def download(self, what):
        with self.page.expect_download() as waiting:
            self.page.locator(f"[data-action=download-{what}]").click()
        return json.loads(pathlib.Path(waiting.value.path()).read_text())

    def said(self):
        return self.page.locator("#said").inner_text()

    def close(self):
        self.context.close()


@pytest.fixture
def open_page(browser):
    made = []

    def call(address, **keywords):
        made.append(Opened(browser, address, **keywords))
        return made[-1]

    yield call
    for page in made:
        page.close()


@pytest.fixture
def page_file(run, sample, tmp_path):
    def call(*arguments):
        done = run("trace", *arguments, "--page", tmp_path / "page.html")
        assert done.returncode == 0, done.stderr
        return (tmp_path / "page.html").as_uri()

    return call


@pytest.fixture
def serve(program):
    """Starts the verb, gives its address, ends it by Ctrl-C."""
    started = []

    def call(*arguments):
        process = subprocess.Popen([str(program), "trace", *map(str, arguments)], stdout=subprocess.PIPE, text=True)
        started.append(process)
        address = process.stdout.readline().strip()
        assert address.startswith("http://127.0.0.1:")
        return address

    yield call
    for process in started:
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=60) == 0


def write_png(path, rows):
    """Grey, 8 bits."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    data = b"".join(b"\0" + bytes(row) for row in rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))


def quadrant(width, height, left, top):
    """Dark, and bright from a column and a row on."""
    return [[250 if u >= left and v >= top else 10 for u in range(width)] for v in range(height)]


def edge(opened, axis, at):
    """Where on the screen the picture turns from dark to bright, along a row (axis 0) or a column (1) through a place of
    the screen: measured in a picture of the screen, hence by nothing of the page's own arithmetic."""
    # Between pixels a browser interpolates in sixteenths of one, which is less than what is asked of the page.
    opened.page.add_style_tag(content="#drawing, #drafts, #aim { display: none } .film { image-rendering: pixelated }")
    opened.settle()
    box = opened.page.locator(".pane").bounding_box()
    strip = dict(box)
    strip[("y", "x")[axis]] = round(at[1 - axis])
    strip[("height", "width")[axis]] = 1
    shot = base64.b64encode(opened.page.screenshot(clip=strip)).decode()
    grey = opened.page.evaluate(
        """async shot => {
          const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(shot), c => c.charCodeAt(0))], { type: "image/png" }));
          const canvas = new OffscreenCanvas(bitmap.width, bitmap.height), context = canvas.getContext("2d");
          context.drawImage(bitmap, 0, 0);
          return [...context.getImageData(0, 0, bitmap.width, bitmap.height).data].filter((_, i) => i % 4 === 0);
        }""",
        shot,
    )
    middle = (min(grey) + max(grey)) / 2
    assert max(grey) - min(grey) > 100
    (first,) = [i for i in range(len(grey) - 1) if (grey[i] < middle) != (grey[i + 1] < middle)]
    # A pixel of the screen covers the stretch to the next one: its middle is half of it further.
    return box["xy"[axis]] + first + 0.5 + (middle - grey[first]) / (grey[first + 1] - grey[first])


def click_the_corner(opened, expected, into=(1, 1)):
    """Zooms in until a pixel of the screen is less than a hundredth of one of the radiograph, and clicks the bright
    quadrant's corner where it is seen. `into`: to which side of it the quadrant lies."""
    opened.look_at(expected, turns=20)
    (x, y), (inside_x, inside_y) = opened.screen(expected), opened.screen([e + 1.5 * i for e, i in zip(expected, into)])
    assert abs(inside_x - x) > 150 and abs(inside_y - y) > 150
    seen = edge(opened, 0, (x, inside_y)), edge(opened, 1, (inside_x, y))
    # The screen's pixel in which it lies: mice know no fractions.
    opened.page.mouse.click(int(seen[0]), int(seen[1]))
    (place,) = opened.download("landmarks").values()
    assert place == [pytest.approx(coordinate, abs=0.01) for coordinate in expected]
    # What is drawn there is shown there.
    assert opened.screen(place) == [pytest.approx(coordinate, abs=1) for coordinate in seen]


@pytest.mark.parametrize("spacing", [None, (0.25, 0.4), (0.4, 0.25)])
def test_a_click_is_where_the_eye_saw_it(open_page, page_file, tmp_path, spacing):
    """The corner between four pixels is clicked where it is seen, to 0.01 px: an error of half a pixel would be seen, and
    one in the stretch of pixels that are not square."""
    write_png(tmp_path / "corner.png", quadrant(208, 160, 64, 48))
    opened = open_page(page_file(tmp_path / "corner.png", *(() if spacing is None else ("--spacing", *spacing))))
    # Pixel 64 begins at 63.5.
    click_the_corner(opened, (63.5, 47.5))
    if spacing:
        shape = opened.page.evaluate(
            "() => { const box = document.querySelector('image').getBoundingClientRect(); return box.width / box.height; }"
        )
        assert shape == pytest.approx(208 * spacing[0] / (160 * spacing[1]), rel=1e-3)


# Where the stored column c and row r of 160 x 96 pixels go in the upright picture, by EXIF orientation.
TURNS = {1: lambda c, r: (c, r), 3: lambda c, r: (159 - c, 95 - r), 6: lambda c, r: (95 - r, c), 8: lambda c, r: (r, 159 - c)}


def make_turned_jpeg(browser, orientation):
    """160 x 96 stored pixels, bright from column 48 and row 32 on, with an EXIF orientation."""
    page = browser.new_page()
    text = page.evaluate(
        """() => {
          const canvas = document.createElement("canvas");
          [canvas.width, canvas.height] = [160, 96];
          const context = canvas.getContext("2d");
          context.fillStyle = "#111"; context.fillRect(0, 0, 160, 96);
          context.fillStyle = "#fff"; context.fillRect(48, 32, 160, 96);
          return canvas.toDataURL("image/jpeg", 1).split(",")[1];
        }"""
    )
    page.close()
    jpeg = base64.b64decode(text)
    exif = b"Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0" + bytes([orientation]) + b"\0\0\0\0\0\0"
    return jpeg[:2] + b"\xff\xe1" + struct.pack(">H", len(exif) + 2) + exif + jpeg[2:]


@pytest.mark.parametrize("orientation", TURNS)
def test_a_picture_that_the_camera_turned_is_upright(open_page, page_file, browser, tmp_path, orientation):
    """The toolkit counts the pixels of the upright picture, and so does the page."""
    (tmp_path / "turned.jpg").write_bytes(make_turned_jpeg(browser, orientation))
    opened = open_page(page_file(tmp_path / "turned.jpg"))
    data = json.loads(opened.page.locator("#tracing-data").text_content())
    assert data["image_size"] == ([160, 96] if orientation < 5 else [96, 160])
    expected = TURNS[orientation](47.5, 31.5)
    # The bright quadrant lies to another side of the corner in each.
    into = [1 if after > before else -1 for before, after in zip(expected, TURNS[orientation](60, 44))]
    click_the_corner(opened, expected, into)


@pytest.mark.parametrize("width", WIDTHS)
def test_page_by_itself_asks_nothing_and_fits(open_page, page_file, sample, width):
    address = page_file(sample / "ceph.png", "--output", sample / "contours.json")
    opened = open_page(address, size=WIDTHS[width])
    assert [url for url in opened.requests if not url.startswith(("data:", "blob:"))] == [address]
    assert opened.errors == []
    assert opened.page.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth")
    assert opened.page.locator("#chart button.drawn").count() > 8


def test_what_is_read_is_written_again(open_page, page_file, sample):
    """Files made by others, with all that they hold: not a digit is lost, and no field."""
    opened = open_page(page_file(sample / "ceph.png"))
    tracing = json.loads((sample / "contours.json").read_text())
    tracing["_note"] = "mine"
    tracing["contours"]["upper"][0].update(weights=[0.5] * len(tracing["contours"]["upper"][0]["points"]), sigma_px=1.25)
    marks = {"U1_tip": {"position": [500.123456789, 400.5], "sigma_px": 2.0}, "S": [100.0, 100.0], "_by": "reader 1"}
    files = [{"name": name, "mimeType": "application/json", "buffer": json.dumps(content).encode()} for name, content in (("c.json", tracing), ("l.json", marks))]
    opened.page.locator("#open").set_input_files(files)
    opened.wait("document.querySelector('#said').textContent.includes('opened')")
    assert opened.download("contours") == tracing
    assert opened.download("landmarks") == marks


def test_fdi_codes_become_the_charts(open_page, page_file, sample):
    opened = open_page(page_file(sample / "ceph.png"))
    size = json.loads((sample / "contours.json").read_text())["image_size"]
    for numbering, code, chart in (("FDI", "46", "LR6"), ("universal", "30", "LR6"), ("UR", "ur-1", "UR1"), ("FDI", 21, "UL1")):
        jaw = "upper" if chart[0] == "U" else "lower"
        tracing = {"image_size": size, "numbering": numbering, "contours": {jaw: [{"code": code, "points": [[300, 300], [310, 300]]}]}}
        opened.page.locator("#open").set_input_files({"name": "c.json", "mimeType": "application/json", "buffer": json.dumps(tracing).encode()})
        opened.wait(f"document.querySelector('[data-code={chart}]').classList.contains('drawn')")
        written = opened.download("contours")
        assert written["contours"][jaw][0]["code"] == chart and "numbering" not in written


def test_tracing_of_another_radiograph_is_refused(open_page, page_file, sample):
    opened = open_page(page_file(sample / "ceph.png"))
    tracing = {"image_size": [10, 20], "contours": {"upper": [{"code": "UR1", "points": [[1, 1], [2, 2]]}]}}
    opened.page.locator("#open").set_input_files({"name": "c.json", "mimeType": "application/json", "buffer": json.dumps(tracing).encode()})
    opened.wait("document.querySelector('#said').classList.contains('problem')")
    assert "image_size" in opened.said() and opened.page.locator("#chart .drawn").count() == 0


def test_outlines_teeth_by_mouse_and_keys(open_page, page_file, sample):
    opened = open_page(page_file(sample / "ceph.png"))
    page = opened.page
    page.locator("#chart [data-code=UR1]").click()
    points = [(300, 300), (320, 330), (340, 300)]
    for point in points:
        opened.click(point)
    page.locator(".pane").focus()
    page.keyboard.press("Enter")
    # The next tooth is ready.
    assert page.locator("#chart [data-code=UR2]").get_attribute("aria-pressed") == "true"
    for point in ((260, 300), (250, 320), (240, 300)):
        opened.click(point)
    # A click on the first point closes.
    opened.click((260, 300))
    page.locator("#chart [data-code=LL6]").click()
    for point in ((300, 400), (310, 420)):
        opened.click(point)
    drawn = opened.download("contours")
    upper = {contour["code"]: contour for contour in drawn["contours"]["upper"]}
    assert [len(upper[code]["points"]) for code in ("UR1", "UR2")] == [3, 3]
    # A mouse tells which pixel of the screen it is in, and its middle is meant: half of one is what a click may be off.
    (left, top), (right, bottom) = opened.screen((0, 0)), opened.screen((100, 100))
    half = (50 / (right - left) + 1e-3, 50 / (bottom - top) + 1e-3)
    for got, meant in zip(upper["UR1"]["points"], points):
        assert got == [pytest.approx(meant[0], abs=half[0]), pytest.approx(meant[1], abs=half[1])]
    assert upper["UR2"]["closed"] is True and "closed" not in upper["UR1"]
    assert [contour["code"] for contour in drawn["contours"]["lower"]] == ["LL6"]

    # Undo step by step, and forth again.
    count = lambda: sum(len(c["points"]) for jaw in opened.download("contours")["contours"].values() for c in jaw)
    assert count() == 8
    page.keyboard.press("Control+z")
    assert count() == 7
    page.locator("[data-action=undo]").click()
    page.locator("[data-action=undo]").click()
    # The closing was a step of its own.
    assert "closed" not in {c["code"]: c for c in opened.download("contours")["contours"]["upper"]}["UR2"]
    for _ in range(3):
        page.keyboard.press("Control+y")
    assert opened.download("contours") == drawn

    # Drag a point, nudge it, delete it, add one.
    page.keyboard.press("v")
    opened.look_at((320, 320), turns=6)
    opened.click((310, 315))
    page.mouse.move(*opened.screen(upper["UR1"]["points"][1]))
    page.mouse.down()
    page.mouse.move(*opened.screen((322, 338)), steps=5)
    page.mouse.up()
    moved = opened.download("contours")["contours"]["upper"][0]["points"]
    assert moved[1] == [pytest.approx(322, abs=0.3), pytest.approx(338, abs=0.3)] and moved[0] == upper["UR1"]["points"][0]
    page.locator(".pane").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowDown")
    nudged = opened.download("contours")["contours"]["upper"][0]["points"][1]
    assert nudged == [pytest.approx(moved[1][0] + 0.1), pytest.approx(moved[1][1] + 1.0)]
    page.locator("[data-action=insert]").click()
    assert len(opened.download("contours")["contours"]["upper"][0]["points"]) == 4
    page.locator("[data-action=delete]").click()
    page.locator("[data-action=delete]").click()
    left = opened.download("contours")["contours"]["upper"][0]["points"]
    assert left == [moved[0], moved[2]]
    assert opened.errors == []


def test_keyboard_alone_draws(open_page, page_file, sample):
    """Space puts a point where the cross in the middle is; the arrows move the picture under it."""
    opened = open_page(page_file(sample / "ceph.png"))
    page = opened.page
    page.locator(".pane").focus()
    for key in ("+", "+", "ArrowRight", "Space", "ArrowDown", "Space"):
        page.keyboard.press(key)
    marks = opened.download("landmarks")
    assert set(marks) == {"U1_tip", "L1_tip"}
    assert marks["L1_tip"][0] == pytest.approx(marks["U1_tip"][0]) and marks["L1_tip"][1] > marks["U1_tip"][1]
    assert page.locator("#aim path").count() == 1


def test_finger_places_and_two_fingers_zoom(open_page, page_file, sample):
    opened = open_page(page_file(sample / "ceph.png"), size=WIDTHS["narrow"], touch=True)
    page = opened.page
    page.locator(".pane").scroll_into_view_if_needed()
    page.touchscreen.tap(*opened.screen((400, 500)))
    (place,) = opened.download("landmarks").values()
    # A screen's pixel is two of the radiograph here.
    assert place == [pytest.approx(400, abs=2), pytest.approx(500, abs=2)]
    before = float(page.locator("svg.picture").get_attribute("viewBox").split()[2])
    page.locator(".pane").scroll_into_view_if_needed()
    box = page.locator(".pane").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    session = opened.context.new_cdp_session(page)
    touch = lambda kind, spread: session.send(
        "Input.dispatchTouchEvent",
        {"type": kind, "touchPoints": [] if spread is None else [{"x": x - spread, "y": y, "id": 0}, {"x": x + spread, "y": y, "id": 1}]},
    )
    touch("touchStart", 30)
    for spread in (40, 50, 60):
        touch("touchMove", spread)
    touch("touchEnd", None)
    opened.settle()
    assert float(page.locator("svg.picture").get_attribute("viewBox").split()[2]) == pytest.approx(before / 2, rel=0.1)
    # Nothing was drawn by that.
    assert len(opened.download("landmarks")) == 1


def test_finger_outlines_a_tooth_and_drags_a_point(open_page, page_file, sample):
    """On a telephone's width the picture stays in sight while the tooth is chosen below it."""
    opened = open_page(page_file(sample / "ceph.png"), size=WIDTHS["narrow"], touch=True)
    page = opened.page
    page.locator("#chart [data-code=LL8]").scroll_into_view_if_needed()
    page.locator("#chart [data-code=UR1]").tap()
    box = page.locator(".pane").bounding_box()
    assert box["y"] >= 0 and box["y"] + box["height"] < 0.6 * WIDTHS["narrow"][1]
    for point in ((250, 400), (350, 480), (450, 400)):
        page.touchscreen.tap(*opened.screen(point))
    (drawn,) = opened.download("contours")["contours"]["upper"]
    assert drawn["code"] == "UR1" and len(drawn["points"]) == 3
    session = opened.context.new_cdp_session(page)
    start, end = opened.screen(drawn["points"][1]), opened.screen((350, 560))
    for kind, place in (("touchStart", start), ("touchMove", [(a + b) / 2 for a, b in zip(start, end)]), ("touchMove", end), ("touchEnd", None)):
        points = [] if place is None else [{"x": place[0], "y": place[1], "id": 0}]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    opened.settle()
    (moved,) = opened.download("contours")["contours"]["upper"]
    assert moved["points"][1] == [pytest.approx(350, abs=3), pytest.approx(560, abs=3)]
    assert moved["points"][0] == drawn["points"][0]
    assert opened.errors == []


def test_contrast_changes_what_is_seen(open_page, page_file, sample):
    opened = open_page(page_file(sample / "ceph.png"))
    pane = opened.page.locator(".pane")
    seen = {pane.screenshot()}
    opened.page.locator("[data-film=contrast]").fill("3")
    seen.add(pane.screenshot())
    opened.page.locator("[data-film=brightness]").fill("0.5")
    seen.add(pane.screenshot())
    opened.page.locator("[data-film=invert]").check()
    seen.add(pane.screenshot())
    assert len(seen) == 4


def test_a_landmark_is_put_where_it_is_clicked(open_page, page_file, sample):
    """Cusps of both jaws lie on each other, and an outline goes through the tip that was clicked before."""
    opened = open_page(page_file(sample / "ceph.png"))
    page = opened.page
    points = [(500, 600), (503, 602), (498, 604), (501, 598)]
    for point, name in zip(points, ("U1_tip", "L1_tip", "U6_MB", "L6_MB")):
        # What the next click does is said.
        assert f"Click {name}, the " in page.locator("#hint").inner_text()
        opened.click(point)
    marks = opened.download("landmarks")
    for point, name in zip(points, ("U1_tip", "L1_tip", "U6_MB", "L6_MB")):
        assert marks[name] == [pytest.approx(coordinate, abs=1) for coordinate in point], name
    page.locator("#chart [data-code=UR1]").click()
    assert "along the outline of UR1" in page.locator("#hint").inner_text()
    for point in ((450, 580), (500, 600), (560, 580)):
        opened.click(point)
    (drawn,) = opened.download("contours")["contours"]["upper"]
    assert len(drawn["points"]) == 3 and drawn["points"][1] == [pytest.approx(500, abs=1), pytest.approx(600, abs=1)]
    assert opened.download("landmarks") == marks
    assert opened.errors == []


def test_a_tracing_without_sides_has_its_chart(open_page, page_file, sample, tmp_path):
    size = json.loads((sample / "contours.json").read_text())["image_size"]
    tracing = {"image_size": size, "contours": {"upper": [{"code": "U6", "points": [[300, 300], [310, 300]]}]}}
    (tmp_path / "c.json").write_text(json.dumps(tracing))
    opened = open_page(page_file(sample / "ceph.png", "--contours", tmp_path / "c.json"))
    assert "drawn" in opened.page.locator("#chart [data-code=U6]").get_attribute("class")


def test_what_labelme_and_slicer_read_of_it_agrees(open_page, page_file, run, browser, tmp_path):
    """A photograph that the camera turned, with pixels that are not square: what is drawn comes back through the files
    of both programs, and is there by their own rules: labelme counts from the corner of the upright picture, Slicer in mm
    from the first pixel's centre."""
    (tmp_path / "turned.jpg").write_bytes(make_turned_jpeg(browser, 6))
    spacing = (0.25, 0.4)
    grid = ("--spacing", *spacing, "--markups-spacing", *spacing)
    opened = open_page(page_file(tmp_path / "turned.jpg", *grid))
    for point in ((20.3, 30.7), (50, 90)):
        opened.click(point)
    for code, ends in (("UR1", False), ("LL6", True)):
        opened.page.locator(f"#chart [data-code={code}]").click()
        for point in ((10, 10), (40, 20), (30, 60)):
            opened.click(point)
        if ends:
            opened.page.locator("#closed").check()
    own = {"contours": opened.download("contours"), "landmarks": opened.download("landmarks")}
    files = {"labelme": tmp_path / "turned.json", "slicer": tmp_path / "turned.mrk.json"}
    for program, file in files.items():
        file.write_text(json.dumps(opened.download(program)))
    near = lambda point: [pytest.approx(coordinate, abs=1e-3) for coordinate in point]

    shapes = json.loads(files["labelme"].read_text())
    assert (shapes["imageWidth"], shapes["imageHeight"], shapes["imagePath"]) == (96, 160, "turned.jpg")
    by_label = {shape["label"]: shape for shape in shapes["shapes"]}
    assert by_label["U1_tip"]["points"] == [near([c + 0.5 for c in own["landmarks"]["U1_tip"]])]
    assert (by_label["UR1"]["shape_type"], by_label["LL6"]["shape_type"]) == ("linestrip", "polygon")
    markups = {markup["name"]: markup for markup in json.loads(files["slicer"].read_text())["markups"]}
    (tip, _) = markups["landmarks"]["controlPoints"]
    assert tip["label"] == "U1_tip"
    assert tip["position"] == near([c * s for c, s in zip(own["landmarks"]["U1_tip"], spacing)] + [0])
    assert (markups["UR1"]["type"], markups["LL6"]["type"]) == ("Curve", "ClosedCurve")

    for file in files.values():
        again = tmp_path / "again.html"
        done = run("trace", tmp_path / "turned.jpg", *grid, "--contours", file, "--cephalometric-landmarks", file, "--page", again)
        assert done.returncode == 0, done.stderr
        data = json.loads(re.search(r'id="tracing-data">(.*?)</script>', again.read_text(), re.S).group(1))
        assert set(data["landmarks"]) == set(own["landmarks"])
        for name, place in own["landmarks"].items():
            assert data["landmarks"][name] == near(place), (file, name)
        for jaw, contours in own["contours"]["contours"].items():
            read = data["contours"]["contours"][jaw]
            assert [(c["code"], c.get("closed")) for c in read] == [(c["code"], c.get("closed")) for c in contours]
            for c, r in zip(contours, read):
                assert r["points"] == [near(point) for point in c["points"]], (file, c["code"])


def test_state_of_the_files_is_in_sight(open_page, serve, page_file, sample, tmp_path):
    """Whether anything would be lost: said above the picture, whatever is done."""
    state = lambda opened: opened.page.locator("#state").inner_text()
    alone = open_page(page_file(sample / "ceph.png"))
    assert state(alone) == ""
    alone.click((400, 500))
    assert state(alone) == "Kept in this browser, not in a file"
    file = tmp_path / "l.json"
    file.write_text('{"U1_tip": [300, 300]}')
    opened = open_page(serve(sample / "ceph.png", "--landmarks", file))
    assert state(opened) == "Saved"
    opened.click((400, 500))
    assert state(opened) == "Not saved"
    opened.page.keyboard.press("Control+s")
    opened.wait("document.querySelector('#state').textContent === 'Saved'")
    # Another program writes: what cannot be saved is not said to be.
    file.write_text("{}")
    opened.click((420, 520))
    opened.page.keyboard.press("Control+s")
    opened.wait("document.querySelector('#said').classList.contains('problem')")
    assert state(opened) == "Not saved" and "another program" in opened.said()
    assert file.read_text() == "{}"


def test_what_was_drawn_outlives_the_page(open_page, page_file, sample):
    opened = open_page(page_file(sample / "ceph.png"))
    opened.click((400, 500))
    marks = opened.download("landmarks")
    opened.page.reload()
    opened.wait("document.querySelectorAll('#chart button').length > 0")
    assert "is back" in opened.said()
    assert opened.download("landmarks") == marks
    opened.page.locator("[data-action=undo]").click()
    assert opened.page.locator("[data-action=download-landmarks]").is_disabled()


def test_page_saves_itself_and_its_end_is_the_programs(open_page, program, sample, tmp_path):
    """A file that is new is written as one draws; a page that is loaded again goes on with it; who closes it is done."""
    process = subprocess.Popen(
        [str(program), "trace", str(sample / "ceph.png"), "--landmarks", str(tmp_path / "l.json")], stdout=subprocess.PIPE, text=True
    )
    opened = open_page(process.stdout.readline().strip())
    opened.click((400, 500))
    opened.wait("document.querySelector('#saved').textContent.startsWith('Saved')")
    (place,) = json.loads((tmp_path / "l.json").read_text()).values()
    assert place == [pytest.approx(400, abs=1), pytest.approx(500, abs=1)]
    opened.page.reload()
    opened.wait("document.querySelectorAll('#landmarks .drawn').length === 1")
    # Saved, hence not said to be unsaved.
    assert "is back" not in opened.said()
    # The file is not new any more, but it is this page's.
    opened.click((420, 520))
    opened.wait("document.querySelector('#saved').textContent.startsWith('Saved')")
    assert set(json.loads((tmp_path / "l.json").read_text())) == {"U1_tip", "L1_tip"}
    opened.page.close(run_before_unload=True)
    assert process.wait(timeout=60) == 0
    assert opened.errors == []


def test_file_that_was_there_is_written_when_saved(open_page, serve, sample, tmp_path):
    before = '{"U1_tip": [300, 300]}'
    (tmp_path / "l.json").write_text(before)
    opened = open_page(serve(sample / "ceph.png", "--landmarks", tmp_path / "l.json"))
    opened.wait("document.querySelectorAll('#landmarks .drawn').length === 1")
    # The next one is ready: what is there is not moved.
    opened.click((400, 500))
    opened.page.wait_for_timeout(2000)
    assert (tmp_path / "l.json").read_text() == before
    opened.page.keyboard.press("Control+s")
    opened.wait("document.querySelector('#said').textContent.startsWith('Saved')")
    assert set(json.loads((tmp_path / "l.json").read_text())) == {"U1_tip", "L1_tip"}


@pytest.fixture(scope="module")
def known(run, sample, tmp_path_factory):
    """Where the landmarks are on the radiograph, by a good registration with the true tracing."""
    folder = tmp_path_factory.mktemp("known")
    done = run("register", sample / "case.json", "--output", folder, "--no-report")
    assert done.returncode == 0, done.stderr
    jaws = json.loads((folder / "result.json").read_text())["jaws"]
    return {**jaws["upper"]["landmarks_px"], **jaws["lower"]["landmarks_px"]}


def four_clicks(known):
    return {
        f"{jaw}{what}": max(known[f"{jaw}R1_tip"], known[f"{jaw}L1_tip"]) if what == "1_tip" else [(a + b) / 2 for a, b in zip(known[f"{jaw}R6_MB"], known[f"{jaw}L6_MB"])]
        for what in ("1_tip", "6_MB")
        for jaw in "UL"
    }


def last_registration(opened):
    return [answer for answer in opened.answers if answer.url.endswith("/register")][-1]


def wait_for_registration(opened, act):
    with opened.page.expect_response(lambda answer: answer.url.endswith("/register")) as waiting:
        act()
    answer = waiting.value
    assert answer.status == 200, answer.text()
    opened.settle()
    return answer.json()


def test_four_clicks_drafts_two_corrections_save_and_register(open_page, serve, run, case, known, tmp_path, record_property):
    """From a radiograph and two scans to a result: what the page says in the end is what the saved files give."""
    content = {key: value for key, value in case.load().items() if key not in ("contours", "traced_side", "landmarks_2d")}
    case.save(content)
    tracing, marks = tmp_path / "tracing.json", tmp_path / "marks.json"
    begun = time.monotonic()

    def note(what, told):
        """How long a person has to wait, beside what hands and eyes take: python -m pytest -s."""
        spent = time.monotonic() - begun
        print(f"\n{what}: {told['status']} {spent:.1f} s after the program was started, of which {told['seconds']:.2f} s is this registration")
        record_property(what, told["seconds"])

    opened = open_page(serve("--case", case.file, "--output", tracing, "--landmarks", marks))
    page = opened.page
    clicks = four_clicks(known)
    centre = [sum(place[i] for place in clicks.values()) / 4 for i in (0, 1)]
    opened.look_at(centre, turns=4)
    for name in ("U1_tip", "L1_tip", "U6_MB"):
        opened.click(clicks[name])
    told = wait_for_registration(opened, lambda: opened.click(clicks["L6_MB"]))
    note("four clicks", told)
    assert told["status"] == "ok"
    assert set(told["jaws"]) == {"upper", "lower"} and all(jaw["registered"] for jaw in told["jaws"].values())
    assert "standard" in page.locator("#verdict").inner_text()
    # Residuals and sigma are there.
    assert page.locator("#residuals table").count() == 2 and page.locator("#predicted table").count() == 2
    assert re.search(r"σ of its landmarks \d+\.\d to \d+\.\d px", page.locator("#verdict").inner_text())

    # Another click takes no landmark along.
    opened.click([coordinate + 60 for coordinate in clicks["L6_MB"]])
    assert opened.download("landmarks")["L6_MB"] == [pytest.approx(coordinate, abs=0.6) for coordinate in clicks["L6_MB"]]
    # Drafts of both sides, seen on the picture and on the chart.
    opened.settle()
    assert page.locator("#drafts path.draft").count() >= 20
    assert {page.locator("#chart .drafted").nth(i).get_attribute("data-code")[:2] for i in range(page.locator("#chart .drafted").count())} == {"UR", "UL", "LR", "LL"}

    told = wait_for_registration(opened, lambda: page.locator("[data-accept=R]").click())
    note("drafts of the right side taken", told)
    assert told["traced_side"] == "right"
    assert page.locator("#chart .drawn").count() >= 10
    assert page.locator("#drafts path.draft").count() >= 8

    # What was taken as it was is said to be no evidence, here and in the file.
    assert told["status"] == "suspect"
    assert all("drafts-unmended" in [finding["code"] for finding in jaw["findings"]] for jaw in told["jaws"].values())
    assert "are drafts as a registration projected them" in page.locator("#verdict").inner_text()
    assert "upper suspect, lower suspect" in page.locator("#outcome").inner_text()
    assert all(c["drafted"] for jaw in opened.download("contours")["contours"].values() for c in jaw)

    # Two corrections by hand, each registered at once.
    for code in ("UR1", "LR6"):
        page.locator(f"#chart [data-code={code}]").click()
        page.keyboard.press("v")
        drawn = {c["code"]: c["points"] for jaw in opened.download("contours")["contours"].values() for c in jaw}
        middle = drawn[code][len(drawn[code]) // 2]
        opened.look_at(middle, turns=6)
        page.locator(f"#chart [data-code={code}]").click()
        opened.settle()

        def drag():
            page.mouse.move(*opened.screen(middle))
            page.mouse.down()
            page.mouse.move(*opened.screen((middle[0] + 1.5, middle[1] + 1.0)), steps=4)
            page.mouse.up()

        told = wait_for_registration(opened, drag)
        corrected = {c["code"]: c["points"] for jaw in opened.download("contours")["contours"].values() for c in jaw}
        assert corrected[code][len(drawn[code]) // 2] == [pytest.approx(middle[0] + 1.5, abs=0.2), pytest.approx(middle[1] + 1.0, abs=0.2)]
        note(f"{code} corrected", told)
        assert "drafted" not in {c["code"]: c for jaw in opened.download("contours")["contours"].values() for c in jaw}[code]
    assert {row["tooth"] for jaw in told["jaws"].values() for row in jaw["teeth"]} >= {"UR1", "LR6"}

    with page.expect_response(lambda answer: answer.url.endswith("/save")) as saving:
        page.keyboard.press("Control+s")
    assert saving.value.status == 200, saving.value.text()
    opened.wait("document.querySelector('#said').textContent.startsWith('Saved')")
    assert opened.errors == []
    host = re.match(r"http://[^/]+/", page.url).group()
    assert all(url.startswith((host, "data:", "blob:")) for url in opened.requests)

    case.change(contours=str(tracing), cephalometric_landmarks=str(marks))
    done = run("register", case.file, "--output", tmp_path / "result", "--no-report")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "result/result.json").read_text())
    assert result["status"] == told["status"] and result["traced_side"] == told["traced_side"]
    for jaw, said in result["jaws"].items():
        assert told["jaws"][jaw]["projection_3x4"] == pytest.approx(sum(said["projection_3x4"], []), rel=1e-9)
        # Near where the true tracing puts it: the whole exercise.
        for name, place in said["landmarks_px"].items():
            away = sum((a - b) ** 2 for a, b in zip(place, known[name])) ** 0.5
            assert away < 8.0, name


def test_a_draft_is_taken_alone_and_a_side_is_hidden(open_page, serve, case, known):
    content = {key: value for key, value in case.load().items() if key not in ("contours", "traced_side", "landmarks_2d")}
    case.save({**content, "cephalometric_landmarks": four_clicks(known)})
    opened = open_page(serve("--case", case.file))
    page = opened.page
    page.wait_for_selector("#chart .drafted")
    page.locator("[data-side=L]").uncheck()
    assert all(button.get_attribute("data-code")[1] == "R" for button in page.locator("#chart .drafted").all())
    page.locator("#live").uncheck()
    page.locator("#chart [data-code=UR6]").click()
    page.keyboard.press("a")
    assert [c["code"] for c in opened.download("contours")["contours"]["upper"]] == ["UR6"]
    assert "drafted" not in page.locator("#chart [data-code=UR6]").get_attribute("class")


def test_error_of_the_reader_is_shown(open_page, serve, sample, tmp_path):
    """Two landmarks of one meaning: the server refuses, and says which."""
    (tmp_path / "l.json").write_text(json.dumps({"U1_tip": [300, 300], "UIT": [310, 300]}))
    opened = open_page(serve(sample / "ceph.png", "--output", tmp_path / "c.json", "--landmarks", tmp_path / "out.json"))
    opened.page.locator("#open").set_input_files(str(tmp_path / "l.json"))
    opened.wait("document.querySelectorAll('#landmarks .drawn').length > 0")
    opened.page.keyboard.press("Control+s")
    opened.wait("document.querySelector('#said').classList.contains('problem')")
    assert "UIT" in opened.said()
    assert not (tmp_path / "out.json").exists()


@pytest.mark.skipif("DENTALSCR_SCREENSHOTS" not in os.environ, reason="pictures for Documentation/: set DENTALSCR_SCREENSHOTS to a folder")
def test_take_screenshots(open_page, serve, case, known):
    folder = pathlib.Path(os.environ["DENTALSCR_SCREENSHOTS"])
    content = {key: value for key, value in case.load().items() if key not in ("contours", "traced_side", "landmarks_2d")}
    case.save({**content, "cephalometric_landmarks": four_clicks(known)})
    for name, size in WIDTHS.items():
        opened = open_page(serve("--case", case.file, "--output", case.folder / f"{name}.json"), size=size)
        opened.page.wait_for_selector("#chart .drafted")
        wait_for_registration(opened, lambda: opened.page.locator("[data-accept=R]").click())
        opened.page.locator("#chart [data-code=UR6]").click()
        opened.page.locator("[data-action=teeth]").click()
        opened.settle()
        opened.page.screenshot(path=folder / f"tracing-{name}.png", full_page=name == "narrow")
