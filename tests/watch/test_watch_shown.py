"""What a person sees on the page: strokes that fade, the rate at which samples come, and the limit of a forecast."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import ready
from browser import CHROMIUM, browser
from made_recording import content
from scripted_rig import synthetic_rig
from watch.test_watch import HELLO, ROOT, SAMPLE, folder, told, watched

from pipeline.run.strokes import segment
from pipeline.watch.appended import Printed
from pipeline.watch.arrival_rate import Coming
from pipeline.wire import Event, Kind, encode, read_recording
from pipeline.wire.frames import EVENT

PACE = 5  # times as fast as life
DARKEST = """((low, high) => {
  const canvas = document.getElementById("loop"), pen = canvas.getContext("2d");
  const rows = [low, high].map((part) => Math.round(part * canvas.height));
  const dots = pen.getImageData(canvas.width / 2, rows[0], 40, rows[1] - rows[0]).data;
  let most = 0;
  for (let k = 0; k < dots.length; k += 4) most = Math.max(most, dots[k + 3] * (1 - dots[k] / 255));
  return most;
})"""  # how dark, on white, the darkest dot of a strip of the canvas is


def strokes(count: int, apart_mm: float) -> bytes:
    """Strokes of equal length, each so much higher than the one before."""
    each, frames = 400, [encode(Kind.HELLO, 0, HELLO.pack())]
    for stroke in range(count):
        first = 1 + stroke * (each + 1)
        begins = EVENT.pack(first * 1000, Event.STROKE_START, stroke + 1)
        frames.append(encode(Kind.EVENT, first, begins))
        rows = np.zeros(each, SAMPLE)
        rows["t_us"] = (first + 1 + np.arange(each)) * 1000
        rows["motor_turns"] = np.arange(each) * 25
        rows["displacement_mm"] = round(1000 * stroke * apart_mm)
        frames += [encode(Kind.SAMPLE, first + 1 + at, row.tobytes()) for at, row in enumerate(rows)]
    return b"".join(frames)


@CHROMIUM
def test_older_strokes_fade_so_that_a_person_sees_it(tmp_path: Path):
    """They had half and three quarters of the newest one's colour, which nobody could tell apart."""
    run = folder(tmp_path)
    (run / "recording.frames").write_bytes(strokes(3, 40.0))
    with watched(run) as (port, _), browser(tmp_path / "home") as page:
        page.open(f"http://127.0.0.1:{port}/")
        page.until("document.getElementById('samples')?.textContent === '1,200'")
        newest, before, oldest = (page.run(f"{DARKEST}({low}, {low + 0.14})") for low in (0.0, 0.38, 0.74))
    assert newest > 100 and 0 < before < 0.6 * newest and 0 < oldest < 0.75 * before


def ramps(count: int, each: int) -> bytes:
    """So many ramps of so many samples each, up and down in turn, one sample a ms."""
    rows = np.zeros(count * each, SAMPLE)
    at = np.arange(len(rows))
    rows["t_us"] = at * 1000
    rows["motor_turns"] = 5 * np.minimum(at % (2 * each), -at % (2 * each))
    return b"".join(encode(Kind.SAMPLE, 1 + n, row.tobytes()) for n, row in enumerate(rows))


@CHROMIUM
def test_a_ramp_of_many_samples_is_drawn_as_a_ramp(tmp_path: Path):
    """The least and the greatest of a part stood at one time: a ramp was stairs, and each top had a pointed spike."""
    run, each = folder(tmp_path), 3000
    (run / "recording.frames").write_bytes(encode(Kind.HELLO, 0, HELLO.pack()) + ramps(4, each))
    with watched(run) as (port, _), browser(tmp_path / "home") as page:
        page.open(f"http://127.0.0.1:{port}/")
        page.until("document.getElementById('samples')?.textContent === '12,000'")
        (turns,) = [channel for channel in told(port)["channels"] if channel["name"] == "motor_turns"]
        xs, ys = (np.array(part) for part in page.run(f"inOrder({json.dumps(turns)})"))
        join = page.run("document.querySelector('#channels canvas').getContext('2d').lineJoin")
        words = page.run("document.getElementById('channels-part').textContent")
    place = (xs - xs[0]) * 1000.0 / each % 2.0
    assert len(xs) > 1000 and np.all(np.diff(xs) >= 0.0)
    assert np.abs(ys / ys.max() - np.minimum(place, 2.0 - place)).max() < 0.01
    assert join == "round" and "the least and the greatest sample" in words and "more than 1,200 samples" in words


