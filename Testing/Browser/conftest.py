"""What the tests of the pages share: one browser for all of them.

Needs Chromium and the package playwright (Utilities/python-venv.sh); where either is missing whatever asks for the browser is skipped.
Playwright drives the browser of the system, it brings none."""
import shutil

import pytest

# A software renderer beside a compiler's processes takes its time: what does not come at all is told later, that is all.
PATIENCE_MS = 120_000


class Contexts:
    """A browser that waits for a busy machine."""

    def __init__(self, browser):
        self.browser = browser

    def new_context(self, **options):
        context = self.browser.new_context(**options)
        context.set_default_timeout(PATIENCE_MS)
        return context

    def new_page(self, **options):
        return self.new_context(**options).new_page()


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
        yield Contexts(started)
        started.close()
