"""What physics demands of every law of the author `lattice`, seen on a small bench of a few strokes."""

import numpy as np
import pytest

from pipeline.rig.authors.lattice.catalogue import BY_EFFECT
from pipeline.rig.authors.lattice.chain import reading_mm
from pipeline.rig.authors.lattice.world import Dimensions, World

STEP_S = 0.005
RIG = Dimensions(radius_mm=0.4, length_mm=400.0, stiffness_n_per_mm=15.0, torsion_zone_mm=150.0, separator_mm=8.0)
TOP = 24.0


def bench(rate=2.0, load_n=20.0, hold_s=8.0, rest_s=8.0, strokes=3, loads=None, warmth=0.0):
    """Strokes of 24 turns with a hold above and a rest below, and their steps by phase."""
    turns, load, stroke, phase = (
        [np.zeros(400)],
        [np.full(400, (loads or [load_n])[0])],
        [np.full(400, -1)],
        ["start"] * 400,
    )
    for i in range(strokes):
        steps = round(TOP / rate / STEP_S)
        up = np.arange(1, steps + 1) / steps * TOP
        parts = {
            "wind": up,
            "hold": np.full(round(hold_s / STEP_S), TOP),
            "unwind": up[::-1] - up[0],
            "rest": np.zeros(round(rest_s / STEP_S)),
        }
        for name, part in parts.items():
            turns.append(part)
            load.append(np.full(part.size, loads[i] if loads else load_n))
            stroke.append(np.full(part.size, i))
            phase += [f"{name} {i}"] * part.size
    twist = np.concatenate(turns)
    time_s = np.arange(twist.size) * STEP_S
    ones = np.ones(twist.size)
    ambient = warmth * np.sin(time_s / 20.0)
    world = World(RIG, STEP_S, time_s, twist, np.concatenate(load), ambient, ones, np.concatenate(stroke))
    return world, np.array(phase)


def drawn(law, world, strength, seed=5):
    return law.draw(np.random.default_rng(seed), world) | {law.strength: strength}


def error_mm(law, world, params):
    """What the law adds to an ideal reading, in mm."""
    return reading_mm(world, [(law, params)]) - reading_mm(world, [])


def at_turns(world, error, phase, name, turns):
    """The error where a phase passes the given twists."""
    in_phase = phase == name
    order = np.argsort(world.turns[in_phase], kind="stable")
    return np.interp(turns, world.turns[in_phase][order], error[in_phase][order])


def loop_mm(world, error, phase, stroke, turns):
    """How much higher the error stands unwinding than winding, in mm."""
    names = (f"unwind {stroke}", f"wind {stroke}")
    return float(np.subtract(*(at_turns(world, error, phase, name, turns) for name in names)))


def laws(*effects):
    return pytest.mark.parametrize(
        "law", [pytest.param(law, id=f"{law.effect}-{law.name}") for effect in effects for law in BY_EFFECT[effect]]
    )


@laws("friction_hysteresis")
def test_friction_follows_the_load_and_the_lever_but_hardly_the_rate(law):
    world, phase = bench(strokes=4, loads=[10.0, 10.0, 30.0, 30.0])
    params = drawn(law, world, 0.3)
    error = error_mm(law, world, params)
    light, heavy = (loop_mm(world, error, phase, stroke, 18.0) for stroke in (1, 3))
    assert light > 0 and heavy > 1.3 * light
    assert heavy > 1.5 * loop_mm(world, error, phase, 3, 5.0)
    slow, slow_phase = bench(rate=1.0, strokes=4, loads=[10.0, 10.0, 30.0, 30.0])
    assert loop_mm(slow, error_mm(law, slow, params), slow_phase, 3, 18.0) == pytest.approx(heavy, rel=0.2)
    hold_error = error[phase == "hold 3"]
    assert hold_error[-1] == pytest.approx(hold_error[50], abs=0.02 * heavy), "friction lets go at standstill"


@laws("backlash")
def test_backlash_is_as_wide_under_every_load_and_rate(law):
    gaps = []
    for rate, load_n in ((2.0, 10.0), (2.0, 30.0), (1.0, 30.0)):
        world, phase = bench(rate=rate, load_n=load_n)
        error = error_mm(law, world, drawn(law, world, 0.4))
        slope = np.gradient(world.base_mm[phase == "wind 1"], world.turns[phase == "wind 1"])
        gaps.append(loop_mm(world, error, phase, 1, 12.0) / np.interp(12.0, world.turns[phase == "wind 1"], slope))
    assert gaps[0] == pytest.approx(0.4, rel=0.12)
    assert gaps[1:] == pytest.approx([gaps[0]] * 2, rel=0.01)


@laws("viscous_loss")
def test_viscous_loss_follows_the_rate_at_every_twist_and_ends_with_the_motion(law):
    world, phase = bench()
    params = drawn(law, world, 0.5)
    error = error_mm(law, world, params)
    low, high = (loop_mm(world, error, phase, 1, turns) for turns in (6.0, 20.0))
    assert low == pytest.approx(high, rel=0.02) and low > 0.1
    assert np.abs(error[phase == "hold 1"][-200:-5]).max() < 0.01 * low
    slow, slow_phase = bench(rate=1.0)
    assert loop_mm(slow, error_mm(law, slow, params), slow_phase, 1, 12.0) < 0.85 * low


