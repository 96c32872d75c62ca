"""docs/use_a_model.md says what the programs do: which model answers, which cannot be exported, what none knows."""

import re
import shlex
import subprocess
from pathlib import Path

import pandas as pd
import programs
from models.made_dataset import made_dataset

from pipeline.export.interface import names
from pipeline.ground.kinematics import usual_stiffness
from pipeline.ground.model_names import USUAL
from pipeline.ground.stored import schemas
from pipeline.models.interface import names_with_motion

PAGE = " ".join((Path(__file__).parents[2] / "docs" / "use_a_model.md").read_text().split())


def test_the_page_leaves_the_model_to_take_to_the_job_and_says_which_cannot_be_exported():
    """It called the spline the one to export where the job said to take another."""
    assert "the one to export, as a rule" not in PAGE and "Take the model that the job names" in PAGE
    (with_motion,) = names_with_motion()
    assert with_motion not in names()
    _, _, why = PAGE.partition(f"**`{with_motion}` cannot be exported.**")
    assert "it answers along a whole motion, and a controller asks single points." in why
    assert "Simulate with it on a computer (`python -m pipeline.simulate`" in why


def test_the_page_says_which_model_answers_and_that_a_model_knows_no_time():
    assert f"the usual one, `{USUAL}`, fitted anew to all points. Another answers by `--model NAME`" in PAGE
    predict = " ".join(programs.run("pipeline.predict", "--help").stdout.split())
    assert f"default: {USUAL}" in predict and "--model MODEL" in predict
    assert "A model knows no time." in PAGE
    assert "names creep or drift, ask `python -m pipeline.simulate` with `--motion`" in PAGE


def test_the_questions_about_a_new_string_are_answered_as_the_page_says(tmp_path):
    """Nothing said how to ask about a string that nobody recorded, nor which of its sizes may be left out."""
    page = (Path(__file__).parents[2] / "docs" / "use_a_model.md").read_text()
    _, _, section = page.partition("### A string that nobody recorded")
    written, ask_command = re.search(r"```sh\n(.*)\n(.*)\n```", section).groups()
    points = made_dataset(60, 6)
    strings = [
        points.assign(string=name, radius_mm=radius_mm, stiffness_n_per_mm=usual_stiffness(radius_mm, 400.0))
        for name, radius_mm in (("A", 0.4), ("B", 0.5))
    ]
    varied = pd.concat(strings, ignore_index=True)
    varied.loc[varied["stroke"] % 2 == 0, "load_n"] = 30.0
    dataset = tmp_path / "processed" / "nylon" / "dataset.parquet"
    dataset.parent.mkdir(parents=True)
    schemas.write(varied, schemas.DATASET, dataset)
    subprocess.run(["sh", "-c", written], cwd=tmp_path, check=True)
    _, _, module, *words = shlex.split(ask_command.replace("<material>", "nylon"))
    done = programs.run(module, *words, "--model", "polynomial", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    answers = pd.read_csv(tmp_path / words[-1])
    assert answers["displacement_mm"].notna().all() and not answers["inside"].any()
    assert answers["displacement_mm_low"].isna().all() and answers["why"].str.contains("its stiffness is assumed").all()
    questions = pd.read_csv(tmp_path / "new_string.csv")
    for more in (questions.assign(stiffness_n_per_mm=""), questions.drop(columns="string")):
        more.to_csv(tmp_path / "new_string.csv", index=False)
        assert programs.run(module, *words, "--model", "polynomial", cwd=tmp_path).returncode == 0
        assert pd.read_csv(tmp_path / words[-1])["displacement_mm"].tolist() == answers["displacement_mm"].tolist()
