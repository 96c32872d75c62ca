"""The cable drive that is made: its effects are as large as declared, and behave as cables do."""

from functools import cache

import numpy as np
import pytest

from pipeline.rig.others import cable_drive, cable_parts
from pipeline.rig.others.cable_plan import TIME_S
from pipeline.rig.others.capstan import Capstans
from pipeline.rig.others.made import write_run
from pipeline.rig.others.streams import stream, wander
from pipeline.run.description import parse_run
from pipeline.run.samples import read_samples

ALL = {
    "friction_hysteresis": 1.5,
    "axial_elasticity": 25.0,
    "backlash": 0.8,
    "sensor_lag": 0.02,
    "creep": 0.6,
    "sensor_drift": 0.3,
    "sensor_offset": 0.5,
    "clamp_slip": 0.4,
    "x_kink": 0.3,
}
PLANS = ("sine-0.1", "sine-0.6", "loads-0.4", "swing-0.3", "steps")
SEEDS = range(4)


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def part(seed, name, size, plan="sine-0.3", **more):
    """A recording with one effect, and that effect's part of the jaw's angle."""
    recording = cable_drive.record(seed, {name: size}, plan, noise="none", **more)
    return recording, recording.hidden[name].to_numpy()


def sliding(recording, loss, low=0.3, high=0.7):
    """Half the height of a loop in the middle of its ways, after the first cycle, winding less unwinding."""
    motor = recording.hidden.motor_deg.to_numpy()
    middle = (motor > low * 60) & (motor < high * 60) & (TIME_S > 4.0)
    rate = np.gradient(motor)
    return (loss[middle & (rate < 0)].mean() - loss[middle & (rate > 0)].mean()) / 2


def test_a_seed_is_a_rig_and_a_take_is_a_day():
    first_take, same, later = (cable_drive.record(5, ALL, "steps", take=take) for take in (0, 0, 1))
    assert first_take.samples.equals(same.samples) and first_take.truth == same.truth and first_take.run == same.run
    assert not first_take.samples.jaw_deg.equals(later.samples.jaw_deg)
    other = cable_drive.record(6, ALL, "steps")
    elsewhere = cable_drive.record(5, ALL, "sine-0.2")
    assert later.truth["parameters"] == elsewhere.truth["parameters"] == first_take.truth["parameters"]
    assert other.truth["parameters"] != first_take.truth["parameters"]
    for name in ("axial_elasticity", "backlash", "sensor_lag", "creep", "x_kink"):
        shapes = [recording.truth["effects"][name]["parameters"] for recording in (first_take, elsewhere, other)]
        assert shapes[0] == shapes[1] != shapes[2], name


def test_without_effects_the_cable_is_rigid_and_its_gear_within_tolerance():
    gears = []
    for seed in range(30):
        recording = cable_drive.record(seed, {}, "steps", noise="none")
        gears.append(recording.truth["parameters"]["gear_ratio"])
        np.testing.assert_allclose(recording.samples.jaw_deg, gears[-1] * recording.samples.motor_deg, atol=1e-12)
    assert np.ptp(gears) > 0.05 and np.max(np.abs(np.array(gears) / 0.9 - 1.0)) <= 1.5 * 0.05


@cache
def whole():
    """A recording with every effect, which tests leave alone."""
    return cable_drive.record(2, ALL, "loads-0.3")


@pytest.mark.long
@pytest.mark.parametrize("name", ALL)
def test_an_effect_that_is_off_is_absent_and_moves_nothing_else(name):
    every = whole()
    without = cable_drive.record(2, {other: size for other, size in ALL.items() if other != name}, "loads-0.3")
    none = cable_drive.record(2, {**ALL, name: 0.0}, "loads-0.3")
    assert none.samples.equals(without.samples) and none.truth["effects"][name]["rms"] == 0.0
    assert name not in without.truth["effects"]
    took = every.hidden.jaw_deg - without.hidden.jaw_deg
    assert rms(took) == pytest.approx(every.truth["effects"][name]["rms"], rel=1e-9) and rms(took) > 0.02
    assert every.samples[["motor_deg", "torque_nm"]].equals(without.samples[["motor_deg", "torque_nm"]])
    noise = every.samples.jaw_deg - every.hidden.jaw_deg, without.samples.jaw_deg - without.hidden.jaw_deg
    assert np.max(np.abs(noise[0] - noise[1])) <= cable_drive.JAW_QUANTUM_DEG + 1e-9
    assert every.truth["effects"][name]["mechanism"] == (name if name != "x_kink" else None)


