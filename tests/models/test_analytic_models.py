"""The traditional model is the paper's equations; the calibrated one moves their dimensions and no more."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from made_dataset import LOAD_N, STRING, ZONE

from pipeline.ground.kinematics import Geometry
from pipeline.models.calibrated import Calibrated, sigma_mm
from pipeline.models.traditional import Traditional


def exact(points: pd.DataFrame, zero_mm: float = 0.0, **dimensions: float) -> pd.DataFrame:
    """The points with the displacement that a string of the given true dimensions has, and little noise."""
    string = Geometry("separator", **{**STRING, **ZONE, **dimensions})
    noise_mm = np.random.default_rng(3).normal(0.0, 0.03, len(points))
    return points.assign(displacement_mm=string.contraction_mm(points["motor_turns"], LOAD_N) + zero_mm + noise_mm)


def in_sigmas(model: Calibrated, points: pd.DataFrame, string: str) -> dict[str, float]:
    """The moves of a string's dimensions over how well each was measured."""
    moves = {name: by for name, by in model.moves[string].items() if name != "zero_mm"}
    return {name: by / float(sigma_mm(points, name).iloc[0]) for name, by in moves.items()}


def test_traditional_is_eq_4_and_eq_5(points: pd.DataFrame) -> None:
    string = Geometry("separator", **STRING, **ZONE)
    np.testing.assert_array_equal(Traditional().forward(points), string.contraction_mm(points["motor_turns"], LOAD_N))
    np.testing.assert_array_equal(Traditional().inverse(points), string.motor_turns(points["displacement_mm"], LOAD_N))


def test_rows_of_both_actuators_may_be_mixed(points: pd.DataFrame, pair_points: pd.DataFrame) -> None:
    mixed = pd.concat([points, pair_points]).sample(frac=1.0, random_state=0)
    forward, pair = Traditional().forward(mixed), (mixed["actuator"] == "twisted_pair").to_numpy()
    np.testing.assert_array_equal(forward[pair], Traditional().forward(mixed[pair]))
    np.testing.assert_array_equal(forward[~pair], Traditional().forward(mixed[~pair]))


def test_a_pair_wound_up_contracts_by_its_length(pair_points: pd.DataFrame) -> None:
    np.testing.assert_array_equal(Traditional().forward(pair_points.assign(motor_turns=1000.0)), 300.0)


def test_calibrated_recovers_a_mismeasured_radius_and_zero(points: pd.DataFrame) -> None:
    model = Calibrated()
    model.fit(exact(points, zero_mm=-0.7, radius_mm=0.4 * 1.04), 0)
    move = model.moves["made-01"]
    # Other dimensions trade a little against the radius, within what 0.03 mm of noise can tell apart.
    assert move["radius_mm"] == pytest.approx(0.04 * 0.4, abs=0.004)
    assert move["zero_mm"] == pytest.approx(-0.7, abs=0.1)
    questions = points.assign(displacement_mm=np.nan)
    truth = exact(points, zero_mm=-0.7, radius_mm=0.4 * 1.04)["displacement_mm"]
    assert np.sqrt(np.mean((model.forward(questions) - truth) ** 2)) < 0.032


def test_calibrated_stays_within_three_sigma(points: pd.DataFrame) -> None:
    model, narrow = Calibrated(), exact(points, radius_mm=0.5).assign(radius_tolerance=0.01)
    model.fit(narrow, 0)
    sigmas = in_sigmas(model, narrow, "made-01")
    assert set(sigmas) == {"radius_mm", "separator_mm", "torsion_zone_mm", "length_mm"}
    assert max(map(abs, sigmas.values())) == pytest.approx(3.0, abs=1e-3)
    assert max(map(abs, sigmas.values())) <= 3.0 + 1e-9


def test_calibrated_leaves_right_dimensions_where_they_are(points: pd.DataFrame) -> None:
    model = Calibrated()
    model.fit(exact(points), 0)
    # Radius and torsion zone trade against each other, so either may wander by a good part of its sigma.
    assert max(map(abs, in_sigmas(model, points, "made-01").values())) < 1.0


def test_calibrated_moves_of_a_pair_what_a_pair_has(pair_points: pd.DataFrame) -> None:
    model = Calibrated()
    model.fit(pair_points.assign(radius_mm=0.41), 0)
    move = model.moves["pair-01"]
    assert set(move) == {"radius_mm", "length_mm", "zero_mm"}
    assert move["radius_mm"] == pytest.approx(0.40 - 0.41, abs=0.002)


def test_strings_are_calibrated_apart_and_an_unknown_one_is_nominal(points: pd.DataFrame) -> None:
    thick = exact(points, radius_mm=0.42).assign(string="thick")
    thin = exact(points, radius_mm=0.38).assign(string="thin")
    model = Calibrated()
    model.fit(pd.concat([thick, thin]).sample(frac=1.0, random_state=0), 0)
    assert model.moves["thick"]["radius_mm"] > 0.012 and model.moves["thin"]["radius_mm"] < -0.012
    stranger = points.assign(string="stranger")
    np.testing.assert_array_equal(model.forward(stranger), Traditional().forward(stranger))
    np.testing.assert_array_equal(model.inverse(stranger), Traditional().inverse(stranger))


def test_calibrated_inverse_undoes_its_forward(points: pd.DataFrame) -> None:
    model = Calibrated()
    model.fit(exact(points, zero_mm=0.4, radius_mm=0.41), 0)
    predicted = points.assign(displacement_mm=model.forward(points))
    np.testing.assert_allclose(model.inverse(predicted), points["motor_turns"], atol=1e-9)


def test_a_loaded_model_needs_no_tolerance(points: pd.DataFrame, tmp_path: Path) -> None:
    model, loaded = Calibrated(), Calibrated()
    model.fit(points, 0)
    model.save(tmp_path / "model.json")
    loaded.load(tmp_path / "model.json")
    wider = points.assign(radius_tolerance=0.2)
    np.testing.assert_array_equal(loaded.forward(wider), model.forward(points))
