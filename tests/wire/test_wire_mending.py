"""How stamps are mended at the limits: bursts as long as may be, ends that leap, and no sample held for longer."""

import numpy as np
import pytest
from faults.scripted_device import frames
from test_wire_pieces import cut
from whole_stamps import mend as mend_whole

from pipeline.wire import decoded_recording, read_pieces, read_recording
from pipeline.wire.in_order import in_order
from pipeline.wire.mending import Mending, steps_between, usual_steps
from pipeline.wire.stamps import BURST, LEAP

STEP_US = 1000


def mended(steps_us, apart=None, borders=()):
    """What a recording's steps become in pieces: the stamps in us, the counts, and how often the steps were read."""
    steps_us = np.array(steps_us, float)
    apart = np.ones(len(steps_us)) if apart is None else np.array(apart, float)
    reads = []

    def pieces():
        reads.append(len(steps_us))
        return iter(cut((steps_us.copy(), apart), borders))

    mending = Mending.of(pieces)
    times = len(reads)
    return np.concatenate(list(mending.stamps(pieces()))), mending.counted, times


@pytest.mark.parametrize("length", [1, 2, BURST - 2, BURST - 1, BURST, BURST + 1])
@pytest.mark.parametrize("error_us", [-5_000_000, -300_000, 300_000, 5_000_000])
@pytest.mark.parametrize("first", [1, 2, 40, 150])
def test_a_burst_as_long_as_may_be_is_mended_as_when_it_is_held_whole(length, error_us, first):
    """Every step comes alone: each is looked at as soon as it may be, and no sooner."""
    stamps = np.arange(300, dtype=np.int64) * STEP_US
    stamps[first : first + length] += error_us
    steps_us = np.diff(stamps)
    right, counted = mend_whole(stamps, np.arange(300))
    for borders in (range(1, 299), [first, first + length], [150]):
        mended_us, mend_counts, _ = mended(steps_us, borders=list(borders))
        assert np.array_equal(mended_us, right) and mend_counts == counted


def test_a_stamp_is_given_at_most_two_bursts_after_its_sample():
    """Or memory would go by how long a recording is whose clock once stood still."""
    steps_us = np.full(1000, float(STEP_US))
    steps_us[500:502] = [-100.0, 2100.0]
    pieces = cut((steps_us, np.ones(1000)), list(range(1, 1000)))
    mending, fed = Mending.of(lambda: iter(pieces)), []

    def passing():
        for piece in pieces:
            fed.append(piece)
            yield piece

    stamp_count = 0
    for stamps in mending.stamps(passing()):
        stamp_count += len(stamps)
        assert len(fed) + 1 - stamp_count <= 2 * BURST
    assert stamp_count == 1001


@pytest.mark.parametrize("borders", [[], [1], [399], [1, 399], [150, 300]])
@pytest.mark.parametrize(
    ("first_us", "last_us", "within_us", "leaps"),
    [
        (40_000, 1000, 1000, [0]),
        (1000, 40_000, 1000, [399]),
        (50_000, 40_000, 1000, [0, 399]),
        (40_000, 40_000, 1000, []),  # each is no longer than the other
        (40_000, 1000, 40_000, []),  # one within is as long: a gap is nothing odd in this recording
        (40_001, 1000, 40_000, [0]),
        (1000, 40_001, 40_000, [399]),
        (LEAP * STEP_US, 1000, 1000, []),
        (LEAP * STEP_US + 1, 1000, 1000, [0]),
        (1000, LEAP * STEP_US, 1000, []),
        (1000, LEAP * STEP_US + 1, 1000, [399]),
    ],
)
def test_an_end_leaps_by_more_than_ten_usual_steps_and_than_any_other(first_us, last_us, within_us, leaps, borders):
    steps_us = np.full(400, float(STEP_US))
    steps_us[[0, 200, 399]] = first_us, within_us, last_us
    mended_us, counted, _ = mended(steps_us, borders=borders)
    assert counted == ({"leaping_time_stamps": len(leaps)} if leaps else {})
    steps_us[leaps] = STEP_US
    assert np.diff(mended_us).tolist() == steps_us.tolist()


@pytest.mark.parametrize("missing", [3, 40])
@pytest.mark.parametrize("place", [0, 399])
def test_an_end_that_is_far_away_because_frames_are_missing_is_read_once(missing, place):
    """Nothing is wrong with it: a recording of hours is not gone through again."""
    steps_us, apart = np.full(400, float(STEP_US)), np.ones(400)
    steps_us[place], apart[place] = missing * LEAP * STEP_US, missing
    _, counted, times = mended(steps_us, apart)
    assert (counted, times) == ({}, 1)
    steps_us[place] += missing
    mended_us, counted, times = mended(steps_us, apart)
    assert counted == {"leaping_time_stamps": 1} and times == 2
    assert np.diff(mended_us)[place] == missing * STEP_US


