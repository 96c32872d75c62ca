"""A contraction that cannot be is not printed: its cell is empty, and the column `why` says the reason."""

from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_dataset import made_dataset, pair_dataset, words_that_ask

import pipeline as tb
from pipeline.ground.kinematics import point_contraction_mm
from pipeline.ground.stored import schemas
from pipeline.models.parts.inside.impossible import impossible

LENGTH = "no number is given: the paper's equation gives more than the string's length, 400 mm, there, which cannot be"


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("impossible") / "dataset.parquet"
    schemas.write(made_dataset(60, 6), schemas.DATASET, path)
    return path


@pytest.mark.parametrize("is_saved", [False, True], ids=["anew", "saved"])
def test_a_contraction_that_cannot_be_has_an_empty_cell_and_a_reason(dataset: Path, is_saved: bool) -> None:
    """It was printed, with a flag alone: no string of 400 mm contracts by 630."""
    questions, answers = dataset.with_name("questions.csv"), dataset.with_name("answers.csv")
    questions.write_text("stroke,direction,motor_turns,displacement_mm\n2,1,12,\n2,1,300,\n2,1,60,\n2,1,,9\n")
    words = words_that_ask(dataset, is_saved=is_saved)
    done = programs.run("pipeline.predict", dataset, questions, "--out", answers, *words)
    assert done.returncode == 0, done.stderr
    table = pd.read_csv(answers, dtype={"why": str}, keep_default_na=False, na_values={"displacement_mm": [""]})
    assert table["displacement_mm"].isna().tolist() == [False, True, False, False]
    assert table["inside"].tolist() == [True, False, False, True], "60 turns are outside, and may be: it has a number"
    assert table["why"][1].startswith("twist 300 turns is above ") and table["why"][1].endswith(LENGTH)
    assert "1 of them without a number: no string can do what the model answers" in done.stdout


def test_the_python_call_gives_no_such_number_either() -> None:
    questions = pd.DataFrame({"stroke": [2, 2], "direction": [1, 1], "motor_turns": [12.0, 300.0]})
    table = tb.answers(made_dataset(60, 6), questions, "polynomial")
    assert table["displacement_mm"].isna().tolist() == [False, True] and table["why"][1].endswith(LENGTH)


def test_the_limits_are_the_length_a_multiple_of_the_equation_and_the_recorded_stroke() -> None:
    points = made_dataset(60, 6)
    question = points[(points["motor_turns"] > 20.0) & (points["direction"] == 1)].iloc[[0]]
    most_mm = float(points["displacement_mm"].max())
    words_of = {}
    for answer_mm in (401.0, 60.0, 14.0, -most_mm / 2.0, -1.1 * most_mm, np.nan, np.inf):
        (words_of[answer_mm],) = impossible(question, np.array([answer_mm]), points)
    reasons = {answer_mm: words for answer_mm, words in words_of.items() if words}
    assert len(reasons) == 5 and not words_of[14.0] and not words_of[-most_mm / 2.0]
    assert "more than the string's length, 400 mm, which cannot be" in words_of[401.0]
    assert (
        "where the paper's equation gives 11 mm, " in words_of[60.0]
        and "a string longer than untwisted by" in words_of[-1.1 * most_mm]
    )
    most_mm = 1.5 * float(point_contraction_mm(question)[0])
    assert not impossible(question, np.array([most_mm - 0.1]), points)[0]
    assert impossible(question, np.array([most_mm + 0.1]), points)[0], (
        "a spline gave 2.5 times what is true, and it was printed"
    )
    for recorded in (points, pair_dataset(), points.assign(displacement_mm=4.0 * points["displacement_mm"])):
        words = impossible(recorded, recorded["displacement_mm"].to_numpy(), recorded)
        assert not any(words), "what was recorded can be, also where a radius was told that is half of the true one"
