"""What physics demands of the laws of the author `mechanics`, on one motion with two loads, two speeds and a rest."""

from itertools import pairwise

import numpy as np
import pytest

from pipeline.ground.kinematics import Geometry
from pipeline.rig.authors.mechanics import bench, coil, drive, friction, load, sensor, slips, string
from pipeline.rig.authors.mechanics.catalogue import WRITERS
from pipeline.rig.authors.mechanics.motion import Plan, driven
from pipeline.rig.authors.mechanics.scene import STEP_S, Scene, displacement_mm

TOP, LOAD_N = 20.0, 12.0
SLOW, FAST, HEAVY, LAST = range(4)  # the strokes


@pytest.fixture(scope="module")
def scene():
    """Four strokes: slow, twice as fast, slow with twice the load, and after a long rest slow again."""
    heights, speeds, loads = np.ones(4), np.array([1.0, 2.0, 1.0, 1.0]), np.array([1.0, 1.0, 2.0, 1.0])
    plan = Plan(heights, speeds, np.full(4, 6.0), np.full(4, 6.0), loads, (LAST,), 190.0)
    turns, load_n = driven(plan, 0.0, TOP, LOAD_N, np.random.default_rng(4))
    return Scene(Geometry("separator", 0.4, 300.0, 30.0, 150.0, 8.0), turns, load_n)


def strokes(scene):
    """For each stroke its steps: winding, dwell, unwinding (as slices)."""
    rate = np.sign(np.round(np.diff(scene.turns, append=scene.turns[-1]), 9))
    edges = np.flatnonzero(np.diff(rate)) + 1
    winding = [(a, b) for a, b in pairwise(edges) if rate[a] > 0]
    unwinding = [(a, b) for a, b in pairwise(edges) if rate[a] < 0]
    return [(slice(*up), slice(up[1], down[0]), slice(*down)) for up, down in zip(winding, unwinding, strict=True)]


def rest(scene):
    """The steps of the long rest, in which the weight is set down."""
    steps = np.flatnonzero(scene.load_n < 0.5 * LOAD_N)
    return slice(int(steps[0]), int(steps[-1]))


def drawn(scene, writer, seed=1):
    return writer(scene, np.random.default_rng(seed))


def change_mm(scene, writer, strength, seed=1):
    return displacement_mm(scene, [(drawn(scene, writer, seed), strength)]) - displacement_mm(scene, [])


def at(scene, values, steps, turns):
    """A value within one winding or unwinding at a twist."""
    place = np.argsort(scene.turns[steps], kind="stable")
    return float(np.interp(turns, scene.turns[steps][place], values[steps][place]))


def gap(scene, values, stroke, turns=12.0):
    """Unwinding less winding of one stroke at a twist."""
    up, _, down = strokes(scene)[stroke]
    return at(scene, values, down, turns) - at(scene, values, up, turns)


@pytest.mark.parametrize("writer", [friction.shoe_on_rail, friction.strand_sliders])
def test_friction_follows_the_load_and_not_the_speed(scene, writer):
    law = drawn(scene, writer)
    friction_shift = law.act(1.0, scene.turns)
    slow, fast, heavy = (gap(scene, friction_shift, stroke) for stroke in (SLOW, FAST, HEAVY))
    assert slow > 0.1 and fast == pytest.approx(slow, rel=0.1)
    assert heavy / slow == pytest.approx(2.0 ** law.parameters.get("load_power", 1.0), rel=0.1)


@pytest.mark.parametrize("writer", [drive.toothed, drive.two_dogs])
def test_backlash_has_one_width_whatever_load_and_speed(scene, writer):
    law = drawn(scene, writer)
    played = law.act(0.8, scene.turns)
    width = 0.8 * (1.0 + law.parameters.get("narrower_share", 1.0)) / 2.0
    for stroke in (SLOW, FAST, HEAVY):
        for turns in (3.0, 12.0, 18.0):
            assert gap(scene, played, stroke, turns) == pytest.approx(width, rel=0.03)
    for _, dwell, _ in strokes(scene):
        assert np.ptp(played[dwell][200:]) < 0.01 * width


