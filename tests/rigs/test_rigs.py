"""Each rig of docs/rigs.md, recorded by another hand: what its simulator leaves out is named, and nothing else is."""

import json
from dataclasses import replace
from pathlib import Path

import benches
import pytest
from scipy.io import savemat

import pipeline
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem
from pipeline.foreign.imported import import_run
from pipeline.run.samples import read_strokes

NOTHING = ("consistent", "parameters")


def written(samples, file):
    """The file with a recording in it."""
    samples.to_csv(file, index=False)
    return file


def one_name(content, id_):
    """Parameters of the one mechanism that a verdict names."""
    assert content["verdict"] == "explained"
    (only,) = content["mechanisms"]
    assert only["id"] == id_
    return only["parameters"]


def named(content):
    """What a verdict names, by id."""
    return {mechanism["id"]: mechanism for mechanism in content["mechanisms"]}


def own(content):
    """What a verdict names of mechanisms whose ids begin with `x_`, by id."""
    assert content["verdict"] == "unknown"
    return {mechanism["id"]: mechanism for mechanism in content["of_your_own"]["mechanisms"]}


def held_out(content):
    """Errors on the last strokes: nominal, calibrated, explained."""
    return [value for key, value in content["fit"]["heldout"].items() if key != "split"]


SMALL_TANKS = {  # of the benchmark's tanks, forty times as fast
    "channels": {"time_s": {"step_s": 0.1}},
    "rig": {"pump_gain": 1.6, "upper_outflow": 1.9, "lower_outflow": 1.9},
}


@pytest.mark.long
def test_tanks_that_overflow_are_told_from_tanks_that_do_not(tmp_path, diagnosed):
    file = tmp_path / "dataBenchmark.csv"
    content = diagnosed(written(benches.tanks(1), file), "cascaded_tanks", **SMALL_TANKS)
    assert content["verdict"] in NOTHING
    content = diagnosed(written(benches.tanks(2, rim_cm=20.0), file), "cascaded_tanks", **SMALL_TANKS)
    named_mechanisms = own(content)
    assert set(named_mechanisms) == {"x_overflow"}
    assert named_mechanisms["x_overflow"]["parameters"]["rim_v"]["value"] == pytest.approx(
        20.0 / 2.5 - 13.2 / 2.5, abs=0.15
    )
    better = diagnosed(file, "cascaded_tanks", content["of_your_own"]["simulation"], **SMALL_TANKS)
    assert better["verdict"] in NOTHING
    assert held_out(better)[1] < 0.2 * held_out(content)[1]


@pytest.mark.long
def test_tanks_with_a_sample_every_four_seconds_are_diagnosed_like_faster_ones(tmp_path, diagnosed):
    file = tmp_path / "dataBenchmark.csv"
    benches.tanks(2, rim_cm=20.0).to_csv(file, index=False)  # told of as if it had run forty times as slowly
    rig = {name: value / 40.0 for name, value in SMALL_TANKS["rig"].items()}
    content = diagnosed(file, "cascaded_tanks", channels={"time_s": {"step_s": 4.0}}, rig=rig)
    assert set(own(content)) == {"x_overflow"}


SLOW_CIRCUIT = {  # a resonance at 30 Hz in place of the Silverbox's
    "file": {"rows": [0, 4000]},
    "rig": {"inertia_s2": 2.9e-5, "damping_s": 6.0e-4},
}


@pytest.mark.long
def test_a_circuit_whose_spring_is_cubic_is_told_from_a_straight_one(tmp_path, diagnosed):
    file = tmp_path / "SNLS80mV.mat"
    samples = benches.oscillator(1)
    savemat(file, {name: samples[name].to_numpy()[None] for name in samples})
    content = diagnosed(file, "silverbox", **SLOW_CIRCUIT)
    assert content["verdict"] in NOTHING
    samples = benches.oscillator(2, hardening=4.0)
    savemat(file, {name: samples[name].to_numpy()[None] for name in samples})
    content = diagnosed(file, "silverbox", **SLOW_CIRCUIT)
    named_mechanisms = own(content)
    assert set(named_mechanisms) == {"x_cubic_spring"}
    assert named_mechanisms["x_cubic_spring"]["parameters"]["cubic_v_per_v3"]["value"] == pytest.approx(
        4.0 / 0.97, rel=0.05
    )
    better = diagnosed(file, "silverbox", content["of_your_own"]["simulation"], **SLOW_CIRCUIT)
    assert better["verdict"] in NOTHING
    assert held_out(better)[1] < 0.2 * held_out(content)[1]


@pytest.mark.long
def test_a_servo_that_rubs_is_told_from_one_that_does_not(tmp_path, diagnosed):
    file = tmp_path / "2024-03-01_12h00m00.json"
    file.write_text(json.dumps(benches.servo(1)))
    content = diagnosed(file, "servo_pendulum")
    assert content["verdict"] in NOTHING
    assert content["parameters"]["weight_v"]["value"] == pytest.approx(0.49 * 9.81 * 0.2 * 2.1 / 1.63, rel=0.03)
    file.write_text(json.dumps(benches.servo(2, rubs_nm=0.5)))
    content = diagnosed(file, "servo_pendulum")
    rubs = one_name(content, "friction_hysteresis")
    assert rubs["half_loop_rad"]["value"] == pytest.approx(0.5 * 2.1 / 1.63 / 75.84, rel=0.1)
    assert held_out(content)[2] < 0.3 * held_out(content)[1]