def test_frames_that_are_missing_make_a_step_longer_and_an_event_does_not():
    assert usual_steps(np.array([1, 2, 3, 4, 40])).tolist() == [1.0, 1.0, 3.0, 4.0, 40.0]


def test_the_usual_step_is_of_one_frame_where_frames_are_missing():
    """Of 3100 us for three frames it is a third, and no whole number."""
    steps_us, apart = np.array([3100.0] * 20 + [-500.0]), np.array([3.0] * 20 + [1.0])
    assert Mending.of(lambda: iter(cut((steps_us, apart), [7]))).usual_us == 3100.0 / 3.0


@pytest.mark.parametrize(
    "steps_us", [[], [1000.0], [-1000.0], [0.0], [0.0, 0.0], [-5.0, -5.0], [5.0, -5.0], [0.0, 9.0]]
)
def test_of_very_few_samples_the_stamps_are_as_when_they_are_held_whole(steps_us):
    """A recording that broke off after one, two or three samples is read all the same."""
    stamps = np.cumsum([0, *steps_us]).astype(np.int64)
    right, counted = mend_whole(stamps, np.arange(len(stamps)))
    mended_us, mend_counts, _ = mended(steps_us)
    assert np.array_equal(mended_us, right) and mend_counts == counted


@pytest.mark.parametrize("sizes", [(12,), (1, 11), (5, 7), (1,) * 12, (4, 1, 6, 1)])
def test_steps_go_on_from_piece_to_piece_where_clock_and_numbers_jump(sizes):
    numbers = np.array([1, 2, 4, 5, 9, 10, 11, 30, 31, 32, 33, 34])
    stamps = np.array([10, 20, 2**32 - 5, 3, 40, 40, 35, 200, 210, 220, 230, 240], np.uint32)
    borders = np.cumsum(sizes)[:-1]
    pieces = zip(np.split(numbers, borders), np.split(stamps, borders), strict=True)
    steps, apart = (np.concatenate(parts) for parts in zip(*steps_between(pieces), strict=True))
    assert steps.tolist() == [10, -25, 8, 37, 0, -5, 165, 10, 10, 10, 10]
    assert apart.tolist() == [1, 1, 1, 4, 1, 1, 19, 1, 1, 1, 1]


def ordered(parts, sent):
    """Numbers as they come out, part by part, and after how many parts that went in."""
    taken = []

    def passing():
        for part in parts:
            taken.append(part)
            yield np.array(part), np.array(part).astype([("t_us", "<u4")])

    releases = []
    for numbers, samples in in_order(passing(), np.array([part[0] for part in parts]), sent):
        assert samples["t_us"].tolist() == numbers.tolist()
        releases.append((len(taken), numbers.tolist()))
    return releases


@pytest.mark.parametrize(
    ("parts", "sent", "releases"),
    [
        ([[1, 2], [3, 4], [5]], 6, [(1, [1, 2]), (2, [3, 4]), (3, [5])]),
        ([[1, 2], [4, 5], [3], [6]], 7, [(1, [1, 2]), (3, [3, 4, 5]), (4, [6])]),
        ([[1, 4], [3], [2], [5]], 6, [(1, [1]), (3, [2, 3, 4]), (4, [5])]),
        ([[5, 6], [1, 2], [3, 4]], 7, [(2, [1, 2]), (3, [3, 4, 5, 6])]),
        ([[1, 2, 9], [3, 8]], 8, [(1, [1, 2]), (2, [3])]),  # 8 and 9 came after the end
        ([[1], [8, 9], [2], [10]], 8, [(1, [1]), (3, [2])]),
        ([[3], [1], [2], [4]], 5, [(2, [1]), (3, [2, 3]), (4, [4])]),
    ],
)
def test_a_sample_is_given_as_soon_as_none_before_it_can_come(parts, sent, releases):
    assert ordered(parts, sent) == releases


@pytest.mark.parametrize(("less", "times"), [(0, 1), (1, 3)])
def test_samples_are_kept_up_to_the_limit_to_the_byte(monkeypatch, less, times):
    """More of them are decoded anew, each time that they are asked for."""
    data, taken = b"".join(frames(500)), []
    sample_bytes = np.dtype(read_recording(data).hello.sample_type).itemsize
    monkeypatch.setattr(decoded_recording, "KEPT", 500 * (8 + sample_bytes) - less)

    def chunks():
        taken.append(len(data))
        return (data[at : at + 1000] for at in range(0, len(data), 1000))

    pieces = read_pieces(chunks)
    assert pieces.mended == {} and sum(len(numbers) for _, _, numbers in pieces.samples()) == 500
    assert len(taken) == times


def test_a_log_without_a_hello_has_no_piece():
    pieces = read_pieces(lambda: iter([b"junk\0", b"more\0"]))
    assert pieces.hello is None and list(pieces.samples()) == [] and pieces.mended == {}
