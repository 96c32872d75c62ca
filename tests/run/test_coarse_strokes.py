"""Strokes of few or coarse samples, where each sample and each limit counts: as a mark for every sample has them."""

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from whole_strokes import label as label_whole
from whole_strokes import segment as segment_whole
from whole_strokes import turning_points as turning_points_whole

from pipeline.ground.errors import BadInput
from pipeline.ground.stored import schemas
from pipeline.run.strokes import label, segment
from pipeline.run.turning import turning_points

LEVELS = [0.0, 0.0, 1.0, 5.0, 16.0, 19.0, 20.0]


def coarse(seed):
    """A motion in whole steps, at a slow and even rate, with legs of a few samples and stands at the limits."""
    rng = np.random.default_rng(seed)
    count = rng.integers(4, 14)
    corners = np.cumsum(rng.uniform(0.1, 6.0, count) * rng.choice([1.0, 0.2], count))
    time_s = np.arange(0.0, corners[-1] + 1.0, 1.0 / rng.choice([1.0, 2.0, 4.0, 8.0, 16.0, 64.0]))
    turns = np.interp(time_s, corners, rng.choice(LEVELS, count)) + rng.choice([0.0, 0.05, 0.5]) * rng.standard_normal(
        len(time_s)
    )
    grid = rng.choice([1.0, 4.0, 64.0])
    turns = np.round(turns * grid) / grid + rng.choice([0.0, 1024.0, -32.0])
    kept = rng.random(len(time_s)) < rng.choice([1.0, 0.8])
    return time_s[kept], turns[kept]


def outcome(cut, time_s, turns):
    try:
        return cut(pd.DataFrame({"time_s": time_s, "motor_turns": turns}), "motor_turns", "here").to_csv()
    except BadInput as error:
        return str(error)


@pytest.mark.parametrize(("group", "seeds"), [(7, 40), (1 << 20, 150)])
def test_few_and_coarse_samples_have_the_strokes_of_marks_for_every_sample(monkeypatch, group, seeds):
    monkeypatch.setattr(schemas, "ROW_GROUP", group)
    for seed in range(seeds):
        time_s, turns = coarse(seed)
        if len(time_s) < 3:
            continue
        for mark, whole in zip(label(time_s, turns), label_whole(time_s, turns), strict=True):
            assert mark.tolist() == whole.tolist(), seed
        assert outcome(segment, time_s, turns) == outcome(segment_whole, time_s, turns), seed


@settings(max_examples=300)
@given(
    st.lists(st.integers(-5, 5), min_size=2, max_size=30),
    st.sets(st.integers(1, 29), max_size=6),
    st.sampled_from([0.25, 0.5, 0.75, 1.0, 2.0]),
)
def test_a_motion_turns_where_it_does_when_it_is_held_whole(steps, cuts, reversal):
    walk = np.cumsum(np.array(steps) / 4.0)
    pieces = [piece for piece in np.split(walk, sorted(cuts)) if len(piece)]
    assert turning_points(iter(pieces), reversal).tolist() == turning_points_whole(walk, reversal).tolist()
    assert turning_points(walk, reversal).tolist() == turning_points_whole(walk, reversal).tolist()


def phases(corners, rate_hz=64.0):
    time_s = np.arange(0.0, corners[-1][0], 1.0 / rate_hz)
    turns = np.interp(time_s, *np.transpose(corners))
    return segment(pd.DataFrame({"time_s": time_s, "motor_turns": turns}), "motor_turns", "here")


def test_a_hold_lasts_a_quarter_of_a_second_at_least():
    """Of stands that grow by a sample each the first to be a hold is the first that lasts 0.25 s."""
    shortest = []
    for count in range(8, 48):
        table = phases([(0, 0), (5, 10), (5 + count / 64, 10), (10 + count / 64, 20), (20 + count / 64, 0)])
        holds = table[table["phase"] == "hold"]
        shortest += (holds["end_s"] - holds["start_s"]).tolist()
    assert min(shortest) == 0.25


def test_a_stand_that_creeps_over_the_edge_of_the_band_is_a_rest_where_most_of_its_samples_are():
    """The edge is at 1 of 20 turns, and a stand is a rest or a hold as a whole."""
    names = set()
    for begin in np.linspace(0.90, 1.0, 41):
        corners = [(0, 0), (10, 20), (20, begin), (22, begin + 0.1), (32, 20), (34, 20), (44, 0), (48, 0)]
        table = phases(corners, rate_hz=10.0)
        stand = table.iloc[2]
        place = np.arange(stand["first_sample"], stand["last_sample"] + 1)
        turns = np.interp(place / 10.0, *np.transpose(corners))
        assert stand["phase"] == ("rest" if (turns <= 1.0).mean() > 0.5 else "hold"), begin
        names.add(stand["phase"])
    assert names == {"rest", "hold"}


