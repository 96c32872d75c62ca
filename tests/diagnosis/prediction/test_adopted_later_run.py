"""A run that has adopted a joint diagnosis goes after the runs before it, where all of these lie beside it."""

import json
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_recording import content, recording

import pipeline
from pipeline.diagnosis.prediction.later_run import adopted_by
from pipeline.ground.input.strict_yaml import write_yaml
from pipeline.run.folder import read_run

CREEP = {
    "id": "creep",
    "parameters": {"fresh": 1.0, "fastest_s": 1.0, "slowest_s": 700.0, "loaded": 1.0, "twist_120_s_mm_per_10_n": 3.0},
}
RUNS = ("a-1", "a-2", "a-3")
FITTED = {  # each motor was switched off before its run
    "radius_mm": (0.4, 0.41), "angle_turns": (0.0, 0.1), "angle_turns_2": (0.0, 0.3), "angle_turns_3": (0.0, -0.2),
    "zero_1_mm": (0.0, -4.9), "zero_2_mm": (0.0, -4.2), "zero_3_mm": (0.0, -3.7),
}  # fmt: skip


def diagnosis_of(runs, place, **changes) -> Path:
    """A diagnosis of runs in which a creep is named, as a file."""
    parameters = {name: {"nominal": nominal, "value": value} for name, (nominal, value) in FITTED.items()}
    verdict = {
        "run": runs, "verdict": "explained", "mismatch": None, "mechanisms": [{"id": "creep"}], "alternatives": [],
        "fit": {"noise_floor_mm": 0.02}, "parameters": parameters, "simulation": [CREEP],
    }  # fmt: skip
    place.write_text(json.dumps(verdict | changes))
    return place


@pytest.fixture
def joint(tmp_path) -> tuple[Path, Path]:
    """A folder with three runs of one string, and the diagnosis of all of them."""
    raw = tmp_path / "raw"
    for seed, name in enumerate(RUNS):
        (raw / name).mkdir(parents=True)
        (raw / name / "run.yaml").write_text(write_yaml(content(name)))
        table = recording(2, rate_hz=10.0, top=8.0, speed=4.0, seed=seed)
        table.to_parquet(raw / name / "recording.parquet")
    return raw, diagnosis_of(list(RUNS), tmp_path / "joint.json")


def adopted(diagnosis, folder):
    """A run folder that has adopted a diagnosis, and the words of that."""
    done = programs.run("pipeline.adopt", diagnosis, folder)
    assert done.returncode == 0, done.stderr
    return " ".join(done.stdout.split())