@laws("sensor_lag")
def test_a_lag_vanishes_at_standstill_and_is_late_by_its_time(law):
    world, phase = bench()
    error = error_mm(law, world, drawn(law, world, 0.2))
    for still in ("hold 1", "rest 1"):
        assert np.abs(error[phase == still][-200:]).max() < 1e-3
    winding = (phase == "wind 1") & (world.turns > 5.0)
    speed = np.gradient(world.base_mm, STEP_S)[winding]
    assert np.median(-error[winding] / speed) == pytest.approx(0.2, rel=0.06)


@laws("creep")
def test_creep_grows_under_load_and_comes_back_at_rest(law):
    world, phase = bench(hold_s=60.0, rest_s=200.0, strokes=1)
    error = error_mm(law, world, drawn(law, world, 1.0))
    hold_error, rest = error[phase == "hold 0"], error[phase == "rest 0"]
    assert hold_error[-1] < hold_error[0] < 0, "longer, thus less contraction"
    assert rest[-1] > 0.6 * hold_error[-1]
    assert np.all(np.diff(rest[400:]) > -1e-4)


@laws("plastic_elongation")
def test_plastic_elongation_is_for_good(law):
    world, phase = bench(hold_s=10.0, rest_s=30.0)
    error = error_mm(law, world, drawn(law, world, 1.0))
    assert np.diff(error).max() < 1e-9 and error[-1] == pytest.approx(-1.0)
    assert np.ptp(error[phase == "rest 1"]) < 1e-6
    if law.name == "yield_surface":
        assert error[phase == "rest 0"][-1] == pytest.approx(-1.0), "nothing new without a greater tension"


@laws("stiffening")
def test_stiffening_lifts_the_load_more_the_heavier_it_is(law):
    loads = [20.0] * 5 + [40.0]
    world, phase = bench(strokes=6, loads=loads)
    error = error_mm(law, world, drawn(law, world, 1.0))
    assert np.diff(error[world.stroke < 5]).min() > -1e-9 and error[phase == "rest 4"][-1] > 0.3
    assert error[phase == "wind 5"][0] == pytest.approx(2.0 * error[phase == "rest 4"][-1], rel=0.02)


@laws("axial_elasticity")
def test_elasticity_follows_the_load_and_nothing_else(law):
    world, phase = bench(loads=[10.0, 30.0, 10.0])
    error = error_mm(law, world, drawn(law, world, 1.0))
    assert np.ptp(error[world.stroke == 1]) < 1e-9
    assert error[phase == "wind 1"][0] < -0.2
    assert error[-1] == pytest.approx(0.0, abs=1e-9)


@laws("thermal")
def test_warmth_comes_and_goes_by_itself(law):
    world, phase = bench(strokes=4, rest_s=60.0, warmth=3.0)
    params = drawn(law, world, 1.0)
    error = params["sign"] * -error_mm(law, world, params)
    assert np.ptp(error) == pytest.approx(1.0, rel=0.05)
    if law.name == "ambient_node":
        assert np.corrcoef(error, world.ambient_k)[0, 1] > 0.3
        turning = bench(strokes=4, rest_s=60.0, rate=2.2, warmth=3.0)[0]
        count = min(turning.time_s.size, world.time_s.size)
        assert error_mm(law, turning, params)[:count] == pytest.approx(error_mm(law, world, params)[:count], abs=0.1)
    else:
        resting = error[phase == "rest 1"]
        assert resting[-1] < resting[2000] and error[phase == "unwind 0"][-1] > 0.05


@laws("radius_compaction", "shaft_windup", "jam")
def test_what_has_no_memory_is_the_same_both_ways_and_in_every_stroke(law):
    world, phase = bench()
    error = error_mm(law, world, drawn(law, world, 0.2))
    for turns in (6.0, 12.0, 20.0, 23.0):
        winding = at_turns(world, error, phase, "wind 0", turns)
        assert at_turns(world, error, phase, "unwind 2", turns) == pytest.approx(winding, abs=1e-4)
    assert error[phase == "hold 1"].max() < -0.05, "the displacement falls behind"


@laws("shaft_windup")
def test_wind_up_follows_the_load(law):
    world, phase = bench(loads=[10.0, 30.0, 10.0])
    error = error_mm(law, world, drawn(law, world, 1.0))
    assert error[phase == "hold 1"].mean() < 1.2 * error[phase == "hold 0"].mean() < 0


@laws("jam", "end_stop")
def test_a_limit_does_nothing_below_it(law):
    world = bench()[0]
    error = error_mm(law, world, drawn(law, world, 0.5))
    low = world.turns < 0.5 * TOP
    assert np.abs(error[low]).max() < 0.01 and error.min() < -0.1


