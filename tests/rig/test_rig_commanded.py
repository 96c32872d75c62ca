"""A rig that takes programs of motion: what it refuses, follows and stops, over frames and over a pseudo-terminal."""

import json
import os
import signal
import time
import zlib
from contextlib import ExitStack
from itertools import count
from pathlib import Path

import numpy as np
import pytest
from ready import start
from scripted_rig import synthetic_rig

from pipeline.capture.motion_program import as_legs
from pipeline.rig.commanded import Commanded
from pipeline.rig.kept_string import Standing, followed
from pipeline.rig.setup import read_setup
from pipeline.wire import Decoder, Kind, Reason, encode, read_recording
from pipeline.wire.frames import END
from pipeline.wire.motion import LEG, PROGRAM, TAKEN, Answer, Leg, cruise, packed

GOOD = [Leg(2.0, 0.0), Leg(4.0, 10.0, 40.0), Leg(1.0, 10.0, 40.0), Leg(4.0, 0.0, 40.0)]


@pytest.fixture
def standing() -> Standing:
    return Standing(read_setup("small"), 3)


def said(device: Commanded) -> list:
    return [heard.frame for heard in Decoder().feed(device.speak())]


def tell(device: Commanded, legs: list[Leg], crc: int | None = None) -> tuple[int, int]:
    """Answer and leg that a program is answered with."""
    payloads, ours = packed(legs)
    for number, payload in enumerate(payloads):
        device.hear(encode(Kind.LEG, number, payload))
    device.hear(encode(Kind.PROGRAM, 9, PROGRAM.pack(len(legs), ours if crc is None else crc)))
    (frame,) = [frame for frame in said(device) if frame.kind == Kind.TAKEN]
    return TAKEN.unpack(frame.payload)[2:]


def test_the_check_of_a_program_is_that_of_zip_over_its_legs_as_the_page_writes_them():
    payloads, crc = packed([Leg(1.5, -2.25), Leg(0.5, 3.0, 20.0)])
    by_hand = bytes.fromhex("0000 dc050000 36f7ffff 00000080  0100 f4010000 b80b0000 204e0000".replace(" ", ""))
    assert b"".join(payloads) == by_hand and crc == zlib.crc32(by_hand)
    assert (LEG.size, PROGRAM.size, TAKEN.size) == (14, 6, 9)


def test_a_way_takes_the_time_that_it_is_given_and_its_ramps_are_even():
    speed = cruise(10.0, 4.0, 20.0)
    ramp_s = speed / 20.0
    assert speed * (4.0 - 2 * ramp_s) + speed * ramp_s == pytest.approx(10.0)
    assert cruise(10.0, 1.0, 20.0) is None


def test_legs_are_followed_from_standstill_to_standstill():
    trajectory = followed(GOOD, 0.0, 20.0, 100.0, 0.01)
    at = dict(zip(np.round(trajectory.time_s, 6).tolist(), trajectory.motor_turns.tolist(), strict=True))
    assert [at[second] for second in (0, 2, 6, 7, 11)] == pytest.approx([0, 0, 10, 10, 0], abs=1e-9)
    assert np.abs(np.diff(trajectory.motor_turns)).max() / 0.01 <= cruise(10, 4, 100) * 1.001
    assert set(trajectory.load_n[trajectory.time_s < 1.99]) == {20.0} and set(
        trajectory.load_n[trajectory.time_s > 2.01]
    ) == {40.0}
    assert trajectory.strokes_s.tolist() == [[2.0, 6.0, 7.0, 11.0]]


@pytest.mark.parametrize(
    ("legs", "answer", "leg"),
    [
        (GOOD, Answer.TAKEN, 0),
        ([Leg(4.0, 23.0)], Answer.TURNS, 1),
        ([Leg(2.0, 0.0), Leg(4.0, -0.1)], Answer.TURNS, 2),
        ([Leg(1.5, 20.0)], Answer.SPEED, 1),
        ([Leg(0.1, 2.0)], Answer.ACCELERATION, 1),
        ([Leg(1.0, 0.0, 200.0)], Answer.LOAD, 1),
        ([Leg(1801.0, 0.0), Leg(1801.0, 0.0)], Answer.SECONDS, 0),
        ([Leg(1.0, 0.0)] * 201, Answer.LEGS, 0),
    ],
)
def test_what_is_beyond_the_limits_is_refused_by_the_device_with_the_leg(standing, legs, answer, leg):
    device = Commanded(standing)
    assert tell(device, legs) == (answer, leg)
    device.hear(encode(Kind.START, 1))
    assert (device.program is not None) == (answer == Answer.TAKEN)


