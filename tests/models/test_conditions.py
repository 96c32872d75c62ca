"""What varies is a condition, what only jitters is not, and a strange material counts as the first."""

import json

import numpy as np
import pandas as pd
import pytest
from first_few import first_few
from made_dataset import made_dataset

from pipeline.models.interface import make_model
from pipeline.models.parts.conditions import Conditions


@pytest.fixture(scope="module")
def campaign() -> pd.DataFrame:
    """Two strings of different radius, load and material."""
    thick = made_dataset(60, 3).assign(
        string="made-02", radius_mm=0.5, load_n=30.0, material="nylon",
        displacement_mm=lambda points: 1.3 * points["displacement_mm"],
    )  # fmt: skip
    return pd.concat([made_dataset(60, 3).assign(material="aramid"), thick], ignore_index=True)


def test_only_what_varies_is_a_condition(campaign: pd.DataFrame) -> None:
    conditions = Conditions.of(campaign)
    assert set(conditions.names) == {"radius_mm", "load_n"} and conditions.materials == ("aramid", "nylon")
    assert conditions.size == 3 == conditions.table(campaign).shape[1]
    scaled = conditions.table(campaign)[:, :2]
    assert np.allclose(scaled.mean(axis=0), 0) and np.allclose(scaled.std(axis=0), 1)


def test_a_load_cells_noise_is_no_condition(points: pd.DataFrame) -> None:
    jittering = points.assign(load_n=20.0 + np.random.default_rng(0).normal(0.0, 0.1, len(points)))
    assert Conditions.of(jittering).size == 0
    assert Conditions.of(jittering).table(points).shape == (len(points), 0)


def test_a_strange_material_counts_as_the_first(campaign: pd.DataFrame) -> None:
    conditions = Conditions.of(campaign)
    of_first = conditions.table(campaign.assign(material="aramid"))
    np.testing.assert_array_equal(conditions.table(campaign.assign(material="steel")), of_first)
    np.testing.assert_array_equal(conditions.table(campaign.drop(columns="material")), of_first)


def test_conditions_come_back_from_a_file(campaign: pd.DataFrame) -> None:
    conditions = Conditions.of(campaign)
    assert Conditions.from_saved(json.loads(json.dumps(conditions.saved()))) == conditions


@pytest.mark.parametrize(
    ("name", "settings"),
    first_few([("spline", {}), ("polynomial", {}), ("mlp", {"epochs": 60, "batch": 60}), ("cinn", {"batch": 60})], 3),
)
def test_a_model_tells_materials_and_loads_apart(
    name: str, settings: dict[str, object], campaign: pd.DataFrame
) -> None:
    """The second string contracts by 1.3 times what it would: no dimension says so."""
    model = make_model(name, **settings)
    model.fit(campaign, 0)
    for _, rows in campaign.groupby("string"):
        error_mm = model.forward(rows) - rows["displacement_mm"]
        assert np.sqrt(np.mean(error_mm**2)) < 0.3
    other = campaign[campaign["string"] == "made-02"]
    apart_mm = model.forward(other) - model.forward(other.assign(material="aramid"))
    assert np.abs(apart_mm).max() > 0.1


def test_a_polynomial_stays_at_the_edge_of_what_it_has_seen(points: pd.DataFrame) -> None:
    model = make_model("polynomial")
    model.fit(points, 0)
    top = points["motor_turns"].max()
    beyond = model.forward(points.assign(motor_turns=10 * top))
    at_edge = model.forward(points.assign(motor_turns=model.box.high["motor_turns"]))
    np.testing.assert_array_equal(beyond, at_edge)
