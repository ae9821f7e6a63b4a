"""The page of an experiment in a real browser: tables to sort and filter, figures, nothing asked of the network.

Needs what conftest.py says."""
import os
import pathlib
import shutil

import pytest

HOSTILE = "<img src=x onerror=alert(1)>"


@pytest.fixture(scope="module")
def folder(run, sample, tmp_path_factory):
    """Of two cases of a person's own, one with a name that would run if it were let."""
    made = tmp_path_factory.mktemp("experiment")
    for name in ("plain", HOSTILE):
        shutil.copytree(sample, made / "cases" / name)
    done = run("experiment", "--from", made / "cases", "--methods", "bounding-box,paper,icp", "--output", made / "out")
    assert done.returncode == 0, done.stderr
    assert "index.html" in done.stdout
    return made / "out"


@pytest.fixture(params=[1200, 400])
def page(browser, folder, request):
    context = browser.new_context(viewport={"width": request.param, "height": 900})
    page = context.new_page()
    page.said, page.asked = [], []
    page.on("console", lambda message: page.said.append(message.text))
    page.on("pageerror", lambda error: page.said.append(str(error)))
    page.on("dialog", lambda dialog: (page.said.append(dialog.message), dialog.dismiss()))
    page.on("request", lambda request: page.asked.append(request.url))
    page.goto((folder / "index.html").as_uri())
    yield page
    context.close()


def cells(page, section, column):
    rows = page.locator(f"section:has(> h2:text-is('{section}')) tbody tr")
    return [row.locator("td").nth(column).inner_text() for row in rows.all()]


def test_holds_every_table_and_figure_and_asks_for_nothing(page, folder):
    titles = page.locator("main h2").all_inner_texts()
    assert titles[:2] == ["Figures", "Landmark errors"] or titles[0] == "Landmark errors"
    assert {"Landmark errors", "Landmarks within a limit", "Contour distances", "Failures", "Cases"} <= set(titles)
    # All that was drawn is in the page and is a picture.
    drawn = [*folder.glob("plots/*.png"), *folder.glob("figure_*.png")]
    images = page.locator("main img")
    assert images.count() == len(drawn) >= 2
    assert all(image.evaluate("element => element.decode().then(() => element.naturalWidth)") > 100 for image in images.all())
    assert [url for url in page.asked if not url.startswith("data:")] == [(folder / "index.html").as_uri()]
    assert page.said == []
    assert (folder / "index.html").stat().st_size < 6_000_000


def test_figures_of_the_tables_are_those_of_the_files(page, folder):
    header, *rows = (line.split(",") for line in (folder / "table1_landmarks.csv").read_text().splitlines())
    column = header.index("mean_px")
    shown = cells(page, "Landmark errors", column)
    assert [float(text) for text in shown] == pytest.approx([float(row[column]) for row in rows], rel=1e-3)


def test_sorts_by_figures_and_filters_by_words(page):
    section = page.locator("section:has(> h2:text-is('Landmark errors'))")
    heads = section.locator("th button")
    column = heads.all_inner_texts().index("mean px")
    heads.nth(column).click()
    rising = [float(text) for text in cells(page, "Landmark errors", column)]
    assert rising == sorted(rising) and len(set(rising)) > 2
    assert section.locator("th").nth(column).get_attribute("aria-sort") == "ascending"
    heads.nth(column).focus()
    page.keyboard.press("Enter")
    assert [float(text) for text in cells(page, "Landmark errors", column)] == rising[::-1]
    section.locator("input[type=search]").fill("icp")
    assert set(cells(page, "Landmark errors", 1)) == {"icp"}
    assert "2 of 6 rows" in section.locator("[role=status]").inner_text()


def test_fits_its_width_and_the_keyboard_reaches_tables(page):
    assert page.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth")
    wanted = page.locator("a[href], button:visible, input, [tabindex='0']").count()
    reached = set()
    for _ in range(wanted + 10):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("[...document.querySelectorAll('*')].indexOf(document.activeElement)"))
    assert len(reached) >= wanted


def test_hostile_names_stay_text(page):
    section = page.locator("section:has(> h2:text-is('Cases'))")
    section.locator("input[type=search]").fill("<img")
    assert set(cells(page, "Cases", 0)) == {HOSTILE}
    assert page.said == []


@pytest.mark.skipif("DENTALSCR_SCREENSHOTS" not in os.environ, reason="pictures to look at: set DENTALSCR_SCREENSHOTS to a folder")
def test_take_screenshots(page):
    target = pathlib.Path(os.environ["DENTALSCR_SCREENSHOTS"])
    page.screenshot(path=target / f"experiment-{page.viewport_size['width']}.png", full_page=True)