@pytest.mark.parametrize("seed", SEEDS)
def test_effects_have_the_size_that_is_declared(seed):
    recording, loss = part(seed, "friction_hysteresis", 1.5, loads_nm=[0.03])
    assert sliding(recording, loss) == pytest.approx(1.5, rel=0.12)
    recording, stretch = part(seed, "axial_elasticity", 30.0, "swing-0.3", loads_nm=[0.02, 0.06])
    full = np.abs(recording.hidden.torque_nm - 0.05) < 5e-4
    assert stretch[full].mean() / -0.05 == pytest.approx(30.0, rel=0.06)
    recording, loss = part(seed, "backlash", 0.8)
    assert np.ptp(loss) / recording.truth["parameters"]["gear_ratio"] == pytest.approx(0.8, rel=0.1)
    recording, behind = part(seed, "sensor_lag", 0.02)
    rate = np.gradient(recording.hidden.motor_deg * recording.truth["parameters"]["gear_ratio"], 1e-3)
    assert -np.dot(behind, rate) / np.dot(rate, rate) == pytest.approx(0.02, rel=0.05)
    for name, size in (("sensor_drift", 0.4), ("sensor_offset", -0.7), ("clamp_slip", 0.5), ("x_kink", 0.6)):
        _, moved = part(seed, name, size)
        got = {"sensor_drift": moved[-1], "sensor_offset": moved.mean(), "clamp_slip": -moved[-1]}
        assert got.get(name, moved.max()) == pytest.approx(size, rel=0.08), name
    assert cable_parts.crept(np.full(20_001, 0.05), 1e-3, 1.1)[-1] == pytest.approx(1.0, rel=1e-3)


@pytest.mark.parametrize("seed", SEEDS)
def test_friction_takes_work_in_every_cycle_and_more_under_more_tension(seed):
    heights = []
    for load_nm in (0.01, 0.025, 0.05):
        recording, lost = part(seed, "friction_hysteresis", 1.5, "sine-0.4", loads_nm=[load_nm])
        motor = recording.hidden.motor_deg.to_numpy()
        for start in range(300, 17_000, 2500):
            cycle = slice(start, start + 2501)
            assert -np.trapezoid(lost[cycle], motor[cycle]) > 1.2 * 60 * 0.5 * sliding(recording, lost)
        heights.append(sliding(recording, lost))
    assert heights[0] * 1.1 < heights[1] and heights[1] * 1.3 < heights[2]


def test_a_reversal_is_forgotten_over_some_degrees_and_not_at_once():
    recording, lost = part(1, "friction_hysteresis", 1.5, "sine-0.1", loads_nm=[0.03])
    motor, back = recording.hidden.motor_deg.to_numpy(), slice(5300, 10_200)  # the first way back
    gone = (lost[back] - lost[back][0]) / np.ptp(lost[back])
    travelled = motor[back][0] - motor[back]
    half, most = (travelled[np.argmax(gone > share)] for share in (0.5, 0.9))
    assert 0.5 < half < 5.0 and 3 * half < most < 30.0