@CHROMIUM
@pytest.mark.long
def test_the_rate_is_that_at_which_samples_come_where_the_rig_goes_at_another_pace_than_its_clock(tmp_path: Path):
    """It said 100, the rig's own rate, while capture said 498 samples/s."""
    run, setup = folder(tmp_path), ROOT / "pipeline/rig/setups/small.yaml"
    with (
        synthetic_rig(tmp_path / "port", setup, "--pace", PACE),
        watched(run) as (port, _),
        browser(tmp_path / "home") as page,
    ):
        process = ready.start("pipeline.capture", tmp_path / "port", run)
        page.open(f"http://127.0.0.1:{port}/")
        page.until("document.getElementById('rate')?.textContent.includes('times')")
        shown = page.text("rate")
        process.communicate()
        snapshot = told(port, lambda snapshot: snapshot["ended"])
        page.until("document.getElementById('state').textContent === 'complete'")
        after = page.run("document.getElementById('rate').parentNode.textContent")
    own_hz = snapshot["rate_hz"]
    rate_match = re.fullmatch(rf"([\d.]+) \((\d\.?\d*) times the {own_hz:g} of the rig's own clock\)", shown)
    assert rate_match and 0.7 * PACE * own_hz < float(rate_match[1]) < 1.4 * PACE * own_hz, shown
    assert after == f"samples per second by the rig's clock{own_hz:g}"


def test_samples_that_come_are_counted_over_the_last_looks_alone():
    coming = Coming()
    for look in range(40):
        coming.look(0.5 * look, 50 * look, True)
    assert coming.rate_hz == 100.0
    for look in range(40, 60):
        coming.look(0.5 * look, 2000, True)
    assert coming.rate_hz is None, "none come any more"
    coming.look(31.0, 2050, False)
    coming.look(31.5, 9050, True)
    assert coming.rate_hz is None, "what was read of the past did not come now"


def test_printed_lines_have_a_rate_by_the_time_that_they_tell():
    printed = Printed(("time_ms", "motor_turns"))
    printed.feed(b"".join(b"%d,1.5\n" % (20 * at) for at in range(101)))
    assert printed.rate_hz == 50.0


@CHROMIUM
def test_the_tile_of_the_strokes_left_names_its_limit_and_the_page_what_the_other_one_leaves(tmp_path: Path):
    """18 strokes until a model is off stood for those that the string has left, of which there were 197."""
    run = folder(tmp_path, string=content("run-1")["string"] | {"id": "spool-1"})
    lifespan_folder = tmp_path / "reports" / "spool-1"
    lifespan_folder.mkdir(parents=True)
    model = {"limit": 1.0, "unit": "mm", "strokes_left": {"low": 12.5, "median": 18.2, "high": 30.0}}
    stroke = {"limit": 0.1, "unit": "1", "strokes_left": {"low": 150.0, "median": 197.9, "high": None}}
    forecast = {"first": "model_error", "questions": {"model_error": model, "stroke_loss": stroke}}
    (lifespan_folder / "lifespan.json").write_text(json.dumps(forecast))
    with watched(run) as (port, _), browser(tmp_path / "home") as page:
        page.open(f"http://127.0.0.1:{port}/")
        page.until("document.getElementById('left')?.textContent.startsWith('18')")
        tile = page.run("document.getElementById('left').previousSibling.textContent")
        file = page.text("left-file")
    assert tile == "strokes left, forecast, until a model calibrated on the first strokes is off by 1 mm"
    assert "stand in reports/spool-1/lifespan.json. Counted until a model calibrated on the first" in file
    assert file.endswith("Also: 197 (median), at least 150 in 90 % of the futures, until 10 % of the stroke is lost.")


