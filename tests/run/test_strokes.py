import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_recording import motion, recording

from pipeline.ground.errors import BadInput
from pipeline.ground.stored.rows import rows_of
from pipeline.run.clean_motion import Motion
from pipeline.run.strokes import label, of_samples, segment, stretches, turning_points


def sampled(corners, rate_hz=50.0, noise_turns=0.0, seed=0):
    rng = np.random.default_rng(seed)
    time_s = np.arange(corners[0][0], corners[-1][0], 1 / rate_hz)
    turns = np.interp(time_s, *np.transpose(corners))
    return time_s, turns + noise_turns * rng.standard_normal(len(turns))


def phases_of(corners, **how):
    time_s, turns = sampled(corners, **how)
    table = segment(pd.DataFrame({"time_s": time_s, "motor_turns": turns}), "motor_turns", "here")
    return list(zip(table["stroke"], table["phase"], strict=True)), table


FULL = [(n, phase) for n in (1, 2, 3) for phase in ("winding", "hold", "unwinding", "rest")]


@pytest.mark.parametrize("noise_turns", [0.0, 0.003])
@pytest.mark.parametrize("rate_hz", [10.0, 50.0, 1000.0])
def test_clean_protocol(rate_hz, noise_turns):
    stroke_phases, table = phases_of(motion(3), rate_hz=rate_hz, noise_turns=noise_turns)
    assert stroke_phases == [(0, "rest"), *FULL]
    assert table["complete"][1:].all()


def test_boundaries_lie_where_the_motor_starts_and_stops():
    corners = motion(3)
    _, table = phases_of(corners, rate_hz=100.0)
    assert table["end_s"].to_numpy() == pytest.approx(corners[1:, 0], abs=0.15)
    assert (table["first_sample"].to_numpy()[1:] == table["last_sample"].to_numpy()[:-1] + 1).all()


def test_last_winding_without_unwinding_is_a_partial_stroke():
    stroke_phases, table = phases_of(motion(3)[:-3])
    assert stroke_phases[-1] == (3, "winding")
    assert table.groupby("stroke")["complete"].first().to_dict() == {0: False, 1: True, 2: True, 3: False}


def test_small_reversals_stay_inside_their_stroke():
    corners = [(0, 0), (5, 20), (6, 16), (7, 20), (12, 0), (17, 20), (22, 0)]
    stroke_phases, _ = phases_of(corners)
    assert max(stroke for stroke, _ in stroke_phases) == 2
    assert stroke_phases[:4] == [(1, "winding"), (1, "unwinding"), (1, "winding"), (1, "unwinding")]


def test_a_reversal_of_a_third_makes_a_new_stroke():
    stroke_phases, _ = phases_of([(0, 0), (5, 20), (7, 13), (9, 20), (14, 0)])
    assert max(stroke for stroke, _ in stroke_phases) == 2


def test_partial_strokes_count():
    corners = [(0, 0), (10, 20), (20, 0), (25, 10), (30, 0), (33, 6), (36, 0)]
    stroke_phases, _ = phases_of(corners)
    assert max(stroke for stroke, _ in stroke_phases) == 3


def test_dwells_half_way_are_holds_and_split_nothing():
    corners = [(0, 0), (5, 10), (15, 10), (20, 20), (25, 8), (40, 8), (44, 0), (50, 0), (60, 20), (70, 0)]
    stroke_phases, _ = phases_of(corners)
    first_phases = ["winding", "hold", "winding", "unwinding", "hold", "unwinding", "rest"]
    assert stroke_phases == [*((1, phase) for phase in first_phases), (2, "winding"), (2, "unwinding")]


def test_unwinding_before_the_first_winding_is_no_stroke():
    stroke_phases, _ = phases_of([(0, 20), (10, 0), (12, 0), (22, 20), (32, 0)])
    assert stroke_phases[:2] == [(0, "unwinding"), (0, "rest")]
    assert stroke_phases[2:] == [(1, "winding"), (1, "unwinding")]


def test_sinusoid_that_starts_half_way():
    time_s = np.arange(0, 21, 0.0102)
    turns = 32.5 + 10 * np.sin(2 * np.pi * time_s / 6.2)
    stroke, phase = label(time_s, turns)
    assert stroke.max() == 4  # three whole ones and the last winding
    assert {"winding", "unwinding"} <= set(phase)


