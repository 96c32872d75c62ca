"""Author `kinetics`: what the physics of each law demands, and that sizes are what was asked."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import yaml
from scipy.optimize import least_squares

from pipeline.ground.kinematics import Geometry
from pipeline.rig.authors.interface import Asked, OutOfReach
from pipeline.rig.authors.kinetics import LAWS, make
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.reading import Hidden, displacement
from pipeline.rig.authors.kinetics.recording import recorded
from pipeline.rig.authors.kinetics.register import BY_EFFECT
from pipeline.run.samples import read_samples

EVERY = [
    pytest.param(effect, law, marks=() if law == laws[0] else pytest.mark.long)
    for effect, laws in LAWS.items()
    for law in laws
]  # one law of each effect, and those that take long
SIZES = {"radius_compaction": 0.05, "wear": 0.05, "sensor_lag": 0.08, "x_clocks": 0.2, "thermal": 0.5, "jam": 0.1}
SIZES |= {"x_moisture": 0.05, "friction_hysteresis": 0.3}


def motion(*legs, load=20.0):
    """A bench that goes through legs of (seconds, turns at the end); `load` is one or (second, newton) corners."""
    times, places = np.cumsum([0.0, *(s for s, _ in legs)]), [0.2, *(turns for _, turns in legs)]
    clock = np.arange(0.0, times[-1], STEP_S)
    load_n = np.interp(clock, *zip(*load, strict=True)) if isinstance(load, list) else np.full(len(clock), load)
    turns = np.interp(clock, times, places)
    stroke = np.cumsum(np.diff(turns, prepend=turns[0], append=turns[-1])[:-1] > 0) > 0
    geometry = Geometry("separator", 0.5, 320.0, 35.0, 150.0, 8.0)
    return Bench(geometry, turns, load_n, np.full(len(clock), 22.0) + clock / 30.0, stroke.astype(int), False)


STROKE = ((10.0, 20.0), (2.0, 20.0), (10.0, 0.2), (20.0, 0.2))


def hidden(effect, law, seed=1, **fixed):
    chosen_law = next(candidate for candidate in BY_EFFECT[effect] if candidate.name == law)
    parameters = {**chosen_law.drawn(np.random.default_rng(seed)), "wander": 0.0, **fixed}
    return Hidden(effect, chosen_law, parameters, SIZES.get(effect, 0.5))


def change(bench, effect, law, **fixed):
    """What an effect does to the displacement over a bench's time."""
    return displacement(bench, [hidden(effect, law, **fixed)]) - displacement(bench, [])


def at(bench, values, time_s):
    return float(np.interp(time_s, bench.time_s, values))


def of(*effects):
    return [(effect, law) for effect in effects for law in LAWS[effect]]


def test_the_laws_are_of_known_physics_and_own_ones_with_two_forms_where_print_knows_two():
    assert sum(effect.startswith("x_") for effect in LAWS) >= 4
    assert all(len(set(laws)) == len(laws) >= 2 for effect, laws in LAWS.items() if effect != "x_snag")


@cache
def case(effect, law):
    for seed in range(1, 20):
        try:
            return seed, recorded(Asked(seed, (effect,), (4.0,), "usual"), {effect: law})
        except OutOfReach:
            continue
    raise AssertionError(f"no seed shows {law}")


@pytest.mark.parametrize(("effect", "law"), EVERY)
def test_every_law_makes_a_recording_of_the_size_that_was_asked(effect, law, tmp_path):
    _, recording = case(effect, law)
    hidden_effect = recording.truth["effects"][0]
    assert (hidden_effect["id"], hidden_effect["law"]) == (effect, law)
    assert hidden_effect["kappa"] == pytest.approx(4.0, rel=0.1)
    assert hidden_effect["rms_mm"] > 0.5 * recording.truth["noise_floor_mm"]
    assert np.isfinite(recording.table.to_numpy()).all() and len(recording.table) <= 25_000
    (tmp_path / "case").mkdir()
    (tmp_path / "case" / "run.yaml").write_text(yaml.safe_dump({"run": "case", **recording.content}, sort_keys=False))
    recording.table.to_parquet(tmp_path / "case" / "recording.parquet", index=False)
    _, samples = read_samples(tmp_path / "case")
    assert 180.0 < np.ptp(samples["time_s"]) < 600.0


