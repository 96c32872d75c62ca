"""Programs of motion on the reference firmware, for this computer and on an Arduino Uno in simavr."""

import json
import struct
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import ready
from firmware.builds import SMALL, for_the_uno, for_this_computer, running, simulator
from firmware.test_firmware import Talk

from pipeline.wire import Decoder, Event, Hello, Kind, Reason, encode, read_recording
from pipeline.wire.frames import END, EVENT
from pipeline.wire.motion import PROGRAM, TAKEN, Answer, Leg, cruise, packed, refusal

GOOD = [Leg(1.0, 0.0), Leg(2.0, 4.0), Leg(0.5, 4.0), Leg(4.0, 1.0), Leg(1.0, 2.5), Leg(2.0, 0.0)]


COUNTS_PER_TURN, SAMPLE = 4096, struct.Struct("<IiiH")


@pytest.fixture(scope="module", params=["here", "uno"])
def board(request, tmp_path_factory) -> tuple[Path, ...]:
    """The command that runs a board."""
    place = tmp_path_factory.mktemp("firmware")
    if request.param == "here":
        return (for_this_computer(place / "board"),)
    return simulator(place / "uno"), for_the_uno(place / "rig.elf", *SMALL)


@contextmanager
def talk(board: tuple[Path, ...], **settings: object) -> Iterator[Talk]:
    """A host at a board that runs at about the pace of life."""
    with running(*board, **({"PACE": 1} | settings)) as port:
        yield Talk(port)


def asked(host: Talk, legs: list[Leg], crc: int | None = None, leave_out: int | None = None) -> tuple[int, ...]:
    """What TAKEN says of a program."""
    payloads, ours = packed(legs)
    for number, payload in enumerate(payloads):
        if number != leave_out:
            host.say(encode(Kind.LEG, number, payload))
            time.sleep(0.002)
    host.say(encode(Kind.PROGRAM, 9, PROGRAM.pack(len(legs), ours if crc is None else crc)))
    return TAKEN.unpack(host.until(Kind.TAKEN)[-1].payload)


def greeted(host: Talk) -> Hello:
    host.say(encode(Kind.GREET, 0))
    return Hello.unpack(host.until(Kind.HELLO)[-1].payload)


def begun(host: Talk, legs: list[Leg]) -> None:
    """Hand a program over and start it."""
    host.until(Kind.HELLO)  # of the boot
    greeted(host)
    assert asked(host, legs)[2] == Answer.TAKEN
    host.say(encode(Kind.START, 1))


def ended(host: Talk, reason: Reason) -> float:
    """Where the motor stands after END has come and been acknowledged; it stands there still when asked again."""
    last = host.until(Kind.END)[-1]
    assert END.unpack(last.payload)[1] == reason
    host.say(encode(Kind.ACK, last.seq))
    at_turns = greeted(host).program.at_turns
    time.sleep(0.3)
    assert greeted(host).program.at_turns == at_turns
    return at_turns


def test_it_declares_its_limits_and_refuses_what_is_beyond_them_as_the_host_does(board):
    with talk(board, PACE=2) as host:
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


@pytest.mark.parametrize("board", ["here", pytest.param("uno", marks=pytest.mark.long)], indirect=True)
def test_it_follows_a_program_leg_by_leg(board, tmp_path):
    program = tmp_path / "program.json"
    program.write_text(json.dumps([{"seconds": leg.seconds, "motor_turns": leg.turns} for leg in GOOD]))
    with running(*board, PACE=1) as port:  # silence of the host is counted in the board's time
        done = ready.run("pipeline.capture", port, tmp_path / "pc-1", "--program", program)
    assert done.returncode == 0, done.stdout + done.stderr
    recording = read_recording((tmp_path / "pc-1" / "recording.frames").read_bytes())
    assert recording.account.end.reason == Reason.COMPLETE and recording.account.lost == 0
    ends_s = np.cumsum([leg.seconds for leg in GOOD])
    assert recording.time_s[-1] == pytest.approx(ends_s[-1], abs=0.02)
    at = np.interp(ends_s, recording.time_s, recording.channels["motor_turns"])
    np.testing.assert_allclose(at, [leg.turns for leg in GOOD], atol=0.02)
    way = np.interp([4.5, 6.5], recording.time_s, recording.channels["motor_turns"])  # of 3 turns in 4 s, with ramps
    assert way[0] - way[1] == pytest.approx(2 * cruise(3.0, 4.0, 16.0), abs=0.01)
    events = [(event.code, event.value) for event in recording.events]
    assert events == [(code, number) for number in (1, 2) for code in (Event.STROKE_START, Event.STROKE_END)]


def test_it_stops_when_the_host_goes_silent_and_says_where(board):
    with talk(board) as host:
        begun(host, [Leg(10.0, 5.0)])
        for _ in range(8):
            host.say(encode(Kind.BEAT, 2))
            assert not [
                decoded for decoded in Decoder().feed(b"".join(host.hear(0.25))) if decoded.frame.kind == Kind.END
            ]
        assert 0.1 < ended(host, Reason.SILENCE) < 2.5


def test_stop_stops_it_at_once_and_the_next_program_begins_where_it_stands(board):
    with talk(board) as host:
        begun(host, [Leg(10.0, 5.0)])
        counts = 0
        while counts < 0.5 * COUNTS_PER_TURN:
            counts = SAMPLE.unpack(host.until(Kind.SAMPLE)[-1].payload)[1]
            host.say(encode(Kind.BEAT, 2))
        host.say(encode(Kind.STOP, 2))
        stands = ended(host, Reason.STOPPED)
        assert 0.5 <= stands < 2.0
        assert asked(host, [Leg(1.0, stands + 3.2)])[2:] == (Answer.SPEED, 1)
        assert asked(host, [Leg(1.0, stands + 2.8)])[2] == Answer.TAKEN, "from 0 turns it were too far"


def test_a_stall_stops_a_program_as_a_fault(board):
    with talk(board, STALL_TURNS=1.0) as host:
        begun(host, [Leg(2.0, 4.0), Leg(2.0, 0.0)])
        events = [EVENT.unpack(decoded.payload)[1:] for decoded in host.until(Kind.END) if decoded.kind == Kind.EVENT]
        assert events == [(Event.STROKE_START, 1), (Event.FAULT, 1)]
        host.say(encode(Kind.GREET, 0))
        assert 1.2 < Hello.unpack(host.until(Kind.HELLO)[-1].payload).program.at_turns < 1.6


def test_half_a_program_moves_nothing(board):
    with talk(board) as host:
        host.until(Kind.HELLO)
        greeted(host)
        payloads, _ = packed([Leg(2.0, 4.0), Leg(2.0, 0.0)])
        host.say(encode(Kind.LEG, 0, payloads[0]))
        host.say(encode(Kind.BEAT, 2))
        host.hear(0.5)
        assert greeted(host).program.at_turns == 0.0
        assert asked(host, [Leg(2.0, 4.0), Leg(2.0, 0.0)], leave_out=0)[2] == Answer.BROKEN
        assert greeted(host).program.at_turns == 0.0
