"""The training program: what it reads, predicts and refuses."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pipeline.ground.errors import BadInput
from pipeline.ground.kinematics import Geometry
from pipeline.ground.stored import schemas
from pipeline.models.parts.configured import configured
from pipeline.models.parts.divided import divided
from pipeline.models.parts.saved import read_bytes, read_json
from pipeline.stages.train import main, predictions


def table(points: int = 40) -> pd.DataFrame:
    """A dataset of one stroke whose string is thicker than measured; every fourth point is held out."""
    turns, dimensions = np.linspace(0.0, 20.0, points), {"length_mm": 400.0, "stiffness_n_per_mm": 15.0}
    dimensions |= {"torsion_zone_mm": 150.0, "separator_mm": 8.0}
    true = Geometry("separator", radius_mm=0.41, **dimensions)
    columns = {
        "run": "made-01", "string": "made-01", "stroke": 1, "phase": "winding", "direction": 1, "block": 0,
        "within": np.where(np.arange(points) % 4 == 1, "test", "train"), "later": "train", "time_s": turns / 2,
        "motor_turns": turns, "displacement_mm": true.contraction_mm(turns, 20.0), "load_n": 20.0,
        "actuator": "separator", "radius_mm": 0.4, **dimensions,
        "radius_tolerance": 0.03, "length_tolerance_mm": 2.0, "torsion_zone_tolerance_mm": 1.0,
        "separator_tolerance_mm": 0.5,
    }  # fmt: skip
    return pd.DataFrame(columns)[schemas.DATASET.names]


@pytest.fixture
def dataset(tmp_path: Path) -> Path:
    schemas.write(table(), schemas.DATASET, tmp_path / "dataset.parquet")
    return tmp_path / "dataset.parquet"


def words(dataset: Path, model: str, *more: str, split: str = "within") -> list[str]:
    out = ["--out-model", f"{dataset.parent}/m/model", "--out-predictions", f"{dataset.parent}/m/p.parquet"]
    return [str(dataset), "--model", model, "--split", split, *out, *more]


def program(arguments: list[str]) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, "-m", "pipeline.stages.train", *arguments], capture_output=True, text=True, check=False
    )


def test_the_program_writes_the_model_and_predictions_of_the_held_out_points(
    dataset: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "argv", ["train", *words(dataset, "calibrated")])
    main()
    predicted, points = schemas.read(dataset.parent / "m/p.parquet", schemas.PREDICTIONS), table()
    assert predicted["point"].tolist() == points.index[points["within"] == "test"].tolist()
    truth = points.loc[predicted["point"]]
    np.testing.assert_allclose(predicted["displacement_mm"], truth["displacement_mm"], atol=0.01)
    np.testing.assert_allclose(predicted["motor_turns"], truth["motor_turns"], atol=0.05)
    assert read_json(dataset.parent / "m/model")["made-01"]["radius_mm"] == pytest.approx(0.01, abs=5e-3)


def test_a_split_that_the_dataset_leaves_out_is_skipped_and_says_so(tmp_path: Path) -> None:
    schemas.write(table().assign(later=""), schemas.DATASET, tmp_path / "dataset.parquet")
    done = program(words(tmp_path / "dataset.parquet", "traditional", split="later"))
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.startswith("skipped")
    assert schemas.read(tmp_path / "m/p.parquet", schemas.PREDICTIONS).empty
    assert read_bytes(tmp_path / "m/model") == b""


def test_the_mlp_trains_from_the_command_line_and_says_so(dataset: Path) -> None:
    done = program(words(dataset, "mlp", "--seed", "3", "--settings", '{"epochs": 3, "width": 4}'))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("mlp: epoch 3 of 3, loss ")
    assert (dataset.parent / "m/model").exists()


def test_a_split_without_held_out_points_is_bad_input_and_writes_nothing(dataset: Path) -> None:
    done = program(words(dataset, "traditional", split="later"))
    assert done.returncode == 2
    assert done.stderr.startswith(f"error: {dataset}: later: ")
    assert not (dataset.parent / "m").exists()


def test_the_points_of_neither_part_are_left_out() -> None:
    points = table().assign(within=["", "train", "test", ""] * 10)
    train, test = divided(points.set_index(points.index + 100), "within", "x")
    assert train.index.tolist() == list(range(1, 40, 4)) and test.index.tolist() == list(range(2, 40, 4))
    with pytest.raises(BadInput, match='no point is "train"'):
        divided(points.assign(within="test"), "within", "x")


@pytest.mark.parametrize(
    ("model", "settings", "problem"),
    [
        ("nonesuch", "{}", "nonesuch"),
        ("interface", "{}", "MODEL"),
        ("calibrated", '{"depth": 3}', "depth"),
        ("traditional", '{"depth": 3}', "depth"),
        ("inn", '{"loss": "none"}', "loss"),
        ("inn", "{", "JSON"),
    ],
)
def test_an_unknown_model_or_setting_is_bad_input(model: str, settings: str, problem: str) -> None:
    with pytest.raises(BadInput, match=problem):
        configured(model, settings)


class Blind:
    """A model that answers only what it is not shown."""

    def forward(self, points: pd.DataFrame) -> np.ndarray:
        return points["displacement_mm"].fillna(1.0).to_numpy()

    def inverse(self, points: pd.DataFrame) -> np.ndarray:
        return points["motor_turns"].fillna(2.0).to_numpy()


def test_a_model_never_sees_the_answer() -> None:
    predicted = predictions(Blind(), table())  # type: ignore[arg-type]
    assert set(predicted["displacement_mm"]) == {1.0} and set(predicted["motor_turns"]) == {2.0}


def test_a_prediction_that_is_not_finite_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Blind, "forward", lambda self, points: np.full(len(points), np.inf))
    with pytest.raises(ArithmeticError, match="40 of 40"):
        predictions(Blind(), table())  # type: ignore[arg-type]
