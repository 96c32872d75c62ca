"""The moving mass that is made: Newton holds, friction takes power, and effects are as large as declared."""

import numpy as np
import pytest
from scipy.signal import butter, sosfiltfilt

from pipeline.rig.others import moving_mass
from pipeline.rig.others.made import write_run
from pipeline.rig.others.mass_plan import PLANS, STEP_S, told
from pipeline.run.description import parse_run
from pipeline.run.samples import read_samples
from pipeline.run.strokes import segment

ALL = {
    "viscous_loss": 200.0,
    "friction_hysteresis": 20.0,
    "sensor_offset": -3.0,
    "sensor_drift": 2.0,
    "sensor_lag": 0.004,
    "eccentricity": 3.0,
    "rail_friction": 8.0,
    "x_push": 6.0,
}
SEEDS = range(3)


def smooth(values):
    return sosfiltfilt(butter(4, 30.0, fs=1 / STEP_S, output="sos"), values)[300:-300]


def motion(recording):
    """Filtered acceleration, speed and force, as one who has the recording alone would take them."""
    speed = np.gradient(recording.samples.position_m.to_numpy(), STEP_S)
    return smooth(np.gradient(speed, STEP_S)), smooth(speed), smooth(recording.samples.force_n.to_numpy())


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def test_a_seed_is_a_rig_and_a_take_is_a_day():
    first, same, later = (moving_mass.record(5, ALL, take=take) for take in (0, 0, 1))
    assert first.samples.equals(same.samples) and first.truth == same.truth
    assert not first.samples.force_n.equals(later.samples.force_n)
    elsewhere, other = moving_mass.record(5, ALL, "speeds"), moving_mass.record(6, ALL)
    assert first.truth["parameters"] == later.truth["parameters"] == elsewhere.truth["parameters"]
    assert first.truth["parameters"] != other.truth["parameters"]
    for name in ("viscous_loss", "friction_hysteresis", "rail_friction", "eccentricity", "sensor_lag"):
        shapes = [recording.truth["effects"][name]["parameters"] for recording in (first, elsewhere, other)]
        assert shapes[0] == shapes[1] != shapes[2], name


@pytest.mark.parametrize("plan", PLANS)
def test_least_squares_finds_the_mass_where_nothing_is_hidden(plan):
    for seed in SEEDS:
        recording = moving_mass.record(seed, {}, plan, noise="none")
        acceleration, _, force = motion(recording)
        mass = np.dot(acceleration, force) / np.dot(acceleration, acceleration)
        assert mass == pytest.approx(recording.truth["parameters"]["mass_kg"], rel=0.002)
        assert rms(force - mass * acceleration) < 0.005 * rms(force)
        assert abs(recording.truth["parameters"]["mass_kg"] / 100.0 - 1.0) <= 0.15


@pytest.mark.parametrize("plan", PLANS)
def test_newton_holds_with_every_effect(plan):
    recording = moving_mass.record(3, ALL, plan)
    against = sum(recording.hidden[name] for name in ALL if name != "sensor_lag")
    pulled = recording.truth["parameters"]["mass_kg"] * recording.hidden.acceleration_m_per_s2
    np.testing.assert_allclose(recording.hidden.force_n, pulled + against, atol=1e-9)
    speed = np.gradient(recording.hidden.position_m, STEP_S)
    assert rms(speed - recording.hidden.speed_m_per_s) < 1e-3 * rms(speed)


@pytest.mark.parametrize("name", ALL)
def test_an_effect_that_is_off_is_absent(name):
    without = moving_mass.record(2, {other: size for other, size in ALL.items() if other != name})
    none = moving_mass.record(2, {**ALL, name: 0.0})
    assert none.samples.equals(without.samples) and none.truth["effects"][name]["rms"] == 0.0
    assert name not in without.hidden and name not in without.truth["effects"]
    every = moving_mass.record(2, ALL)
    assert every.truth["effects"][name]["rms"] > 0.5
    assert every.truth["effects"][name]["rms"] == rms(every.hidden[name])
    mechanisms = {"rail_friction": "friction_hysteresis", "x_push": None}
    assert every.truth["effects"][name]["mechanism"] == mechanisms.get(name, name)


@pytest.mark.parametrize("seed", SEEDS)
def test_effects_have_the_size_that_is_declared(seed):
    hidden = moving_mass.record(seed, ALL, "speeds", noise="none").hidden
    speed, position = hidden.speed_m_per_s.to_numpy(), hidden.position_m.to_numpy()
    tenth = np.abs(np.abs(speed) - 0.1) < 0.01
    assert np.median(hidden.viscous_loss[tenth] / speed[tenth]) == pytest.approx(200.0, rel=0.06)
    quick = np.abs(speed) > 0.05
    assert np.median(np.abs(hidden.friction_hysteresis[quick])) == pytest.approx(20.0, rel=0.06)
    assert hidden.sensor_offset.mean() == pytest.approx(-3.0)
    assert hidden.sensor_drift.iloc[-1] == pytest.approx(2.0, rel=0.1)
    assert 2.0 < hidden.rail_friction[position > 0.24].abs().max() < 9.0
    assert hidden.rail_friction[position < 0.02].abs().max() < 1.0
    assert rms(hidden.eccentricity[quick]) == pytest.approx(3.0 / 2**0.5, rel=0.1)
    assert 0.65 * 6.0 < hidden.x_push.abs().max() < 2.1 * 1.3 * 6.0


