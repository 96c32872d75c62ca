"""docs/use_a_model.md says what the programs do: which model answers, which cannot be exported, what none knows."""

from pathlib import Path

import programs

from pipeline.export.interface import names
from pipeline.ground.model_names import USUAL, WHOLE_MOTION

PAGE = " ".join((Path(__file__).parents[2] / "docs" / "use_a_model.md").read_text().split())


def test_the_page_leaves_the_model_to_take_to_the_job_and_says_which_cannot_be_exported():
    """It called the spline the one to export where the job said to take another."""
    assert "the one to export, as a rule" not in PAGE and "Take the model that the job names" in PAGE
    assert WHOLE_MOTION not in names()
    _, _, why = PAGE.partition(f"**`{WHOLE_MOTION}` cannot be exported.**")
    assert "it answers along a whole motion, and a controller asks single points." in why
    assert "Simulate with it on a computer (`python -m pipeline.simulate`" in why


def test_the_page_says_which_model_answers_and_that_a_model_knows_no_time():
    assert f"the usual one, `{USUAL}`, fitted anew to all points. Another answers by `--model NAME`" in PAGE
    predict = " ".join(programs.run("pipeline.predict", "--help").stdout.split())
    assert f"default: {USUAL}" in predict and "--model MODEL" in predict
    assert "A model knows no time." in PAGE
    assert "names creep or drift, ask `python -m pipeline.simulate` with `--motion`" in PAGE
