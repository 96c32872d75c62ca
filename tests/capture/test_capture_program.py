"""A device that answers a program late, oddly or not at all: a sentence, no run begun, and nothing moved."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from programs import ROOT, run
from scripted_rig import CHANNELS, ScriptedRig

from pipeline.capture import motion_program
from pipeline.capture.motion_program import load, strokes_of
from pipeline.capture.port import Port
from pipeline.ground.errors import BadInput
from pipeline.wire import Hello, Kind
from pipeline.wire.motion import TAKEN, Answer, Leg, Limits

LIMITS = Limits(10, (0.0, 20.0), 5.0, 50.0, 100.0, 1.5, 0.0)
HELLO = Hello("a rig", "1", "1", 50.0, 0, CHANNELS, program=LIMITS)
LEGS = [Leg(4.0, 10.0), Leg(4.0, 0.0)]
LITTLE_MEMORY = """
import resource, runpy
resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
runpy.run_module("pipeline.capture", run_name="__main__", alter_sys=True)
"""


def asked(*answers: tuple[float, bytes]) -> ScriptedRig:
    """What a rig heard that was handed a program; raises BadInput as that does."""
    rig = ScriptedRig(HELLO, list(answers))
    with Port(rig.port, 1_000_000) as port:
        load(port, HELLO, LEGS, "the rig")
    return rig


def test_an_answer_that_comes_late_is_taken():
    rig = asked((1.3, b""))
    assert rig.heard.count(Kind.PROGRAM) >= 1 and rig.heard.count(Kind.LEG) >= 2


def test_a_program_that_was_taken_in_half_is_handed_over_again():
    rig = asked((0.0, TAKEN.pack(1, 5, Answer.BROKEN, 0)), (0.0, b""))
    assert rig.heard == [Kind.LEG, Kind.LEG, Kind.PROGRAM] * 2


@pytest.mark.parametrize(
    ("answers", "message"),
    [
        ([], "did not answer it; nothing was moved"),
        ([(0.0, TAKEN.pack(2, 5, Answer.TAKEN, 0))], "did not answer it"),
        ([(0.0, TAKEN.pack(2, 5, Answer.LOAD, 2))], "leg 2: the device refused it: it does not have that load"),
        ([(0.0, TAKEN.pack(2, 5, 77, 0))], "its reason is 77"),
        ([(0.0, TAKEN.pack(1, 5, Answer.BROKEN, 0))] * 3, "it did not get it whole"),
    ],
    ids=["silent", "another program", "load", "unknown reason", "broken line"],
)
def test_what_is_not_taken_is_a_sentence(answers, message):
    with pytest.raises(BadInput, match=message):
        asked(*answers)


@pytest.mark.parametrize(
    ("program", "limits", "message"),
    [
        ({"legs": "many"}, LIMITS, "program.legs: is missing or is not a number"),
        ({"turns": [3, 1]}, LIMITS, "program.turns: its least is above its most"),
        ({"silence_s": 0}, LIMITS, "must be above 0"),
        ([], LIMITS, "program: is not an object"),
    ],
)
def test_limits_that_are_none_are_refused_before_anything_is_written(program, limits, message, tmp_path):
    content = json.loads(HELLO.pack())
    content["program"] = content["program"] | program if isinstance(program, dict) else program

    class Odd:
        protocol = HELLO.protocol

        def pack(self) -> bytes:
            return json.dumps(content).encode()

    rig = ScriptedRig(Odd())  # type: ignore[arg-type]
    done = run("pipeline.capture", rig.port, tmp_path / "run-1")
    assert done.returncode == 2 and message in done.stderr and not (tmp_path / "run-1").exists()


def test_a_rig_without_limits_takes_no_program(tmp_path: Path):
    rig = ScriptedRig(Hello("a rig", "1", "1", 50.0, 0, CHANNELS))
    path = tmp_path / "program.json"
    path.write_text(json.dumps([{"seconds": 4, "motor_turns": 10}]))
    done = run("pipeline.capture", rig.port, tmp_path / "run-1", "--program", path)
    assert done.returncode == 2 and "takes no program" in done.stderr
    assert set(rig.heard) == {Kind.GREET} and not (tmp_path / "run-1").exists()


@pytest.mark.parametrize("kind", ["a pipe", "a device", "too large", "not there"])
def test_a_program_that_is_no_file_or_too_large_is_refused_at_once(kind, tmp_path, monkeypatch):
    """A pipe was waited for without end, and /dev/zero took all memory."""
    path = Path("/dev/zero") if kind == "a device" else tmp_path / "program.json"
    if kind == "a pipe":
        os.mkfifo(path)
    elif kind == "too large":
        monkeypatch.setattr(motion_program, "LARGEST_PROGRAM", 100)
        path.write_text(json.dumps([{"seconds": 4, "motor_turns": 10}] * 10))
    if kind == "too large":
        done = run("pipeline.capture", "/dev/null", tmp_path / "run-1", "--program", path)
    else:  # in a process, which can be ended where it waits or takes all memory
        words = ["-c", LITTLE_MEMORY, "/dev/null", tmp_path / "run-1", "--program", path]
        done = subprocess.run([sys.executable, *words], cwd=ROOT, capture_output=True, text=True, timeout=60)
    is_kind = {"too large": "has more than 0.0001 MB", "not there": "is not there"}.get(kind, f"is {kind}, not a file")
    assert done.returncode == 2 and f"error: {path}: --program: {is_kind}. Mend: " in done.stderr, done.stderr


@pytest.mark.parametrize("text", ["{", "[1]", "{}", '{"next_run": null}', '[{"seconds": -1, "motor_turns": 2}]'])
def test_a_file_without_a_program_is_refused(text, tmp_path):
    path = tmp_path / "program.json"
    path.write_text(text)
    done = run("pipeline.capture", "/dev/null", tmp_path / "run-1", "--program", path)
    assert done.returncode == 2 and "--program" in done.stderr and "Mend:" in done.stderr


@pytest.mark.parametrize(
    ("turns", "at", "strokes"),
    [
        ([10, 0], 0, 1),
        ([0, 10, 10, 0, 0, 20, 0], 0, 2),
        ([5, 10, 10, 12, 3, 8], 0, 2),
        ([3, 0], 10, 0),
        ([10, 10], 10, 0),
        ([], 0, 0),
    ],
)
def test_a_program_has_as_many_strokes_as_it_begins_to_wind(turns, at, strokes):
    assert strokes_of([Leg(1.0, float(end)) for end in turns], float(at)) == strokes
