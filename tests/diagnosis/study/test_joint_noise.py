"""Two runs of one string under two loads: what a diagnosis takes for noise is the noise of the sensor."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml

from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.run.samples import read_strokes

LENGTH_MM, RADIUS_MM, STIFFNESS_N_PER_MM, ZONE_MM, SEPARATOR_MM = 380.0, 0.42, 15.0, 150.0, 8.0
LOOP_MM, WEAR_TURNS, CREEP_MM, TAU_S, AT_N = 0.5, 0.4, 0.35, 20.0, 20.0  # hidden effects, under 20 N
NOISE_MM, STEP_S, TOP_TURNS, STROKES = 0.012, 0.01, 22.0, 9


def worked(load_n: float, seed: int) -> pd.DataFrame:
    """A separator rig whose loop follows the twist with a memory and whose string creeps under its load."""
    speeds, corners = (2.0, 4.0, 1.5), [(0.0, 0.0)]
    for stroke in range(STROKES):
        speed = speeds[stroke % 3]
        for wait_s, turns in ((3.0, TOP_TURNS), (4.0, 0.0)):
            corners += [(corners[-1][0] + wait_s, corners[-1][1])]
            corners += [(corners[-1][0] + TOP_TURNS / speed, turns)]
    at_s, at_turns = np.array(corners).T
    time_s = np.arange(0.0, at_s[-1] + 3.0, STEP_S)
    turns = np.interp(time_s, at_s, at_turns)
    side, crept, readings = 0.0, 0.0, []
    radius_mm = RADIUS_MM * np.sqrt(LENGTH_MM / (LENGTH_MM + load_n / STIFFNESS_N_PER_MM))
    for step, turn in zip(np.diff(turns, prepend=0.0), turns, strict=True):
        side += (np.sign(step) - side) * (1.0 - np.exp(-abs(step) / WEAR_TURNS)) if step else 0.0
        crept += (CREEP_MM * load_n / AT_N - crept) * STEP_S / TAU_S
        across_mm = SEPARATOR_MM + 2.0 * np.pi * turn * radius_mm
        loop_mm = 0.5 * LOOP_MM * side * turn / TOP_TURNS * load_n / AT_N
        readings.append(np.hypot(ZONE_MM, across_mm) - ZONE_MM - loop_mm - crept)
    reading = np.array(readings) + np.random.default_rng(seed).normal(0.0, NOISE_MM, len(time_s))
    return pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": reading, "load_n": load_n})


def recorded(folder: Path, name: str, samples: pd.DataFrame) -> RecordedRun:
    string = {"material": "nyl", "radius_mm": RADIUS_MM, "length_mm": LENGTH_MM, "id": "A"}
    string["stiffness_n_per_mm"] = STIFFNESS_N_PER_MM
    rig = {"torsion_zone_mm": ZONE_MM, "separator_mm": SEPARATOR_MM}
    (folder / name).mkdir()
    samples.to_parquet(folder / name / "recording.parquet")
    content = {"run": name, "actuator": "separator", "string": string, "rig": rig}
    (folder / name / "run.yaml").write_text(yaml.safe_dump(content))
    return RecordedRun(*read_strokes(folder / name), folder / name)


@pytest.mark.long
def test_the_noise_of_two_runs_is_that_of_the_sensor(tmp_path) -> None:
    runs = [recorded(tmp_path, name, worked(load_n, seed)) for name, load_n, seed in (("a", 20.0, 1), ("b", 40.0, 3))]
    problem = make_problem(runs)
    averaged_mm = NOISE_MM * np.sqrt(STEP_S / problem.drivers.step_s)
    assert study(problem).noise.floor == pytest.approx(averaged_mm, rel=0.1)
