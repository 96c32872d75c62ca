"""Another run takes of a diagnosis what holds on its first stroke: all, a part, or the motor's zero alone."""

import json
import re
from pathlib import Path

import numpy as np
import programs
import pytest
from test_motor_zero import runs, simulated  # noqa: F401  the fixture

from pipeline.diagnosis.prediction.simulation import state_of
from pipeline.diagnosis.words.foretold.home import PARTS
from pipeline.real.asked_recording import About
from pipeline.rig.others import cable_drive
from pipeline.rig.others.made import write_run
from pipeline.string.from_raw import read

SPOILED_MM = 0.05  # what a radius is off: four of its tolerances


def changed(diagnosis: Path, out: Path, effects: bool, dimensions: bool) -> Path:
    """A diagnosis whose effects act twelve times, or whose radius is wrong."""
    content = json.loads(diagnosis.read_text())
    if effects:
        content["simulation"] *= 12
    if dimensions:
        content["parameters"]["radius_mm"]["value"] += SPOILED_MM
    out.write_text(json.dumps(content))
    return out


def without(diagnosis: Path, out: Path, *fields: str) -> Path:
    """A diagnosis whose effects (`simulation`) or dimensions (`parameters`) are taken out."""
    content = json.loads(diagnosis.read_text())
    out.write_text(json.dumps(content | {name: type(content[name])() for name in fields}))
    return out


@pytest.mark.long
def test_all_of_a_diagnosis_that_holds_is_taken_and_nothing_is_said(runs, tmp_path):  # noqa: F811
    _, later, diagnosis = runs
    _, printed = simulated(later, diagnosis, tmp_path / "homed.csv", "--home")
    assert re.search(f"{PARTS[True, True]} [0-9.]+ mm taken ", printed) and "All of the diagnosis is taken" in printed
    assert f"the dimensions of {diagnosis}" in printed


@pytest.mark.long
@pytest.mark.parametrize(
    ("spoiled", "kept", "part", "why"),
    [
        ((True, False), ("simulation",), (False, True), "the effects of the diagnosis do not fit this recording"),
        ((True, True), ("simulation", "parameters"), (False, False), "neither the effects nor the dimensions"),
    ],
)
def test_what_fails_on_the_first_stroke_is_left_out_and_that_is_said(runs, tmp_path, spoiled, kept, part, why):  # noqa: F811
    _, later, diagnosis = runs
    wrong = changed(diagnosis, tmp_path / "wrong.json", *spoiled)
    error, printed = simulated(later, wrong, tmp_path / "wrong.csv", "--home")
    assert re.search(f"{PARTS[part]} [0-9.]+ mm taken ", printed) and why in printed
    assert "simulated with no mechanism" in printed
    assert ("where run.yaml has" in printed) == ("parameters" in kept), "whose zero of the motor it is beside"
    assert ("nothing of the diagnosis of" in printed) == ("parameters" in kept), "whose error it is"
    assert "likely explanations" not in printed
    assert (f"the dimensions of {later / 'run.yaml'}" in printed) == ("parameters" in kept)
    alone, _ = simulated(later, without(diagnosis, tmp_path / "part.json", *kept), tmp_path / "part.csv", "--home")
    assert error == pytest.approx(alone, rel=0.02)


@pytest.mark.long
def test_effects_alone_are_taken_where_the_dimensions_fail(runs, tmp_path):  # noqa: F811
    _, later, diagnosis = runs
    wrong = changed(diagnosis, tmp_path / "wrong.json", effects=False, dimensions=True)
    _, printed = simulated(later, wrong, tmp_path / "wrong.csv", "--home")
    assert re.search(f"{PARTS[True, False]} [0-9.]+ mm taken ", printed)
    assert "the dimensions of the diagnosis do not fit this recording, and are left out" in printed
    assert f"simulated with creep and the dimensions of {later / 'run.yaml'}" in printed


@pytest.mark.long
def test_what_a_black_box_learnt_beside_all_of_it_is_not_added_to_a_part(runs, tmp_path):  # noqa: F811
    _, later, diagnosis = runs
    wrong, out = changed(diagnosis, tmp_path / "wrong.json", effects=True, dimensions=True), tmp_path / "more.csv"
    words = ("--simulation", wrong, "--home", "--residual", "--out", out)
    done = programs.run("pipeline.simulate", later, *words)
    assert done.returncode == 2 and "was learnt beside all of the diagnosis" in done.stderr and not out.exists()


@pytest.fixture
def drive(tmp_path) -> Path:
    """A recording of a cable drive, whose motor has no zero to home."""
    recording = cable_drive.record(3)
    return write_run(recording, tmp_path / "raw" / recording.run["run"])


@pytest.mark.parametrize(
    ("half_deg", "dimensions", "taken"),
    [
        (0.02, {}, (True, True)),
        (8.0, {}, (False, True)),
        (0.02, {"gear_ratio": {"value": 1.0}}, (True, False)),
        (8.0, {"gear_ratio": {"value": 1.0}}, (False, False)),
    ],
)
def test_of_a_drive_the_part_is_taken_that_holds_on_the_first_stroke(drive, tmp_path, half_deg, dimensions, taken):
    entry = {"id": "backlash", "parameters": {"half_width_deg": half_deg, "share": 1.0}}
    content = {"run": "other", "parameters": dimensions, "simulation": [entry]}
    (tmp_path / "diagnosis.json").write_text(json.dumps(content))
    words = ("--simulation", tmp_path / "diagnosis.json", "--home", "--out", tmp_path / "out.csv")
    done = programs.run("pipeline.simulate", drive, *words)
    printed = " ".join(done.stdout.split())
    assert re.search(f"{re.escape(PARTS[taken])} [0-9.]+ deg taken", printed), done.stderr + printed
    assert "motor's zero" not in printed and "read for the choice on the first stroke" in printed
    assert ("simulated with backlash" in printed) == taken[0]
    about = About(read(drive))
    part = content | {"parameters": dimensions if taken[1] else {}, "simulation": [entry] if taken[0] else []}
    expected = about.problem.simulate(state_of(part, about.problem, tmp_path, about.run.run))
    reading = about.simulated(content, tmp_path / "diagnosis.json")[0]
    np.testing.assert_array_equal(reading, expected, "learnt elsewhere, the public drives take the same part")
