"""A model that is older than its dataset: export and predict say it, and tell nothing of points it has not seen."""

import re
from pathlib import Path

import numpy as np
import onnx
import pandas as pd
import programs
import pytest
from models.made_dataset import made_dataset

from pipeline.ground.stored import schemas
from pipeline.ground.words.jump_notes import SET_ANEW, write_jumps
from pipeline.models.interface import make_model
from pipeline.models.parts.fitted_to import apart
from pipeline.models.parts.saved import read_bytes, write_bytes

DATASET = Path("processed/poly/dataset.parquet")
MODEL = Path("processed/poly/spline/within-0.model")
ANEW = "fit it anew: snakemake --cores 2 -- processed/poly/spline/within-0.model"
QUESTIONS = "stroke,direction,motor_turns\n3,1,9\n5,-1,14\n10,1,9\n"


def split(points: pd.DataFrame) -> pd.DataFrame:
    """Points of one string whose last quarter of the strokes is held out, as the dataset's program does."""
    is_late = points["stroke"] > 0.75 * points["stroke"].max()
    return points.assign(string="poly", later=np.where(is_late, "test", "train"))


def first_run() -> pd.DataFrame:
    """The six strokes of a run."""
    return split(made_dataset(60, 6).assign(run="poly-1"))


def both_runs() -> pd.DataFrame:
    """The same, and four strokes of a second run of the string."""
    points = made_dataset(60, 10)
    second = points[points["stroke"] > 6].assign(run="poly-2")
    return split(pd.concat([first_run(), second], ignore_index=True))


def write(points: pd.DataFrame, path: Path = DATASET) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    schemas.write(points, schemas.DATASET, path)


def run(module: str, *words: object) -> programs.Done:
    return programs.run(module, *words, cwd=Path.cwd())


def fit(model: str = "spline", *splits: str) -> None:
    for of in splits or ("within",):
        out = DATASET.with_name(model) / f"{of}-0.model"
        out.parent.mkdir(exist_ok=True)
        words = "--model", model, "--split", of, "--out-model", out
        done = run("pipeline.stages.train", DATASET, *words, "--out-predictions", out.with_suffix(".parquet"))
        assert done.returncode == 0, done.stderr


def export(*words: object, file: Path = MODEL) -> tuple[str, str]:
    """The header's first comment as one line, and the screen."""
    done = run("pipeline.export", file, "--format", "c", "--out", "out/", *words)
    assert done.returncode == 0, done.stderr
    text = next(Path("out").glob("tsa.h")).read_text()
    return " ".join(text.partition("*/")[0].replace("\n *", " ").split()), done.stdout