@pytest.mark.parametrize("effect", LAWS)
def test_the_laws_of_one_effect_differ(effect):
    more = ((4.0, 20.0), (15.0, 20.0), (4.0, 0.2), (8.0, 0.2), (25.0, 14.0), (9.0, 0.2))
    bench = motion(*STROKE, *more, load=[(0, 20), (42, 20), (43, 40), (60, 40), (70, 12), (200, 12)])
    seen = [change(bench, effect, law) for law in LAWS[effect]]
    for i, shape in enumerate(seen):
        assert np.ptp(shape) > 1e-4
        for other in seen[:i]:
            alike = np.std(shape - other * np.dot(shape, other) / np.dot(other, other)) / np.std(shape)
            assert alike > 0.003, (LAWS[effect][i], alike)


def test_a_seed_makes_one_recording_and_another_seed_another():
    request = Asked(5, ("creep", "backlash"), (3.0, 2.0), "usual")
    recording, again = make(request), make(request)
    assert recording.content == again.content and recording.truth == again.truth and recording.table.equals(again.table)
    plain = make(Asked(5, (), (), "usual"))
    assert plain.content == recording.content and plain.truth["noise_floor_mm"] == recording.truth["noise_floor_mm"]
    assert plain.table.drop(columns="displacement_mm").equals(recording.table.drop(columns="displacement_mm"))
    assert make(replace(request, seed=6)).content != recording.content
    assert [effect["kappa"] for effect in recording.truth["effects"]] == pytest.approx([3.0, 2.0], rel=0.1)


@pytest.mark.parametrize(("seed", "protocol"), [(1, "rich"), (2, "usual"), (3, "poor")])
def test_without_effects_calibration_leaves_noise(seed, protocol):
    recording = make(Asked(seed, (), (), protocol))
    string, rig, table = recording.content["string"], recording.content["rig"], recording.table
    load_n = table["load_n"].to_numpy() if "load_n" in table else rig["load_n"]
    measured = table["displacement_mm"].to_numpy()

    def residual(p):
        moved = {
            "torsion_zone_mm": rig.get("torsion_zone_mm", np.nan) + p[2],
            "separator_mm": rig.get("separator_mm", np.nan) + p[1],
        }
        radius_mm, length_mm = string["radius_mm"] * (1 + 0.03 * p[0]), string["length_mm"] + 2.0 * p[3]
        geometry = Geometry(recording.content["actuator"], radius_mm, length_mm, 30.0, **moved)
        x = (1 + 0.005 * p[4]) * geometry.contraction_mm(table["motor_turns"].to_numpy() + 0.05 * p[5], load_n)
        return (lambda e: e - np.median(e))(measured - x)

    solution = least_squares(residual, np.zeros(6), bounds=(-3, 3), loss="soft_l1", f_scale=0.05)
    rest = residual(solution.x)
    floor_mm = recording.truth["noise_floor_mm"]
    assert np.std(rest[np.abs(rest) < 6 * floor_mm]) == pytest.approx(floor_mm, rel=0.1)


def test_what_a_protocol_cannot_show_is_out_of_reach():
    with pytest.raises(OutOfReach):
        make(Asked(3, ("axial_elasticity",), (3.0,), "poor"))
    with pytest.raises(OutOfReach):
        make(Asked(3, ("stiffening",), (1e6,), "rich"))


LOADED = [(0.0, 10.0), (42.0, 10.0), (42.5, 40.0), (200.0, 40.0)]


def gaps(effect, law):
    """Unwinding minus winding at 14 turns, of a stroke under 10 N and one under 40 N."""
    bench = motion(*STROKE, *STROKE, load=LOADED)
    e = change(bench, effect, law)
    up, down = 10.0 * 13.8 / 19.8, 12.0 + 10.0 * 6.0 / 19.8
    return [at(bench, e, start + down) - at(bench, e, start + up) for start in (0.0, 42.0)]


