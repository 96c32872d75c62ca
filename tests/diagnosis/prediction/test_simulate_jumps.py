"""The improved simulator alone, of a force that jumps: it errs by what the diagnosis says of it."""

import json
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
import yaml

from pipeline.diagnosis.numerics import residual_band

ROOT = Path(__file__).parents[3]
EACH = 10  # samples of 1 ms that are compared as one


def recorded(folder):
    """A mass that rubs, at 1 kHz: its force jumps by 40 N within a sample wherever it turns."""
    chance = np.random.default_rng(4)
    time_s = np.arange(0.0, 16.0, 1e-3)
    speed = 0.12 * np.sin(2.0 * np.pi * 0.61 * time_s) * (1.0 + 0.4 * np.sin(0.5 * time_s))
    position = np.cumsum(speed) * 1e-3
    force = 104.0 * np.gradient(speed, time_s) + 180.0 * speed + 20.0 * np.sign(speed)
    force += 8.0 * chance.standard_normal(len(time_s))
    folder.mkdir(parents=True)
    table = pd.DataFrame({"time_s": time_s, "position_m": position, "force_n": force})
    table.to_csv(folder / "recording.csv", index=False)
    run = {"run": folder.name, "actuator": "moving_mass", "rig": {"mass_kg": 100.0}}
    (folder / "run.yaml").write_text(yaml.safe_dump(run))
    return table


def test_simulated_at_the_recordings_rate_it_errs_by_what_the_diagnosis_says(tmp_path):
    table = recorded(tmp_path / "raw/mass-01")
    diagnosis_path, out = tmp_path / "out/mass-01/diagnosis.json", tmp_path / "simulated.parquet"
    for command in (
        ["diagnose", tmp_path / "raw/mass-01", "--out", tmp_path / "out"],
        ["simulate", tmp_path / "raw/mass-01", "--simulation", diagnosis_path, "--out", out],
    ):
        done = programs.run(f"pipeline.{command[0]}", *command[1:])
        assert done.returncode == 0, done.stderr
    content = json.loads(diagnosis_path.read_text())
    assert {"friction_hysteresis", "viscous_loss"} <= {entry["id"] for entry in content["mechanisms"]}
    measured = table["force_n"].to_numpy()
    residual = measured - pd.read_parquet(out)["force_n"].to_numpy()
    assert len(residual) == len(table)
    means = [signal.reshape(-1, EACH).mean(axis=1) for signal in (residual, measured)]
    kept = [residual_band.within(signal, np.arange(len(signal)), EACH * 1e-3, 10.0) for signal in means]
    share = float(np.std(kept[0]) / np.sqrt(np.mean(kept[1] ** 2)))
    assert share == pytest.approx(content["fit"]["relative_residual"]["explained"], rel=0.05)
    whole = content["fit"]["noise_floor_n"]
    printed = float(done.stdout.split("rms error against the recording: ")[1].split()[0])
    assert printed == pytest.approx(np.sqrt(np.mean(means[0] ** 2)), rel=0.05) and printed < 2.0 * whole
