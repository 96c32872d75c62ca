"""Between recorded loads an interval of `predict` holds what it says: it was as narrow as under a recorded load."""

import re
import shlex
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
import yaml
from made_dataset import TOP_TURNS, made_dataset
from made_recording import content

from pipeline.ground.kinematics import point_contraction_mm
from pipeline.ground.stored import schemas
from pipeline.models.parts.questions.bad_rows import numbered

ASKED_N = 20.0


def under_loads(loads_n: tuple[float, ...], strokes: int) -> pd.DataFrame:
    """Strokes under loads in turn; what a load adds is curved, and none of the models' own form."""
    points = made_dataset(60, strokes)
    points["load_n"] = np.take(loads_n, (points["stroke"].to_numpy() - 1) % len(loads_n))
    given_mm = 1.5 * np.sqrt(points["load_n"] / 40.0) * (1.0 + points["motor_turns"] / TOP_TURNS)
    return points.assign(displacement_mm=points["displacement_mm"] - given_mm)


def asked_between(
    folder: Path, loads_n: tuple[float, ...], given_column: str = "motor_turns"
) -> tuple[pd.DataFrame, str]:
    """Answers of the program about the strokes under 20 N, which it never saw, with what was measured."""
    points = under_loads(loads_n, 12)
    truth = points[points["load_n"] == ASKED_N].iloc[::5].reset_index(drop=True)
    dataset, questions, answers = folder / "dataset.parquet", folder / "questions.csv", folder / "answers.csv"
    schemas.write(points[points["load_n"] != ASKED_N].reset_index(drop=True), schemas.DATASET, dataset)
    truth[["stroke", "direction", given_column, "load_n"]].to_csv(questions, index=False)
    done = programs.run("pipeline.predict", dataset, questions, "--out", answers, "--model", "polynomial")
    assert done.returncode == 0, done.stderr
    wanted = {"motor_turns": "displacement_mm", "displacement_mm": "motor_turns"}[given_column]
    table = pd.read_csv(answers)
    return table.assign(
        held=truth[wanted].between(table[f"{wanted}_low"], table[f"{wanted}_high"]),
        half=(table[f"{wanted}_high"] - table[f"{wanted}_low"]) / 2.0,
    ), done.stdout


@pytest.mark.parametrize("given_column", ["motor_turns", "displacement_mm"])
@pytest.mark.parametrize(
    ("loads_n", "why"),
    [
        ((8.0, ASKED_N, 40.0), "the interval reaches over the answers at both"),
        ((8.0, ASKED_N, 32.0, 45.0), "the interval is as wide as the errors at 1 recorded value left out whole"),
        ((8.0, ASKED_N, 28.0, 36.0, 44.0), "the interval is as wide as the errors at 2 recorded values left out whole"),
    ],
    ids=["two", "three", "four"],
)
def test_a_load_that_was_held_out_lies_in_the_intervals(
    tmp_path: Path, loads_n: tuple[float, ...], why: str, given_column: str
) -> None:
    table, out = asked_between(tmp_path, loads_n, given_column)
    inside = table["inside"]
    assert inside.mean() > 0.9 and table["held"][inside].mean() >= 0.9
    sentence = f"no load between 8 and {loads_n[2]:g} N was recorded, so no error was measured there; {why}"
    assert (table["why"][inside] == sentence).all()
    assert f"  {numbered((1 + np.flatnonzero(inside)).tolist())}: {sentence}" in out


def test_an_unrecorded_load_is_said_to_be_so_with_the_command_that_asks_the_equations(tmp_path: Path) -> None:
    """Each load had strokes of its own: 50 N was answered with 52 mm, and nothing said what to do."""
    points = made_dataset(60, 12)
    points["load_n"] = np.where(points["stroke"] <= 6, 8.0, 40.0)
    points["displacement_mm"] = point_contraction_mm(points) + np.random.default_rng(0).normal(0.0, 0.03, len(points))
    dataset, questions, answers = (tmp_path / name for name in ("dataset.parquet", "my questions.csv", "answers.csv"))
    schemas.write(points, schemas.DATASET, dataset)
    questions.write_text("stroke,direction,motor_turns,load_n\n4,3,12,20\n4,1,12,20\n2,1,12,20\n9,1,12,60\n")
    words = [dataset, questions, "--out", answers, "--seed", "1"]
    done = programs.run("pipeline.predict", *words, "--model", "polynomial")
    note = "the string was not recorded under this load, and the numbers of polynomial may be far off."
    thinner = "The equations know of a load that it makes the string thinner, and they know no stretch."
    compare = f"{thinner} To compare, what the equations answer:"
    line = re.search(rf"Rows 2 to 4: {re.escape(note)} {re.escape(compare)}\n  (.*)\n", done.stdout)[1]
    typed = shlex.split(line)
    compared = ["--out", tmp_path / "answers-calibrated.csv", dataset, questions, "--seed", "1"]
    assert typed == ["python", "-m", "pipeline.predict", "--model", "calibrated", *map(str, compared)]
    again = programs.run(*typed[2:])
    assert "by the calibrated model, fitted anew to " in again.stdout and "may be far off" not in again.stdout, again
    questioned = points.iloc[[0, 0]].assign(motor_turns=12.0, load_n=[20.0, 60.0], direction=1)
    answered_mm = pd.read_csv(tmp_path / "answers-calibrated.csv")["displacement_mm"][2:].to_numpy()
    assert answered_mm == pytest.approx(point_contraction_mm(questioned), abs=0.1)
    questions.write_text("stroke,direction,motor_turns,load_n\n2,1,12,40\n12,1,12,8\n8,1,12,8\n7,1,12,8\n14,1,12,40\n")
    done = programs.run("pipeline.predict", *words, "--model", "polynomial")
    note = note.replace("load,", "load in such a stroke,")
    assert f"Rows 1 to 3: {note} {compare}\n  {line}\n" in done.stdout, done.stdout
    recorded = tmp_path / "recorded.csv"
    recorded.write_text("stroke,direction,motor_turns,load_n\n4,1,12,8\n9,1,12,40\n9,1,90,40\n")
    done = programs.run("pipeline.predict", dataset, recorded, "--out", answers, "--model", "polynomial")
    assert done.returncode == 0 and "1 of them without" in done.stdout and "may be far off" not in done.stdout