@pytest.mark.parametrize(("effect", "law"), of("friction_hysteresis"))
def test_friction_follows_the_load(effect, law):
    light, heavy = gaps(effect, law)
    assert light > 0 and heavy > 1.7 * light


@pytest.mark.parametrize(("effect", "law"), of("backlash"))
def test_play_has_one_width_whatever_the_load_and_the_rate(effect, law):
    light, heavy = gaps(effect, law)
    assert light > 0.1 and heavy == pytest.approx(light, rel=0.02)
    fast, slow = (motion((s, 20.0), (2.0, 20.0), (s, 0.2)) for s in (5.0, 40.0))
    ends = [change(bench, effect, law)[-1] for bench in (fast, slow)]
    assert ends[0] == pytest.approx(ends[1], rel=0.02)


@pytest.mark.parametrize(("effect", "law"), of("sensor_lag", "viscous_loss"))
def test_lag_and_rate_loss_vanish_at_standstill(effect, law):
    bench = motion(*STROKE, *STROKE)
    e = change(bench, effect, law)
    assert np.abs(e).max() > 0.05
    assert abs(at(bench, e, 11.9)) < 0.02 * np.abs(e).max() and abs(e[-1]) < 1e-3 * np.abs(e).max()


@pytest.mark.parametrize(("effect", "law"), of("sensor_lag", "viscous_loss"))
def test_lag_follows_the_displacement_and_rate_loss_the_twist(effect, law):
    bench = motion((20.0, 20.0), (10.0, 20.0))
    e = change(bench, effect, law)
    ratio = at(bench, e, 18.0) / at(bench, e, 4.0)
    speeds = np.gradient(bench.contraction_mm, STEP_S)
    wanted = at(bench, speeds, 18.0) / at(bench, speeds, 4.0) if effect == "sensor_lag" else 1.0
    assert ratio == pytest.approx(wanted, rel=0.08)


@pytest.mark.parametrize(("effect", "law"), of("creep"))
def test_creep_comes_under_tension_and_goes_at_rest(effect, law):
    bench = motion((5.0, 20.0), (60.0, 20.0), (5.0, 0.2), (500.0, 0.2))
    e = change(bench, effect, law, hung_s=1e6)
    e = e - e[0]
    assert at(bench, e, 64.0) < at(bench, e, 20.0) < -0.01
    assert abs(e[-1]) < 0.35 * abs(at(bench, e, 64.0))


@pytest.mark.parametrize(("effect", "law"), of("plastic_elongation", "wear"))
def test_what_is_permanent_comes_with_work_and_stays_at_rest(effect, law):
    bench = motion(*STROKE, *STROKE, (10.0, 20.0), (2.0, 20.0), (10.0, 0.2), (300.0, 0.2))
    e = change(bench, effect, law)
    assert at(bench, e, 130.0) == pytest.approx(e[-1], rel=1e-6)
    tops = np.abs([at(bench, e, start + 11.0) for start in (0.0, 42.0, 84.0)])
    assert tops[0] < tops[1] < tops[2] and tops[2] > 0.02


@pytest.mark.parametrize(("effect", "law"), of("axial_elasticity", "stiffening"))
def test_stretch_follows_the_load_and_stiffening_lifts(effect, law):
    bench = motion(
        *STROKE, (1.0, 0.2), (10.0, 0.2), (5.0, 0.2), load=[(0, 20), (42, 20), (43, 40), (52, 40), (53, 20), (60, 20)]
    )
    e = change(bench, effect, law)
    step = at(bench, e, 50.0) - at(bench, e, 41.0)
    assert step < -0.05 if effect == "axial_elasticity" else step > 0.01
    assert at(bench, e, 57.0) == pytest.approx(at(bench, e, 41.0), abs=0.02)


@pytest.mark.parametrize(("effect", "law"), of("count_slip", "clamp_slip"))
def test_a_slip_is_sudden_and_stays(effect, law):
    bench = motion(*STROKE, *STROKE, *STROKE, *STROKE)
    e = change(bench, effect, law)
    assert abs(at(bench, e, 20.0)) < 1e-3 and at(bench, e, 155.0) == pytest.approx(e[-1], abs=5e-3) and e[-1] < -0.02


