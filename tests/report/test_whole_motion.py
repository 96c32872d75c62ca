"""A model that answers along a whole motion alone is proposed nowhere for export, whatever its name and its errors."""

import sys
from pathlib import Path

import pandas as pd
import pytest
from test_models_page import FORWARD, TITLES, made_metrics

from pipeline.ground.model_errors import errors_in
from pipeline.ground.stored import schemas
from pipeline.models import interface
from pipeline.report.end_of_job.summary import summary
from pipeline.report.model_to_take.fitted import lines_at_end
from pipeline.report.model_to_take.model_advice import advice_on
from pipeline.report.model_to_take.to_take import Models
from pipeline.report.models import main

SECOND = "replayed"  # no name that any module knows
ERRORS_MM = FORWARD | {"diagnosed": [0.010], SECOND: [0.005]}
WITH_MOTION = ("diagnosed", SECOND)
ALL_TITLES = TITLES | {"diagnosed": "Diagnosed simulator", SECOND: "Replayed model"}
EXPORTED = f"processed/made/{SECOND}/within-0.model --format"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The page of the models of a material, by the real program, with two that need a whole motion and err least."""
    processed, reports = tmp_path / "processed" / "made", tmp_path / "reports" / "made"
    schemas.write(made_metrics(ERRORS_MM), schemas.METRICS, processed / "metrics.parquet")
    words = ["models", str(processed / "metrics.parquet"), "--directed", "mlp", "--whole-motion", *WITH_MOTION]
    words += ["--titles", *(f"{model}={title}" for model, title in ALL_TITLES.items())]
    words += ["--out", str(reports / "models.md"), "--table", str(reports / "models.csv")]
    monkeypatch.setattr(sys, "argv", words)
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 0
    return reports


def test_the_page_takes_none_and_says_of_each_that_it_needs_the_whole_motion(folder):
    text = (folder / "models.md").read_text()
    assert "Take the **MLP model**." in text and f"`{EXPORTED}" not in text
    for model in WITH_MOTION:
        assert f"`{model}` needs the whole motion: it is neither exported nor asked." in text
        assert f"`processed/made/{model}/`" in text, "its files are listed like those of the others"
    assert "Replayed model errs less" not in text and "Replayed model, which errs less" not in text


def test_whoever_reads_the_table_takes_none(folder):
    assert {model for model, _ in errors_in(folder / "models.csv")} == {"inn", "mlp", "calibrated"}
    models = Models.read(folder / "models.csv")
    assert models.chosen() == "mlp" and models.weighed() == models.at_inverse() == ""
    assert models.row()[-2] != "", "the simulator's own errors stand beside those of the model to take"
    assert advice_on(["mlp", "inn"], folder / "models.csv").model == "mlp"


@pytest.mark.parametrize("has_page", [True, False])
def test_the_end_of_the_job_names_none_to_export_with_and_without_the_page(folder, has_page):
    processed = folder.parents[1] / "processed" / "made"
    paths = [processed / model / "within-0.model" for model in ALL_TITLES]
    for path in paths:
        path.parent.mkdir(parents=True)
        path.touch()
    job_files = [*paths, processed / "metrics.parquet", *([folder / "models.csv"] if has_page else [])]
    text = summary(map(str, job_files), folder.parent, ["made"], [], WITH_MOTION)
    assert "model to take: mlp. " in text and SECOND not in text and "diagnosed" not in text
    assert SECOND in summary(map(str, paths), folder.parent, ["made"], []), "by no name"


def test_without_any_errors_none_is_proposed(tmp_path):
    files = [Path(f"processed/nylon/{SECOND}/within-0.model")]
    assert lines_at_end("nylon", files, tmp_path / "none.csv", whole_motion=WITH_MOTION) == []


def test_a_table_of_an_earlier_version_marks_none_and_is_read(folder):
    table = pd.read_csv(folder / "models.csv").drop(columns="needs_motion")
    table.to_csv(folder / "models.csv", index=False)
    assert (SECOND, "within") in errors_in(folder / "models.csv")


def test_which_models_need_a_whole_motion_their_own_files_say():
    """The report was told of one by its name."""
    assert interface.names_with_motion() == tuple(
        name for name in interface.names() if interface.about(name).needs_motion
    )
