"""A model is fitted to a dataset by one command, as the stage of training does, and lies where its export looks."""

import json
from pathlib import Path

import programs
import pytest
from models.made_dataset import made_dataset

from pipeline.export.closing_words import MADE_UP
from pipeline.ground.names import SYNTHETIC_DEVICE
from pipeline.ground.stored import schemas
from pipeline.models.parts.saved import read_bytes

SETTINGS = ("--settings", '{"degree": 3}')


@pytest.fixture
def root(tmp_path: Path) -> Path:
    points = made_dataset(40, 6)
    later = points["stroke"].map(lambda stroke: "test" if stroke > 4 else "train")
    schemas.write(points.assign(later=later), schemas.DATASET, tmp_path / "processed/made/dataset.parquet")
    return tmp_path


def fit(root: Path, *words: str) -> programs.Done:
    return programs.run("pipeline.fit_model", *words, cwd=root)


def test_it_is_byte_by_byte_what_the_stage_makes_of_both_splits(root: Path) -> None:
    done = fit(root, "polynomial", "processed/made/dataset.parquet", "--seed", "2", *SETTINGS)
    assert done.returncode == 0, done.stderr
    for split in ("within", "later"):
        words = ["--model", "polynomial", "--split", split, "--seed", "2", *SETTINGS, "--out-model", f"{split}.model"]
        words += ["--out-predictions", "p.parquet"]
        staged = programs.run("pipeline.stages.train", "processed/made/dataset.parquet", *words, cwd=root)
        assert staged.returncode == 0, staged.stderr
        fitted = root / f"processed/made/polynomial/{split}-2.model"
        assert fitted.read_bytes() == (root / f"{split}.model").read_bytes()
    assert "Errors on blocks inside strokes that the fit left out" in done.stdout
    assert "Errors on whole last strokes that the fit left out (strokes 5 to 6), by a fit" in done.stdout


def test_too_few_strokes_for_later_ones_are_no_harm(root: Path) -> None:
    path = root / "processed/made/dataset.parquet"
    schemas.write(made_dataset(40, 3).assign(later=""), schemas.DATASET, path)
    done = fit(root, "polynomial", str(path))
    assert done.returncode == 0 and "whole last strokes" not in done.stdout, done.stderr
    assert read_bytes(root / "processed/made/polynomial/later-0.model") == b""
    words = [f"{path.parent}/polynomial/within-0.model", "--format", "c"]
    assert programs.run("pipeline.export.__main__", *words, cwd=root).returncode == 0


def test_a_fit_that_lies_elsewhere_is_exported_with_its_dataset(root: Path) -> None:
    done = fit(root, "traditional", "processed/made/dataset.parquet", "--out", "mine")
    assert done.returncode == 0, done.stderr
    (line,) = [line for line in done.stdout.splitlines() if line.startswith("Next: export it: ")]
    words = line.removeprefix("Next: export it: python -m pipeline.export ").split()
    assert words == ["mine/traditional/within-0.model", "--format", "c", "--dataset", "processed/made/dataset.parquet"]
    done = programs.run("pipeline.export.__main__", *words, cwd=root)
    assert done.returncode == 0, done.stderr
    assert (root / "mine/traditional/tsa.h").is_file()


def test_outside_of_a_job_an_older_fit_names_the_command_and_the_synthetic_rig_is_told(root: Path) -> None:
    path, points = root / "mine/dataset.parquet", made_dataset(40, 3).assign(later="")
    schemas.write(points, schemas.DATASET, path)
    rig = root / "raw" / str(points["run"].iloc[0]) / "capture.json"
    rig.parent.mkdir(parents=True)
    rig.write_text(json.dumps({"hello": {"device": SYNTHETIC_DEVICE}}))
    assert fit(root, "polynomial", "mine/dataset.parquet", "--seed", "1").returncode == 0
    words = ["mine/polynomial/within-1.model", "--format", "c"]
    assert MADE_UP in programs.run("pipeline.export.__main__", *words, cwd=root).stdout
    schemas.write(points.assign(run="another"), schemas.DATASET, path)
    done = programs.run("pipeline.export.__main__", *words, cwd=root)
    anew = "python -m pipeline.fit_model polynomial mine/dataset.parquet --seed 1"
    assert done.returncode == 0 and f"fit it anew: {anew}\n" in done.stdout, done.stdout


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (
            "diagnosed processed/made/dataset.parquet",
            "MODEL: diagnosed: is no model that can be exported. Mend: choose",
        ),
        ("splin processed/made/dataset.parquet", "MODEL: splin: is no model that can be exported. Mend: choose one of"),
        (
            "polynomial processed/none/dataset.parquet",
            "processed/none/dataset.parquet: file: is missing. Mend: name pr",
        ),
        (
            "polynomial split.parquet",
            "split.parquet: within: has no points that are held out. Mend: name processed/made",
        ),
        ("polynomial later.parquet", 'later.parquet: later: no point is "train". Mend: use the other split, or record'),
        ("polynomial home/processed/x/dataset.parquet", "dataset: home/processed/x: is where a checkout makes its own"),
    ],
)
def test_what_cannot_be_fitted_is_refused_and_no_file_is_made(root: Path, words: str, complaint: str) -> None:
    (root / "home/processed/x").mkdir(parents=True)
    (root / "home/Snakefile").touch()
    points = made_dataset(40, 3)
    schemas.write(points.assign(within="", later=""), schemas.DATASET, root / "split.parquet")
    schemas.write(points.assign(later="test"), schemas.DATASET, root / "later.parquet")
    done = fit(root, *words.split())
    assert done.returncode == 2 and complaint in done.stderr, done.stderr
    assert not list(root.rglob("*.model"))