def test_gaps_dropped_samples_jitter_and_outliers_change_nothing():
    rng = np.random.default_rng(3)
    time_s, turns = sampled(motion(3), rate_hz=50.0)
    expected = segment(pd.DataFrame({"time_s": time_s, "motor_turns": turns}), "motor_turns", "here")
    keep = rng.random(len(time_s)) > 0.1
    keep[400:450] = False  # a second of nothing, within the first winding
    time_s, turns = time_s[keep] + rng.uniform(0, 0.008, keep.sum()), turns[keep].copy()
    turns[rng.choice(len(turns), 5, replace=False)] += 40.0
    stroke_table = segment(pd.DataFrame({"time_s": time_s, "motor_turns": turns}), "motor_turns", "here")
    assert stroke_table["stroke"].tolist() == expected["stroke"].tolist()
    assert stroke_table["phase"].tolist() == expected["phase"].tolist()
    assert stroke_table["end_s"].to_numpy() == pytest.approx(expected["end_s"].to_numpy(), abs=0.2)
    assert stroke_table["missing_samples"].sum() == pytest.approx((~keep).sum(), abs=3)


def test_slow_and_fast_strokes_in_one_run():
    corners, at = [(0.0, 0.0), (2.0, 0.0)], 2.0
    for speed in (0.3, 2.0, 6.0):
        for duration, turns in ((27 / speed, 27.0), (27 / speed, 0.0), (2.0, 0.0)):
            at += duration
            corners.append((at, turns))
    stroke_phases, _ = phases_of(corners, noise_turns=0.002)
    assert stroke_phases == [
        (0, "rest"),
        *((n, phase) for n in (1, 2, 3) for phase in ("winding", "unwinding", "rest")),
    ]


@settings(max_examples=50)
@given(
    st.lists(st.tuples(st.floats(0.5, 1.0), st.floats(0.5, 4.0), st.floats(0.0, 5.0)), min_size=1, max_size=6),
    st.sampled_from([10.0, 37.0, 200.0]),
)
def test_any_protocol_of_large_strokes_is_counted(strokes, rate_hz):
    corners, at = [(0.0, 0.0), (1.0, 0.0)], 1.0
    for share, speed, hold_s in strokes:
        top = 30.0 * share
        for duration_s, turns in ((top / speed, top), (hold_s, top), (top / speed, 0.0), (1.0, 0.0)):
            at += duration_s
            corners.append((at, turns))
    time_s, turns = sampled(corners, rate_hz, noise_turns=0.003)
    stroke, phase = label(time_s, turns)
    assert stroke.max() == len(strokes)
    assert (np.diff(stroke) >= 0).all()
    for number in range(1, len(strokes) + 1):
        assert {"winding", "unwinding"} <= set(phase[stroke == number])


@pytest.mark.parametrize("motion_turns", [np.zeros(200), np.full(200, 12.0), np.linspace(20, 0, 200)])
def test_no_stroke_is_an_error_that_says_so(motion_turns):
    table = pd.DataFrame({"time_s": np.arange(200) * 0.1, "motor_turns": motion_turns})
    with pytest.raises(BadInput, match="motor_turns: there is no stroke in it"):
        segment(table, "motor_turns", "here")


def test_turning_points_of_a_staircase():
    assert turning_points(np.array([0.0, 1, 2, 1.9, 3, 0, 3.0]), 1.0).tolist() == [0, 4, 5, 6]


def test_every_sample_has_one_stretch():
    samples = recording()
    table = segment(samples, "motor_turns", "here")
    covered = np.concatenate(
        [np.arange(a, b + 1) for a, b in zip(table["first_sample"], table["last_sample"], strict=True)]
    )
    assert (covered == np.arange(len(samples))).all()


@pytest.mark.parametrize(("back", "strokes"), [(0.24, 1), (0.26, 2)])
def test_a_quarter_of_the_range_parts_strokes(back, strokes):
    stroke_phases, _ = phases_of([(0, 0), (10, 20), (13, 20 * (1 - back)), (16, 20), (26, 0)])
    assert max(stroke for stroke, _ in stroke_phases) == strokes


