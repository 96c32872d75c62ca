"""The page's two buttons, on the real programs: a loop on a synthetic rig, the page, and a real browser."""

import http.client
import json
import time
from pathlib import Path

import numpy as np
import pytest
from settle.settle_bench import LIMITS, described, program, rig, set_up, started, state, until
from watch.browser import CHROMIUM, browser
from watch.test_watch import folder, get, told, watched
from watch.test_watch_shown import one_stroke

from pipeline.settle.answers import Answers
from pipeline.wire import Reason, read_recording

FRAMES = "recording.frames"


@pytest.fixture
def place(tmp_path) -> Path:
    set_up(tmp_path)
    described(tmp_path)
    return tmp_path


def page(place: Path, *options: object):
    """The page of the run that the loop in `out` settles."""
    return watched(place / "raw" / "poor-1", "--settle", place / "out", *options)


def press(port: int, button: str, token: str, body: object = None, **headers: str) -> int:
    """Press a button as a client says; the status of the answer."""
    text = body if isinstance(body, bytes) else json.dumps({} if body is None else body).encode()
    head = {"Content-Type": "application/json", "X-Watch-Token": token} | headers
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    try:
        connection.request(
            "POST", f"/{button}", text, {name.replace("_", "-"): header_text for name, header_text in head.items()}
        )
        return connection.getresponse().status
    finally:
        connection.close()


def token_of(printed: str) -> str:
    return printed.partition("?token=")[2]


def waits(place: Path, *words: object):
    """A loop that is started and asks the page."""
    fixed = ["raw/poor-1", "--port", "port", "--out", "out", "--approve", "page", "--limits", LIMITS]
    loop = program(place, "settle", *fixed, *words)
    until(loop, place / "out" / "question.json")
    return loop


def test_a_button_needs_the_token_and_this_page_and_what_is_asked_now(place):
    with rig(place, "--pace", "inf"), page(place) as (port, printed):
        token = token_of(printed)
        assert press(port, "stop", token) == 409, "no loop is at work"
        loop = waits(place)
        question = told(port, lambda snapshot: snapshot["loop"] and snapshot["loop"]["question"])["loop"]["question"]
        yes = {"question": question}
        foreign = {"Origin": "http://127.0.0.1:9"}
        for status, told_it in (
            (403, press(port, "approve", "", yes)),
            (403, press(port, "approve", token + "x", yes)),
            (403, press(port, "approve", token, yes, **foreign)),
            (403, press(port, "approve", token, yes, Host="elsewhere.example")),
            (403, press(port, "approve", token, yes, Content_Type="text/plain")),
            (403, press(port, "approve", "", yes, Cookie=f"twistbench_watch_{port}={token}")),
            (409, press(port, "approve", token, {"question": "of another run"})),
            (409, press(port, "approve", token, {"question": ["a"]})),
            (400, press(port, "approve", token, b"{")),
            (400, press(port, "approve", token, b"[" * 3000)),
            (413, press(port, "approve", token, b'{"question":"' + b"a" * 100_000)),
            (405, press(port, "erase", token)),
        ):
            assert told_it == status
        time.sleep(0.5)
        assert state(place, 0)["state"] == "proposed" and not (place / "raw" / "poor-1" / FRAMES).exists()
        assert press(port, "approve", token, yes) == 200
        until(loop, place / "raw" / "poor-1" / FRAMES)
        assert press(port, "approve", token, yes) == 409, "a second browser comes too late"
        assert press(port, "stop", token) == 200 and press(port, "stop", token) in (200, 409)
        output = loop.communicate(timeout=120)[0]
        assert loop.returncode == 130, output
        assert not told(port, lambda snapshot: not snapshot["loop"]["at_work"])["loop"]["question"]


def test_a_question_that_nobody_asks_any_more_is_not_shown(place):
    with rig(place, "--pace", "inf"), page(place) as (port, printed):
        loop = waits(place)
        question = told(port, lambda snapshot: snapshot["loop"] and snapshot["loop"]["question"])["loop"]["question"]
        loop.kill()
        loop.communicate()
        snapshot = told(port, lambda snapshot: not snapshot["loop"]["at_work"])
        assert snapshot["loop"]["question"] is None and snapshot["loop"]["state"] == "proposed"
        assert press(port, "approve", token_of(printed), {"question": question}) == 409
        loop = waits(place)
        new = told(port, lambda snapshot: snapshot["loop"]["question"])["loop"]["question"]
        assert new != question and press(port, "approve", token_of(printed), {"question": question}) == 409
        Answers(place / "out").stop()
        assert loop.communicate(timeout=120) and loop.returncode == 130
        assert not (place / "raw" / "poor-1" / FRAMES).exists()