@pytest.mark.parametrize(("effect", "law"), of("jam", "overtwist", "end_stop"))
def test_limits_act_only_far_up(effect, law):
    bench = motion(*STROKE, *STROKE)
    e = change(bench, effect, law)
    assert np.abs(e[bench.turns < 5.0]).max() < 0.02
    top = e[bench.turns > 19.9].mean()
    assert top > 0.1 if effect == "overtwist" else top < -0.1


@pytest.mark.parametrize(("effect", "law"), of("overtwist"))
def test_coils_go_later_than_they_come(effect, law):
    bench = motion((20.0, 20.0), (2.0, 20.0), (20.0, 0.2))
    e = change(bench, effect, law)
    assert e[2200:].sum() > 1.05 * e[:2000].sum()


@pytest.mark.parametrize(("effect", "law"), of("slack"))
def test_slack_takes_the_first_twist_alone(effect, law):
    bench = motion(*STROKE)
    low = np.ptp(displacement(bench, [hidden(effect, law, shape=5.0)])[:100])
    e = change(bench, effect, law)
    assert low < 0.65 * np.ptp(bench.contraction_mm[:100])
    assert at(bench, e, 9.0) == pytest.approx(at(bench, e, 10.0), abs=0.02) and e[-1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("law", LAWS["eccentricity"])
def test_ripple_comes_once_a_turn(law):
    bench = motion((40.0, 20.2), (1.0, 20.2))
    ripple = change(bench, "eccentricity", law)[:4000]
    spectrum = np.abs(np.fft.rfft(ripple - ripple.mean()))
    assert np.argmax(spectrum) == pytest.approx(20, abs=1)


@pytest.mark.parametrize("law", LAWS["load_swing"])
def test_a_swing_starts_with_a_jerk_and_dies(law):
    bench = motion((5.0, 0.2), (10.0, 20.0), (60.0, 20.0))
    e = change(bench, "load_swing", law, damping=0.04)
    assert np.ptp(e[:490]) < 1e-9 and np.ptp(e[1500:1700]) > 4 * np.ptp(e[-500:])


@pytest.mark.parametrize("law", LAWS["shaft_windup"])
def test_windup_follows_the_torque_and_has_no_loop(law):
    bench = motion(*STROKE, *STROKE, load=LOADED)
    e = change(bench, "shaft_windup", law)
    assert at(bench, e, 8.0) == pytest.approx(at(bench, e, 14.0), abs=2e-3)
    assert at(bench, e, 53.0) < 1.1 * at(bench, e, 11.0) < -0.01


@pytest.mark.parametrize("law", LAWS["radius_compaction"])
def test_compaction_has_no_memory(law):
    bench = motion(*STROKE, *STROKE)
    e = change(bench, "radius_compaction", law)
    assert at(bench, e, 8.0) == pytest.approx(at(bench, e, 56.0), abs=2e-3) and at(bench, e, 11.0) < -0.1
    assert abs(at(bench, e, 1.0)) < 0.1 * abs(at(bench, e, 11.0))


@pytest.mark.parametrize("law", LAWS["thermal"])
def test_warmth_follows_the_air_or_the_motion(law):
    bench = motion(*STROKE, *STROKE, (400.0, 0.2))
    still = replace(bench, turns=np.full(len(bench.turns), 0.2) + 1e-9 * bench.turns)
    cold = replace(bench, air_c=np.full(len(bench.turns), 22.0))
    if law == "air_soaks_in":
        assert np.allclose(change(cold, "thermal", law), 0.0) and np.ptp(change(still, "thermal", law)) > 0.1
    else:
        e = change(cold, "thermal", law)
        assert np.allclose(e, change(bench, "thermal", law)) and np.abs(e).max() > 0.02
        assert abs(e[-1]) < 0.4 * np.abs(e).max()


@pytest.mark.parametrize("law", LAWS["stick_slip"])
def test_contacts_stick_and_let_go(law):
    bench = motion((40.0, 20.0), (5.0, 20.0))
    e = change(bench, "stick_slip", law)
    jumps = np.diff(e)
    assert np.sum(jumps > 20 * np.median(np.abs(jumps[:3900]))) > 5
    assert np.allclose(e[-400:], e[-1])
