"""Two runs of one string under two loads, in one diagnosis: creep is named, whatever the string did between them."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml

from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.run.samples import read_strokes

LENGTH_MM, RADIUS_MM, STIFFNESS_N_PER_MM, LOADS_N = 300.0, 0.4, 30.0, (10.0, 30.0)
TAU_S, COMPLIANCE_MM_PER_N = 90.0, 0.03  # of the hidden creep; the time lies between two of the library's
NOISE_MM, STEP_S, STROKES, TOP_TURNS = 0.02, 0.02, 8, 22.0


def recorded(folder: Path, keeps: bool) -> list[RecordedRun]:
    """Both runs, of a string that was rested before the second one, or `keeps` what it had crept; by Euler's steps."""
    rng, strain_mm, runs = np.random.default_rng(2), 0.0, []
    corners_s = 2.0 + 40.0 * np.arange(STROKES)[:, None] + np.array([0.0, 14.0, 20.0, 34.0])
    time_s = np.arange(0.0, 40.0 * STROKES, STEP_S)
    turns = np.interp(time_s, corners_s.ravel(), np.tile([0.0, TOP_TURNS, TOP_TURNS, 0.0], STROKES))
    for number, load_n in enumerate(LOADS_N):
        name, strain_mm, crept = f"two-{number + 1}", strain_mm if keeps else 0.0, []
        for _ in time_s:
            strain_mm += (COMPLIANCE_MM_PER_N * load_n - strain_mm) * STEP_S / TAU_S
            crept.append(strain_mm)
        loaded_mm = LENGTH_MM + load_n / STIFFNESS_N_PER_MM
        drawn_mm = loaded_mm - np.sqrt(loaded_mm**2 - (2.0 * np.pi * 1.02 * RADIUS_MM * turns) ** 2)
        reading = drawn_mm - np.array(crept) + rng.normal(0.0, NOISE_MM, len(time_s))
        table = pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": reading - reading[0]})
        string = {"material": "Z", "radius_mm": RADIUS_MM, "length_mm": LENGTH_MM, "id": "s-1"}
        string |= {"stiffness_n_per_mm": STIFFNESS_N_PER_MM, "strokes_before": number * STROKES}
        content = {"run": name, "actuator": "twisted_pair", "string": string, "rig": {"load_n": load_n}}
        (folder / name).mkdir()
        table.to_parquet(folder / name / "recording.parquet")
        (folder / name / "run.yaml").write_text(yaml.safe_dump(content))
        runs.append(RecordedRun(*read_strokes(folder / name)))
    return runs


@pytest.mark.long
@pytest.mark.parametrize("keeps", [False, True])
def test_creep_under_two_loads_is_named_and_foretells_unseen_strokes(tmp_path, keeps) -> None:
    content, _ = diagnosed(recorded(tmp_path, keeps))
    assert content["verdict"] == "explained" and [entry["id"] for entry in content["mechanisms"]] == ["creep"]
    assert content["fit"]["heldout"]["explained_mm"] < 1.3 * content["fit"]["noise_floor_mm"]
