"""A recording that is read in pieces gives what it gives when it is held whole, wherever the pieces end."""

from itertools import pairwise

import numpy as np
import pytest
from faults.scripted_device import STEP_US, frames
from hypothesis import given
from hypothesis import strategies as st
from whole_stamps import mend as mend_whole

from pipeline.wire import Kind, decoded_recording, encode, read_pieces, read_recording
from pipeline.wire.mending import Mending, usual_steps
from pipeline.wire.stamps import BURST

KEPT = decoded_recording.KEPT


def in_pieces(data, size):
    """What `read_recording` gives, from chunks of some bytes: times, channels, numbers, and what they came in."""
    pieces = read_pieces(lambda: (data[at : at + size] for at in range(0, len(data), size)))
    times, channels, numbers = zip(*pieces.samples(), strict=True)
    joined = {name: np.concatenate([piece_channels[name] for piece_channels in channels]) for name in channels[0]}
    return np.concatenate(times), joined, np.concatenate(numbers), pieces, len(times)


def agree(data, size):
    """What is read whole is what is read in pieces, whether these are kept or decoded anew."""
    for decoded_recording.KEPT in (0, KEPT):
        whole, count = _agree(data, size)
    return whole, count


def _agree(data, size):
    whole, (time_s, channels, numbers, pieces, count) = read_recording(data), in_pieces(data, size)
    assert pieces.hello == whole.hello and pieces.account == whole.account and pieces.mended == whole.mended
    assert np.array_equal(time_s, whole.time_s) and np.array_equal(numbers, whole.seq)
    assert list(channels) == list(whole.channels)
    assert all(np.array_equal(channels[name], whole.channels[name]) for name in channels)
    return whole, count


@pytest.mark.parametrize("at", range(-2, 24))
def test_a_damaged_frame_at_the_border_of_two_pieces_is_one_that_is_lost(at):
    sent_frames = frames(1500)
    data, size = bytearray(b"".join(sent_frames)), 4096
    data[2 * size + at] ^= 0x55
    whole, count = agree(bytes(data), size)
    ends = np.cumsum([len(frame) for frame in sent_frames])
    hit = int(np.searchsorted(ends, 2 * size + at, side="right"))
    assert whole.account.received + whole.account.lost == len(sent_frames) and whole.account.lost in (1, 2)
    assert hit not in whole.seq and count > 5
    assert len(whole.time_s) == 1500 - whole.account.lost


@pytest.mark.parametrize(("at", "to"), [(100, 900), (900, 100), (1, 1400), (600, 601)])
def test_a_frame_that_comes_many_pieces_late_or_early_is_put_where_it_belongs(at, to):
    sent_frames = frames(1500)
    right = read_recording(b"".join(sent_frames))
    sent_frames.insert(to, sent_frames.pop(at))
    whole, _ = agree(b"".join(sent_frames), 700)
    assert whole.account.out_of_order >= 1
    assert np.array_equal(whole.time_s, right.time_s) and np.array_equal(whole.seq, right.seq)


def test_samples_after_the_end_are_left_out_of_every_piece():
    sent_frames = frames(300)
    late = [encode(Kind.SAMPLE, len(sent_frames) + number, b"1234567890") for number in range(200)]
    whole, _ = agree(b"".join([*sent_frames, *late]), 500)
    assert len(whole.time_s) == 300 and whole.account.repeated == 200


def test_a_log_without_a_sample_is_one_piece_without_rows():
    time_s, channels, _, _, count = in_pieces(b"".join(frames(0)), 64)
    assert (len(time_s), count) == (0, 1) and list(channels) == ["motor_turns", "displacement_mm"]


def cut(steps, borders):
    return [(steps[0][start:other], steps[1][start:other]) for start, other in pairwise([0, *borders, len(steps[0])])]


@given(
    st.integers(2, 700),
    st.lists(st.tuples(st.integers(0, 699), st.sampled_from([-65_536, 65_536, -25_000, -STEP_US, 2**20, -(2**24)]))),
    st.sets(st.integers(1, 698), max_size=20),
    st.sampled_from([1, 1, 1, 5, 200]),
    st.sets(st.integers(0, 698), max_size=12),
)
def test_stamps_are_mended_as_when_they_are_held_whole(count, bad, lost, ticks, borders):
    stamps = np.arange(700, dtype=np.int64) // ticks * ticks * STEP_US
    for at, error in bad:
        stamps[at] += error
    numbers = np.array([at for at in range(count) if at not in lost])
    steps = (np.diff(stamps[numbers]).astype(float), usual_steps(np.diff(numbers)))
    pieces = cut(steps, sorted(min(border, len(steps[0])) for border in borders))
    mending = Mending.of(lambda: iter(pieces))
    mended_us = np.concatenate(list(mending.stamps(pieces)))
    right, counted = mend_whole(stamps[numbers] - stamps[numbers][0], numbers)
    assert np.array_equal(mended_us, right) and mending.counted == counted


