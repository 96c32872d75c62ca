"""The page in each state of a loop, in a real browser: all that belongs on it is there, and nothing says an error."""

import json
from pathlib import Path

import pytest
from settle.settle_bench import LIMITS, described, ended, rig, set_up, state
from watch.browser import CHROMIUM, Browser, browser
from watch.test_watch import watched
from watch.test_watch_loop import BLACK

from pipeline.settle.answers import QUESTION
from pipeline.settle.loop_lock import alone

DRAWN = """((name) => {
  const canvas = document.querySelector(name);
  if (!canvas.offsetParent) return false;
  return canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.some((value) => value);
})"""
PARTS = ("#loop", "#channels canvas")  # of a recording


@pytest.fixture(scope="module")
def place(tmp_path_factory) -> Path:
    """A loop that went from nothing to its end."""
    folder = tmp_path_factory.mktemp("states")
    set_up(folder)
    described(folder)
    words = ("raw/poor-1", "--port", "port", "--out", "reports/settle/poor-1", "--approve", "auto")
    with rig(folder, "--pace", "inf"):
        done = ended(folder, "settle", *words, "--limits", LIMITS)
    assert done.returncode == 0, done.stdout
    (folder / "out").symlink_to(folder / "reports" / "settle" / "poor-1")
    return folder


def at(place: Path, name: str, number: int = 1) -> None:
    """Put the loop back to a state of a step, as its folder holds it then."""
    (place / "out" / f"step-{number}" / "state.json").write_text(json.dumps(state(place, number) | {"state": name}))


def shown(page: Browser, place: Path, words: str) -> None:
    """Wait for a state, look at all that is there in each of them, and keep a picture."""
    page.until(f"document.getElementById('loop-state')?.textContent == '{words}'", 30.0)
    page.until("document.getElementById('link').textContent != 'connecting'")
    page.well()
    assert all(page.run(f"{DRAWN}('{part}')") for part in PARTS), "a recording is there in each of these states"
    assert page.text("verdict") and page.text("state") == "complete" and page.text("step").startswith("Step ")
    page.picture(place / f"{words.replace(' ', '-')}.png")


@pytest.mark.long
@CHROMIUM
def test_in_each_state_of_a_loop_the_page_shows_all_its_parts_and_no_error(place):
    """From the first recording on, the page said "link is not a function", and all below the loop stayed empty.

    What opens `came.png` used a function of another part of the page. Tests read its address, and no browser was shown
    the page of a step whose recording had been drawn.
    """
    last = len([*(place / "out").glob("step-*/came.png")]) - 1
    assert last >= 1, "the first recording is drawn over what the simulator foretold, and so is a run that decides"
    with watched(place / "raw" / "poor-1", "--reports", place / "reports") as (_, printed), browser(place) as page:
        logs = place / ".snakemake" / "log"
        logs.mkdir(parents=True)
        (logs / "2026-01-01T000000.000000.snakemake.log").write_text(
            "total   1\n1 of 1 steps (100%) done\nComplete log(s):\n"
        )
        page.open(printed)
        page.until("document.getElementById('jobs')?.textContent.startsWith('1 of 1 done, ended at 2')")
        shown(page, place, "settled")
        assert page.run(f"{BLACK}('apart')") > 200 and not page.run("document.getElementById('came').hidden")
        each = "[...document.querySelectorAll('#rivals span')].map((name) => getComputedStyle(name).color)"
        explanations, below = page.run(each), "getComputedStyle(document.querySelector('#loop-key .{}')).color"
        others = {page.run(below.format(name)) for name in ("measured", "simulated")}
        assert len(explanations) >= 2 and not others & {*explanations}, "one colour, one meaning"
        assert page.run(below.format("measured")) == page.run("getComputedStyle(document.getElementById('came')).color")
        for name, words in (
            ("proposed", "waits for yes in the terminal where settle runs"),
            ("proposed", "waits for approval"),
            ("approved", "is made now"),
            ("recorded", "is being diagnosed"),
            ("diagnosed", "diagnosed"),
        ):
            with alone(place / "out"):
                at(place, name, last)
                if words == "waits for approval":
                    question = {"step": last, "question": "of a test"}
                    (place / "out" / QUESTION).write_text(json.dumps(question))
                shown(page, place, words)
                came = page.run("[...document.querySelectorAll('#came-file a')].map((link) => link.pathname)")
                assert came == [f"/reports/settle/poor-1/step-{last}/came.png"]
                assert page.run(f"fetch('{came[0]}').then((answer) => answer.status)") == 200
                assert page.run(f"{DRAWN}('#foretold')") and page.run(f"{DRAWN}('#apart')"), "after the end too"
                assert name == "diagnosed" or len(page.text("legs")) > 50, "what moves is said in numbers"
                (place / "out" / QUESTION).unlink(missing_ok=True)


@pytest.mark.long
@CHROMIUM
def test_a_part_that_cannot_be_shown_is_named_and_leaves_the_others(place):
    """A fault in the part of the loop looked like a server that does not answer, and emptied all parts below it."""
    with watched(place / "raw" / "poor-1", "--reports", place / "reports") as (_, printed), browser(place) as page:
        page.open(printed)
        page.until("document.getElementById('link')?.textContent == 'connected'")
        page.run("document.getElementById('came-file').remove()")
        page.run("document.getElementById('verdict').textContent = ''")
        page.until("document.getElementById('link').className == 'bad'")
        page.until("document.getElementById('verdict').textContent", 10.0)
        assert page.text("link").startswith("connected, but a part of this page cannot be shown (loop: ")
        page.open("about:blank")
        page.until("location.href == 'about:blank'")
        assert page.faults, "the console has it too"
        page.faults.clear()