def ask(text: str = QUESTIONS, file: Path = MODEL) -> tuple[pd.DataFrame, programs.Done]:
    Path("questions.csv").write_text(text)
    done = run("pipeline.predict", DATASET, "questions.csv", "--saved", file, "--out", "answers.csv")
    assert done.returncode == 0, done.stderr
    return pd.read_csv("answers.csv", keep_default_na=False), done


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder with the dataset of one run, and a spline that was fitted to it by the training program."""
    monkeypatch.chdir(tmp_path)
    write(first_run())
    fit()


@pytest.mark.usefixtures("place")
def test_a_fresh_model_is_said_to_be_none_whatever_the_order_and_last_digits_of_its_dataset() -> None:
    fit("spline", "later")
    for points in (first_run(), first_run().sample(frac=1.0, random_state=1)):
        shaken = points.assign(displacement_mm=points["displacement_mm"] * (1.0 + 1e-13))
        write(shaken)
        for of in ("within", "later"):
            assert apart(MODEL.with_name(f"{of}-0.model"), DATASET) is None
    text, screen = export()
    assert "fit it anew" not in text + screen
    assert "Errors on blocks inside strokes" in text and "Errors on whole last strokes" in text
    table, done = ask()
    assert "beware" not in done.stderr and table["inside"].tolist() == [True, True, False]


@pytest.mark.usefixtures("place")
def test_an_export_of_a_model_whose_dataset_has_grown_says_so_and_nothing_of_the_new_points() -> None:
    fit("spline", "later")
    write(both_runs())
    text, screen = export()
    says = f"{MODEL} was fitted to other points than those of {DATASET}: run poly-2 is new to it; {ANEW}"
    both = f"{says} processed/poly/spline/later-0.model"
    for words in (text, screen):
        assert f"Errors, zero and what was recorded are not told, for {both}" in words
        assert "Errors on" not in words and "rms" not in words
    assert "Fitted to points of run poly-1 of material poly." in text
    assert "Strokes to 6 were trained on." in text and "It was set so for string" not in text
    assert "tsa_recorded(" not in Path("out/tsa.h").read_text()
    done = run("pipeline.export", MODEL, "--format", "onnx", "--out", "graphs/")
    assert done.returncode == 0, done.stderr
    metadata = {prop.key: prop.value for prop in onnx.load("graphs/tsa.forward.onnx").metadata_props}
    assert metadata["older"].endswith(both) and "errors" not in metadata
    fit("spline", "within", "later")
    text, screen = export()
    assert "fit it anew" not in text + screen and "strokes 1 to 10" in text


@pytest.mark.usefixtures("place")
def test_the_errors_of_an_older_fit_beside_a_fresh_model_are_not_told() -> None:
    fit("spline", "later")
    write(both_runs())
    fit("spline", "within")
    text, screen = export()
    later = "Errors on whole last strokes that the fit left out are not told, for processed/poly/spline/later-0.model"
    for words in (text, screen):
        assert "Errors on blocks inside strokes that the fit left out (strokes 1 to 10): forward" in words
        assert later in words and words.count("Errors on whole last strokes") == 1
    text, _ = export("--all-points")
    assert later in text and "Errors, zero" not in text
    write(first_run())
    text, screen = export(file=MODEL.with_name("all-0.model"))
    anew = f"fit it anew: python -m pipeline.export {MODEL} --format c --all-points"
    assert f"run poly-2 is no longer there; {anew}" in text and "Errors on" not in text


@pytest.mark.usefixtures("place")
def test_a_zero_that_was_set_anew_is_not_said_of_a_model_that_was_fitted_before() -> None:
    write(both_runs())
    fit()
    points = both_runs()
    points.loc[points["run"] == "poly-2", "displacement_mm"] += 0.3
    write(points)
    write_jumps(DATASET.with_name("zero_jumps.json"), {"poly": [f"{SET_ANEW} raw/poly-2"]})
    text, screen = export()
    assert "run poly-2 is there with other points to train on; fit it anew" in text
    assert SET_ANEW not in text + screen
    table, done = ask()
    assert "beware: processed/poly/spline/within-0.model was fitted to other points" in done.stderr
    assert SET_ANEW not in done.stderr
    assert not table["inside"].any() and table["displacement_mm"].astype(float).notna().all()
    assert table["why"].str.contains("the dataset has other points than the model was fitted to: fit it anew").all()
    write_jumps(DATASET.with_name("zero_jumps.json"), {})
    points = both_runs()
    points.loc[points.index[points["within"] == "train"][7], "displacement_mm"] += 1.0
    write(points)
    assert not ask()[0]["inside"].any(), "one point is off by 1 mm"


@pytest.mark.parametrize("model", ["spline", "polynomial", "traditional", "calibrated"])
@pytest.mark.usefixtures("place")
def test_inside_is_what_the_model_was_fitted_to_where_the_dataset_has_grown(model: str) -> None:
    file = DATASET.with_name(model) / "within-0.model"
    fit(model)
    fresh, _ = ask(file=file)
    write(both_runs().assign(motor_turns=lambda points: points["motor_turns"] + 9.0 * (points["run"] == "poly-2")))
    older, done = ask(file=file)
    assert f"beware: {file} was fitted to other points than those of {DATASET}: run poly-2 is new to it" in done.stderr
    pd.testing.assert_frame_equal(older, fresh)
    assert older["inside"].tolist() == [True, True, False] and "10 is 4 after 6" in older["why"][2]


@pytest.mark.parametrize(("model", "status"), [("polynomial", 0), ("traditional", 2), ("calibrated", 2)])
@pytest.mark.usefixtures("place")
def test_a_model_without_ranges_is_refused_where_the_points_that_had_them_changed(model: str, status: int) -> None:
    file = DATASET.with_name(model) / "within-0.model"
    fit(model)
    write(first_run().assign(displacement_mm=lambda points: points["displacement_mm"] + 0.3))
    done = run("pipeline.export", file, "--format", "c", "--out", "out/")
    assert done.returncode == status and "poly-1 is there with other points" in done.stdout + done.stderr
    assert f"snakemake --cores 2 -- {file}" in done.stdout + done.stderr


@pytest.mark.usefixtures("place")
def test_a_file_without_a_note_is_read_as_before_and_the_model_is_the_same() -> None:
    points = first_run()
    model, noted = make_model("spline"), make_model("spline")
    model.fit(points[points["within"] == "train"], 0)
    noted.load(MODEL)
    np.testing.assert_array_equal(model.forward(points), noted.forward(points))
    write_bytes(MODEL, read_bytes(MODEL))
    write(both_runs())
    text, screen = export()
    assert "fit it anew" not in text + screen and re.search(r"Errors on blocks inside strokes .* 1 to 10", text)