def test_a_late_encoder_is_late_by_what_is_declared():
    recording = moving_mass.record(4, {"sensor_lag": 0.005}, noise="none")
    behind = recording.samples.position_m - recording.hidden.position_m
    speed = recording.hidden.speed_m_per_s
    assert -np.dot(behind, speed) / np.dot(speed, speed) == pytest.approx(0.005, rel=0.02)
    acceleration, _, force = motion(recording)
    late = force - recording.truth["parameters"]["mass_kg"] * acceleration
    assert rms(late) == pytest.approx(recording.truth["effects"]["sensor_lag"]["rms"], rel=0.1)


@pytest.mark.parametrize("plan", PLANS)
def test_friction_takes_power_and_gives_back_no_more_than_its_bristles_hold(plan):
    hidden = moving_mass.record(1, ALL, plan).hidden
    speed = hidden.speed_m_per_s.to_numpy()
    assert (hidden.viscous_loss * speed >= 0).all()
    for name, size in (("friction_hysteresis", 20.0), ("rail_friction", 8.0)):
        work = np.cumsum(hidden[name].to_numpy() * speed) * STEP_S
        back = np.max(np.maximum.accumulate(work) - work)
        assert work[-1] > 0.05 * size and back < 1.5e-4 * size, name  # in J; bristles bend by less than 0.1 mm


def test_friction_rises_smoothly_out_of_a_stand():
    recording = moving_mass.record(0, {"friction_hysteresis": 20.0}, noise="none")
    hidden, reach_m = recording.hidden, recording.truth["effects"]["friction_hysteresis"]["parameters"]["bristle_m"]
    begun = int(np.argmax(hidden.position_m > 0.3 * reach_m))
    later = int(np.argmax(hidden.position_m > 5.0 * reach_m))
    assert hidden.friction_hysteresis[begun] < 0.8 * 20.0 < 0.9 * hidden.friction_hysteresis[later]
    assert later - begun >= 2


@pytest.mark.parametrize("plan", PLANS)
def test_the_carriage_keeps_to_its_reference_and_its_strokes_are_strokes(plan):
    for seed in range(8):
        place, speed = told(plan, np.random.default_rng(seed))
        assert place.min() > -0.001 and 0.235 < place.max() < 0.251
        np.testing.assert_allclose(np.cumsum(speed) * STEP_S, place)
    recording = moving_mass.record(1, ALL, plan)
    assert recording.samples.position_m.between(-0.005, 0.26).all() and recording.samples.force_n.abs().max() < 400.0
    assert segment(recording.samples, "position_m", "made").stroke.max() >= 3


def test_the_encoder_counts_micrometres_and_noise_is_what_was_drawn():
    for noise, low, high in (("usual", 0.3, 1.0), ("trap", 1.0, 4.0)):
        recording = moving_mass.record(7, ALL, noise=noise)
        for column, quantum in (("position_m", 1e-6), ("force_n", moving_mass.FORCE_QUANTUM_N)):
            counts = recording.samples[column] / quantum
            np.testing.assert_allclose(counts, np.rint(counts), atol=1e-5)
        force_noise_n = (recording.samples.force_n - recording.hidden.force_n).to_numpy()
        assert low <= recording.truth["noise"]["force_n"] <= high
        assert rms(force_noise_n) == pytest.approx(recording.truth["noise"]["force_n"], rel=0.15)
        assert (np.corrcoef(force_noise_n[:-50], force_noise_n[50:])[0, 1] > 0.3) == (noise == "trap")


@pytest.mark.parametrize("plan", PLANS)
def test_a_run_folder_holds_the_recording_and_no_truth(plan, tmp_path):
    recording = moving_mass.record(11, ALL, plan)
    parse_run(recording.run, tmp_path / recording.run["run"] / "run.yaml")
    folder = write_run(recording, tmp_path / "mass-1")
    assert sorted(path.name for path in folder.iterdir()) == ["recording.parquet", "run.yaml"]
    run, samples = read_samples(folder)
    assert run.rig == {"mass_kg": 100.0} and run.tolerance == {"mass_kg": 0.1}
    assert samples.equals(recording.samples) and len(samples) == 25_000


def test_what_is_not_known_is_refused():
    for arguments in (({"magic": 1.0}, "bang"), ({"sensor_lag": -0.1}, "bang"), ({}, "waltz")):
        with pytest.raises(ValueError, match=r"known|positive"):
            moving_mass.record(1, *arguments)