@pytest.mark.parametrize("writer", [sensor.filtered, sensor.heavy_pickup])
@pytest.mark.parametrize("lag_s", [0.02, 0.2])
def test_a_lag_is_the_rate_times_its_time_and_nothing_at_standstill(scene, writer, lag_s):
    late = change_mm(scene, writer, lag_s)
    rate = np.gradient(scene.contraction_mm, STEP_S)
    for up, dwell, _ in strokes(scene)[:3]:
        middle = (up.start + up.stop) // 2
        assert late[middle] == pytest.approx(-lag_s * rate[middle], rel=0.05)
        assert abs(late[dwell.stop - 10]) < 0.002


@pytest.mark.parametrize(
    ("writer", "least", "most"), [(friction.grease_dashpot, 1.9, 2.1), (friction.stirred_fluid, 2.5, 4.1)]
)
def test_viscous_loss_follows_the_rate_at_every_twist_and_ends_with_it(scene, writer, least, most):
    lost = change_mm(scene, writer, 1.0)
    slow, fast = gap(scene, lost, SLOW), gap(scene, lost, FAST)
    assert slow > 0 and least < fast / slow < most
    assert gap(scene, lost, HEAVY) == pytest.approx(slow, rel=0.02)
    assert gap(scene, lost, SLOW, 4.0) == pytest.approx(slow, rel=0.05), "also at low twist"
    assert all(abs(lost[dwell.stop - 10]) < 0.01 for _, dwell, _ in strokes(scene))


@pytest.mark.parametrize("writer", [string.kelvin_voigt, string.two_kelvins])
def test_creep_lengthens_under_load_and_comes_back_at_rest(scene, writer):
    crept = change_mm(scene, writer, 1.0)
    pause = rest(scene)
    assert crept[pause.start] < -0.5 and crept.max() < 0.02
    assert crept[pause.stop - 1] - crept[pause.start] > 0.15
    assert np.abs(np.diff(crept)).max() < 0.01, "nothing about it is sudden"


@pytest.mark.parametrize("writer", [string.hardening_knots, string.viscous_knots])
def test_plastic_elongation_stays_at_rest_and_grows_with_the_tension(scene, writer):
    slipped = change_mm(scene, writer, 1.0)
    assert np.diff(slipped).max() < 1e-4, "it never comes back"
    pause = rest(scene)
    assert slipped[pause.stop - 1] == pytest.approx(slipped[pause.start], abs=0.005)
    heavy = strokes(scene)[HEAVY]
    assert slipped[heavy[0].start] - slipped[heavy[2].stop - 1] > 0.3, "the greatest load does most of it"


