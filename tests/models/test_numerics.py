"""The invertible models over their whole declared box: undone by their inverse, finite, rising, clear about outside."""

import numpy as np
import pandas as pd
import pytest
from made_dataset import made_dataset

from pipeline.models.interface import Model, make_model
from pipeline.models.parts.box import Box

ON_DATA_TURNS, IN_BOX_TURNS = 1e-4, 1e-3


@pytest.fixture(scope="module")
def train() -> pd.DataFrame:
    points = made_dataset(per_phase=120)
    return points[points["within"] == "train"]


@pytest.fixture(scope="module", params=["spline", "cinn"])
def model(request: pytest.FixtureRequest, train: pd.DataFrame) -> Model:
    settings = {"cinn": {"epochs": 15}, "spline": {}}[request.param]
    model = make_model(request.param, **settings)
    model.fit(train, 0)
    return model


def grid(train: pd.DataFrame, per_side: int = 400) -> pd.DataFrame:
    """Twists over the box, evenly and at its very edges, for every stroke and both directions."""
    box = Box.of(train)
    turns = np.linspace(box.low["motor_turns"], box.high["motor_turns"], per_side)
    base = train.iloc[[0]]
    parts = [
        pd.concat([base] * per_side, ignore_index=True).assign(motor_turns=turns, stroke=stroke, direction=way)
        for stroke in range(1, 10)
        for way in (1, -1)
    ]
    return pd.concat(parts, ignore_index=True)


def test_the_round_trip_on_the_data(model: Model, train: pd.DataFrame) -> None:
    predicted = train.assign(displacement_mm=model.forward(train))
    assert np.abs(model.inverse(predicted) - train["motor_turns"]).max() <= ON_DATA_TURNS


def test_the_round_trip_over_the_whole_box(model: Model, train: pd.DataFrame) -> None:
    whole = grid(train)
    predicted = whole.assign(displacement_mm=model.forward(whole))
    assert np.abs(model.inverse(predicted) - whole["motor_turns"]).max() <= IN_BOX_TURNS


def test_it_rises_with_the_twist(model: Model, train: pd.DataFrame) -> None:
    """The spline by construction, wherever eq. 4 rises, that is from zero twist; the INN because it learnt it."""
    whole = grid(train)
    whole = whole[whole["motor_turns"] > -0.3]
    for _, curve in whole.groupby(["stroke", "direction"]):
        assert (np.diff(model.forward(curve)) > 0).all()


def test_nothing_in_the_box_is_not_a_number(model: Model, train: pd.DataFrame) -> None:
    box, rng = Box.of(train), np.random.default_rng(0)
    points = train.sample(2000, replace=True, random_state=0)
    for name in ("motor_turns", "displacement_mm", "load_n"):
        points[name] = rng.uniform(box.low[name], box.high[name], len(points))
    assert np.isfinite(model.forward(points)).all() and np.isfinite(model.inverse(points)).all()
    assert not box.outside(points, "motor_turns") and not box.outside(points, "displacement_mm")


@pytest.mark.parametrize("name", ["motor_turns", "stroke", "load_n", "radius_mm", "separator_mm"])
@pytest.mark.parametrize("wrong", ["below", "above", "nan", "infinite"])
def test_the_box_names_what_lies_outside(train: pd.DataFrame, name: str, wrong: str) -> None:
    box, points = Box.of(train), train.astype({"stroke": float}).copy()
    value = {"below": box.low[name] - 0.5, "above": box.high[name] + 0.5, "nan": np.nan, "infinite": np.inf}[wrong]
    points.iloc[7, points.columns.get_loc(name)] = value
    outside = box.outside(points, "motor_turns")
    assert list(outside) == [name] and np.flatnonzero(outside[name]).tolist() == [7]


def test_the_box_asks_nothing_of_the_answer_and_knows_materials(train: pd.DataFrame) -> None:
    points = train.assign(material="nylon")
    box = Box.of(points)
    assert not box.outside(points.assign(displacement_mm=np.nan), "motor_turns")
    assert list(box.outside(points.assign(displacement_mm=np.nan), "displacement_mm")) == ["displacement_mm"]
    assert list(box.outside(points.assign(material="steel"), "motor_turns")) == ["material"]
    assert Box.from_saved(box.saved()) == box
