"""A loop that begins with nothing: it makes the first recording itself, and stops when somebody says so elsewhere."""

import json
import signal
import threading
import time
from dataclasses import replace
from pathlib import Path

import pytest
from scripted_rig import CHANNELS, ScriptedRig
from settle_bench import LIMITS, described, ended, program, rig, set_up, settled, started, state, until

from pipeline.capture.motion_program import as_legs
from pipeline.ground.errors import BadInput
from pipeline.run.folder import read_run
from pipeline.settle.answers import Answers
from pipeline.settle.choose import Budget
from pipeline.settle.first import first_run
from pipeline.wire import Hello, Reason, read_recording
from pipeline.wire.motion import Limits, refusal

RIG = Limits(100, (0.0, 30.0), 8.0, 40.0, 600.0, 1.5, 5.0, (5.0, 60.0))
PLENTY = Budget(3, 30.0, 40)
FRAMES = "recording.frames"


@pytest.fixture
def place(tmp_path) -> Path:
    """A rig's file and a run's folder without a recording."""
    set_up(tmp_path)
    described(tmp_path)
    return tmp_path


def made_of(run: Path, limits: Limits | None = RIG, budget: Budget = PLENTY) -> dict:
    return first_run(read_run(run), limits, budget)


def test_it_is_equal_strokes_within_the_limits_and_the_simulator_is_foretold(place):
    entry = made_of(place / "raw" / "poor-1")
    ways = [leg["motor_turns"] for leg in entry["legs"]]
    assert entry["title"] == "a first recording: 6 equal strokes to 30 turns"
    assert ways.count(30.0) == 12 and set(ways) == {0.0, 30.0} and entry["from"] == 5.0
    assert "load_n" not in entry["legs"][0], "what hangs is left alone"
    curves = entry["curves"]
    assert curves["calibrated"][0] == 0.0 and max(curves["motor_turns"]) == pytest.approx(30.0, abs=0.3)
    assert max(curves["calibrated"]) == pytest.approx(20.4, abs=1.0) and curves["rivals"] == {}


@pytest.mark.parametrize(
    ("limits", "budget", "strokes"),
    [
        (RIG, Budget(3, 30.0, 5), 5),
        (replace(RIG, seconds=80.0), PLENTY, 4),
        (replace(RIG, seconds=56.0), PLENTY, 5),  # faster
        (replace(RIG, turns=(-9.0, 4.0)), PLENTY, 6),
        (replace(RIG, turns=(2.0, 4.0)), PLENTY, 6),
    ],
)
def test_it_fits_in_what_is_allowed(limits, budget, strokes, place):
    entry = made_of(place / "raw" / "poor-1", limits, budget)
    assert f": {strokes} equal" in entry["title"]
    legs = as_legs(entry["legs"])
    assert refusal(legs, limits) is None
    assert min(leg.turns for leg in legs) == max(0.0, limits.turns[0])


@pytest.mark.parametrize(
    ("limits", "budget", "message"),
    [
        (replace(RIG, seconds=20.0), PLENTY, "and the device takes 20 s"),
        (RIG, Budget(3, 0.3, 40), "of --minutes 0.3 are left"),
        (RIG, Budget(3, 30.0, 3), "of --strokes 3 are left"),
        (replace(RIG, turns=(-5.0, 0.0)), PLENTY, "leave nothing to wind"),
    ],
)
def test_where_it_does_not_fit_it_is_a_sentence(limits, budget, message, place):
    with pytest.raises(BadInput, match=message):
        made_of(place / "raw" / "poor-1", limits, budget)


def test_an_approval_is_of_the_question_that_is_asked_now(tmp_path):
    answers, approvals = Answers(tmp_path), []
    assert answers.question() is None and not answers.approve("anything")
    asking = threading.Thread(target=lambda: approvals.append(answers.approved(3)))
    asking.start()
    while (question := answers.question()) is None:
        time.sleep(0.01)
    assert question["step"] == 3 and not answers.approve("of an earlier question")
    (tmp_path / "approved.json").write_text(json.dumps({"step": 3, "question": "of an earlier question"}))
    time.sleep(0.3)
    assert approvals == [] and answers.approve(question["question"])
    asking.join(timeout=10)
    assert approvals == [True] and [path.name for path in tmp_path.iterdir()] == []


@pytest.mark.parametrize("text", ["{", "[]", '{"step": 1}', '{"step": 1, "question": 5}', "[" * 9999])
def test_files_of_somebody_else_approve_nothing(text, tmp_path):
    (tmp_path / "question.json").write_text(text)
    assert Answers(tmp_path).question() is None and not Answers(tmp_path).approve("x")