def test_half_a_program_is_not_taken(standing):
    device = Commanded(standing)
    assert tell(device, GOOD, crc=1)[0] == Answer.BROKEN and device.program is None
    payloads, crc = packed(GOOD)
    for number in (0, 1, 3):
        device.hear(encode(Kind.LEG, number, payloads[number]))
    device.hear(encode(Kind.PROGRAM, 9, PROGRAM.pack(len(GOOD), crc)))
    (frame,) = said(device)
    assert TAKEN.unpack(frame.payload)[2] == Answer.BROKEN and device.program is None
    assert tell(device, GOOD)[0] == Answer.TAKEN
    device.hear(encode(Kind.START, 1))
    assert tell(device, GOOD)[0] == Answer.BUSY


def test_a_stopped_program_leaves_the_motor_and_the_string_where_they_were(standing):
    device = Commanded(standing)
    tell(device, GOOD)
    device.hear(encode(Kind.START, 1))
    device.speak(4.0)
    device.hear(encode(Kind.STOP, 2))
    end = said(device)[-1]
    samples, reason = END.unpack(end.payload)
    assert reason == Reason.STOPPED
    expected = followed(GOOD, 0.0, 20.0, standing.limits.turns_per_s2, standing.step_s)
    steps = samples * standing.setup.steps_per_sample
    assert standing.at_turns == pytest.approx(expected.motor_turns[steps - 1]) and 4 < standing.at_turns < 6
    assert standing.string.motor_rad == pytest.approx(standing.at_turns * 2 * np.pi)


def test_the_string_of_the_second_recording_has_lived_through_the_first():
    used_string, other = (Standing(read_setup("small"), 3) for _ in range(2))
    used_string.perform([*GOOD, *GOOD[1:] * 5])
    assert used_string.perform(GOOD).truth["displacement_mm"][0] != other.perform(GOOD).truth["displacement_mm"][0]


# over a pseudo-terminal, with the real programs


@pytest.fixture
def rig(tmp_path):
    numbers = count()
    with ExitStack() as rigs:
        yield lambda *options: rigs.enter_context(
            synthetic_rig(tmp_path / f"port{next(numbers)}", "small", "--standing", *options)
        )


def entries(legs: list[Leg]) -> list[dict]:
    return [{"seconds": leg.seconds, "motor_turns": leg.turns, "load_n": leg.load_n or 20.0} for leg in legs]


def programmed(tmp_path: Path, legs: list[Leg]) -> Path:
    path = tmp_path / "program.json"
    path.write_text(json.dumps(entries(legs)))
    return path


def test_a_program_is_recorded_as_it_was_told_and_the_next_goes_on_from_there(rig, tmp_path):
    port, program = rig("--pace", 20), programmed(tmp_path, GOOD[:2])
    printed = start("pipeline.capture", port, tmp_path / "run-1", "--program", program).communicate()[0]
    recording = read_recording((tmp_path / "run-1" / "recording.frames").read_bytes())
    assert "complete" in printed and recording.account.lost == 0, printed
    assert recording.time_s[-1] == pytest.approx(6.0, abs=0.06)
    turns = recording.channels["motor_turns"]
    assert (turns[0], turns[-1]) == pytest.approx((0.0, 10.0), abs=1e-3)
    assert recording.channels["load_n"][-1] == pytest.approx(40.0, abs=0.5)
    program = programmed(tmp_path, GOOD[2:])
    start("pipeline.capture", port, tmp_path / "run-2", "--program", program).communicate()
    turns = read_recording((tmp_path / "run-2" / "recording.frames").read_bytes()).channels["motor_turns"]
    assert (turns[0], turns[-1]) == pytest.approx((10.0, 0.0), abs=1e-3)


