"""A motion that nobody has recorded is simulated: the run's own gives what its recording gives, one stroke will do."""

import json
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
import yaml
from made_recording import recording

from pipeline.run.samples import read_samples


@pytest.fixture
def folder(conceal) -> Path:
    """A run with nothing in it but its dimensions."""
    return conceal("creep")[0]


@pytest.fixture
def diagnosis(folder: Path, tmp_path: Path) -> Path:
    """A diagnosis of the run that moves a dimension and has a zero of the reading."""
    path, radius_mm = (
        tmp_path / "diagnosis.json",
        yaml.safe_load((folder / "run.yaml").read_text())["string"]["radius_mm"],
    )
    held = {"radius_mm": {"value": 1.02 * radius_mm}, "zero_mm": {"value": 0.7}}
    path.write_text(json.dumps({"run": folder.name, "parameters": held, "simulation": []}))
    return path


def simulated(folder: Path, diagnosis: Path, out: Path, *words: object) -> programs.Done:
    done = programs.run("pipeline.simulate", folder, "--simulation", diagnosis, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    return done


def test_the_runs_own_motion_planned_gives_what_its_recording_gives(folder, diagnosis, tmp_path):
    _, samples = read_samples(folder)
    plan = tmp_path / "plan.csv"
    samples.drop(columns="displacement_mm").to_csv(plan, index=False, float_format="%.17g")
    simulated(folder, diagnosis, tmp_path / "own.parquet")
    done = simulated(folder, diagnosis, tmp_path / "planned.parquet", "--motion", plan)
    own, planned = (pd.read_parquet(tmp_path / f"{name}.parquet") for name in ("own", "planned"))
    assert np.allclose(own, planned, rtol=0.0, atol=1e-9)
    assert f"its zero is that of the recording of {folder.name}" in done.stdout and "rms error" not in done.stdout
    assert not done.stderr, "it stays inside what was recorded"
    samples.assign(motor_turns=1.5 * samples["motor_turns"], load_n=40.0).to_csv(plan, index=False)
    most = samples["motor_turns"].max()
    far = simulated(folder, diagnosis, tmp_path / "far.csv", "--motion", plan).stderr
    assert f"to {1.5 * most:.4g} (" in far and "Nothing says how well the simulator does there" in far
    assert "load_n of 40 to 40" in far and "a second (at most" in far and "a hold" not in far
    top = samples["motor_turns"].max()
    pd.DataFrame({"time_s": [0, 20, 140, 160], "motor_turns": [0, 0.9 * top, 0.9 * top, 0], "load_n": 15.0}).to_csv(
        plan, index=False
    )
    held = simulated(folder, diagnosis, tmp_path / "held.csv", "--motion", plan).stderr
    assert "it asks for a hold of 120 s (at most" in held


def test_one_stroke_will_do_and_a_name_that_ends_in_csv_is_text(folder, diagnosis, tmp_path):
    time_s = np.arange(0.0, 12.0, 0.02)
    plan = pd.DataFrame({"time_s": time_s, "motor_turns": 8.0 * np.minimum(time_s / 8.0, 1.0), "note": "x"})
    plan["load_n"] = 15.0
    plan.to_csv(tmp_path / "plan.csv", index=False)
    other = json.loads(diagnosis.read_text()) | {"run": "another"}
    diagnosis.write_text(json.dumps(other))
    done = simulated(folder, diagnosis, tmp_path / "answer.csv", "--motion", tmp_path / "plan.csv")
    assert f"{tmp_path / 'answer.csv'} holds time_s and displacement_mm" in done.stdout
    assert "its zero is the reading in the first second" in done.stdout
    answer = pd.read_csv(tmp_path / "answer.csv")
    assert list(answer) == ["time_s", "displacement_mm"] and len(answer) == len(plan)
    wound = answer["displacement_mm"].iloc[-1]
    assert wound > 1.0 and answer["displacement_mm"][time_s > 8.0].std() < 1e-6, "the motor stands, the string too"
    assert abs(answer["displacement_mm"].iloc[0]) < 0.1 * wound


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda plan: plan.drop(columns="motor_turns"), "motor_turns: there is no such column, only time_s"),
        (lambda plan: plan.assign(motor_turns=np.nan), "motor_turns: is not a number in 600 rows"),
        (lambda plan: plan.assign(motor_turns="fast"), "motor_turns: is not a number in 600 rows"),
        (lambda plan: plan[::-1], "time_s: runs backwards"),
        (lambda plan: plan[:3], "holds 3 samples"),
        (
            lambda plan: plan.drop(columns="load_n"),
            "load_n: there is no such column, and the load of run-",
        ),
    ],
)
def test_what_is_no_plan_is_refused_in_words_and_nothing_written(folder, diagnosis, tmp_path, change, says):
    time_s = np.arange(0.0, 12.0, 0.02)
    plan = pd.DataFrame({"time_s": time_s, "motor_turns": np.minimum(time_s, 8.0), "load_n": 15.0})
    change(plan).to_csv(tmp_path / "plan.csv", index=False)
    words = ["--simulation", diagnosis, "--motion", tmp_path / "plan.csv", "--out", tmp_path / "answer.csv"]
    done = programs.run("pipeline.simulate", folder, *words)
    assert done.returncode == 2 and says in done.stderr and "Mend: " in done.stderr, done.stderr
    assert not (tmp_path / "answer.csv").exists()


def test_corners_of_a_motion_are_joined_by_straight_lines(folder, diagnosis, tmp_path):
    corners = pd.DataFrame({"time_s": [0.0, 6.0, 26.0, 32.0], "motor_turns": [0.0, 8.0, 8.0, 0.0], "load_n": 15.0})
    fine = pd.DataFrame({"time_s": np.arange(0.0, 32.0001, 0.02)})
    for name in ("motor_turns", "load_n"):
        fine[name] = np.interp(fine["time_s"], corners["time_s"], corners[name])
    for name, plan in (("corners", corners), ("fine", fine)):
        plan.to_csv(tmp_path / f"{name}.csv", index=False)
        simulated(folder, diagnosis, tmp_path / f"{name}-answer.csv", "--motion", tmp_path / f"{name}.csv")
    few, many = (pd.read_csv(tmp_path / f"{name}-answer.csv") for name in ("corners", "fine"))
    at_s = np.linspace(0.0, 32.0, 50)
    answers = [np.interp(at_s, one["time_s"], one["displacement_mm"]) for one in (few, many)]
    assert np.allclose(*answers, atol=1e-3) and np.ptp(answers[0]) > 1.0


def test_a_load_that_hangs_still_need_not_be_planned(make_run, tmp_path):
    folder = make_run("still", recording(4).assign(load_n=lambda table: 20.0 + 0.1 * np.sin(table["time_s"])))
    content = {"run": "still", "parameters": {}, "simulation": []}
    (tmp_path / "diagnosis.json").write_text(json.dumps(content))
    for name, more in (("without", {}), ("with", {"load_n": 20.0})):
        pd.DataFrame({"time_s": [0.0, 5.0, 10.0], "motor_turns": [0.0, 20.0, 0.0]} | more).to_csv(
            tmp_path / f"{name}.csv", index=False
        )
        simulated(
            folder, tmp_path / "diagnosis.json", tmp_path / f"{name}-answer.csv", "--motion", tmp_path / f"{name}.csv"
        )
    without, given = (pd.read_csv(tmp_path / f"{name}-answer.csv") for name in ("without", "with"))
    assert np.allclose(without, given, atol=1e-4)
