"""The second run of a joint diagnosis is simulated after the first: its creep does not begin anew."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest

import pipeline
from pipeline.diagnosis.prediction.simulation import state_of
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.own_rate import at_own_rate
from pipeline.run.folder import read_run
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
    zero = content["parameters"].pop("zero_mm")
    content["parameters"] |= {"zero_1_mm": zero, "zero_2_mm": {"value": ZERO_MM, "nominal": 0.0}}
    for doubt in content["uncertainty"]:
        doubt["name"] = doubt["name"].replace("zero_mm", "zero_1_mm")
    diagnosis = root / "diagnosis.json"
    diagnosis.write_text(json.dumps(content))
    return folders[0], folders[1], diagnosis


def simulate(folder, diagnosis, out, *words):
    """What `simulate` gives for a run, in mm, and what it says."""
    done = programs.run("pipeline.simulate", folder, "--simulation", diagnosis, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    return pd.read_csv(out)["displacement_mm"].to_numpy(), " ".join(done.stdout.split())


@pytest.mark.long
def test_it_is_what_the_joint_simulator_gives_with_the_zero_that_was_fitted(joint, tmp_path):
    first, later, diagnosis = joint
    problem = at_own_rate([RecordedRun(*read_strokes(folder)) for folder in (first, later)], thin=False)
    state = state_of(json.loads(diagnosis.read_text()), problem, diagnosis, later.name)
    whole = problem.simulate(state) + ZERO_MM
    reading, printed = simulate(later, diagnosis, tmp_path / "later.csv")
    assert reading == pytest.approx(whole[problem.record.run_index == 1], abs=1e-6)
    assert "it is simulated after one-1, as they were diagnosed together" in printed and "as it was fitted" in printed
    alone, printed = simulate(first, diagnosis, tmp_path / "first.csv")
    assert "simulated after" not in printed and "beware" not in printed
    assert float(np.std(reading - alone)) > 0.01, "the same motion again creeps less"


@pytest.mark.long
def test_in_memory_it_is_simulated_after_the_run_before_too(joint, tmp_path):
    _, later, diagnosis = joint
    reading, _ = simulate(later, diagnosis, tmp_path / "later.csv")
    in_memory = pipeline.Recording.read(later).simulate(pipeline.Diagnosis.read(diagnosis))
    assert in_memory["displacement_mm"].to_numpy() == pytest.approx(reading, abs=1e-6)


@pytest.mark.long
def test_a_plan_after_its_recording_goes_after_the_run_before_too(joint, tmp_path):
    _, later, diagnosis = joint
    plan = tmp_path / "plan.csv"
    plan.write_text("time_s,motor_turns,load_n\n0,0,20\n5,3,20\n10,0,20\n")
    both, printed = simulate(later, diagnosis, tmp_path / "both.csv", "--motion", plan, "--after-recording")
    assert "it is simulated after one-1" in printed
    assert np.isfinite(both).all()


PLANS = "0,0,20\n8,8,20\n16,0,20\n", "0,0,20\n3,0,20\n11,8,20\n19,0,20\n"  # at once; after a rest


@pytest.mark.long
def test_a_plan_that_moves_at_once_has_the_zero_of_the_recording_of_its_run(joint, tmp_path):
    first, later, diagnosis = joint
    for folder, state in ((first, "as it was before its first stroke"), (later, "as one-1 left it, before its first")):
        answers = []
        for rows in PLANS:
            (tmp_path / "plan.csv").write_text(f"time_s,motor_turns,load_n\n{rows}")
            reading, printed = simulate(folder, diagnosis, tmp_path / "a.csv", "--motion", tmp_path / "plan.csv")
            assert f"its zero is that of the recording of {folder.name}; the string is taken to be {state}" in printed
            assert "beware: it" not in printed and "may be far off" not in printed
            answers.append(reading[-801:])
        at_once, rested = answers
        assert float(np.abs(at_once - rested).max()) < 0.08, "creep in a rest moves it by 0.07 mm"


@pytest.mark.long
def test_the_zero_of_a_run_of_several_is_adopted_with_it_and_its_plan_has_it(joint, tmp_path):
    first, later, diagnosis = joint
    (tmp_path / "plan.csv").write_text(f"time_s,motor_turns,load_n\n{PLANS[0]}")
    for folder, name in ((first, "zero_1_mm"), (later, "zero_2_mm")):
        adopting = Path(shutil.copytree(folder.parent, tmp_path / f"of-{folder.name}")) / folder.name
        reading, _ = simulate(adopting, diagnosis, tmp_path / "given.csv", "--motion", tmp_path / "plan.csv")
        assert programs.run("pipeline.adopt", diagnosis, adopting).returncode == 0
        assert f"{name}:" in (adopting / "run.yaml").read_text()
        words = "--motion", tmp_path / "plan.csv", "--out", tmp_path / "adopted.csv"
        done = programs.run("pipeline.simulate", adopting, *words)
        printed = " ".join(done.stdout.split())
        assert f"its zero is that of the recording of {folder.name};" in printed, done.stderr
        adopted = pd.read_csv(tmp_path / "adopted.csv")["displacement_mm"].to_numpy()
        assert adopted == pytest.approx(reading, abs=1e-3)


@pytest.mark.long
def test_a_zero_that_nothing_tells_is_where_the_plan_begins_and_the_band_holds_it(joint, tmp_path):
    first, _, diagnosis = joint
    (tmp_path / "plan.csv").write_text("time_s,motor_turns,load_n\n0,2,20\n8,8,20\n16,2,20\n")
    words = "--simulation", diagnosis, "--motion", tmp_path / "plan.csv", "--out", tmp_path / "a.csv"
    new = tmp_path / "new-1"
    new.mkdir()
    (new / "run.yaml").write_text((first / "run.yaml").read_text().replace(first.name, new.name))
    done = programs.run("pipeline.simulate", new, *words)
    assert "its zero is where the plan begins: displacement_mm is 0 in its first row" in " ".join(done.stdout.split())
    answer = pd.read_csv(tmp_path / "a.csv")
    assert answer["displacement_mm"][0] == 0.0 and answer["low_mm"][0] == pytest.approx(-answer["high_mm"][0])
    other = Path(shutil.copytree(first, tmp_path / "other-1"))
    (other / "run.yaml").write_text((first / "run.yaml").read_text().replace(first.name, other.name))
    done = programs.run("pipeline.simulate", other, *words)
    printed = " ".join(done.stdout.split())
    assert "its zero is that of the recording of other-1, as its first second gives it" in printed, done.stderr


@pytest.mark.long
def test_where_the_run_before_does_not_lie_beside_it_that_is_said(joint, tmp_path):
    _, later, diagnosis = joint
    alone = tmp_path / "raw" / later.name
    shutil.copytree(later, alone)
    _, printed = simulate(alone, diagnosis, tmp_path / "alone.csv")
    assert "begins anew, so the reading may be far off. Mend: keep the runs in one folder" in printed
    assert "set in the first second" in printed


@pytest.mark.long
def test_a_run_that_adopted_it_is_simulated_as_with_it_and_adopt_tells_that_error(joint, tmp_path):
    """It began anew, erred by 38 times the expected error, and adopting looked as if it made the simulator worse."""
    _, later, diagnosis = joint
    by_diagnosis, printed = simulate(later, diagnosis, tmp_path / "given.csv")
    error = re.search(r"its zero as it was fitted: ([0-9.]+ mm)", printed)[1]
    later = Path(shutil.copytree(later.parent, tmp_path / "raw")) / later.name
    done = programs.run("pipeline.adopt", diagnosis, later)
    table = " ".join(done.stdout.split())
    assert re.search(r"error of pipeline.simulate [0-9.]+ mm ([0-9.]+ mm)", table)[1] == error
    assert "In the verdict one-2 goes after one-1, and so does what is simulated now." in table
    assert "begins anew" not in table
    done = programs.run("pipeline.simulate", later, "--out", tmp_path / "adopted.csv")
    printed = " ".join(done.stdout.split())
    assert "it is simulated after one-1, as they were diagnosed together" in printed, done.stderr
    assert f"its zero as it was fitted: {error}" in printed
    adopted = pd.read_csv(tmp_path / "adopted.csv")["displacement_mm"].to_numpy()
    assert adopted == pytest.approx(by_diagnosis, abs=1e-3)


@pytest.mark.long
def test_adopting_it_says_that_alone_it_begins_anew(joint, tmp_path):
    _, later, diagnosis = joint
    later = Path(shutil.copytree(later, later.parents[1] / "adopting" / later.name))
    done = programs.run("pipeline.adopt", diagnosis, later)
    printed = " ".join(done.stdout.split())
    assert done.returncode == 0, done.stderr
    alone = programs.run("pipeline.simulate", later, "--out", tmp_path / "alone.csv")
    beware = f"beware: what {later}/run.yaml has adopted was made of one-1 and one-2 together, and here one-1 does not"
    assert beware in " ".join(alone.stdout.split())
    anew = "In the verdict one-2 goes after one-1; here it is alone, what goes on over time or strokes begins anew in "
    assert anew in printed and printed.index("same, if the whole recording sets the zero") < printed.index(anew)
    assert anew not in printed[printed.index("Those errors are of strokes that the fit has seen") :]
    assert "lacks these effects" not in printed, "no other run of the verdict lies beside it"


@pytest.mark.long
def test_adopting_it_names_the_runs_beside_it_that_lack_the_effects_until_none_does(joint, tmp_path):
    """It went into the last run alone without a word, and the next joint diagnosis was refused."""
    first, later, diagnosis = joint
    first, later = (Path(shutil.copytree(run, tmp_path / "raw" / run.name)) for run in (first, later))
    done = programs.run("pipeline.adopt", diagnosis, later)
    lacks = "The verdict is of 2 runs together, and one-1 lacks these effects. A joint diagnosis needs the same in all"
    assert lacks in " ".join(done.stdout.split()), done.stderr
    line = f"pipeline.adopt {diagnosis} {first}"
    assert line in done.stdout
    done = programs.run(*line.split())
    assert done.returncode == 0 and "lacks these effects" not in done.stdout and "goes after" not in done.stdout
    assert read_run(first).simulation == read_run(later).simulation != []