def test_a_loop_whose_state_is_damaged_is_not_shown(place):
    (place / "out" / "step-0").mkdir(parents=True)
    (place / "out" / "step-0" / "state.json").write_text('{"number": 0, "state": "proposed", "run_dir": "../../etc"}')
    with page(place) as (port, _):
        snapshot = told(port)
        assert snapshot["run"] == "poor-1" and snapshot["loop"]["foretold"] is None
        (place / "out" / "step-0" / "state.json").write_text("{")
        assert told(port, lambda snapshot: snapshot["loop"] is None)["run"] == "poor-1"


@CHROMIUM
def test_in_a_browser_a_person_approves_looks_and_stops(place):
    run = place / "raw" / "poor-1"
    with rig(place, "--pace", 5), page(place) as (port, printed), browser(place) as seen:
        loop = waits(place)
        seen.open(f"http://127.0.0.1:{port}/")  # without the token it can be read
        seen.until("document.getElementById('approve')?.hidden === false")
        seen.press("clear")
        assert seen.run("document.getElementById('approve').disabled")
        assert "with its token" in seen.run("document.body.innerText")
        seen.open(printed)
        seen.until("document.getElementById('loop-state')?.textContent == 'waits for approval'")
        assert seen.text("stop") == "Stop the loop", "a button says what it does, and not how things stand"
        assert seen.text("still") == "nothing is moving now" and seen.run("!document.getElementById('still').hidden")
        assert seen.text("step").startswith("Step 0: a first recording: 6 equal strokes to 21 turns (73 s, 6 strokes)")
        rows = [row.split() for row in seen.run("document.getElementById('legs').innerText").splitlines()]
        assert ["leg", "s", "turns", "turns/s", "load", "(N)"] in rows, "each leg is said in numbers before the yes"
        winding = next(row for row in rows if row[:4] == ["3,", "7", "…", "23"])
        assert winding[5:8] == ["0.00", "to", "21.00"] and 4.3 < float(winding[8]) <= 4.5, "half of the 9 allowed"
        assert seen.run("location.search") == "" and seen.run("document.getElementById('approve').disabled")
        seen.picture(place / "proposed.png")
        seen.press("clear")
        seen.press("approve")
        until(loop, run / FRAMES, 15_000)
        seen.until("document.getElementById('loop-state').textContent == 'is made now'")
        assert seen.text("stop") == "Stop the motor, then the loop" and seen.run(
            "document.getElementById('still').hidden"
        )
        seen.until("parseInt(document.getElementById('samples').textContent.replace(',', '')) > 400")
        seen.until("document.getElementById('strokes').textContent.endsWith('of 6')")  # of its own motion: of 8
        seen.picture(place / "moves.png")
        seen.press("stop")
        output = loop.communicate(timeout=120)[0]
        assert loop.returncode == 130, output
        seen.until("document.getElementById('state').textContent == 'ended by Ctrl-C or kill'")
        recording = read_recording((run / FRAMES).read_bytes())
        assert recording.account.end.reason == Reason.STOPPED and state(place, 0)["approved_by"].endswith("on the page")
        seen.until(f"document.getElementById('samples').textContent == '{len(recording.time_s):,}'")
        seen.until("document.getElementById('loop-state').textContent.includes('no loop is at work')")
        assert seen.text("lost") == "0, 0"
        assert seen.run("document.getElementById('stop').hidden")
        dark = "[...document.getElementById('foretold').getContext('2d').getImageData(0,0,800,100).data].some(v => v)"
        assert seen.run(dark), "something is drawn"
        seen.picture(place / "stopped.png")


BLACK = """((name) => {
  const canvas = document.getElementById(name), pen = canvas.getContext("2d");
  const { data } = pen.getImageData(70, 0, canvas.width - 80, canvas.height - 40);
  let dots = 0;
  for (let k = 0; k < data.length; k += 4) dots += data[k + 3] > 200 && Math.max(...data.slice(k, k + 3)) < 40;
  return dots;
})"""  # how many dots of a canvas's curves are black