@laws("end_stop")
def test_a_stop_is_never_passed_by_more_than_it_gives(law):
    world = bench()[0]
    reading = reading_mm(world, [(law, drawn(law, world, 3.0))])
    assert reading.max() <= world.span_mm - 3.0 + {"hard": 1e-9, "hertz": 0.9, "foam": 1.0}[law.name]
    assert np.argmax(reading) in np.flatnonzero(world.turns > 0.8 * TOP)


@laws("overtwist")
def test_coils_run_ahead_beyond_a_critical_twist_and_melt_later(law):
    world, phase = bench()
    params = drawn(law, world, 0.5)
    error = error_mm(law, world, params)
    assert np.abs(error[world.turns < 0.4 * TOP]).max() < 0.02
    assert error[phase == "hold 1"].min() > 0.3
    middle = np.linspace(params["critical_turns"] - 4.0, TOP - 0.5, 60)
    loops = [loop_mm(world, error, phase, 1, turns) for turns in middle]
    assert max(loops) > 0.1 and min(loops) > -0.05


@laws("slack")
def test_slack_is_taken_up_once_and_then_constant(law):
    world, phase = bench()
    error = error_mm(law, world, drawn(law, world, 1.0))
    top = error[world.turns > 0.8 * TOP]
    assert top.mean() < -0.6 and np.ptp(top) < 0.1
    start = (world.turns < 1.5) & (phase == "wind 1")
    moved = np.ptp(reading_mm(world, [(law, drawn(law, world, 1.0))])[start])
    assert moved < 0.75 * np.ptp(world.base_mm[start])
    assert error[phase == "rest 1"] == pytest.approx(error[phase == "start"][0], abs=1e-6)


@laws("wear")
def test_wear_goes_by_the_travel_and_stays(law):
    world, phase = bench(strokes=5, rest_s=20.0)
    error = error_mm(law, world, drawn(law, world, 0.05))
    tops = np.abs([error[phase == f"hold {stroke}"].mean() for stroke in range(5)])
    assert np.all(np.diff(tops) > 0)
    assert np.ptp(error[phase == "hold 2"]) < 1e-6 and np.ptp(error[phase == "rest 2"]) < 1e-6
    assert np.abs(error[phase == "rest 4"]).max() < 0.1 * tops[-1], "nothing at low twist"


@laws("count_slip", "clamp_slip")
def test_slips_happen_within_moments_and_stay(law):
    world, phase = bench(strokes=8, hold_s=2.0, rest_s=2.0)
    params = drawn(law, world, 1.0)
    error = error_mm(law, world, params)
    rests = [error[phase == f"rest {stroke}"] for stroke in range(8)]
    assert all(np.ptp(rest) < 1e-9 for rest in rests)
    changed = np.flatnonzero(np.diff([rest[0] for rest in rests]) < -1e-4)
    assert len(changed) == len(params["at_s"])
    tops = error[phase == "hold 7"].mean() / rests[7].mean()
    assert tops == pytest.approx(1.0) if law.effect == "clamp_slip" else tops > 3.0


@laws("sensor_drift")
def test_a_drift_knows_nothing_of_the_motion(law):
    world, other = bench()[0], bench(hold_s=2.0, rest_s=14.0)[0]
    params = drawn(law, world, 1.0)
    assert error_mm(law, world, params) == pytest.approx(error_mm(law, other, params), abs=1e-9)


@laws("eccentricity")
def test_the_ripple_repeats_every_turn_both_ways(law):
    world, phase = bench()
    error = error_mm(law, world, drawn(law, world, 0.3))
    turns = np.linspace(10.0, 11.0, 40)
    winding = at_turns(world, error, phase, "wind 1", turns)
    assert at_turns(world, error, phase, "unwind 1", turns) == pytest.approx(winding, abs=1e-3)
    assert at_turns(world, error, phase, "wind 1", turns + 1.0) == pytest.approx(winding, abs=0.05)
    assert np.ptp(winding) > 0.2


@laws("load_swing")
def test_a_swing_rings_down_in_a_hold_about_nothing(law):
    world, phase = bench(hold_s=40.0, rest_s=40.0, strokes=2)
    error = error_mm(law, world, drawn(law, world, 1.0))
    hold_error = error[phase == "hold 0"]
    assert np.abs(hold_error[:1000]).max() > 0.05
    assert np.abs(hold_error[-1000:]).max() < 0.7 * np.abs(hold_error[:1000]).max()
    assert abs(hold_error.mean()) < 0.05 * np.abs(hold_error).max()


@laws("stick_slip")
def test_it_stands_still_and_jumps_while_the_motor_turns(law):
    world, phase = bench(rate=1.0, strokes=2)
    reading = reading_mm(world, [(law, drawn(law, world, 2.0 if law.name == "rate_and_state" else 0.4))])
    winding = (phase == "wind 1") & (world.turns > 8.0)
    speed, free = np.gradient(reading, STEP_S)[winding], np.gradient(world.base_mm, STEP_S)[winding]
    assert np.mean(np.abs(speed) < 0.2 * free) > 0.4, "it sticks most of the time"
    assert speed.max() > 5.0 * free.max(), "and jumps"
    assert np.ptp(reading[phase == "hold 1"][100:]) < 0.02, "but not in a hold"
