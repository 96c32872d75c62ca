"""Where the reading of a sensor begins to count is arbitrary: a diagnosis says the same, whatever its zero."""

import numpy as np
import pandas as pd
import pytest

import pipeline as twistbench

STROKES = ((40, 6.0), (50, 3.0), (30, 6.0), (45, 10.0), (50, 5.0))  # turns, turns/s
STEP_S = 0.05
PAIR = {
    "run": "pair-1", "actuator": "twisted_pair", "rig": {"load_n": 20.0},
    "string": {"material": "dyneema", "radius_mm": 0.4, "length_mm": 300.0},
}  # fmt: skip


def rubbing_and_creeping(zero_mm: float) -> pd.DataFrame:
    """Two strings twisted about each other, with a loop and a slow branch that no simulator has."""
    turns = [0.0]
    for top, speed in STROKES:
        for start, end in ((0, top), (top, 0)):
            turns += list(np.linspace(start, end, int(top / speed / STEP_S) + 1)[1:])
            turns += [end] * int((2.0 if end else 1.0) / STEP_S)
    turns = np.array(turns)
    side, slow, lost = 0.0, 0.0, np.zeros(len(turns))
    for place, step in enumerate(np.diff(turns), start=1):
        side += step / 2.5 * (1.0 - side * np.sign(step))
        slow += STEP_S * (0.3 - slow) / 40.0
        lost[place] = 0.15 * side + slow
    contraction_mm = 300.0 - np.sqrt(300.0**2 - (2.0 * np.pi * 0.4 * turns) ** 2)
    noise_mm = np.random.default_rng(1).normal(0.0, 0.02, len(turns))
    return pd.DataFrame({
        "time_s": STEP_S * np.arange(len(turns)),
        "motor_turns": turns,
        "displacement_mm": contraction_mm - lost + noise_mm + zero_mm,
    })  # fmt: skip


@pytest.mark.long
def test_the_zero_of_a_sensor_moves_no_dimension_and_no_name():
    """A laser that read -120 mm where the string began moved the length by 6 mm, to its bound, and the gain with it."""
    diagnoses = []
    for zero_mm in (0.0, -120.0):
        content = twistbench.Diagnosis.of(twistbench.Recording.of(rubbing_and_creeping(zero_mm), PAIR)).content
        values = {name: entry["value"] for name, entry in content["parameters"].items() if not name.startswith("zero")}
        diagnoses.append((values, [entry["id"] for entry in content["mechanisms"]], content["alternatives"]))
    (first, *names), (other, *same) = diagnoses
    assert names == same
    assert abs(first["length_mm"] - 300.0) < 2.0, "its length is right"
    for name, value in first.items():
        assert abs(value - other[name]) <= 1e-3 * max(abs(value), 0.1), name