def test_a_burst_of_bad_stamps_across_a_border_is_mended_as_a_whole():
    stamps = np.arange(1000, dtype=np.int64) * STEP_US
    stamps[480 : 480 + BURST - 10] += 5_000_000
    steps = (np.diff(stamps).astype(float), np.ones(999))
    for border in range(400, 600):
        pieces = cut(steps, [border])
        mended_us = np.concatenate(list(Mending.of(lambda pieces=pieces: iter(pieces)).stamps(pieces)))
        assert np.array_equal(mended_us, mend_whole(stamps, np.arange(1000))[0])
        np.testing.assert_allclose(mended_us, np.arange(1000) * STEP_US)


@pytest.mark.parametrize(
    ("steps_us", "usual_us"),
    [
        ([900, 1000, 1100, 1300] * 5 + [-500], 1050.0),  # between the two in the middle
        ([900, 1000, 1100, 1300, 1400] * 5 + [-500], 1100.0),
        ([900, 900, 1000, 1300, 1300, 1300] * 5 + [-500], 1150.0),
        ([900, 1000, 1100, 1300, 0, 0], 1050.0 * 4 / 6),  # a clock that stands still at two of six samples
    ],
)
@pytest.mark.parametrize("border", range(1, 5))
def test_the_usual_step_is_the_median_of_those_that_rise(steps_us, usual_us, border):
    pieces = cut((np.array(steps_us, float), np.ones(len(steps_us))), [border])
    assert Mending.of(lambda: iter(pieces)).usual_us == pytest.approx(usual_us)


def test_the_shortest_step_that_rises_is_right():
    steps_us = [1000.0, 1000.0, 1.0, 1999.0, 1000.0, -500.0, 2500.0, 1000.0]
    pieces = [(np.array(steps_us), np.ones(len(steps_us)))]
    mended_us = np.concatenate(list(Mending.of(lambda: iter(pieces)).stamps([(np.array(steps_us), np.ones(8))])))
    assert mended_us[:6].tolist() == [0.0, 1000.0, 2000.0, 2001.0, 4000.0, 5000.0]


@pytest.mark.parametrize("end", ["first", "last"])
@pytest.mark.parametrize("missing", [0, 30])
@pytest.mark.parametrize("repeated", [0, 1])
@pytest.mark.parametrize("back", [0, 1])
def test_an_end_leaps_by_what_is_missing_there_not_by_its_length(end, missing, back, repeated):
    """Of 40 usual steps at an end: a leap where no frame is missing, and what is to be expected where 39 are."""
    steps_us, apart = np.full(400, 1000.0), np.ones(400)
    place = 0 if end == "first" else 399
    steps_us[place], apart[place] = 40_000.0, missing + 1.0
    steps_us[30:32] += [-1500.0 * back, 1500.0 * back]
    steps_us[60:62] += [-1000.0 * repeated, 1000.0 * repeated]
    mending = Mending.of(lambda: iter(cut((steps_us.copy(), apart), [150, 300])))
    counted = {"backward_time_stamps": back, "repeated_time_stamps": repeated, "leaping_time_stamps": int(not missing)}
    assert mending.counted == {rule: times for rule, times in counted.items() if times}
    mended_us = np.concatenate(list(mending.stamps(cut((steps_us.copy(), apart), [150, 300]))))
    usual_us = 1000.0 * (1.0 - repeated / (400 - back))  # the clock stood at one of the steps that do not fall
    assert np.diff(mended_us)[place] == pytest.approx(40_000.0 if missing else usual_us, abs=0.1)


def test_a_log_with_samples_gives_no_piece_without_any():
    pieces = read_pieces(lambda: iter([b"".join(frames(100))]))
    assert [len(time_s) for time_s, _, _ in pieces.samples()] == [100]


def test_a_short_log_is_decoded_once_and_a_long_one_is_not_kept(monkeypatch):
    data, taken = b"".join(frames(1500)), []

    def chunks():
        taken.append(len(data))
        return (data[at : at + 4096] for at in range(0, len(data), 4096))

    for kept, times in ((KEPT, 1), (4096, 3)):
        monkeypatch.setattr(decoded_recording, "KEPT", kept)
        taken.clear()
        pieces = read_pieces(chunks)
        assert pieces.mended == {} and sum(len(time_s) for time_s, _, _ in pieces.samples()) == 1500
        assert len(taken) == times


@pytest.mark.parametrize(("backward", "is_clock"), [(10, True), (11, False)])
def test_more_than_a_tenth_of_steps_that_fall_back_is_no_clock(backward, is_clock):
    steps_us = np.array([-500.0] * backward + [1000.0] * (100 - backward))
    mending = Mending.of(lambda: iter([(steps_us, np.ones(100))]))
    assert mending.counted == ({"backward_time_stamps": backward} if is_clock else {})