@pytest.mark.parametrize(("level", "phase"), [(0.04, "rest"), (0.06, "hold")])
def test_a_rest_is_a_hold_within_five_percent_of_the_lowest_twist(level, phase):
    low = 20 * level
    stroke_phases, _ = phases_of([(0, 0), (10, 20), (20, low), (25, low), (35, 20), (45, 0), (48, 0)])
    assert stroke_phases[2] == (1, phase)


@pytest.mark.parametrize("noise_turns", [0.01, 0.03])
@pytest.mark.parametrize("seed", range(4))
def test_a_noisy_motor_channel_leaves_no_sample_without_a_phase(noise_turns, seed):
    time_s, turns = sampled(motion(3), rate_hz=100.0, noise_turns=noise_turns, seed=seed)
    stroke, phase = label(time_s, turns)
    assert stroke.max() == 3 and set(phase) == {"winding", "hold", "unwinding", "rest"}
    assert phase[0] == "rest" and (phase[:180] == "rest").all()  # what the tare stands on


@pytest.mark.parametrize("step", [0.25, 0.16])
def test_a_winding_in_small_steps_is_a_winding(step):
    corners = [(0.0, 0.0), (2.0, 0.0)]
    for number in range(1, round(20 / step) + 1):
        corners += [(corners[-1][0] + 0.1, step * number), (corners[-1][0] + 1.1, step * number)]
    corners += [(corners[-1][0] + 10, 0.0), (corners[-1][0] + 13, 0.0)]
    stroke_phases, table = phases_of(corners)
    assert (1, "winding") in stroke_phases and (1, "unwinding") in stroke_phases and table["stroke"].max() == 1


def test_a_twist_of_less_than_a_tenth_of_a_turn_is_no_stroke():
    time_s, turns = sampled(motion(3))
    with pytest.raises(BadInput, match="no stroke"):
        segment(pd.DataFrame({"time_s": time_s, "motor_turns": turns * 0.003}), "motor_turns", "here")


@pytest.mark.parametrize(("driver", "least"), [("motor_turns", 0.1), ("motor_deg", 1.0), ("position_m", 1e-3)])
def test_each_unit_has_a_least_range_of_its_own(driver, least):
    time_s, turns = sampled(motion(3))
    unit = (turns - turns.min()) / np.ptp(turns)
    assert segment(pd.DataFrame({"time_s": time_s, driver: 1.1 * least * unit}), driver, "here")["stroke"].max() == 3
    with pytest.raises(BadInput, match="no stroke"):
        segment(pd.DataFrame({"time_s": time_s, driver: 0.9 * least * unit}), driver, "here")


@settings(max_examples=200)
@given(st.lists(st.integers(-9, 9), min_size=2, max_size=30))
def test_no_leg_but_the_last_is_smaller_than_a_reversal(steps):
    walk = np.cumsum(np.array(steps) / 4.0)
    points = turning_points(walk, 1.0)
    legs = np.abs(np.diff(walk[points]))
    assert points[0] == 0 and points[-1] == len(walk) - 1 and (np.diff(points) > 0).all()
    assert (legs[1:-1] >= 1.0).all()


def test_a_beginning_as_large_as_a_reversal_is_a_leg_of_its_own():
    assert turning_points(np.array([0.0, 1.0, -2.0]), 1.0).tolist() == [0, 1, 2]
    assert turning_points(np.array([0.0, 0.9, -2.0]), 1.0).tolist() == [0, 2]


@pytest.mark.parametrize(("stand_s", "has_hold"), [(0.40, False), (0.60, True)])
@pytest.mark.parametrize("rate_hz", [50.0, 1000.0])
def test_the_speed_is_taken_over_a_tenth_of_a_second_on_either_side_at_any_rate(rate_hz, stand_s, has_hold):
    corners = [(0, 0), (5, 10), (5 + stand_s, 10), (10 + stand_s, 20), (20 + stand_s, 0)]
    stroke_phases, _ = phases_of(corners, rate_hz=rate_hz)
    assert ((1, "hold") in stroke_phases) is has_hold


