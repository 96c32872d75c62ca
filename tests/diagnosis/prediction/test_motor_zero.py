"""The motor's zero is another in each run that names no string: found in runs together, and on a first stroke after."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest

from pipeline.diagnosis.prediction.errors_to_compare import ToCompare
from pipeline.diagnosis.prediction.simulation import read_diagnosis
from pipeline.diagnosis.words.foretold import recorded_error
from pipeline.real.asked_recording import About
from pipeline.string.from_raw import read

TURNS = 0.1  # by which the motor counts from elsewhere, two tolerances


@pytest.fixture(scope="module")
def runs(conceal, remembered, tmp_path_factory) -> tuple[Path, Path, Path]:
    """A run, the same one after the motor was switched off and on, and the diagnosis of the first."""
    first, root = conceal("creep")[0], tmp_path_factory.mktemp("raw")
    later = root / "later"
    shutil.copytree(first, later)
    (later / "run.yaml").write_text((first / "run.yaml").read_text().replace(first.name, "later"))
    samples = pd.read_parquet(later / "recording.parquet")
    samples.assign(motor_turns=samples["motor_turns"] + TURNS).to_parquet(later / "recording.parquet")
    with remembered():
        done = programs.run("pipeline.diagnose", first, "--out", root / "out")
    assert done.returncode == 0, done.stderr
    return first, later, root / "out" / first.name / "diagnosis.json"


def simulated(folder: Path, diagnosis: Path, out: Path, *words: object) -> tuple[float, str]:
    """The rms by which `simulate` misses a recording, in mm, about the zero of all; and what it says."""
    done = programs.run("pipeline.simulate", folder, "--simulation", diagnosis, *words, "--out", out)
    assert done.returncode == 0, done.stderr
    residual = pd.read_parquet(folder / "recording.parquet")["displacement_mm"] - pd.read_csv(out)["displacement_mm"]
    return float(residual.std()), " ".join(done.stdout.split())


@pytest.mark.long
def test_a_plan_for_another_run_gets_the_commands_that_predict_it(runs, tmp_path):
    _, later, diagnosis = runs
    words = "--simulation", diagnosis, "--home", "--motion", "plan.csv", "--out", tmp_path / "a.csv"
    done = programs.run("pipeline.simulate", later, *words)
    assert done.returncode == 2
    assert f"pipeline.diagnose {later} --out DIR" in done.stderr
    assert f"pipeline.simulate {later} --simulation DIR/later/diagnosis.json --motion plan.csv --out" in done.stderr


@pytest.mark.long
def test_of_the_same_string_both_runs_are_to_be_diagnosed_together_and_the_row_is_named(runs, tmp_path):
    first, later, diagnosis = runs
    for run in (first, later):
        shutil.copytree(run, tmp_path / run.name)
        text = (run / "run.yaml").read_text()
        assert "string:" in text
        (tmp_path / run.name / "run.yaml").write_text(re.sub(r"(?m)^string:\n", "string:\n  id: spool-1\n", text))
    _, printed = simulated(tmp_path / "later", diagnosis, tmp_path / "a.csv")
    assert re.search(
        r"the error if the whole recording sets the zero, [0-9.]+ mm, is [0-9.]+ times what was to", printed
    )
    assert f"later is of the same string as {first.name} (string.id)" in printed
    both = f"pipeline.diagnose {tmp_path / first.name} {tmp_path / 'later'} --together --out DIR"
    assert f"Else diagnose both together: python -m {both}" in printed
    with open(tmp_path / first.name / "run.yaml", "a") as file:
        file.write("simulation: [{id: sensor_drift, parameters: {whole_s: 200.0, straight_mm: 0.1}}]\n")
    _, printed = simulated(tmp_path / "later", diagnosis, tmp_path / "a.csv")
    remove = f"python -m pipeline.adopt --remove {tmp_path / first.name}"
    assert f"Else take out first what was adopted, then diagnose both together: {remove} python -m {both}" in printed
    whole = recorded_error.means(0.2, "b", ToCompare(0.01, 0.02, ("a",)), None, "", "mm")
    assert whole[0].startswith("the error is 10 times what was to be expected (0.020 mm)")


@pytest.mark.long
def test_asked_about_another_run_the_motor_is_homed_on_its_first_stroke(runs, tmp_path):
    first, later, diagnosis = runs
    best, _ = simulated(first, diagnosis, tmp_path / "own.csv")
    astray, printed = simulated(later, diagnosis, tmp_path / "astray.csv")
    assert astray > 1.6 * best and "homed" not in printed
    assert "holds poorly in later. If the motor was switched off in between, its zero is another: add --home" in printed
    again, printed = simulated(later, diagnosis, tmp_path / "homed.csv", "--home")
    assert again < 1.1 * best
    assert re.search(
        rf"strokes of {first.name} that no fit had seen [0-9.]+ mm the error .*? is [0-9.]+ times what", printed
    )
    assert f"the diagnosis of {first.name} holds in later too" in printed
    before = json.loads(diagnosis.read_text())["parameters"]["angle_turns"]["value"]
    home = float(printed.partition("first stroke of the recording, is ")[2].partition(" turns")[0])
    assert home == pytest.approx(before - TURNS, abs=0.02)
    assert f"where the diagnosis has {before:.3g}" in printed and "as far as its tolerance" not in printed


@pytest.mark.long
def test_what_was_learnt_elsewhere_is_homed_before_it_is_judged_and_so_is_the_nominal_simulator(runs, tmp_path):
    first, later, diagnosis = runs

    def missed(folder, content):
        predicted, measured, _ = About(read(folder)).simulated(content, diagnosis)
        return float(np.std(measured - predicted))

    content = read_diagnosis(diagnosis)
    best, _ = simulated(first, diagnosis, tmp_path / "own.csv")
    assert missed(later, content) < 1.1 * best
    bare = {"parameters": {}, "simulation": []}
    shutil.copytree(later, tmp_path / "named")
    described = (later / "run.yaml").read_text().replace("later", "named")
    (tmp_path / "named" / "run.yaml").write_text(described.replace("string:", "string:\n  id: s-1", 1))
    assert missed(tmp_path / "named", content) > 1.4 * best, "a string that is named keeps its zero"
    assert missed(later, bare) < 0.98 * missed(tmp_path / "named", bare)


@pytest.mark.long
def test_it_reads_no_more_of_the_recording_than_the_first_stroke(runs, tmp_path):
    _, later, diagnosis = runs
    cut = Path(shutil.copytree(later, tmp_path / "later"))
    samples = pd.read_parquet(cut / "recording.parquet")
    half = samples.index > len(samples) // 2
    samples["displacement_mm"] = samples["displacement_mm"].where(~half, 3.0)
    samples.to_parquet(cut / "recording.parquet")
    for folder, name in ((later, "whole.csv"), (cut, "cut.csv")):
        simulated(folder, diagnosis, tmp_path / name, "--home")
    whole, half_only = (pd.read_csv(tmp_path / name)["displacement_mm"] for name in ("whole.csv", "cut.csv"))
    assert whole.to_numpy() == pytest.approx(half_only.to_numpy(), abs=1e-9)


@pytest.mark.long
def test_a_diagnosis_of_another_string_is_taken_with_a_warning_that_says_how_it_differs(runs, tmp_path):
    first, later, diagnosis = runs
    other = Path(shutil.copytree(later, tmp_path / "raw" / "later"))
    described = (other / "run.yaml").read_text()
    radius = float(described.partition("radius_mm: ")[2].split()[0])
    changed = described.replace(f"radius_mm: {radius}", f"radius_mm: {2.0 * radius}").replace(
        "string:", "string:\n  id: b"
    )
    (other / "run.yaml").write_text(changed)
    own = Path(shutil.copytree(first, tmp_path / "raw" / first.name))
    (own / "run.yaml").write_text((own / "run.yaml").read_text().replace("string:", "string:\n  id: a"))
    words = ("--simulation", diagnosis, "--out", tmp_path / "out.csv")
    warned = programs.run("pipeline.simulate", other, *words).stderr
    assert f"warning: later is of another string than {first.name}" in warned
    assert f"it names the string b, and {first.name} a" in warned
    run_radius_mm, diagnosed_radius_mm = re.search(
        r"its run.yaml has radius ([0-9.]+) mm \(([0-9.]+) there\)", warned
    ).groups()
    assert (float(run_radius_mm), float(diagnosed_radius_mm)) == pytest.approx((2.0 * radius, radius), rel=1e-4)
    assert "another string" not in programs.run("pipeline.simulate", later, *words).stderr


@pytest.mark.long
def test_a_zero_that_lies_beyond_its_tolerance_is_said_to(runs, tmp_path):
    _, later, diagnosis = runs
    far = Path(shutil.copytree(later, tmp_path / "later"))
    samples = pd.read_parquet(far / "recording.parquet")
    samples.assign(motor_turns=samples["motor_turns"] + 0.3).to_parquet(far / "recording.parquet")
    _, printed = simulated(far, diagnosis, tmp_path / "far.csv", "--home")
    assert "as far as its tolerance lets it: give angle_turns a wider one" in printed


@pytest.mark.long
def test_where_nothing_is_to_be_homed_it_is_refused_with_the_mend(runs, tmp_path):
    first, later, diagnosis = runs
    out = ("--out", tmp_path / "out.csv")
    for words, says in (
        ((first, "--simulation", diagnosis), "is one that the diagnosis was made of: all of it holds there"),
        ((later, "--simulation", diagnosis, "--motion", tmp_path / "plan.csv"), "goes without --motion"),
    ):
        done = programs.run("pipeline.simulate", *words, "--home", *out)
        assert done.returncode == 2 and says in done.stderr and not (tmp_path / "out.csv").exists()


@pytest.mark.long
def test_runs_that_are_learnt_together_have_each_a_zero_of_their_own(runs, tmp_path):
    first, later, _ = runs
    earlier = tmp_path / "earlier"  # no clock tells which run was first, but the names do
    shutil.copytree(first, earlier)
    (earlier / "run.yaml").write_text((first / "run.yaml").read_text().replace(first.name, earlier.name))
    done = programs.run("pipeline.diagnose", earlier, later, "--together", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    content = json.loads((tmp_path / "out" / "diagnosis.json").read_text())
    own = content["parameters"]["angle_turns_2"]
    assert own["low"] <= -TURNS <= own["high"] and own["value"] == pytest.approx(-TURNS, abs=0.02)
    diagnosis, errors = tmp_path / "out" / "diagnosis.json", []
    for folder in (earlier, later):
        errors.append(simulated(folder, diagnosis, tmp_path / "more.csv")[0])
    assert errors[1] == pytest.approx(errors[0], rel=0.1), "both are simulated with their own zero"
