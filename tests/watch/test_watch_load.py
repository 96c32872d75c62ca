"""5 kHz of six channels are recorded without a loss while a real browser has the page open."""

from pathlib import Path

import pytest
from watch.browser import CHROMIUM, browser
from watch.test_watch import folder, watched

from benchmarks.load import RATE_HZ, measure

SECONDS = 20


@CHROMIUM
@pytest.mark.long
def test_the_open_page_costs_the_capture_no_sample(tmp_path: Path):
    run = folder(tmp_path, "load-1")
    with watched(run) as (_, printed), browser(tmp_path) as seen:
        seen.open(printed)
        seen.until("document.getElementById('state')?.textContent == 'no recording yet'")
        load = measure(SECONDS, run)
        assert (load.lost, load.bad, load.samples) == (0, 0, SECONDS * RATE_HZ), load
        seen.until("document.getElementById('state').textContent == 'complete'")
        seen.until(f"document.getElementById('samples').textContent == '{load.samples:,}'")
        assert (seen.text("lost"), seen.text("rate")) == ("0, 0", "5,000")
