"""Another run takes of a diagnosis what holds on its first stroke: all, a part, or the motor's zero alone."""

import json
from pathlib import Path

import programs
import pytest
from test_home import runs, simulated  # noqa: F401  the fixture

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


def test_all_of_a_diagnosis_that_holds_is_taken_and_nothing_is_said(runs, tmp_path):  # noqa: F811
    _, later, diagnosis = runs
    _, printed = simulated(later, diagnosis, tmp_path / "homed.csv", "--home")
    assert "this run takes" not in printed and f"the dimensions of {diagnosis}" in printed


@pytest.mark.long
@pytest.mark.parametrize(
    ("spoiled", "kept", "words"),
    [
        ((True, False), ("simulation",), "the dimensions, without the effects"),
        ((True, True), ("simulation", "parameters"), "nothing but the motor's zero"),
    ],
)
def test_what_fails_on_the_first_stroke_is_left_out_and_that_is_said(runs, tmp_path, spoiled, kept, words):  # noqa: F811
    _, later, diagnosis = runs
    wrong = changed(diagnosis, tmp_path / "wrong.json", *spoiled)
    error, printed = simulated(later, wrong, tmp_path / "wrong.csv", "--home")
    assert f"of the diagnosis this run takes {words}" in printed and "simulated with no mechanism" in printed
    assert "likely explanations" not in printed
    assert (f"the dimensions of {later / 'run.yaml'}" in printed) == ("parameters" in kept)
    part, _ = simulated(later, without(diagnosis, tmp_path / "part.json", *kept), tmp_path / "part.csv", "--home")
    assert error == pytest.approx(part, rel=0.02)


def test_effects_alone_are_taken_where_the_dimensions_fail(runs, tmp_path):  # noqa: F811
    _, later, diagnosis = runs
    wrong = changed(diagnosis, tmp_path / "wrong.json", effects=False, dimensions=True)
    _, printed = simulated(later, wrong, tmp_path / "wrong.csv", "--home")
    assert "this run takes the effects, with the dimensions of run.yaml" in printed
    assert f"simulated with creep and the dimensions of {later / 'run.yaml'}" in printed


@pytest.mark.long
def test_what_a_black_box_learnt_beside_all_of_it_is_not_added_to_a_part(runs, tmp_path):  # noqa: F811
    _, later, diagnosis = runs
    wrong, out = changed(diagnosis, tmp_path / "wrong.json", effects=True, dimensions=True), tmp_path / "more.csv"
    words = ("--simulation", wrong, "--home", "--residual", "--out", out)
    done = programs.run("pipeline.simulate", later, *words)
    assert done.returncode == 2 and "was learnt beside all of the diagnosis" in done.stderr and not out.exists()
