"""The noise that a verdict tells is no larger than the whole error beside it."""

import json

import numpy as np
import pandas as pd
import programs
import yaml


def test_the_noise_of_a_moving_mass_is_not_told_above_all_that_is_left(tmp_path):
    """White noise of 2 N at 1 kHz: the error was 0.6 times "about the least possible"."""
    folder, rng = tmp_path / "mass", np.random.default_rng(2)
    folder.mkdir()
    time_s = np.arange(12_000) / 1000.0
    position_m = 0.1 * (1.0 + 0.3 * np.sin(2.0 * np.pi * time_s / 13.0)) * np.sin(np.pi * time_s)
    force_n = 95.0 * np.gradient(np.gradient(position_m, time_s), time_s) + 2.0 * rng.standard_normal(len(time_s))
    table = pd.DataFrame({"time_s": time_s, "position_m": position_m, "force_n": force_n})
    table.to_csv(folder / "recording.csv", index=False, float_format="%.6g")
    run = {"run": "mass", "actuator": "moving_mass", "rig": {"mass_kg": 95.0}}
    (folder / "run.yaml").write_text(yaml.safe_dump(run))
    done = programs.run("pipeline.diagnose", folder, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    content = json.loads((tmp_path / "out" / "mass" / "diagnosis.json").read_text())
    evidence = content["evidence"]
    assert content["verdict"] == "consistent"
    assert evidence["floor_n"] == content["fit"]["noise_floor_n"], "both are of averages of 10 ms"
    assert 0.8 * evidence["calibrated_n"] < evidence["floor_n"] < 1.1 * evidence["calibrated_n"]
    page = (tmp_path / "out" / "mass" / "verdict.txt").read_text()
    assert " nominal: mass of run.yaml 0.95 N (1.0 times the noise) " in " ".join(page.split()), page