def reading(folder, *words):
    """The simulated reading of a run, of shape (samples,) in mm, and what was said of it."""
    out = folder.parent / "out.csv"
    done = programs.run("pipeline.simulate", folder, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    return pd.read_csv(out)["displacement_mm"].to_numpy(), " ".join(done.stdout.split())


@pytest.mark.parametrize("name", RUNS)
def test_each_run_is_simulated_as_with_the_diagnosis_motor_zeros_of_the_runs_before_it_included(joint, name):
    raw, diagnosis = joint
    by_diagnosis, _ = reading(raw / name, "--simulation", diagnosis)
    adopted(diagnosis, raw / name)
    simulator, number = adopted_by(read_run(raw / name))["parameters"], RUNS.index(name) + 1
    motor = ["angle_turns", "angle_turns_2", "angle_turns_3"][:number]
    assert [simulator[each]["value"] for each in motor] == pytest.approx([FITTED[each][1] for each in motor])
    own, printed = reading(raw / name)
    assert own == pytest.approx(by_diagnosis, abs=1e-4)
    assert ("it is simulated after a-1" in printed) == (name != RUNS[0]) and "beware" not in printed
    in_memory = pipeline.Recording.read(raw / name).simulate()["displacement_mm"].to_numpy()
    assert in_memory == pytest.approx(by_diagnosis, abs=1e-4)


@pytest.mark.parametrize("after", [(), ("--after-recording",)])
def test_its_planned_motion_is_that_of_the_diagnosis_too(joint, after, tmp_path):
    raw, diagnosis = joint
    (tmp_path / "plan.csv").write_text("time_s,motor_turns,load_n\n0,0,20\n4,8,20\n8,0,20\n")
    words = "--motion", tmp_path / "plan.csv", *after
    by_diagnosis, _ = reading(raw / "a-3", "--simulation", diagnosis, *words)
    adopted(diagnosis, raw / "a-3")
    assert reading(raw / "a-3", *words)[0] == pytest.approx(by_diagnosis, abs=1e-4)


def test_where_one_of_them_is_missing_it_is_alone_and_that_is_said(joint):
    raw, diagnosis = joint
    shutil.rmtree(raw / "a-1")
    words = adopted(diagnosis, raw / "a-3")
    assert "In the verdict a-3 goes after a-1 and a-2; here it is alone, what goes on over time" in words
    _, printed = reading(raw / "a-3")
    assert f"beware: what {raw / 'a-3'}/run.yaml has adopted was made of a-1 and a-2 and a-3 together" in printed
    assert "and here a-1 and a-2 do not go before." in printed and "set in the first second" in printed
    with pytest.warns(UserWarning, match="and here a-1 and a-2 do not go before.*read this one by Recording.read"):
        pipeline.Recording.read(raw / "a-3").simulate()


def test_the_diagnosis_adopted_last_tells_what_goes_before(joint, tmp_path):
    raw, diagnosis = joint
    adopted(diagnosis, raw / "a-3")
    entries = [each.model_dump(exclude_none=True) for each in read_run(raw / "a-3").adopted]
    zero = {"parameters": {"radius_mm": {"nominal": 0.4, "value": 0.41}, "zero_mm": {"nominal": 0.0, "value": -3.6}}}
    alone = diagnosis_of("a-3", tmp_path / "alone.json", adopted=entries, **zero)
    by_diagnosis, _ = reading(raw / "a-3", "--simulation", alone)
    assert "goes after" not in adopted(alone, raw / "a-3")
    assert [each.runs for each in read_run(raw / "a-3").adopted] == [list(RUNS), ["a-3"]]
    own, printed = reading(raw / "a-3")
    assert own == pytest.approx(by_diagnosis, abs=1e-4) and "simulated after" not in printed and "beware" not in printed


def test_a_run_that_inherited_the_effects_goes_after_none(joint):
    raw, diagnosis = joint
    adopted(diagnosis, raw / "a-3")
    shutil.copytree(raw / "a-3", raw / "a-4")
    (raw / "a-4" / "run.yaml").write_text((raw / "a-3" / "run.yaml").read_text().replace("run: a-3", "run: a-4"))
    assert adopted_by(read_run(raw / "a-4"))["run"] == "a-4"
    _, printed = reading(raw / "a-4")
    assert "simulated after" not in printed and "beware" not in printed and "set in the first second" in printed


def test_a_dimension_measured_since_is_that_of_the_run_and_not_of_the_first(joint, tmp_path):
    raw, diagnosis = joint
    adopted(diagnosis, raw / "a-2")
    text = (raw / "a-2" / "run.yaml").read_text()
    (raw / "a-2" / "run.yaml").write_text(text.replace("radius_mm: 0.4\n", "radius_mm: 0.5\n", 1))
    after, printed = reading(raw / "a-2")
    assert "it is simulated after a-1" in printed
    alone, _ = reading(Path(shutil.copytree(raw / "a-2", tmp_path / "alone" / "a-2")))
    assert np.ptp(after) == pytest.approx(np.ptp(alone), rel=0.05), "with the 0.4 mm of a-1 it is two thirds of that"


@pytest.mark.parametrize("program", ["adopt", "simulate"])
def test_a_run_before_that_is_damaged_or_of_another_rig_is_named(joint, program, tmp_path):
    raw, diagnosis = joint
    words = ["pipeline.adopt", diagnosis, raw / "a-3"]
    if program == "simulate":
        adopted(diagnosis, raw / "a-3")
        words = ["pipeline.simulate", raw / "a-3", "--out", tmp_path / "a.csv"]
    text = (raw / "a-3" / "run.yaml").read_bytes()
    (raw / "a-1" / "recording.parquet").write_bytes(b"PAR1")
    done = programs.run(*words)
    assert done.returncode == 2 and f"error: {raw / 'a-1'}" in done.stderr and "Traceback" not in done.stderr
    other = {"run": "a-1", "actuator": "twisted_pair", "string": {**content("a-1")["string"], "radius_mm": 0.88}}
    (raw / "a-1" / "run.yaml").write_text(write_yaml(other))
    recording(2, rate_hz=10.0, top=8.0, speed=4.0).to_parquet(raw / "a-1" / "recording.parquet")
    done = programs.run(*words)
    assert done.returncode == 2 and f"{raw / 'a-1'}: actuator: is twisted_pair, and a-3, which was" in done.stderr
    assert (raw / "a-3" / "run.yaml").read_bytes() == text
