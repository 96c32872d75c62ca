"""Rigs that answer the loop badly, on the real program: a clear sentence, and nothing has moved."""

from dataclasses import replace
from pathlib import Path

import pytest
from scripted_rig import CHANNELS, ScriptedRig
from settle_bench import LIMITS, described, ended, program, set_up, state, until

from pipeline.settle.answers import Answers
from pipeline.wire import Hello, Kind
from pipeline.wire.motion import TAKEN, Answer, Limits

RIG = Limits(100, (0.0, 21.0), 9.0, 90.0, 600.0, 1.5, 0.0, None)
HELLO = Hello("a rig", "1", "1", 50.0, 9, CHANNELS)
HALF = TAKEN.pack(14, 7, Answer.TAKEN, 0)


@pytest.fixture
def place(tmp_path) -> Path:
    set_up(tmp_path)
    described(tmp_path)
    return tmp_path


def words(device: ScriptedRig, limits: str = LIMITS) -> list[str]:
    return ["raw/poor-1", "--port", device.port, "--out", "out", "--approve", "auto", "--limits", limits]


def rig(*answers: tuple[float, bytes], limits: Limits = RIG) -> ScriptedRig:
    return ScriptedRig(replace(HELLO, program=limits), [*answers])


@pytest.mark.parametrize(
    ("answers", "message"),
    [
        ([(0.0, HALF)] * 3, "the device did not answer it; nothing was moved"),
        ([(0.0, TAKEN.pack(14, 7, Answer.BROKEN, 0))] * 3, "the device refused it: it did not get it whole"),
        ([(0.0, TAKEN.pack(28, 7, Answer.LOAD, 3))], "leg 3: the device refused it: it does not have that load"),
        ([(0.0, TAKEN.pack(28, 7, 77, 0))], "the device refused it: its reason is 77"),
        ([(60.0, b"")], "the device did not answer it; nothing was moved"),
    ],
    ids=["took half of it", "says that it has half", "lacks a load", "a reason of its own", "answers too late"],
)
def test_a_program_that_is_not_taken_moves_nothing_and_is_a_sentence(answers, message, place):
    device = rig(*answers)
    done = ended(place, "settle", *words(device))
    assert done.returncode == 2 and message in done.stdout and "Mend:" in done.stdout, done.stdout
    assert Kind.START not in device.heard and not (place / "raw" / "poor-1" / "recording.frames").exists()
    assert state(place, 0)["state"] == "approved"


def test_an_answer_that_comes_late_is_taken(place):
    device = rig((0.6, b""))
    loop = program(place, "settle", *words(device))
    until(loop, place / "raw" / "poor-1" / "recording.frames")
    while Kind.START not in device.heard:
        assert loop.poll() is None, loop.stdout.read()
    Answers(place / "out").stop()
    printed = loop.communicate(timeout=120)[0]  # the rig says nothing more: that is a stop in good order
    assert loop.returncode in (1, 130) and "poor-1" in printed


@pytest.mark.parametrize(
    ("limits", "allowed", "message"),
    [
        (replace(RIG, load_n=(5.0, 60.0)), "{turns: [0, 21], turns_per_s: 9, seconds: 300}", "load_n must be given"),
        (RIG, "{turns: [0, 21], turns_per_s: 9, seconds: 10}", "does not fit in what is allowed"),
        (replace(RIG, legs=10), LIMITS, "and the device takes 1 to 10"),
    ],
)
def test_what_the_rig_cannot_do_is_said_before_anything_moves(limits, allowed, message, place):
    device = rig(limits=limits)
    done = ended(place, "settle", *words(device, allowed))
    assert done.returncode == 2 and message in done.stdout and set(device.heard) == {Kind.GREET}, done.stdout