def test_an_unwinding_half_way_down_in_small_steps_is_no_hold():
    corners = [(0.0, 0.0), (10.0, 20.0)]
    for number in range(1, 64):
        corners += [(corners[-1][0] + 0.1, 20 - 0.16 * number), (corners[-1][0] + 1.1, 20 - 0.16 * number)]
    corners += [(corners[-1][0] + 10, 20.0), (corners[-1][0] + 20, 0.0)]
    stroke_phases, table = phases_of(corners)
    down = table[(table["phase"] == "unwinding") & (table["stroke"] == 1)]
    assert (1, "unwinding") in stroke_phases and down["end_turns"].min() < 11 and (down["start_turns"].max()) > 19


def test_a_winding_alone_is_a_stroke_that_is_not_complete():
    stroke_phases, table = phases_of([(0, 0), (10, 20)])
    assert stroke_phases == [(1, "winding")] and not table["complete"].any()


def test_a_logger_that_slows_down_within_a_winding_does_not_make_a_hold_of_it():
    """The speed is the way by the time that it took, also where samples lie further apart."""
    time_s = np.concatenate([np.arange(0, 10, 0.01), np.arange(10, 31, 0.1)])
    turns = np.interp(time_s, [0, 20, 30], [0, 20, 0])
    table = segment(pd.DataFrame({"time_s": time_s, "motor_turns": turns}), "motor_turns", "here")
    assert table["phase"].tolist()[:2] == ["winding", "unwinding"] and table["end_s"][0] == pytest.approx(20, abs=0.2)


def test_two_bad_samples_in_a_row_are_no_motion():
    time_s, turns = sampled(motion(3))
    spoilt = turns.copy()
    spoilt[[40, 41, 700, 701]] += 40.0
    before, after = (label(time_s, motor_turns) for motor_turns in (turns, spoilt))
    assert (before[0] == after[0]).all() and (before[1] == after[1]).mean() > 0.995


@pytest.mark.parametrize(("jump", "phases"), [(0.008, ["rest"]), (0.015, ["rest", "unwinding", "rest"])])
def test_a_jump_of_less_than_a_hundredth_of_the_range_within_a_rest_is_none(jump, phases):
    corners = [(0, 0), (10, 20), (20, 0), (23, 0), (23.04, 20 * jump), (26, 20 * jump)]
    stroke_phases, _ = phases_of(corners)
    assert [phase for _, phase in stroke_phases[2:]] == phases


def test_a_rest_goes_on_to_the_end_of_the_recording_where_its_last_samples_jitter():
    stroke_phases, table = phases_of([(0, 0), (10, 20), (20, 0), (25, 0), (25.2, 0.15)])
    assert stroke_phases[:3] == [(1, "winding"), (1, "unwinding"), (1, "rest")]
    assert table["end_s"][2] == pytest.approx(25.2, abs=0.05)


def test_the_stretches_of_labelled_samples_are_those_that_they_were_cut_into():
    samples = recording()
    table = segment(samples, "motor_turns", "here")
    again = stretches(*of_samples(table))
    pd.testing.assert_frame_equal(again, table[list(again)], check_dtype=False)


@pytest.mark.parametrize("cuts", [(1,), (2, 3), (5, 8, 9), (7, 20)])
def test_turning_points_are_the_same_whatever_pieces_the_motion_comes_in(cuts):
    walk = np.array([0, 1, 2, 2, 1, 0, 0, 3, 5, 4, 4, 4, 1, 2, 6, 6, 2, 1, 0, 7, 7, 5, 3, 1.0])
    assert turning_points(iter(np.split(walk, cuts)), 1.0).tolist() == turning_points(walk, 1.0).tolist()


def test_the_speed_of_the_first_and_of_the_last_sample_is_taken_up_to_the_ends():
    time_s = np.arange(0.0, 2.0, 0.02)
    motor_motion = Motion(rows_of(pd.DataFrame({"time_s": time_s, "motor_turns": time_s**2})), "motor_turns")
    speed = motor_motion.speed(0, len(time_s))
    assert speed[0] == pytest.approx(time_s[5], abs=0.01) and speed[50] == pytest.approx(2 * time_s[50], abs=1e-6)
    assert speed[-1] == pytest.approx(time_s[-1] + time_s[-6], abs=0.05)
