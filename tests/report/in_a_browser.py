"""A page in a headless browser, for tests of what its script and its style do."""

import shutil
import subprocess

import pytest

needs_browser = pytest.mark.skipif(not shutil.which("chromium"), reason="there is no chromium here")


def clicked(page, script, place):
    """The title of a page, 1200 pixels wide, after a script at its end ran in a browser."""
    copy = page.with_name("clicked.html")
    copy.write_text(page.read_text().replace("</body>", script))
    options = ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--window-size=1200,900"]
    command = ["chromium", *options, f"--user-data-dir={place / 'home'}", "--dump-dom", copy.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    copy.unlink()
    return done.stdout.partition("<title>")[2].partition("</title>")[0]
