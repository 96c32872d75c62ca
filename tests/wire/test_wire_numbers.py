"""Numbers and stamps that cannot be true cost their own frame and nothing else; both protocol versions are read."""

import struct
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pipeline.wire import Channel, Event, Hello, Kind, Reason, encode, read_recording
from pipeline.wire.frames import END, EVENT
from pipeline.wire.mending import Mending, usual_steps

CHANNELS = (Channel("motor_turns", "turns", "i32", 0.25), Channel("displacement_mm", "mm", "i16", 0.02))
HELLO = Hello("a rig", "1.0", "00000001", 50.0, 2, CHANNELS)
STEP_US = 20_000


def sample(seq: int, t_us: int, turns: int = 1, protocol: int = 2) -> bytes:
    return encode(Kind.SAMPLE, seq, struct.pack("<Iih", t_us % 2**32, turns, 2), protocol)


def end(seq: int, samples: int, protocol: int = 2) -> bytes:
    return encode(Kind.END, seq, END.pack(samples, Reason.COMPLETE), protocol)


def log(count: int, protocol: int = 2) -> list[bytes]:
    """HELLO and `count` samples, without an END."""
    hello = encode(Kind.HELLO, 0, replace(HELLO, protocol=protocol).pack(), protocol)
    return [hello, *(sample(number, number * STEP_US, number, protocol) for number in range(1, count + 1))]


@pytest.mark.parametrize("protocol", [1, 2])
def test_a_recording_of_either_version_is_read(protocol):
    recording = read_recording(b"".join([*log(100, protocol), end(101, 100, protocol)]))
    assert recording.hello == replace(HELLO, protocol=protocol)
    assert (recording.account.sent, recording.account.lost, recording.account.bad) == (102, 0, 0)
    np.testing.assert_array_equal(recording.channels["motor_turns"], 0.25 * np.arange(1, 101))


def test_a_frame_under_the_other_versions_check_is_a_damaged_one():
    frames = log(100)
    frames[50] = sample(50, 50 * STEP_US, 50, protocol=1)
    account = read_recording(b"".join(frames)).account
    assert (account.samples, account.lost, account.bad) == (99, 1, 1)


@pytest.mark.parametrize("kind", [Kind.SAMPLE, Kind.EVENT, Kind.END, 99])
@pytest.mark.parametrize("seq", [2_000_000_000, 2**32 - 5, 1_500])
@pytest.mark.parametrize("at", [60, 101])
def test_a_false_frame_is_not_taken_for_millions_that_are_lost(kind, seq, at):
    payload = {
        Kind.SAMPLE: struct.pack("<Iih", at * STEP_US, 1, 2),
        Kind.EVENT: EVENT.pack(at * STEP_US, Event.STROKE_START, 1),
        Kind.END: END.pack(77_777, Reason.COMPLETE),
    }.get(kind, b"1")
    frames = log(100, protocol=1)
    frames.insert(at, encode(kind, seq, payload, 1))
    recording = read_recording(b"".join(frames))
    account = recording.account
    assert (account.sent, account.received, account.lost, account.repeated) == (101, 101, 0, 1)
    assert len(recording.time_s) == 100 and account.end is None


@pytest.mark.parametrize("lost", [5, 900, 50_000])
def test_a_loss_that_the_clock_speaks_for_is_believed(lost):
    frames = log(100 + lost + 50)
    account = read_recording(b"".join([*frames[:100], *frames[100 + lost :]])).account
    assert (account.lost, account.samples) == (lost, 150)


def test_a_loss_that_no_clock_speaks_for_is_believed_with_the_second_frame():
    late = [sample(number, 101 * STEP_US, number) for number in range(50_001, 50_051)]
    account = read_recording(b"".join([*log(100), *late])).account
    assert (account.sent, account.samples, account.lost) == (50_051, 149, 49_901)


def test_an_end_after_a_great_loss_is_believed_by_its_count_of_samples():
    account = read_recording(b"".join([*log(100), end(5_001, 5_000)])).account
    assert account.end.samples == 5_000 and account.lost == 4_900


def test_an_end_before_what_has_come_is_none():
    recording = read_recording(b"".join([*log(3_000), end(5, 4), sample(3_001, 3_001 * STEP_US), end(3_002, 3_001)]))
    assert recording.account.end.seq == 3_002 and len(recording.time_s) == 3_001


def mend(time_us: np.ndarray, numbers: np.ndarray) -> tuple[np.ndarray, dict[str, int]]:
    """Mended stamps since the first, and how often each rule was needed."""
    steps = (np.diff(time_us).astype(float), usual_steps(np.diff(numbers)))
    mending = Mending.of(lambda: iter([steps]))
    return time_us[0] + np.concatenate(list(mending.stamps([steps]))), mending.counted


def stamped(t_us: list[int]) -> bytes:
    return b"".join([log(0)[0], *(sample(number, stamp) for number, stamp in enumerate(t_us, 1))])