def test_a_program_beyond_a_limit_is_refused_with_a_sentence_and_no_run_is_begun(rig, tmp_path):
    port = rig("--fixed-load")
    for legs, sentence in (
        ([Leg(20.0, 30.0)], "goes to 30 turns, and the rig goes from 0 to 22"),
        (GOOD, "the rig cannot change its load"),
    ):
        program = start("pipeline.capture", port, tmp_path / "run-1", "--program", programmed(tmp_path, legs))
        printed = program.communicate()[0]
        assert program.returncode == 2 and sentence in printed and "Mend:" in printed and "Traceback" not in printed
        assert not (tmp_path / "run-1").exists()


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGSTOP], ids=["killed", "hangs"])
def test_a_host_that_goes_silent_stops_the_motor(rig, tmp_path, how):
    port, folder = rig("--pace", 1), tmp_path / "run-1"
    host = start("pipeline.capture", port, folder, "--program", programmed(tmp_path, [Leg(30.0, 20.0)]))
    while not (folder / "recording.frames").exists() or (folder / "recording.frames").stat().st_size < 1200:
        assert host.poll() is None
        time.sleep(0.02)
    host.send_signal(how)
    time.sleep(2.5)  # of silence 1.5 are allowed
    if how == signal.SIGKILL:
        host.communicate()
    else:
        host.send_signal(signal.SIGCONT)
        printed = host.communicate()[0]
        assert host.returncode == 1 and "did not hear this program" in printed
        info = json.loads((folder / "capture.json").read_text())
        assert info["exit_status"] == "fault"
    end = os.open(os.path.realpath(port), os.O_RDWR | os.O_NOCTTY)
    try:
        heard, until_s = [], time.monotonic() + 3
        os.write(end, encode(Kind.GREET, 0))
        decoder = Decoder()
        while not any(heard_frame.frame.kind == Kind.HELLO for heard_frame in heard) and time.monotonic() < until_s:
            heard += decoder.feed(os.read(end, 4096))
    finally:
        os.close(end)
    (hello,) = [json.loads(heard_frame.frame.payload) for heard_frame in heard if heard_frame.frame.kind == Kind.HELLO]
    assert 0.2 < hello["program"]["at_turns"] < 5.0  # of 20, and it is not moved any more


def test_a_stall_ends_the_recording_as_a_fault(rig, tmp_path):
    port = rig("--pace", 20, "--stalls-at", 5)
    host = start("pipeline.capture", port, tmp_path / "run-1", "--program", programmed(tmp_path, GOOD))
    printed = host.communicate()[0]
    assert host.returncode == 1 and "reported a fault" in printed
    recording = read_recording((tmp_path / "run-1" / "recording.frames").read_bytes())
    assert recording.channels["motor_turns"].max() < 8.0 and recording.account.end.reason == Reason.FAULT


def test_ctrl_c_stops_the_motor_and_what_came_is_kept(rig, tmp_path):
    port, folder = rig("--pace", 1), tmp_path / "run-1"
    host = start("pipeline.capture", port, folder, "--program", programmed(tmp_path, [Leg(30.0, 20.0)]))
    while not (folder / "recording.frames").exists() or (folder / "recording.frames").stat().st_size < 1200:
        assert host.poll() is None
        time.sleep(0.02)
    host.send_signal(signal.SIGINT)
    host.communicate()
    info = json.loads((folder / "capture.json").read_text())
    assert info["exit_status"] == "aborted" and info["ended_by"] == "person"
    assert read_recording((folder / "recording.frames").read_bytes()).account.end.reason == Reason.STOPPED


@pytest.mark.parametrize("bad", [[{"seconds": 1}], [1], [{"seconds": float("inf"), "motor_turns": 1}], {}, "x"])
def test_legs_that_are_none_are_refused(bad, tmp_path):
    with pytest.raises(ValueError):
        as_legs(bad if isinstance(bad, list) else [bad])
