"""Each rig of docs/rigs.md, recorded by another hand: what its simulator leaves out is named, and nothing else is."""

import benches
import pytest
from scipy.io import savemat

NOTHING = ("consistent", "parameters")


def named(content):
    """What a verdict names, by id."""
    return {one["id"]: one for one in content["mechanisms"]}


def own(content):
    """What a verdict names of mechanisms that the contract does not list, by id."""
    assert content["verdict"] == "unknown"
    return {one["id"]: one for one in content["of_your_own"]["mechanisms"]}


def held_out(content):
    """Errors on the last strokes: nominal, calibrated, explained."""
    return [value for key, value in content["fit"]["heldout"].items() if key != "split"]


SMALL_TANKS = {  # of the benchmark's tanks, forty times as fast
    "channels": {"time_s": {"step_s": 0.1}},
    "rig": {"pump_gain": 1.6, "upper_outflow": 1.9, "lower_outflow": 1.9},
}


def test_tanks_that_overflow_are_told_from_tanks_that_do_not(tmp_path, diagnosed):
    file = tmp_path / "dataBenchmark.csv"
    benches.tanks(1).to_csv(file, index=False)
    content = diagnosed(file, "cascaded_tanks", **SMALL_TANKS)
    assert content["verdict"] in NOTHING
    benches.tanks(2, rim_cm=20.0).to_csv(file, index=False)
    content = diagnosed(file, "cascaded_tanks", **SMALL_TANKS)
    found = own(content)
    assert set(found) == {"x_overflow"}
    assert found["x_overflow"]["parameters"]["rim_v"]["value"] == pytest.approx(20.0 / 2.5 - 13.2 / 2.5, abs=0.15)
    better = diagnosed(file, "cascaded_tanks", content["of_your_own"]["simulation"], **SMALL_TANKS)
    assert better["verdict"] in NOTHING
    assert held_out(better)[1] < 0.2 * held_out(content)[1]


SLOW_CIRCUIT = {  # a resonance at 30 Hz in place of the Silverbox's
    "file": {"rows": [0, 4000]},
    "rig": {"inertia_s2": 2.9e-5, "damping_s": 6.0e-4},
}


def test_a_circuit_whose_spring_is_cubic_is_told_from_a_straight_one(tmp_path, diagnosed):
    file = tmp_path / "SNLS80mV.mat"
    samples = benches.oscillator(1)
    savemat(file, {name: samples[name].to_numpy()[None] for name in samples})
    content = diagnosed(file, "silverbox", **SLOW_CIRCUIT)
    assert content["verdict"] in NOTHING
    samples = benches.oscillator(2, hardening=4.0)
    savemat(file, {name: samples[name].to_numpy()[None] for name in samples})
    content = diagnosed(file, "silverbox", **SLOW_CIRCUIT)
    found = own(content)
    assert set(found) == {"x_cubic_spring"}
    assert found["x_cubic_spring"]["parameters"]["cubic_v_per_v3"]["value"] == pytest.approx(4.0 / 0.97, rel=0.05)
    better = diagnosed(file, "silverbox", content["of_your_own"]["simulation"], **SLOW_CIRCUIT)
    assert better["verdict"] in NOTHING
    assert held_out(better)[1] < 0.2 * held_out(content)[1]