def test_one_stamp_that_falls_back_is_put_between_its_neighbours():
    t_us = [number * STEP_US for number in range(1000)]
    t_us[500] -= 65_536
    recording = read_recording(stamped(t_us))
    np.testing.assert_allclose(recording.time_s, np.arange(1000) * 0.02, atol=1e-9)
    assert recording.mended == {"backward_time_stamps": 1}
    assert (recording.account.backward_stamps, recording.account.repeated_stamps) == (1, 0)


def test_two_equal_stamps_are_spread_up_to_the_next():
    t_us = [number * STEP_US for number in range(1000)]
    t_us[500] = t_us[499]
    recording = read_recording(stamped(t_us))
    np.testing.assert_allclose(recording.time_s, np.arange(1000) * 0.02, atol=1e-9)
    assert recording.mended == {"repeated_time_stamps": 1} and recording.account.repeated_stamps == 1


@pytest.mark.parametrize("at", [499, 500])
def test_a_bad_stamp_before_a_pause_leaves_the_pause_and_what_is_lost_after_it_where_they_are(at):
    numbers = np.delete(np.arange(1000), [at + 2, at + 3])
    truth = numbers * STEP_US + (numbers > at) * 2_000_000
    time_us, mended = mend(truth - (numbers == at) * 30_000, numbers)
    np.testing.assert_allclose(time_us, truth, atol=1.0)
    assert mended == {"backward_time_stamps": 1}


@pytest.mark.parametrize("first_right", [True, False])
def test_a_first_or_a_last_stamp_that_leaps_is_put_beside_its_neighbour(first_right):
    truth = np.arange(200) * STEP_US
    leaps = np.where(np.arange(200) == (199 if first_right else 0), 1, 0) * (1 if first_right else -1)
    time_us, mended = mend(truth + leaps * 60_000_000, np.arange(200))
    np.testing.assert_allclose(time_us - time_us[0], truth, atol=1.0)
    assert mended == {"leaping_time_stamps": 1}


def test_a_clock_that_is_set_back_for_good_goes_on_one_step_later():
    t_us = [number * STEP_US - (number >= 500) * 9_000_000 + 10_000_000 for number in range(1000)]
    recording = read_recording(stamped(t_us))
    np.testing.assert_allclose(recording.time_s, np.arange(1000) * 0.02, atol=1e-9)
    assert recording.mended == {"backward_time_stamps": 1}


@given(
    st.sets(st.integers(1, 298), max_size=12),
    st.sets(st.integers(1, 298), max_size=30),
    st.lists(st.sampled_from([-65_536, 65_536, -300_000, -25_000, -(2**24), 2**20]), min_size=12, max_size=12),
)
def test_a_few_bad_stamps_cost_themselves(bad, lost, errors):
    truth = np.arange(300) * STEP_US
    stamps = truth.copy()
    for at, error in zip(sorted(bad), errors, strict=False):
        stamps[at] += error
    numbers = np.array([at for at in range(300) if at not in lost])
    time_us, mended = mend(stamps[numbers], numbers)
    assert (np.diff(time_us) > 0).all()
    right = ~np.isin(numbers, list(bad))
    apart = [b - a for a, b in zip(sorted(bad), sorted(bad)[1:], strict=False)]
    if not lost and min(apart, default=9) > 2:  # with two beside each other nobody can say which is right
        np.testing.assert_allclose(time_us[right] - time_us[0], truth[numbers][right], atol=1.0)
        np.testing.assert_allclose(time_us - time_us[0], truth[numbers], atol=STEP_US)
    if not mended:
        np.testing.assert_array_equal(time_us, stamps[numbers])


@pytest.mark.parametrize("step_us", [0, -STEP_US])
def test_a_clock_that_stands_or_runs_backwards_is_none(step_us):
    recording = read_recording(stamped([10_000_000 + number * step_us for number in range(100)]))
    assert recording.account.no_clock and not recording.mended
    np.testing.assert_allclose(recording.time_s, np.arange(100) * step_us * 1e-6)


def test_a_coarse_clock_is_a_clock():
    recording = read_recording(stamped([number // 5 * 5 * STEP_US for number in range(100)]))
    assert not recording.account.no_clock
    np.testing.assert_allclose(recording.time_s[:-5], np.arange(95) * 0.02, atol=1e-9)


def test_the_numbers_of_the_protocol_are_those_of_its_page():
    assert {kind.name: int(kind) for kind in Kind} == {
        "HELLO": 1, "SAMPLE": 2, "EVENT": 3, "END": 4, "TAKEN": 5,
        "GREET": 0x81, "START": 0x82, "STOP": 0x83, "ACK": 0x84, "LEG": 0x85, "PROGRAM": 0x86, "BEAT": 0x87,
    }  # fmt: skip
    reasons = {reason.name: int(reason) for reason in Reason}
    assert reasons == {"COMPLETE": 0, "STOPPED": 1, "FAULT": 2, "SILENCE": 3}
    assert [event.name for event in Event] == ["STROKE_START", "STROKE_END", "FAULT"] and list(Event) == [1, 2, 3]