def test_beside_the_equations_stands_how_they_err_and_what_knows_a_stretch(tmp_path: Path) -> None:
    """60 N of a string that stretches: the screen sent to the equations, which erred twice as far as the model."""
    points = made_dataset(60, 12).assign(run="made-1", string="reel")
    points["load_n"] = np.where(points["stroke"] <= 6, 8.0, 40.0)
    dataset, questions = tmp_path / "processed" / "UHMWPE" / "dataset.parquet", tmp_path / "questions.csv"
    schemas.write(points, schemas.DATASET, dataset)
    questions.write_text("stroke,direction,motor_turns,load_n\n4,1,12,60\n")
    words = [dataset, questions, "--out", tmp_path / "answers.csv", "--model", "polynomial"]
    command = "python -m pipeline.simulate {} --motion PLAN.csv --out FILE.csv\n"
    done = programs.run("pipeline.predict", *words)
    stretch = "A stretch that a diagnosis has named is known to the simulator"
    assert f"\n{stretch}, once it is adopted: {command.format('RUN')}" in done.stdout, done.stderr
    assert "held-out" not in done.stdout, "no page tells errors"
    models_csv = tmp_path / "reports" / "UHMWPE" / "models.csv"
    models_csv.parent.mkdir(parents=True)
    lines = [f"{name},within,forward,all,{error}" for name, error in (("polynomial", 0.0434), ("calibrated", 0.81))]
    models_csv.write_text("\n".join(["model,split,map,column,median", *lines, ""]))
    folder = tmp_path / "raw" / "made-1"
    folder.mkdir(parents=True)
    adopted = [{"effects": ["creep"], "verdict": "explained"}]
    (folder / "run.yaml").write_text(yaml.safe_dump(content("made-1", adopted=adopted)))
    done = programs.run("pipeline.predict", *words)
    errs = "on held-out points, under recorded loads, polynomial errs by 0.043 mm, calibrated by 0.81 mm."
    thinner = "The equations know of a load that it makes the string thinner, and they know no stretch"
    assert f"may be far off. {thinner}; {errs} To compare, what the equations answer:\n" in done.stdout, done.stderr
    assert f"\n{stretch}: {command.format(folder)}" in done.stdout
    done = programs.run("pipeline.predict", *words[:-1], "calibrated")
    assert "simulate" not in done.stdout and "thinner" not in done.stdout


def test_of_a_twisted_pair_nobody_is_sent_to_its_equation_which_knows_no_load(tmp_path: Path) -> None:
    """50 N was answered by 9.37 mm as 15 N was, by the command that the screen had given."""
    points = made_dataset(60, 12).assign(actuator="twisted_pair", torsion_zone_mm=np.nan, separator_mm=np.nan)
    points["load_n"] = np.where(points["stroke"] <= 6, 8.0, 40.0)
    points["displacement_mm"] = point_contraction_mm(points) + np.random.default_rng(0).normal(0.0, 0.03, len(points))
    dataset, questions, answers = (tmp_path / name for name in ("dataset.parquet", "questions.csv", "answers.csv"))
    schemas.write(points, schemas.DATASET, dataset)
    questions.write_text("stroke,direction,motor_turns,load_n\n2,1,4,8\n9,1,4,60\n")
    for model in ("polynomial", "calibrated"):
        done = programs.run("pipeline.predict", dataset, questions, "--out", answers, "--model", model)
        assert done.returncode == 0, done.stderr
        note = f"Row 2: the string was not recorded under this load, and the numbers of {model} may be far off."
        assert f"{note} The equation of a twisted pair knows no load: record the string under it." in done.stdout
        assert "what the equations answer" not in done.stdout


def test_under_a_recorded_load_the_interval_stays_as_narrow(tmp_path: Path) -> None:
    dataset, questions, answers = (tmp_path / name for name in ("dataset.parquet", "questions.csv", "answers.csv"))
    schemas.write(under_loads((8.0, 28.0, 40.0), 12), schemas.DATASET, dataset)
    questions.write_text("stroke,direction,motor_turns,load_n\n4,1,12,28\n4,1,12,18\n4,1,12,8\n")
    done = programs.run("pipeline.predict", dataset, questions, "--out", answers, "--model", "polynomial")
    assert done.returncode == 0, done.stderr
    table = pd.read_csv(answers)
    half = (table["displacement_mm_high"] - table["displacement_mm_low"]) / 2.0
    assert half[0] == pytest.approx(half[2]) and half[1] > 1.3 * half[0] and half[0] < 0.1