def test_the_drawing_of_what_came_can_be_opened_after_the_run_is_diagnosed(place):
    """The curves went with the diagnosis, and nothing said where they are."""
    out = place / "reports" / "settle" / "poor-1" / "step-0"
    out.mkdir(parents=True)
    (out / "state.json").write_text('{"number": 0, "state": "diagnosed", "run_dir": ""}')
    (out / "came.png").write_bytes(b"drawn")
    with watched(place / "raw" / "poor-1") as (port, _):
        came = told(port)["loop"]["came"]
        assert came["step"] == 0 and came["page"] == "settle/poor-1/step-0/came.png"
        assert get(port, f"/reports/{came['page']}")[1] == b"drawn"


@CHROMIUM
def test_what_came_is_drawn_beside_what_each_explanation_foretold_where_they_differ(tmp_path):
    """The panel of the small differences had no black line: nobody could see which explanation came true."""
    run, step = folder(tmp_path), tmp_path / "out" / "step-0"
    (run / FRAMES).write_bytes(one_stroke(0.0))
    step.mkdir(parents=True)
    time_s = np.linspace(0.0, 32.7, 300)
    turns = np.interp(time_s, [0.0, 16.45, 32.7], [0.0, 20.0, 0.0])
    curves = {"time_s": time_s, "motor_turns": turns, "load": 0 * turns + 20, "calibrated": 0.019 * turns**2}
    curves = {name: curve.tolist() for name, curve in curves.items()}
    rivals = {"creep": (0.02 * turns**2).tolist(), "thermal": (0.018 * turns**2).tolist()}
    (step / "proposed.json").write_text(json.dumps({"title": "a", "curves": curves | {"rivals": rivals}}))
    step_state = {"number": 0, "state": "recorded", "run_dir": str(run)}
    leg = {"seconds": 16.45, "motor_turns": 20.0}
    (step / "state.json").write_text(json.dumps(step_state | {"proposal": {"title": "a", "legs": [leg]}}))
    with watched(run, "--settle", tmp_path / "out") as (port, _), browser(tmp_path) as seen:
        seen.open(f"http://127.0.0.1:{port}/")
        seen.until("document.getElementById('samples')?.textContent === '655'")
        came = told(port)["loop"]["foretold"]["came"]
        assert seen.run(f"{BLACK}('apart')") > 200 and seen.run(f"{BLACK}('foretold')") > 200
        assert seen.text("came") == "recorded" and seen.run("!document.getElementById('came').hidden")
        seen.picture(tmp_path / "came.png")
        (step / "state.json").write_text(json.dumps(step_state | {"state": "proposed", "proposal": {"legs": [leg]}}))
        seen.until("document.getElementById('loop-state').textContent.startsWith('proposed')")
        assert seen.run(f"{BLACK}('apart')") == 0 and seen.run("document.getElementById('came').hidden")
    mean_turns = np.interp(came["time_s"], time_s, turns)
    assert np.array(came["difference_mm"]) == pytest.approx(0.001 * mean_turns**2, abs=0.02)


@CHROMIUM
def test_a_page_of_elsewhere_in_the_same_browser_stops_nothing(place):
    with rig(place, "--pace", "inf"), page(place) as (port, printed), browser(place) as seen:
        loop = started(place, "--approve", "page")
        until(loop, place / "out" / "question.json")
        told(port, lambda snapshot: snapshot["loop"] and snapshot["loop"]["question"])
        seen.open(printed)
        seen.until("document.getElementById('loop-state')?.textContent == 'waits for approval'")
        seen.open("data:text/html,<p>elsewhere")
        seen.until("document.body?.innerText == 'elsewhere'")
        for words in (
            "{method: 'POST', mode: 'no-cors', credentials: 'include', body: '{}'}",
            "{method: 'POST', headers: {'Content-Type': 'application/json', 'X-Watch-Token': 'x'}, body: '{}'}",
        ):
            seen.run(f"fetch('http://127.0.0.1:{port}/stop', {words}).then(a => a.status, e => 'refused')")
        time.sleep(0.5)
        assert loop.poll() is None and not (place / "out" / "stop").exists()
        Answers(place / "out").stop()
        loop.communicate(timeout=120)