@pytest.mark.parametrize(("level", "phase"), [(1.0, "rest"), (1.0625, "hold")])
def test_a_stand_at_a_twentieth_of_the_range_is_still_a_rest(level, phase):
    table = phases([(0, 0), (10, 20), (12, 20), (22, level), (25, level), (35, 20), (37, 20), (47, 0), (50, 0)])
    assert table["phase"].tolist()[:4] == ["winding", "hold", "unwinding", phase]


@pytest.mark.parametrize("factor", [2.0**-10, 1.0, 2.0**10])
@pytest.mark.parametrize("zero", [-4096.0, 0.0, 4096.0])
@pytest.mark.parametrize("way", ["winds", "unwinds"])
def test_neither_the_zero_nor_the_unit_of_the_motion_moves_a_stroke(factor, zero, way):
    corners = [(0, 0), (2, 0), (5, 10), (7, 10), (10, 20), (14, 2), (16, 2), (20, 16), (22, 16), (26, 0), (30, 0)]
    time_s = np.arange(0.0, 30.0, 1 / 32)
    turns = np.round(64.0 * np.interp(time_s, *np.transpose(corners))) / 64.0
    turns = 20.0 - turns if way == "unwinds" else turns
    for mark, plain in zip(label(time_s, (turns + zero) * factor), label(time_s, turns), strict=True):
        assert mark.tolist() == plain.tolist()


@pytest.mark.parametrize("way", ["winds", "unwinds"])
def test_one_quick_stroke_in_a_long_recording_sets_the_range_by_which_small_ones_are_none(way):
    """It takes a two-hundredth of the time; the small reversals are a seventh of it, and no strokes."""
    small = [corner for at in range(2, 392, 10) for corner in ((at, 0), (at + 3, 3), (at + 6, 0))]
    corners = np.array([(0, 0), *small, (396, 0), (397, 20), (398, 0), (400, 0)], float)
    corners[:, 1] = 20.0 - corners[:, 1] if way == "unwinds" else corners[:, 1]
    assert phases(corners, rate_hz=16.0)["stroke"].max() == 1


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_quick_stroke_in_a_long_rest_is_large_enough_for_a_stroke(way):
    """It reaches 0.15 turns, for less than a hundredth of the time."""
    corners = [(0, 0), (500, 0), (502, 0.15 * way), (504, 0), (700, 0)]
    assert phases(corners, rate_hz=16.0)["stroke"].max() == 1


def test_a_small_winding_on_the_way_down_is_no_stroke():
    with pytest.raises(BadInput, match="no stroke"):
        phases([(0, 20), (5, 10), (7, 13), (12, 0)])


def test_a_motion_in_an_unknown_unit_is_as_small_as_it_likes():
    time_s = np.arange(0.0, 20.0, 0.05)
    table = pd.DataFrame({"time_s": time_s, "motor_furlongs": 1e-6 * np.interp(time_s, [0, 10, 20], [0, 1, 0])})
    assert segment(table, "motor_furlongs", "here")["stroke"].tolist() == [1, 1]


@pytest.mark.parametrize("lost", [1, 7])
def test_samples_that_are_missing_are_counted_in_the_stretch_that_they_are_missing_from(lost):
    """Two samples that lie close together make up for none of them."""
    time_s = np.arange(0.0, 20.0, 0.05)
    table = pd.DataFrame({"time_s": time_s, "motor_turns": np.interp(time_s, [0, 10, 20], [0, 20, 0])})
    table.loc[[50, 60], "time_s"] -= 0.045
    table = table.drop(index=range(300, 300 + lost))
    assert segment(table, "motor_turns", "here")["missing_samples"].tolist() == [2, lost]


@pytest.mark.parametrize(("share", "has_hold"), [(0.4, True), (0.6, False)])
def test_a_leg_of_which_half_is_small_steps_moves_in_them_too(share, has_hold):
    """Steps of less than a hundredth of the range between stands: jitter of a stand, or how a motor winds slowly."""
    corners, steps = [(0.0, 0.0), (10.0, 20.0 * (1.0 - share))], round(20.0 * share / 0.16)
    for number in range(1, steps + 1):
        level = 20.0 * (1.0 - share) + 0.16 * number
        corners += [(corners[-1][0] + 0.1, level), (corners[-1][0] + 1.1, level)]
    corners += [(corners[-1][0] + 10, 0.0), (corners[-1][0] + 13, 0.0)]
    table = phases(corners, rate_hz=50.0)
    assert ((table["phase"] == "hold").sum() == 1) == has_hold, table["phase"].tolist()