def test_knots_that_only_harden_stop_at_the_greatest_tension_and_viscous_ones_go_on(scene):
    heavy = strokes(scene)[HEAVY][1]
    hard, slow = (change_mm(scene, knots, 1.0)[heavy] for knots in (string.hardening_knots, string.viscous_knots))
    assert abs(hard[-1] - hard[len(hard) // 2]) < 0.02 < slow[len(slow) // 2] - slow[-1]


@pytest.mark.parametrize("writer", [string.linear_spring, string.crimped_braid])
def test_elasticity_follows_the_load_alone(scene, writer):
    stretched = change_mm(scene, writer, 1.0)
    for stroke in (SLOW, FAST, HEAVY, LAST):
        up, dwell, down = strokes(scene)[stroke]
        whole_stroke = slice(up.start, down.stop)
        assert np.ptp(stretched[whole_stroke]) < 0.01
        assert stretched[dwell.start] < -0.3 if stroke == HEAVY else abs(stretched[dwell.start]) < 0.01
    assert stretched[rest(scene).stop - 20] > 0.1, "a lowered weight shortens the string"


@pytest.mark.parametrize(
    ("writer", "strength"),
    [
        (drive.torsion_spring, 1.0),
        (drive.spider_coupling, 1.0),
        (string.springy_core, 0.1),
        (string.pressed_fibres, 0.1),
    ],
)
def test_windup_and_compaction_grow_with_load_and_twist_and_have_no_loop(scene, writer, strength):
    yielded = change_mm(scene, writer, strength)
    largest = float(np.abs(yielded).max())
    assert yielded.max() < 0.03 * largest
    for stroke in (SLOW, FAST, HEAVY):
        assert abs(gap(scene, yielded, stroke)) < 0.04 * largest
    up = [strokes(scene)[stroke][0] for stroke in (SLOW, HEAVY)]
    light, heavy = (at(scene, yielded, winding, 19.0) for winding in up)
    assert heavy < 1.1 * light < 0.0
    assert abs(at(scene, yielded, up[0], 2.0)) < 0.1 * abs(light)


@pytest.mark.parametrize("writer", [drive.strand_pads, drive.packed_strands])
def test_a_jam_leaves_low_twist_alone_and_goes_on_with_less_past_it(scene, writer):
    law = drawn(scene, writer)
    fallen = law.act(5.0, scene.turns)
    up = strokes(scene)[SLOW][0]
    assert np.abs(fallen[scene.turns < TOP - 5.1]).max() < 0.02
    slope = 1.0 + (at(scene, fallen, up, 19.5) - at(scene, fallen, up, 18.5))
    assert 0.0 <= slope < 0.8 and fallen.min() < -1.0
    if "slope_share" in law.parameters:
        assert slope == pytest.approx(law.parameters["slope_share"], abs=0.02)
    assert abs(gap(scene, fallen, SLOW, 17.5)) < 0.03, "it has no loop"


@pytest.mark.parametrize(("writer", "yields_mm"), [(load.hard_stop, 0.01), (load.foam_stop, 0.8)])
def test_an_end_stop_clips_and_touches_nothing_else(scene, writer, yields_mm):
    usual = scene.contraction_mm
    shown = usual + change_mm(scene, writer, 3.0)
    stop = usual.max() - 3.0
    assert stop - 0.01 < shown.max() < stop + yields_mm + 0.01
    below = usual < stop - 0.05
    assert np.abs(shown - usual)[below].max() < 0.02
    assert shown[usual > stop + 2.0].std() < 0.1


@pytest.mark.parametrize("writer", [load.hard_seat, load.springy_seat])
def test_slack_eats_the_first_twist_and_then_stays_what_it_is(scene, writer):
    lost = change_mm(scene, writer, 1.0)
    lost = lost - lost[0]
    usual = scene.contraction_mm - scene.contraction_mm[0]
    taut = usual > 3.0
    assert np.abs(lost[taut] - np.median(lost[taut])).max() < 0.08 and np.median(lost[taut]) < -0.9
    if writer is load.hard_seat:
        assert np.abs(lost + usual)[usual < 0.9].max() < 0.02, "the first twist moves nothing"
    assert np.abs(lost[rest(scene)]).max() < 0.02, "a lowered weight changes nothing"


@pytest.mark.parametrize("writer", [load.bouncing_weight, load.pendulum])
def test_a_load_swings_after_the_motor_has_stopped_and_dies_away(scene, writer):
    swung = change_mm(scene, writer, 1.0)
    dwell = strokes(scene)[FAST][1]
    first, last = swung[dwell][:400], swung[dwell][-400:]
    assert np.std(first) > 0.02 and np.std(last) < 0.95 * np.std(first)
    assert np.count_nonzero(np.diff(np.sign(first - first.mean()))) >= 2, "it rings"
    quiet = swung[rest(scene)][-400:]
    assert np.std(quiet) < 0.5 * np.std(first)


@pytest.mark.parametrize("writer", [sensor.orbiting_eyelet, sensor.tilted_axis])
def test_eccentricity_repeats_every_turn_whatever_speed_and_load(scene, writer):
    ripple = change_mm(scene, writer, 0.3)
    assert np.abs(ripple).max() == pytest.approx(0.3, rel=0.01)
    for stroke in (SLOW, FAST, HEAVY):
        up, _, down = strokes(scene)[stroke]
        assert at(scene, ripple, up, 7.3) == pytest.approx(at(scene, ripple, down, 15.3), abs=0.02)
        assert abs(gap(scene, ripple, stroke, 9.7)) < 0.02


@pytest.mark.parametrize("writer", [coil.adhering_coil, coil.two_coils])
def test_overtwist_runs_ahead_past_a_critical_twist_with_a_loop_there(scene, writer):
    law = drawn(scene, writer)
    ahead = change_mm(scene, writer, 2.0)
    melts = law.parameters.get("melts_turns", law.parameters.get("first_melts_turns"))
    sticks = law.parameters["sticks_turns"]
    assert ahead.min() > -0.01 and np.abs(ahead[scene.turns < melts - 0.1]).max() < 0.02
    up, _, down = strokes(scene)[SLOW]
    assert at(scene, ahead, up, melts + 0.8 * sticks) < 0.02 < 0.08 < at(scene, ahead, down, melts + 0.8 * sticks)
    assert abs(gap(scene, ahead, SLOW, 19.5)) < 0.05


@pytest.mark.parametrize("writer", [slips.one_ridge, slips.several_ridges, slips.one_flat, slips.several_flats])
def test_slips_are_sudden_and_for_good(scene, writer):
    law = drawn(scene, writer, 3)
    slid = law.act(1.0, scene.turns)
    moments = [step for name, step in law.parameters.items() if name.startswith("slip_")]
    assert np.abs(slid[: int(moments[0] / STEP_S) - 1]).max() < 0.02
    assert np.diff(slid).max() < 1e-3 and slid[-1] == pytest.approx(-1.0, abs=0.01)
    moving_s = np.count_nonzero(np.diff(slid) < -1e-3) * STEP_S
    assert moving_s < 3.0 * len(moments)
    assert (len(moments) == 1) == (writer in (slips.one_ridge, slips.one_flat))


def test_a_second_weight_takes_its_stretch_above_its_height_alone(scene):
    height = drawn(scene, bench.second_weight).parameters["lifted_at_mm"]
    hung = change_mm(scene, bench.second_weight, 1.0)
    travel = scene.contraction_mm
    low, high = hung[travel < height - 0.3], hung[travel > height + 2.0]
    assert np.abs(low).max() < 0.25 and np.percentile(np.abs(low), 95) < 0.02
    assert np.median(high) < -0.5 and np.std(high) < 0.1


def test_a_bump_on_the_rail_is_met_at_its_place_in_both_directions(scene):
    height = change_mm(scene, bench.bumpy_rail, 1.0)
    places = [value for name, value in drawn(scene, bench.bumpy_rail).parameters.items() if name.startswith("bump")]
    up = strokes(scene)[SLOW][0]
    top = float(scene.contraction_mm[up][np.argmax(height[up])])
    assert min(abs(top - place) for place in places) < 0.05 * scene.contraction_mm.max()
    for turns in (4.0, 9.0, 14.0, 18.0):
        assert abs(gap(scene, height, SLOW, turns)) < 0.05
        assert abs(gap(scene, height, HEAVY, turns)) < 0.05


def test_a_shaken_bench_does_not_care_what_the_motor_does(scene):
    still = Scene(scene.geometry, np.full_like(scene.turns, 3.0), scene.load_n)
    shaken = change_mm(scene, bench.shaken_bench, 0.5)
    assert shaken == pytest.approx(change_mm(still, bench.shaken_bench, 0.5), abs=1e-9)
    assert np.abs(shaken).max() == pytest.approx(0.5, rel=0.01) and abs(shaken.mean()) < 0.01


@pytest.mark.parametrize("effect", [effect for effect, writers in WRITERS.items() if len(writers) > 1])
def test_the_laws_of_an_effect_are_not_one_law_by_two_names(scene, effect):
    """Scaled at best, one law's effect leaves a part of the other's that no strength takes away."""
    strength = {"radius_compaction": 0.1, "sensor_lag": 0.2, "jam": 6.0, "end_stop": 3.0}.get(effect, 1.0)
    effect_mm, other = (change_mm(scene, writer, strength) for writer in WRITERS[effect])
    effect_mm, other = effect_mm - effect_mm.mean(), other - other.mean()
    remainder = other - effect_mm * (effect_mm @ other) / (effect_mm @ effect_mm)
    assert np.std(remainder) > 0.02 * np.std(other)