@pytest.mark.long
def test_an_axis_whose_bearing_rubs_and_drags_is_told_from_a_free_one(tmp_path, diagnosed):
    file = tmp_path / "axis.csv"
    content = diagnosed(written(benches.axis(1), file), "robot_axis")
    assert content["verdict"] in NOTHING
    assert content["parameters"]["inertia_kg_m2"]["value"] == pytest.approx(31.5, rel=0.01)
    content = diagnosed(written(benches.axis(2, coulomb_nm=12.0, viscous_nm_s=6.0), file), "robot_axis")
    named_mechanisms = named(content)
    assert content["verdict"] == "ambiguous" and set(named_mechanisms) == {"friction_hysteresis", "viscous_loss"}
    assert named_mechanisms["friction_hysteresis"]["parameters"]["half_loop_nm"]["value"] == pytest.approx(
        12.0, rel=0.05
    )
    assert named_mechanisms["viscous_loss"]["parameters"]["straight_nm_per_rad_s"]["value"] == pytest.approx(
        6.0, rel=0.1
    )
    assert held_out(content)[2] < 0.1 * held_out(content)[1]


@pytest.mark.long
def test_an_axis_that_sticks_where_it_creeps_is_told_from_one_that_slides_at_each_speed(tmp_path, diagnosed):
    file = tmp_path / "axis.csv"
    content = diagnosed(written(benches.creeping_axis(3, coulomb_nm=12.0), file), "robot_axis")
    assert one_name(content, "friction_hysteresis")["half_loop_nm"]["value"] == pytest.approx(12.0, rel=0.05)
    content = diagnosed(written(benches.creeping_axis(3, coulomb_nm=12.0, sticks_nm=8.0), file), "robot_axis")
    named_mechanisms = named(content)
    assert content["verdict"] == "explained" and set(named_mechanisms) == {"friction_hysteresis", "x_stribeck"}
    assert named_mechanisms["friction_hysteresis"]["parameters"]["half_loop_nm"]["value"] == pytest.approx(
        12.0, rel=0.05
    )
    sticks = named_mechanisms["x_stribeck"]["parameters"]
    assert 4.0 < sticks["more_nm"]["value"] < 9.0 and 0.02 < sticks["falls_rad_per_s"]["value"] < 0.2
    assert "Friction is higher where the " in named_mechanisms["x_stribeck"]["sentence"]


def test_a_recording_that_never_creeps_cannot_show_what_sticks(tmp_path):
    mapping, shown = Path(pipeline.__file__).parent / "mappings" / "robot_axis.yaml", {}
    for name, samples in (("swings", benches.axis(1)), ("creeps", benches.creeping_axis(1, coulomb_nm=12.0))):
        import_run(written(samples, tmp_path / f"{name}.csv"), mapping, name, tmp_path / "raw")
        drivers = make_problem([RecordedRun(*read_strokes(tmp_path / "raw" / name))]).drivers
        shown[name] = mechanisms()["x_stribeck"].candidates(drivers)
    assert shown["swings"] == [] and shown["creeps"]
    assert not mechanisms()["x_stribeck"].candidates(replace(drivers, levered=True)), "of a string it is never asked"


@pytest.mark.long
def test_a_tendon_that_grips_its_sheath_is_told_from_a_free_one(tmp_path, diagnosed):
    file = tmp_path / "tendon.csv"
    content = diagnosed(written(benches.sheath(1), file), "tendon_sheath")
    assert content["verdict"] in NOTHING
    assert content["parameters"]["pulley_radius_mm"]["value"] == pytest.approx(12.3, rel=0.01)
    content = diagnosed(written(benches.sheath(2, grips_mm=2.5), file), "tendon_sheath")
    assert content["verdict"] == "explained" and "friction_hysteresis" in named(content)
    assert held_out(content)[2] < 0.2 * held_out(content)[1]


@pytest.mark.long
def test_a_cylinder_whose_seal_grips_the_more_the_higher_the_pressure_is_told_from_a_free_one(tmp_path, diagnosed):
    file = tmp_path / "cylinder.csv"
    content = diagnosed(written(benches.cylinder(1), file), "pneumatic_cylinder")
    assert content["verdict"] in NOTHING
    assert content["parameters"]["bore_mm"]["value"] == pytest.approx(25.1, rel=0.001)
    content = diagnosed(written(benches.cylinder(2, seal_n=6.0, seal_n_per_bar=4.0), file), "pneumatic_cylinder")
    seal = one_name(content, "friction_hysteresis")
    assert seal["half_loop_n_per_1_bar"]["value"] == pytest.approx(4.0, rel=0.1)
    assert held_out(content)[2] < 0.1 * held_out(content)[1]
