"""The INN's inverse errors taken apart: networks whose leak is known by hand, and one that is trained."""

import sys

import numpy as np
import pytest
import torch
from models.made_dataset import made_dataset

from pipeline.ground.stored import schemas
from pipeline.models.inn import Inn
from pipeline.models.parts.condition_columns import contraction_and_conditions
from pipeline.models.parts.networks.coupling import product
from pipeline.stages.leak import decomposed, leak, main

TINY = {"blocks": 4, "width": 16, "layers": 1, "epochs": 4, "batch": 60}
UNTRAINED = {"blocks": 3, "width": 4, "layers": 1, "epochs": 1, "rates": (0.0,)}


@pytest.fixture(scope="module")
def points():
    return made_dataset(per_phase=60, strokes=4)


def fitted(points, **settings):
    model = Inn(**settings)
    model.fit(points[points["within"] == "train"], 0)
    return model


def values(model, points):
    table = decomposed(model, points)
    return table.set_index(["map", "metric"])["value"].to_dict()


def rms(errors):
    return float(np.sqrt(np.mean(np.square(errors))))


def test_a_network_that_hands_everything_on_leaks_nothing(points):
    """Fresh blocks are the identity; so is their composite: the inverse is off by the residual alone."""
    metrics = values(fitted(points, **UNTRAINED, composite="identity"), points)
    assert metrics["inverse", "leak_rmse"] == pytest.approx(0.0, abs=1e-5)
    assert metrics["inverse", "residual_rmse"] == pytest.approx(metrics["inverse", "rmse"], rel=1e-4)
    assert all(
        metrics["forward", f"offset_{name}"] < 1e-6 and metrics["inverse", f"slope_{name}"] == 0.0 for name in "blrn"
    )


@pytest.mark.parametrize("seed", range(12))
def test_a_network_that_swaps_its_columns_leaks_everything(points, seed):
    """Then θ leaves through a column that should be constant, and no displacement brings it back."""
    model = fitted(points, **UNTRAINED, composite="random", permutation_seed=seed)
    column = product(model.network.mixing, 5).tolist().index(0)
    metrics = values(model, points)
    slopes = [metrics["inverse", f"slope_{name}"] for name in "blrn"]
    assert slopes == [float(column == place) for place in range(1, 5)]
    if column in (1, 2, 3):  # constants: all that is known of θ is its mean
        turns = points["motor_turns"] - points.loc[points["within"] == "train", "motor_turns"].mean()
        assert metrics["inverse", "rmse"] == pytest.approx(rms(turns), rel=1e-5)
        assert metrics["inverse", "leak_rmse"] == pytest.approx(rms(turns), rel=1e-5)
        assert metrics["inverse", "residual_rmse"] == pytest.approx(0.0, abs=1e-5)


def test_errors_are_those_of_the_model_and_its_own_outputs_lead_back(points):
    model = fitted(points, **TINY, composite="random")
    metrics = values(model, points)
    assert metrics["forward", "rmse"] == pytest.approx(rms(model.forward(points) - points["displacement_mm"]), rel=1e-6)
    assert metrics["inverse", "rmse"] == pytest.approx(rms(model.inverse(points) - points["motor_turns"]), rel=1e-6)
    parts = [metrics["inverse", f"{part}_rmse"] for part in ("leak", "residual")]
    assert min(parts) > 0.0 and metrics["inverse", "rmse"] == pytest.approx(np.hypot(*parts), rel=0.5)


def test_slopes_are_what_a_small_step_gives(points):
    model = fitted(points, **TINY, composite="random")
    few = points.iloc[::40]
    metrics = values(model, few)
    outputs = contraction_and_conditions(few, model.settings.log_stroke)
    x = torch.as_tensor(model.outputs.scaled(outputs), dtype=torch.float32)
    model.network.double()
    step = 1e-5 * torch.eye(5, dtype=torch.float64)
    with torch.no_grad():
        for place, name in enumerate("blrn", start=1):
            ends = [model.network.inverse(x.double() + sign * step[place])[:, 0].numpy() for sign in (1, -1)]
            assert metrics["inverse", f"slope_{name}"] == pytest.approx(rms((ends[0] - ends[1]) / 2e-5), rel=1e-2)


def test_the_stage_names_variants_and_seeds_by_their_files(points, tmp_path, monkeypatch):
    dataset = tmp_path / "made" / "dataset.parquet"
    schemas.write(points, schemas.DATASET, dataset)
    paths = [tmp_path / "made" / "leak" / name / "within-2.model" for name in ("random_forward", "random_both")]
    for path, loss in zip(paths, ("forward", "both"), strict=True):
        path.parent.mkdir(parents=True)
        fitted(points, **TINY, loss=loss).save(path)
    out = tmp_path / "made" / "leak" / "leak.parquet"
    monkeypatch.setattr(sys, "argv", ["leak", str(dataset), *map(str, paths), "--out", str(out)])
    with pytest.raises(SystemExit) as ended:
        main()
    table = schemas.read(out, schemas.METRICS)
    assert ended.value.code == 0 and set(table["material"]) == {"made"} and set(table["seed"]) == {2}
    assert list(dict.fromkeys(table["model"])) == ["random_forward", "random_both"]
    held_out = points[points["within"] == "test"]
    again = leak(held_out, paths[0], "made")
    assert again["value"].tolist() == table.loc[table["model"] == "random_forward", "value"].tolist()
