"""Programs of motion on the reference firmware, compiled for this computer, over a pseudo-terminal."""

import json
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from firmware.builds import for_this_computer, running
from firmware.test_firmware import Talk

from pipeline.wire import Decoder, Event, Hello, Kind, Reason, encode, read_recording
from pipeline.wire.frames import END
from pipeline.wire.motion import PROGRAM, TAKEN, Answer, Leg, cruise, packed, refusal

GOOD = [Leg(1.0, 0.0), Leg(2.0, 4.0), Leg(0.5, 4.0), Leg(4.0, 1.0), Leg(1.0, 2.5), Leg(2.0, 0.0)]


@pytest.fixture(scope="module")
def board(tmp_path_factory) -> Path:
    return for_this_computer(tmp_path_factory.mktemp("firmware") / "board")


def asked(host: Talk, legs: list[Leg], crc: int | None = None, leave_out: int | None = None) -> tuple[int, ...]:
    """What TAKEN says of a program."""
    payloads, ours = packed(legs)
    for number, payload in enumerate(payloads):
        if number != leave_out:
            host.say(encode(Kind.LEG, number, payload))
    host.say(encode(Kind.PROGRAM, 9, PROGRAM.pack(len(legs), ours if crc is None else crc)))
    frames = [one.frame for one in Decoder().feed(b"".join(host.hear(0.4)))]
    (taken,) = [frame for frame in frames if frame.kind == Kind.TAKEN]
    return TAKEN.unpack(taken.payload)


def greeted(host: Talk) -> Hello:
    host.say(encode(Kind.GREET, 0))
    frames = [one.frame for one in Decoder().feed(b"".join(host.hear(0.4)))]
    return Hello.unpack([frame for frame in frames if frame.kind == Kind.HELLO][-1].payload)


def test_it_declares_its_limits_and_refuses_what_is_beyond_them_as_the_host_does(board):
    with running(board, PACE=4) as port:
        host = Talk(port)
        limits = greeted(host).program
        assert limits is not None and limits.turns == (0.0, 5.0) and limits.at_turns == 0 and limits.load_n is None
        assert (limits.turns_per_s, limits.legs, limits.silence_s) == (4.0, 48, 1.5)
        assert limits.turns_per_s2 == pytest.approx(16.0, rel=0.01)
        for legs, answer, leg in (
            ([Leg(2.0, 5.1)], Answer.TURNS, 1),
            ([Leg(2.0, 1.0), Leg(2.0, -0.01)], Answer.TURNS, 2),
            ([Leg(1.4, 5.0)], Answer.SPEED, 1),
            ([Leg(0.2, 1.0)], Answer.ACCELERATION, 1),
            ([Leg(2.0, 1.0, 20.0)], Answer.LOAD, 1),
            ([Leg(3000.0, 1.0), Leg(601.0, 0.0)], Answer.SECONDS, 0),
            ([Leg(1.0, 0.0)] * 49, Answer.LEGS, 0),
        ):
            assert asked(host, legs)[2:] == (answer, leg)
            by_host = refusal(legs, limits)
            assert by_host is not None and by_host[:2] == (answer, leg)
        assert asked(host, GOOD, crc=7)[2] == Answer.BROKEN
        assert asked(host, GOOD, leave_out=2)[2] == Answer.BROKEN
        assert asked(host, GOOD) == (len(GOOD), packed(GOOD)[1], Answer.TAKEN, 0)
        host.say(encode(Kind.START, 1))
        assert asked(host, GOOD)[2] == Answer.BUSY


def test_it_follows_a_program_leg_by_leg(board, tmp_path):
    program = tmp_path / "program.json"
    program.write_text(json.dumps([{"seconds": leg.seconds, "motor_turns": leg.turns} for leg in GOOD]))
    with running(board, PACE=4) as port:
        words = [sys.executable, "-m", "pipeline.capture", port, str(tmp_path / "pc-1"), "--program", str(program)]
        done = subprocess.run(words, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    recording = read_recording((tmp_path / "pc-1" / "recording.frames").read_bytes())
    assert recording.account.end.reason == Reason.COMPLETE and recording.account.lost == 0
    ends_s = np.cumsum([leg.seconds for leg in GOOD])
    assert recording.time_s[-1] == pytest.approx(ends_s[-1], abs=0.02)
    at = np.interp(ends_s, recording.time_s, recording.channels["motor_turns"])
    np.testing.assert_allclose(at, [leg.turns for leg in GOOD], atol=0.02)
    way = np.interp([4.5, 6.5], recording.time_s, recording.channels["motor_turns"])  # of 3 turns in 4 s, with ramps
    assert way[0] - way[1] == pytest.approx(2 * cruise(3.0, 4.0, 16.0), abs=0.01)
    told = [(event.code, event.value) for event in recording.events]
    assert told == [(code, number) for number in (1, 2) for code in (Event.STROKE_START, Event.STROKE_END)]


def test_it_stops_when_the_host_goes_silent_and_says_where(board):
    with running(board, PACE=1) as port:
        host = Talk(port)
        greeted(host)
        assert asked(host, [Leg(10.0, 5.0)])[2] == Answer.TAKEN
        host.say(encode(Kind.START, 1))
        until_s = time.monotonic() + 2.0
        frames = []
        while time.monotonic() < until_s:
            host.say(encode(Kind.BEAT, 2))
            frames += host.hear(0.2)
        assert not [one for one in Decoder().feed(b"".join(frames)) if one.frame.kind == Kind.END]
        heard = Decoder().feed(b"".join(host.hear(2.0)))
        end = next(one.frame for one in heard if one.frame.kind == Kind.END)
        assert END.unpack(end.payload)[1] == Reason.SILENCE
        at_turns = greeted(host).program.at_turns
        assert 1.0 < at_turns < 2.5
        assert greeted(host).program.at_turns == at_turns  # it stands
