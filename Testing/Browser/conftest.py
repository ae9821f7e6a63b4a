"""What the tests of the pages share: one browser for all of them.

Needs Chromium and the package playwright (Utilities/python-venv.sh); where either is missing whatever asks for the browser is skipped.
Playwright drives the browser of the system, it brings none."""
import shutil

import pytest


@pytest.fixture(scope="session")
def browser():
    """Started once: what a test opens in it is a context of its own."""
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed in this Python")
    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if program is None:
        pytest.skip("there is no Chromium")
    with sync_api.sync_playwright() as playwright:
        # A software renderer: no machine of ours has a graphics card.
        started = playwright.chromium.launch(
            executable_path=program,
            args=["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
        )
        yield started
        started.close()
