"""The strength of an effect that wanders."""

import numpy as np
import pytest

from pipeline.ground.kinematics import Geometry
from pipeline.rig import effects
from pipeline.rig.string_state import String

GEOMETRY = Geometry(
    "separator", radius_mm=0.5, separator_mm=8.0, torsion_zone_mm=150.0, length_mm=400.0, stiffness_n_per_mm=15.0
)
STEP_S = 0.01
TURNS = 15.0 * (1.0 - np.cos(np.arange(4000) * STEP_S / 5.0))
LOAD_N = np.full(4000, 20.0)
WAVES = {"shares": [0.1, 0.2], "periods_s": [7.0, 13.0], "phases_rad": [0.3, 1.1]}


def reading(name, stretches=1, **parameters):
    string = String(GEOMETRY, [effects.make(name, parameters)] if name else [], STEP_S)
    parts = zip(np.array_split(TURNS, stretches), np.array_split(LOAD_N, stretches), strict=True)
    return np.concatenate([string.pull(*part) for part in parts])


def strength():
    time_s = np.arange(len(TURNS)) * STEP_S
    return 1.0 + 0.1 * np.sin(2 * np.pi * time_s / 7.0 + 0.3) + 0.2 * np.sin(2 * np.pi * time_s / 13.0 + 1.1)


def test_what_an_effect_does_wanders_and_its_equations_know_nothing_of_it():
    drift = {"mm_per_hour": 100.0}
    bare, steady, unsteady = (
        reading(""),
        reading("sensor_drift", **drift),
        reading("sensor_drift", **drift, unsteady=WAVES),
    )
    np.testing.assert_allclose(unsteady - bare, (steady - bare) * strength(), rtol=1e-9, atol=1e-12)


def test_a_factor_wanders_about_one():
    packed = {"bed_mpa": 50.0, "exponent": 1.5}
    still = {"shares": [0.0], "periods_s": [7.0], "phases_rad": [0.0]}
    np.testing.assert_allclose(
        reading("radius_compaction", **packed, unsteady=still), reading("radius_compaction", **packed)
    )


def test_it_wanders_on_from_stretch_to_stretch():
    lag = {"lag_s": 0.1, "unsteady": WAVES}
    np.testing.assert_allclose(reading("sensor_lag", stretches=5, **lag), reading("sensor_lag", **lag))


def test_waves_are_told_whole():
    with pytest.raises(ValueError, match="one value for each wave"):
        effects.make("sensor_lag", {"lag_s": 0.1, "unsteady": {"shares": [0.1], "periods_s": [], "phases_rad": [0.0]}})
