"""Counts, places and times of an account's frames, by arithmetic that a person can follow."""

import struct

import numpy as np
import pytest
from test_wire_numbers import log, sample

from pipeline.wire import Account, Event, Kind, encode, read_recording
from pipeline.wire.batch import read_batch
from pipeline.wire.counters import from_one, steps_of
from pipeline.wire.frames import END, EVENT
from pipeline.wire.possible_numbers import LATE, Numbers
from pipeline.wire.timeline import Timeline

NEAR_THE_END = 2**32 - 2


def believed(numbers: Numbers, seq: int, t_us: int = 0, kind: int = Kind.SAMPLE) -> bool:
    payload = struct.pack("<Iih", t_us % 2**32, 1, 2) if kind == Kind.SAMPLE else b"1"
    return numbers.believe(kind, numbers.of(seq), payload)


def test_a_number_is_the_nearest_of_those_that_a_wrapping_counter_may_mean():
    numbers = Numbers(50.0, high=100)
    assert [numbers.of(seq) for seq in (101, 99, 100)] == [101, 99, 100]
    assert numbers.of(NEAR_THE_END) == -2, "before HELLO"
    numbers.high = NEAR_THE_END
    assert [numbers.of(seq) for seq in (2**32 - 1, 0, 3)] == [2**32 - 1, 2**32, 2**32 + 3]


def test_a_number_that_leaps_is_believed_once_another_frame_goes_on_from_there():
    for leap, is_doubted in ((LATE, False), (LATE + 1, True)):
        numbers = Numbers(50.0, high=7)
        assert believed(numbers, 7 + leap) != is_doubted
        assert numbers.high == (7 if is_doubted else 7 + leap)
        assert believed(numbers, 8 + leap), "it goes on"
        assert numbers.high == 8 + leap and numbers.others == 0
    numbers = Numbers(50.0, high=7)
    assert not believed(numbers, 7 + 5 * LATE) and not believed(numbers, 7 + 9 * LATE), "neither goes on"
    assert numbers.high == 7


def test_a_number_that_leaps_is_believed_where_the_clock_has_gone_on_as_far():
    step_us = 20_000  # at 50 Hz
    for passed, is_believed in ((2 * LATE, True), (LATE // 4, False)):
        numbers = Numbers(50.0)
        assert believed(numbers, 1, t_us=NEAR_THE_END)
        assert believed(numbers, 2 + 2 * LATE, t_us=NEAR_THE_END + passed * step_us) == is_believed


def test_an_end_is_believed_where_its_count_of_samples_fits_its_number():
    numbers = Numbers(50.0, high=10)
    ends = {number: numbers.ends(number, END.pack(samples, 0)) for number, samples in ((5000, 4999), (5001, 3000))}
    assert ends == {5000: True, 5001: False}
    assert numbers.ends(5000, END.pack(4999 - LATE, 0)) and not numbers.ends(5000, END.pack(4998 - LATE, 0))
    assert not numbers.ends(5000, END.pack(5000, 0)), "more samples than frames"
    numbers.high = LATE + 10
    assert numbers.ends(10, END.pack(1, 0)) and not numbers.ends(9, END.pack(1, 0)) and not numbers.ends(0, b"\0" * 5)


def test_steps_of_a_counter_are_the_short_way_round():
    stamps = np.array([NEAR_THE_END, 1, 0, 5], np.uint32)
    assert steps_of(stamps, NEAR_THE_END - 3).tolist() == [3, 3, -1, 5]
    assert steps_of(stamps[1:], 2**32 + NEAR_THE_END).tolist() == [3, -1, 5], "of a stamp that has wrapped"
    assert from_one(stamps, 2**32 + 1).tolist() == [-3, 0, -1, 4]


@pytest.mark.parametrize("more", [b"", b"\0", b"\0\0\0"])
def test_zeros_between_frames_are_no_bad_frames_and_what_follows_the_last_hangs_over(more):
    frames = log(3)
    for at in range(2):  # the last zero at an even and at an odd place
        data = b"\1" * at + b"\0" * bool(at) + more.join(frames) + b"\5\6\7"
        batch = read_batch(data)
        assert len(batch.bad_at) == at and batch.tail == 3
        assert batch.seq.tolist() == [0, 1, 2, 3] and np.all(np.diff(batch.start) > 0)
        assert all(
            data[end - 1] == 0 and 0 not in data[start : end - 1]
            for start, end in zip(batch.start, batch.end, strict=True)
        )


def test_an_account_of_nothing_counts_nothing():
    assert {value for value in vars(Account()).values()} == {0, (), None}


def test_an_event_before_the_first_sample_is_timed_by_that_one():
    hello = log(0)[0]
    events = ((1, 20_000), (5, 90_000))
    early, late = (encode(Kind.EVENT, seq, EVENT.pack(t_us, Event.STROKE_START, 1)) for seq, t_us in events)
    samples = [sample(number + 1, number * 20_000, number) for number in range(1, 4)]
    timed = read_recording(b"".join([hello, early, *samples, late])).account.events
    assert [event.time_s for event in timed] == [0.0, pytest.approx(0.07)], "since the first sample, at 20 ms"


def test_times_go_on_from_run_to_run_over_a_clock_that_wraps_or_falls_back():
    runs = [[1, 3, 2**32 - 300, 2**32 - 100, 200], [10, 2, 50, 60, 10], [20, 1, 40, 40, 0]]  # 150 us on, 20 us back
    timeline = Timeline.of(np.array(runs))
    assert timeline.end_us.tolist() == [200, 360, 340] and timeline.begin_us.tolist() == [0, 350, 340]
    assert timeline.samples.tolist() == [0, 3, 5, 6] and timeline.first_stamp == 2**32 - 300
    gap = timeline.gap(4, 6)
    assert (gap.after_samples, gap.frames, gap.after_s, gap.until_s) == (
        3,
        6,
        pytest.approx(2e-4),
        pytest.approx(3.5e-4),
    )
    ends = [timeline.gap(0, 1), timeline.gap(21, 1)]
    assert [(gap.after_s, gap.until_s) for gap in ends] == [(None, 0.0), (pytest.approx(3.4e-4), None)]
    assert Timeline.of(np.zeros((0, 5), np.int64)).first_stamp is None
