import numpy as np
import pandas as pd
import pytest

from pipeline.ground.errors import BadInput
from pipeline.ground.kinematics import point_contraction_mm, point_motor_turns
from pipeline.ground.stored import schemas
from pipeline.stages.evaluate import angle_bands, evaluate


@pytest.fixture(scope="module")
def dataset():
    from stages.nine_strokes import NINE

    return NINE


def write_predictions(dataset, path, split="within", **errors):
    held_out = np.flatnonzero(dataset[split] == "test")
    points = dataset.iloc[held_out]
    table = pd.DataFrame({"point": held_out})
    for column in ("displacement_mm", "motor_turns"):
        table[column] = points[column].to_numpy() + errors.get(column, 0.0)
    schemas.write(table, schemas.PREDICTIONS, path)
    return path


def pick(metrics, **where):
    chosen = metrics
    for column, value in where.items():
        chosen = chosen[chosen[column] == value]
    assert len(chosen) == 1
    return chosen.iloc[0]


def test_metrics_by_hand(dataset, tmp_path):
    held_out = np.flatnonzero(dataset["within"] == "test")
    error = np.where(dataset["stroke"].iloc[held_out] == 5, 0.4, -0.2)
    path = write_predictions(dataset, tmp_path / "toy" / "within-3.predictions.parquet", displacement_mm=error)
    metrics = evaluate(dataset, path, "UHMWPE")
    assert set(metrics["model"]) == {"toy"} and set(metrics["seed"]) == {3} and set(metrics["material"]) == {"UHMWPE"}
    where = {"map": "forward", "phase": "winding", "angle_band": "all"}
    assert pick(metrics, **where, stroke="5", metric="average")["value"] == pytest.approx(0.4)
    assert pick(metrics, **where, stroke="1", metric="maximum")["value"] == pytest.approx(0.2)
    share = (dataset.iloc[held_out].query("phase == 'winding'")["stroke"] == 5).mean()
    rmse = np.sqrt(share * 0.16 + (1 - share) * 0.04)
    assert pick(metrics, **where, stroke="all", metric="rmse")["value"] == pytest.approx(rmse)
    assert pick(metrics, **{**where, "map": "inverse"}, stroke="all", metric="rmse")["unit"] == "turns"


def test_every_number_can_be_recomputed_from_the_stored_predictions(dataset, tmp_path):
    held_out = np.flatnonzero(dataset["within"] == "test")
    points = dataset.iloc[held_out]
    forward, inverse = point_contraction_mm(points), point_motor_turns(points)
    errors = {
        "displacement_mm": forward - points["displacement_mm"].to_numpy(),
        "motor_turns": inverse - points["motor_turns"].to_numpy(),
    }
    path = write_predictions(dataset, tmp_path / "t" / "within-0.predictions.parquet", **errors)
    metrics = evaluate(dataset, path, "m")
    stored = schemas.read(path, schemas.PREDICTIONS)
    measured = dataset.loc[stored["point"]].reset_index(drop=True)
    error = (stored["motor_turns"] - measured["motor_turns"])[(measured["stroke"] == 9) & (measured["direction"] == 1)]
    by_hand = error.abs().max()
    where = {"map": "inverse", "phase": "winding", "angle_band": "all", "stroke": "9", "metric": "maximum"}
    assert pick(metrics, **where)["value"] == pytest.approx(by_hand)


def test_errors_of_both_signs_do_not_cancel(dataset, tmp_path):
    held_out = np.flatnonzero(dataset["within"] == "test")
    path = write_predictions(
        dataset, tmp_path / "toy" / "within-0.predictions.parquet", motor_turns=np.resize([1.0, -1.0], len(held_out))
    )
    metrics = evaluate(dataset, path, "m")
    where = {"map": "inverse", "phase": "all", "angle_band": "all", "stroke": "all", "metric": "average"}
    assert pick(metrics, **where)["value"] == pytest.approx(1.0)


def test_predictions_of_other_points_are_refused(dataset, tmp_path):
    path = write_predictions(dataset, tmp_path / "toy" / "later-0.predictions.parquet", split="within")
    with pytest.raises(BadInput, match="not the points that later holds out"):
        evaluate(dataset, path, "m")


def test_a_skipped_split_has_no_metrics(dataset, tmp_path):
    few = dataset.assign(later="")
    path = write_predictions(few, tmp_path / "toy" / "later-0.predictions.parquet", split="later")
    metrics = evaluate(few, path, "m")
    assert metrics.empty and list(metrics.columns) == schemas.METRICS.names


def test_angle_bands_split_the_range_in_quarters():
    assert angle_bands(np.array([0.0, 6.9, 7.1, 20.0, 21.5, 28.0])).tolist() == [
        "0-25%", "0-25%", "25-50%", "50-75%", "75-100%", "75-100%",
    ]  # fmt: skip