def test_tension_builds_up_along_the_pulleys_and_a_slack_strand_stays_a_strand():
    capstans = Capstans.drawn(stream(3, "capstans"))
    tight, loose = capstans.strands(np.array([0.0, 0.03, 0.5]))
    np.testing.assert_allclose(tight - loose, [0.0, 0.03, 0.5])
    assert tight[0] == loose[0] and (loose > 0).all() and (np.diff(loose) < 0).all()
    assert capstans.sliding_nm(0.03, 1.0) > 0 > capstans.sliding_nm(0.03, -1.0)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_stretch_is_nothing_at_no_torque_odd_and_no_straight_line(seed):
    shape = cable_drive._drawn(seed, ("any", 0), "axial_elasticity")
    torque = np.linspace(-0.06, 0.06, 121)
    stretch = cable_parts.stretch_shape(torque, **shape)
    assert cable_parts.stretch_shape(np.zeros(1), **shape)[0] == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(stretch, -stretch[::-1], atol=1e-9)
    assert (np.diff(stretch) > 0).all()
    slope = np.gradient(stretch, torque)
    assert slope[60] > 1.3 * slope[-10]  # it stiffens with the tension


def test_the_play_keeps_its_width_whatever_the_load_and_grips_before_its_end():
    widths = [np.ptp(part(1, "backlash", 0.8, loads_nm=[load_nm])[1]) for load_nm in (0.01, 0.05)]
    assert widths[0] == widths[1]
    motor = np.concatenate([np.linspace(0, 5, 5001), np.linspace(5, 0, 5001)])
    lost = cable_parts.play_lost(motor, 1.0, 0.1)
    assert lost[5000] == pytest.approx(0.5, abs=0.01) and lost[-1] == pytest.approx(-0.5, abs=0.01)
    moving = np.gradient(lost, motor[1] - motor[0])[5001:]
    assert ((moving < -0.05) & (moving > -0.95)).sum() > 20


def test_encoders_count_and_noise_is_what_was_drawn():
    for noise, low, high in (("usual", 0.03, 0.1), ("trap", 0.06, 0.3)):
        recording = cable_drive.record(7, ALL, "loads-0.2", noise=noise)
        for column, quantum in (("motor_deg", 360 / 8192), ("jaw_deg", 0.09), ("torque_nm", 3.9811e-5)):
            counts = recording.samples[column] / quantum
            np.testing.assert_allclose(counts, np.rint(counts), atol=1e-6)
        noise_deg = (recording.samples.jaw_deg - recording.hidden.jaw_deg).to_numpy()
        drawn = recording.truth["noise"]["jaw_deg"]
        assert low <= drawn <= high and rms(noise_deg) == pytest.approx(np.hypot(drawn, 0.09 / 12**0.5), rel=0.15)
        assert np.corrcoef(noise_deg[:-50], noise_deg[50:])[0, 1] > (0.3 if noise == "trap" else 0.02)


def test_a_strength_wanders_by_a_few_per_cent_about_one():
    wandering = [wander(stream(seed, "any"), TIME_S) for seed in range(20)]
    np.testing.assert_allclose(np.mean(wandering, axis=1), 1.0)
    by = np.std(wandering, axis=1)
    assert by.min() > 0.01 and by.max() < 0.04 and np.ptp(by) > 0.015


@pytest.mark.parametrize("plan", PLANS)
def test_a_run_folder_holds_the_recording_and_no_truth(plan, tmp_path):
    recording = cable_drive.record(11, ALL, plan)
    parse_run(recording.run, tmp_path / recording.run["run"] / "run.yaml")
    folder = write_run(recording, tmp_path / "cable-1")
    assert sorted(path.name for path in folder.iterdir()) == ["recording.parquet", "run.yaml"]
    assert not any(name in (folder / "run.yaml").read_text() for name in ALL)
    run, samples = read_samples(folder)
    assert run.rig == {"gear_ratio": 0.9} and run.tolerance == {"gear_ratio": 0.05}
    assert samples.equals(recording.samples) and len(samples) == 20_000


def test_what_is_not_known_is_refused():
    for arguments in (({"magic": 1.0}, "steps"), ({"sensor_lag": -0.1}, "steps"), ({}, "waltz"), ({}, "sine-9")):
        with pytest.raises(ValueError, match=r"known|positive"):
            cable_drive.record(1, *arguments)
    with pytest.raises(ValueError, match="noise"):
        cable_drive.record(1, noise="loud")