def one_stroke(ends_at_turns: float) -> bytes:
    """655 samples of one winding to 20 turns and the unwinding after it, with no word of the stroke's end."""
    turns = np.concatenate([np.linspace(0.0, 20.0, 330), np.linspace(20.0, ends_at_turns, 325)])
    rows = np.zeros(len(turns), SAMPLE)
    rows["t_us"] = (2 + np.arange(len(turns))) * 50_000
    rows["motor_turns"] = np.rint(1000 * turns)
    rows["displacement_mm"] = np.rint(20 * turns**2)
    hello = replace(HELLO, rate_hz=20.0, strokes=1)
    begins = encode(Kind.EVENT, 1, EVENT.pack(50_000, Event.STROKE_START, 1))
    return (
        encode(Kind.HELLO, 0, hello.pack())
        + begins
        + b"".join(encode(Kind.SAMPLE, 2 + at, row.tobytes()) for at, row in enumerate(rows))
    )


@pytest.mark.parametrize(("ends_at_turns", "whole"), [(0.2, 1), (20.0, 0)])
def test_a_recording_that_ended_without_a_rest_counts_its_last_stroke_as_the_pipeline_does(
    tmp_path: Path, ends_at_turns, whole
):
    """`state: complete` stood beside `strokes: 0 of 1`: the run ended with its unwinding, and no event told of it."""
    run = folder(tmp_path)
    (run / "recording.frames").write_bytes(one_stroke(ends_at_turns))
    recording = read_recording((run / "recording.frames").read_bytes())
    samples = pd.DataFrame({"time_s": recording.time_s, **recording.channels})
    assert segment(samples, "motor_turns", run)["complete"].all() == bool(whole)
    with watched(run) as (port, _):
        snapshot = told(port, lambda snapshot: snapshot["samples"] == 655)
        assert (snapshot["strokes"], snapshot["planned"]) == (0, 1), "while it may go on, what the rig told counts"
        assert ready.run("pipeline.capture", "--recover", run).returncode == 0
        assert told(port, lambda snapshot: snapshot["ended"])["strokes"] == whole


@CHROMIUM
def test_few_samples_are_drawn_without_teeth_and_the_page_says_what_cannot_be_seen(tmp_path: Path):
    """A saw stood on both branches; a band thinner than the line was promised; a curve may be mm off."""
    run = folder(tmp_path)
    (run / "recording.frames").write_bytes(one_stroke(0.0))
    verdicts = tmp_path / "reports" / "diagnosis" / "run-1"
    with watched(run) as (port, _), browser(tmp_path / "home") as page:
        page.open(f"http://127.0.0.1:{port}/")
        page.until("document.getElementById('samples')?.textContent === '655'")
        before = page.text("loop-key")
        page.picture(tmp_path / "few.png")
        assert not page.run("isSeen({ y: (mm) => -30 * mm }, 0.066)"), "4 px were promised, and hidden by lines"
        assert page.run("isSeen({ y: (mm) => -30 * mm }, 0.2)")
        other = verdicts.parent / "run-2"
        other.mkdir(parents=True)
        (other / "verdict.txt").write_text("run-2: unknown.\n")
        verdicts.mkdir()
        for name, words in (("verdict.txt", "run-1: explained: friction.\n"), ("diagnosis.pdf", "%PDF")):
            (verdicts / name).write_text(words)
        (verdicts / "diagnosis.json").write_text(json.dumps({"run": "run-1"}))
        page.until("document.getElementById('verdict-page').textContent")
        links = page.run("[...document.querySelectorAll('#verdict-page a')].map((one) => one.textContent)")
        after = page.text("loop-key")
        page.until("!document.getElementById('others').hidden")
        assert page.text("others") == "Other runs" and page.text("verdicts").startswith("run-2"), (
            "its own stood there too"
        )
        (loop,) = told(port)["loops"]
    top = int(np.argmax(loop["motor_turns"]))
    for branch in (slice(0, top), slice(top, None)):
        off = np.array(loop["displacement_mm"])[branch] - 0.02 * np.array(loop["motor_turns"])[branch] ** 2
        assert np.abs(off).max() < 0.002, "each reading stands over its own twist"
    assert (
        ": too thin to draw" in before and "twice the noise of one reading" not in before and "noise band ± " in before
    )
    assert all("run.yaml simulator, not calibrated" in page for page in (before, after))
    assert links == [f"reports/diagnosis/run-1/{name}" for name in ("diagnosis.pdf", "verdict.txt")]