@pytest.mark.long
def test_from_nothing_to_a_right_and_firm_verdict(place):
    with rig(place, "--pace", "inf"):
        loop = started(place)
        printed = loop.communicate(timeout=400)[0]
    assert loop.returncode == 0, printed
    first = state(place, 0)
    assert first["approved_by"] == "--approve auto, within --limits" and first["run_dir"] == "raw/poor-1"
    assert first["verdict"] == "ambiguous" and first["proposal"]["title"].startswith("a first recording: 6 equal")
    for name in ("proposed.png", "came.png", "proposed.json", "diagnosis.json"):
        assert (place / "out" / "step-0" / name).is_file(), name
    recording = read_recording((place / "raw" / "poor-1" / FRAMES).read_bytes())
    assert recording.channels["motor_turns"].max() == pytest.approx(21.0, abs=0.02)
    outcome = settled(place)
    assert (outcome["verdict"], outcome["mechanisms"]) == ("explained", ["friction_hysteresis"])
    assert outcome["runs"][:2] == ["raw/poor-1", "raw/poor-1-s1"] and outcome["spent"]["strokes"] >= 7
    assert outcome["spent"]["runs"] == len(outcome["runs"]) - 1


def test_ctrl_c_in_the_first_recording_stops_the_motor(place):
    with rig(place, "--pace", 1):
        loop = started(place)
        until(loop, place / "raw" / "poor-1" / FRAMES, 1500)
        loop.send_signal(signal.SIGINT)
        printed = loop.communicate(timeout=120)[0]
    assert loop.returncode == 130, printed
    recording = read_recording((place / "raw" / "poor-1" / FRAMES).read_bytes())
    assert recording.account.end.reason == Reason.STOPPED and len(recording.time_s) < 400
    assert state(place, 0)["ended"] == "ended by Ctrl-C or kill"
    again = ended(place, "settle", "raw/poor-1", "--out", "out")
    assert again.returncode == 2 and "poor-1" in again.stdout and "Mend:" in again.stdout


def test_a_stop_that_is_said_elsewhere_stops_the_motor_and_then_the_loop(place):
    with rig(place, "--pace", 1):
        loop = started(place)
        until(loop, place / "raw" / "poor-1" / FRAMES, 1500)
        Answers(place / "out").stop()
        printed = loop.communicate(timeout=120)[0]
    assert loop.returncode == 130, printed
    recording = read_recording((place / "raw" / "poor-1" / FRAMES).read_bytes())
    assert recording.account.end.reason == Reason.STOPPED and state(place, 0)["state"] == "recorded"


@pytest.mark.long
def test_killed_in_the_first_recording_it_makes_what_came_usable(place):
    with rig(place, "--pace", 4):
        loop = started(place)
        until(loop, place / "raw" / "poor-1" / FRAMES, 20_000)
        loop.kill()
        loop.communicate()
        assert state(place, 0)["state"] == "approved" and not (place / "raw" / "poor-1" / "capture.json").exists()
        loop = started(place)
        until(loop, place / "out" / "step-1" / "state.json")
        loop.kill()
        loop.communicate()
    assert state(place, 0)["state"] == "diagnosed" and state(place, 0)["ended"] == "recovered"


def test_nothing_moves_before_the_page_says_yes(place):
    words = ["raw/poor-1", "--port", "port", "--out", "out", "--approve", "page"]
    refused = ended(place, "settle", *words)
    assert refused.returncode == 2 and "needs --limits" in refused.stdout
    with rig(place, "--pace", "inf"):
        loop = program(place, "settle", *words, "--limits", LIMITS)
        until(loop, place / "out" / "question.json")
        other = ended(place, "settle", *words, "--limits", LIMITS)
        assert other.returncode == 2 and "is the folder of a loop that is at work" in other.stdout
        time.sleep(0.5)
        assert state(place, 0)["state"] == "proposed" and not (place / "raw" / "poor-1" / FRAMES).exists()
        answers = Answers(place / "out")
        assert answers.approve(answers.question()["question"])
        until(loop, place / "raw" / "poor-1" / FRAMES)
        until(loop, place / "out" / "question.json")  # of step 1
        answers.stop()
        printed = loop.communicate(timeout=120)[0]
    assert loop.returncode == 130, printed
    assert state(place, 0)["approved_by"] == "a person, on the page" and state(place, 1)["state"] == "proposed"
    assert "stopped by somebody at the page: nothing moves" in printed and not (place / "raw" / "poor-1-s1").exists()


def test_a_rig_that_takes_no_program_has_its_first_recording_made_by_a_person(place):
    old = ScriptedRig(replace(Hello("an old rig", "1", "1", 50.0, 9, CHANNELS), protocol=1))
    loop = program(place, "settle", "raw/poor-1", "--port", old.port, "--out", "out")
    until(loop, place / "out" / "step-0" / "sheet.txt")
    sheet = (place / "out" / "step-0" / "sheet.txt").read_text()
    assert "at least four strokes from rest to rest" in sheet and "What the motor does" not in sheet
    Answers(place / "out").stop()
    printed = loop.communicate(timeout=120)[0]
    assert loop.returncode == 130 and not (place / "raw" / "poor-1" / FRAMES).exists(), printed
