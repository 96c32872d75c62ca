"""The commands: `diagnosis.json` as the contract has it, byte for byte again; adoption; simulation alone; bad input."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]


def command(module: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", module, *map(str, arguments)], cwd=ROOT, capture_output=True, text=True, check=False
    )


@pytest.fixture(scope="module")
def diagnosed(conceal, tmp_path_factory) -> tuple[Path, dict, Path, dict]:
    """A run with creep, its truth, its diagnosis' folder and content."""
    folder, truth = conceal("creep")
    out = tmp_path_factory.mktemp("out")
    done = command("pipeline.diagnose", folder, "--out", out)
    assert done.returncode == 0, done.stderr
    here = out / folder.name
    return folder, truth, here, json.loads((here / "diagnosis.json").read_text())


def test_the_json_is_the_contracts(diagnosed) -> None:
    folder, _, here, content = diagnosed
    assert list(content) == [
        "run", "verdict", "mismatch", "mechanisms", "alternatives", "next_experiment", "parameters", "fit",
        "simulation",
    ]  # fmt: skip
    assert content["run"] == folder.name and content["verdict"] == "explained"
    assert set(content["mismatch"]) == {"rms_mm", "location", "driver"}
    assert set(content["mismatch"]["location"]) == {"motor_turns", "strokes", "phase", "share"}
    (creep,) = content["mechanisms"]
    assert set(creep) == {"id", "confidence", "rms_mm", "parameters", "location", "sentence"}
    assert creep["rms_mm"]["low"] <= creep["rms_mm"]["value"] <= creep["rms_mm"]["high"]
    assert set(content["parameters"]["radius_mm"]) == {"nominal", "value", "low", "high"}
    assert set(content["fit"]) == {"noise_floor_mm", "detectable_mm", "heldout"}
    assert (here / "diagnosis.png").stat().st_size > 10_000


def test_floor_and_held_out_error_are_the_noise(diagnosed) -> None:
    _, truth, _, content = diagnosed
    held = content["fit"]["heldout"]
    assert abs(content["fit"]["noise_floor_mm"] / truth["floor"] - 1) < 0.06
    assert held["explained_mm"] < 1.15 * truth["floor"] < held["calibrated_mm"] < held["nominal_mm"]


def test_again_is_the_same_byte_for_byte(diagnosed, tmp_path) -> None:
    folder, _, here, _ = diagnosed
    assert command("pipeline.diagnose", folder, "--out", tmp_path).returncode == 0
    assert (tmp_path / folder.name / "diagnosis.json").read_bytes() == (here / "diagnosis.json").read_bytes()


def test_simulate_alone_gives_the_error_that_the_diagnosis_claims(diagnosed, tmp_path) -> None:
    folder, truth, here, _ = diagnosed
    out = tmp_path / "simulated.parquet"
    done = command("pipeline.simulate", folder, "--simulation", here / "diagnosis.json", "--out", out)
    assert done.returncode == 0, done.stderr
    simulated, recorded = pd.read_parquet(out), pd.read_parquet(folder / "recording.parquet")
    assert list(simulated.columns) == ["time_s", "displacement_mm"]
    error = simulated["displacement_mm"].to_numpy() - recorded["displacement_mm"].to_numpy()
    assert np.sqrt(np.mean(error**2)) < 1.1 * truth["floor"]


def test_what_is_adopted_is_not_found_again(diagnosed, tmp_path) -> None:
    folder, _, _, content = diagnosed
    adopted = tmp_path / folder.name
    shutil.copytree(folder, adopted)
    described = yaml.safe_load((adopted / "run.yaml").read_text())
    described["simulation"] = content["simulation"]
    (adopted / "run.yaml").write_text(yaml.safe_dump(described))
    done = command("pipeline.diagnose", adopted, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    again = json.loads((tmp_path / "out" / folder.name / "diagnosis.json").read_text())
    assert again["verdict"] in ("consistent", "parameters")


def test_bad_input_is_named_and_the_good_run_is_written(conceal, tmp_path) -> None:
    good, _ = conceal()
    bad = tmp_path / "bad"
    shutil.copytree(good, bad)
    described = yaml.safe_load((bad / "run.yaml").read_text())
    described |= {"run": "bad", "simulation": [{"id": "crep", "parameters": {}}]}
    (bad / "run.yaml").write_text(yaml.safe_dump(described))
    done = command("pipeline.diagnose", bad, good, "--out", tmp_path / "out")
    assert done.returncode == 2 and "simulation[0].id" in done.stderr
    assert (tmp_path / "out" / good.name / "diagnosis.json").is_file()
    assert not (tmp_path / "out" / "bad").exists()
