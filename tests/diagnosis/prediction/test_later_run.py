"""The second run of a joint diagnosis is simulated after the first: its creep does not begin anew."""

import json
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest

from pipeline.diagnosis.prediction.simulation import state_of
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.own_rate import at_own_rate
from pipeline.run.samples import read_strokes

ZERO_MM = 0.25


@pytest.fixture(scope="module")
def joint(conceal, remembered, tmp_path_factory) -> tuple[Path, Path, Path]:
    """Two runs of one motion in one folder, and a diagnosis that was made of both."""
    root, recorded = tmp_path_factory.mktemp("raw"), conceal("creep")[0]
    with remembered():
        done = programs.run("pipeline.diagnose", recorded, "--out", root / "out")
    assert done.returncode == 0, done.stderr
    folders = [root / "raw" / name for name in ("one-1", "one-2")]
    for folder in folders:
        shutil.copytree(recorded, folder)
        (folder / "run.yaml").write_text((recorded / "run.yaml").read_text().replace(recorded.name, folder.name))
    content = json.loads((root / "out" / recorded.name / "diagnosis.json").read_text())
    content["run"] = [folder.name for folder in folders]
    content["parameters"] |= {"zero_2_mm": {"value": ZERO_MM}}
    diagnosis = root / "diagnosis.json"
    diagnosis.write_text(json.dumps(content))
    return folders[0], folders[1], diagnosis


def simulate(folder, diagnosis, out, *words):
    """What `simulate` gives for a run, in mm, and what it says."""
    done = programs.run("pipeline.simulate", folder, "--simulation", diagnosis, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    return pd.read_csv(out)["displacement_mm"].to_numpy(), " ".join(done.stdout.split())


def test_it_is_what_the_joint_simulator_gives_with_the_zero_that_was_fitted(joint, tmp_path):
    first, later, diagnosis = joint
    problem = at_own_rate([RecordedRun(*read_strokes(folder)) for folder in (first, later)], thin=False)
    state = state_of(json.loads(diagnosis.read_text()), problem, diagnosis, later.name)
    whole = problem.simulate(state) + ZERO_MM
    given, said = simulate(later, diagnosis, tmp_path / "later.csv")
    assert given == pytest.approx(whole[problem.record.run_index == 1], abs=1e-6)
    assert "it is simulated after one-1, as they were diagnosed together" in said and "as it was fitted" in said
    alone, said = simulate(first, diagnosis, tmp_path / "first.csv")
    assert "simulated after" not in said and "beware" not in said
    assert float(np.std(given - alone)) > 0.01, "the same motion again creeps less"


def test_a_plan_after_its_recording_goes_after_the_run_before_too(joint, tmp_path):
    _, later, diagnosis = joint
    plan = tmp_path / "plan.csv"
    plan.write_text("time_s,motor_turns,load_n\n0,0,20\n5,3,20\n10,0,20\n")
    both, said = simulate(later, diagnosis, tmp_path / "both.csv", "--motion", plan, "--after-recording")
    assert "it is simulated after one-1" in said
    _, said = simulate(later, diagnosis, tmp_path / "alone.csv", "--motion", plan)
    assert f"beware: {diagnosis} was made of one-1 and one-2 together, and here one-1 does not go before" in said
    assert np.isfinite(both).all()


def test_where_the_run_before_does_not_lie_beside_it_that_is_said(joint, tmp_path):
    _, later, diagnosis = joint
    alone = tmp_path / "raw" / later.name
    shutil.copytree(later, alone)
    _, said = simulate(alone, diagnosis, tmp_path / "alone.csv")
    assert "begins anew, so the reading may be far off. Mend: keep the runs in one folder" in said
    assert "set in the first second" in said


def test_adopting_it_says_that_alone_it_begins_anew(joint):
    first, later, diagnosis = joint
    later = Path(shutil.copytree(later, later.parents[1] / "adopting" / later.name))
    done = programs.run("pipeline.adopt", diagnosis, later)
    said = " ".join(done.stdout.split())
    assert done.returncode == 0, done.stderr
    assert "There one-2 goes after one-1; alone, what goes on over time or strokes begins anew in it" in said
    alone = Path(shutil.copytree(first, first.parents[1] / "adopting" / first.name))
    assert "goes after" not in programs.run("pipeline.adopt", diagnosis, alone).stdout
