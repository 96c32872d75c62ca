"""The oracle's floors on made data whose floors are known, and what becomes of them."""

import numpy as np
import pandas as pd
import pytest

from pipeline.ground.stored import schemas
from pipeline.stages.evaluate import evaluate
from pipeline.stages.floor import FLOORS, noise, predictions, residuals

NOISE_MM, SLOPE_MM_PER_TURN, TOP_TURNS = 0.03, 0.5, 20.0


def strokes(half_loop_mm=0.0, curve_mm=0.0, per_phase=600, count=4, unwinding=1.0, seed=0):
    """Strokes of a rig with a straight (or bent) law, a loop of constant width and noise; `schemas.DATASET`'s columns
    as far as the oracle reads them. `unwinding` is the share of points that unwinding has of winding's."""
    rng = np.random.default_rng(seed)
    parts = []
    for stroke in range(1, count + 1):
        for phase, direction, points in (("winding", 1, per_phase), ("unwinding", -1, int(per_phase * unwinding))):
            turns = np.linspace(0.0, TOP_TURNS, points)[::direction]
            true_mm = SLOPE_MM_PER_TURN * turns + curve_mm * np.square(turns / TOP_TURNS) - 0.1 * np.log(stroke)
            measured_mm = true_mm - direction * half_loop_mm + rng.normal(0.0, NOISE_MM, points)
            part = {"stroke": stroke, "phase": phase, "direction": direction, "motor_turns": turns}
            parts.append(pd.DataFrame({**part, "displacement_mm": measured_mm, "string": "made"}))
    table = pd.concat(parts, ignore_index=True)
    within = np.where(np.arange(len(table)) // 10 % 4 == 0, "test", "train")
    return table.assign(within=within, later=np.where(table["stroke"] == count, "test", "train"))


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def floors(dataset):
    """Forward and inverse RMSE of each oracle over all points."""
    return {name: tuple(map(rms, residuals(dataset, together))) for name, together in FLOORS.items()}


@pytest.mark.parametrize("half_loop_mm", [0.0, 0.05, 0.3])
def test_the_forward_floors_are_the_noise_and_the_loop(half_loop_mm):
    floor_sizes = floors(strokes(half_loop_mm, curve_mm=6.0))
    assert floor_sizes["floor"][0] == pytest.approx(NOISE_MM, rel=0.05)
    assert floor_sizes["floor_blind"][0] == pytest.approx(np.hypot(NOISE_MM, half_loop_mm), rel=0.05)


@pytest.mark.parametrize("half_loop_mm", [0.0, 0.1])
def test_the_inverse_floors_of_a_straight_law_are_those_over_its_slope(half_loop_mm):
    floor_sizes = floors(strokes(half_loop_mm))
    assert floor_sizes["floor"][1] == pytest.approx(NOISE_MM / SLOPE_MM_PER_TURN, rel=0.05)
    assert floor_sizes["floor_blind"][1] == pytest.approx(
        np.hypot(NOISE_MM, half_loop_mm) / SLOPE_MM_PER_TURN, rel=0.05
    )


def test_a_bent_laws_inverse_floor_is_what_the_truth_itself_leaves():
    """The mean twist at a contraction, from the noise and the law, by numbers instead of a curve."""
    dataset = strokes(curve_mm=-8.0, count=1, per_phase=2000)
    grid = np.linspace(0.0, TOP_TURNS, 4001)
    law = SLOPE_MM_PER_TURN * grid - 8.0 * np.square(grid / TOP_TURNS)
    weight = np.exp(-np.square((dataset["displacement_mm"].to_numpy()[:, None] - law) / NOISE_MM) / 2.0)
    least = rms(dataset["motor_turns"] - weight @ grid / weight.sum(axis=1))
    assert floors(dataset)["floor"][1] == pytest.approx(least, rel=0.05)


def test_few_points_do_not_make_the_floor_too_low():
    """The curve's own freedom would: with 40 points a stroke, a fifth of the noise's energy."""
    forward_floors = [floors(strokes(per_phase=40, count=3, curve_mm=6.0, seed=seed))["floor"][0] for seed in range(20)]
    assert rms(forward_floors) == pytest.approx(NOISE_MM, rel=0.05)


def test_unequal_directions_leave_the_blind_oracle_less_than_half_the_loop():
    share, half_loop_mm = 0.25 / 1.25, 0.3
    blind = floors(strokes(half_loop_mm, unwinding=0.25))["floor_blind"][0]
    expected = np.hypot(NOISE_MM, 2.0 * half_loop_mm * np.sqrt(share * (1.0 - share)))
    assert blind == pytest.approx(expected, rel=0.05) and blind < 0.85 * half_loop_mm


def test_a_lone_point_or_place_is_no_trouble():
    assert noise(np.array([3.0]), np.array([1.0])) == pytest.approx([0.0])
    still = noise(np.full(50, 2.0), np.arange(50.0))
    assert rms(still) == pytest.approx(np.arange(50.0).std(ddof=1))
    assert np.isfinite(noise(np.array([0.0, 1.0, 1.0]), np.array([0.0, 1.0, 2.0]))).all()


def test_the_oracle_sees_the_held_out_answers_and_no_model_does():
    """A single wild held-out point draws the oracle's curve towards it: what it answers depends on the answer."""
    dataset = strokes()
    held_out_row = int(np.flatnonzero(dataset["within"] == "test")[17])
    moved = dataset.copy()
    moved.loc[held_out_row, "displacement_mm"] += 1.0
    answers = [
        predictions(table, "within", *residuals(table, FLOORS["floor"])).set_index("point")["displacement_mm"]
        for table in (dataset, moved)
    ]
    assert answers[1][held_out_row] > answers[0][held_out_row] + 0.001


def test_the_floors_are_judged_as_a_model_is(tmp_path):
    dataset = strokes(0.1)
    path = tmp_path / "floor_blind" / "later-0.predictions.parquet"
    missed = residuals(dataset, FLOORS["floor_blind"])
    schemas.write(predictions(dataset, "later", *missed), schemas.PREDICTIONS, path)
    metrics = evaluate(dataset, path, "made")
    rmse = metrics[(metrics["metric"] == "rmse") & (metrics["map"] == "forward")].set_index(
        ["stroke", "phase", "angle_band"]
    )
    assert set(metrics["model"]) == {"floor_blind"} and set(metrics["stroke"]) == {"all", "4"}
    assert rmse.loc[("all", "winding", "all"), "value"] == pytest.approx(np.hypot(NOISE_MM, 0.1), rel=0.1)
    assert rmse.loc[("all", "all", "all"), "value"] == pytest.approx(rms(missed[0][dataset["later"] == "test"]))
