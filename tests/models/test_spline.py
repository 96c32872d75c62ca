"""The spline's mathematics: it rises whatever its weights, is undone by its inverse, and is fitted as it should be."""

import numpy as np
import pandas as pd
import pytest
from grown_dataset import LAWS, NOISE_MM, TOP_TURNS, grown_dataset, true_mm
from hypothesis import example, given
from hypothesis import strategies as st
from scipy import optimize

from pipeline.models.interface import make_model
from pipeline.models.parts.growth import CANDIDATES, early_and_late
from pipeline.models.parts.marquardt import least_squares
from pipeline.models.parts.networks import rational
from pipeline.models.spline import Spline


def drawn(seed: int, points: int, bins: int = 6, spread: float = 1.0) -> rational.Knots:
    """Knots of random rises and slopes, over many orders of size where the spread is large."""
    rng = np.random.default_rng(seed)
    at = np.concatenate([[0.0], np.cumsum(rng.uniform(0.2, 2.0, bins))])
    rise = np.exp(rng.normal(0.0, spread, (points, bins)))
    return rational.Knots(at, rng.normal(size=points), rise, np.exp(rng.normal(0.0, spread, (points, bins + 1))))


def one(knots: rational.Knots, row: int, points: int) -> rational.Knots:
    """The knots of one row for many points."""
    repeated = [np.repeat(part[row : row + 1], points, axis=0) for part in (knots.start, knots.rise, knots.slope)]
    return rational.Knots(knots.at, *repeated)


@given(seed=st.integers(0, 10_000), spread=st.floats(0.1, 3.0))
@example(seed=220, spread=3.0)  # steep from point to point of the grid, and nearly flat at one of them
def test_it_rises_whatever_its_weights_and_is_undone_by_its_inverse(seed: int, spread: float) -> None:
    knots = one(drawn(seed, 1, spread=spread), 0, 400)
    u = np.linspace(knots.at[0] - 2.0, knots.at[-1] + 2.0, 400)
    y = rational.value(knots, u)
    assert (np.diff(y) > 0).all()
    # where the curve is nearly flat, y has too few digits to tell u; compare there what comes out again
    back = rational.inverse(knots, y)
    np.testing.assert_allclose(rational.value(knots, back), y, rtol=1e-9, atol=1e-9)
    beside = [rational.value(knots, u + step) for step in (-1e-5, 1e-5)]
    steep = np.minimum(y - beside[0], beside[1] - y) / 1e-5 > 1e-2
    assert steep.sum() > 20
    np.testing.assert_allclose(back[steep], u[steep], atol=1e-6)


def test_it_passes_its_knots_and_goes_on_straight_beyond_them() -> None:
    knots = one(drawn(3, 1), 0, 7)
    np.testing.assert_allclose(rational.value(knots, knots.at), knots.values[0], rtol=1e-12)
    beyond = rational.value(knots, knots.at[-1] + np.arange(7.0))
    np.testing.assert_allclose(np.diff(beyond), knots.slope[0, -1], rtol=1e-12)
    before = rational.value(knots, knots.at[0] - np.arange(7.0))
    np.testing.assert_allclose(-np.diff(before), knots.slope[0, 0], rtol=1e-12)


def test_the_slopes_by_the_knots_are_those_of_small_differences() -> None:
    knots, step = drawn(5, 60), 1e-6
    u = np.random.default_rng(5).uniform(knots.at[0] - 1.0, knots.at[-1] + 1.0, 60)
    rises, slopes = rational.by_logarithms(knots, u)
    for number in range(knots.rise.shape[1]):
        more = knots.rise * np.where(np.arange(knots.rise.shape[1]) == number, np.exp(step), 1.0)
        changed = rational.value(rational.Knots(knots.at, knots.start, more, knots.slope), u)
        np.testing.assert_allclose(rises[:, number], (changed - rational.value(knots, u)) / step, atol=1e-4)
    for number in range(knots.slope.shape[1]):
        more = knots.slope * np.where(np.arange(knots.slope.shape[1]) == number, np.exp(step), 1.0)
        changed = rational.value(rational.Knots(knots.at, knots.start, knots.rise, more), u)
        np.testing.assert_allclose(slopes[:, number], (changed - rational.value(knots, u)) / step, atol=1e-4)


def test_the_damped_least_squares_finds_what_scipys_does() -> None:
    time, rng = np.linspace(0.0, 4.0, 50), np.random.default_rng(0)
    measured = 3.0 * np.exp(-0.7 * time) + rng.normal(0.0, 0.05, 50)

    def problem(p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        fallen = np.exp(-p[1] * time)
        return p[0] * fallen - measured, np.column_stack([fallen, -p[0] * time * fallen])

    ridge = np.array([0.2, 0.1])
    solution = least_squares(problem, np.array([1.0, 0.1]), ridge, 50)
    expected = optimize.least_squares(lambda p: np.append(problem(p)[0], np.sqrt(ridge) * p), [1.0, 0.1], xtol=1e-12).x
    np.testing.assert_allclose(solution, expected, rtol=1e-4)


def test_a_fit_that_starts_at_nothing_finite_is_refused() -> None:
    with pytest.raises(ArithmeticError, match="not finite"):
        least_squares(lambda p: (p * np.nan, np.eye(1)), np.ones(1), np.ones(1), 3)


def test_the_last_strokes_are_left_out_of_each_string_that_has_enough() -> None:
    table = pd.DataFrame({"string": ["a"] * 10 + ["b"] * 3, "stroke": [*range(1, 11), 1, 2, 3]})
    early, late = early_and_late(table)
    assert late["stroke"].tolist() == [8, 9, 10] and set(late["string"]) == {"a"}
    assert len(early) + len(late) == len(table)


SOON = ("saturating",)  # the others take long


def oracle_turns(test: pd.DataFrame, law: str) -> np.ndarray:
    """E[θ | x, n, direction] by the made data's own truth and noise: no model foresees the twist better."""
    grid, turns = np.linspace(0.0, TOP_TURNS, 4001), np.empty(len(test))
    for (stroke, way), rows in test.reset_index(drop=True).groupby(["stroke", "direction"]):
        curve = true_mm(grid, np.full(len(grid), way), np.full(len(grid), stroke), law)
        far = (rows["displacement_mm"].to_numpy()[:, None] - curve) / NOISE_MM
        weight = np.exp(-0.5 * (far**2 - (far**2).min(axis=1, keepdims=True)))
        turns[rows.index] = (weight @ grid) / weight.sum(axis=1)
    return turns


def rmse(error: object) -> float:
    return float(np.sqrt(np.mean(np.square(error))))


def true_of(points: pd.DataFrame, law: str) -> np.ndarray:
    return true_mm(*(points[name].to_numpy() for name in ("motor_turns", "direction", "stroke")), law)


@pytest.mark.parametrize("law", [law if law in SOON else pytest.param(law, marks=pytest.mark.long) for law in LAWS])
def test_two_strokes_ahead_it_nears_the_floor_under_each_law_of_growth(law: str) -> None:
    """n = 9 from strokes 1 to 7: at most 1.3 times the noise with two of three seeds that nothing was chosen on."""
    ratios: list[float] = []
    for seed in range(100, 103):
        if sum(ratio <= 1.3 for ratio in ratios) == 2:
            break  # the third could change nothing
        points = grown_dataset(law, seed)
        test = points[points["stroke"] == 9]
        model = Spline()
        model.fit(points[points["later"] == "train"], 0)
        floor = rmse(test["displacement_mm"] - true_of(test, law))
        ratios.append(rmse(model.forward(test) - test["displacement_mm"]) / floor)
    assert sum(ratio <= 1.3 for ratio in ratios) == 2, ratios
    assert min(ratios) > 0.97, "better than the noise: the test sees what it should not"


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "forward", "inverse"),
    [("spline", 1.05, 1.10), ("cinn", 1.10, 1.15)],
)
def test_with_the_direction_known_it_nears_the_floor_of_the_data(name: str, forward: float, inverse: float) -> None:
    ratios = []
    for seed in range(100, 105 if name == "spline" else 101):
        points = grown_dataset("power", seed, points=6700)
        test = points[points["within"] == "test"]
        model = make_model(name)
        model.fit(points[points["within"] == "train"], seed)
        floors = (
            rmse(test["displacement_mm"] - true_of(test, "power")),
            rmse(oracle_turns(test, "power") - test["motor_turns"]),
        )
        errors = rmse(model.forward(test) - test["displacement_mm"]), rmse(model.inverse(test) - test["motor_turns"])
        ratios.append([error / floor for error, floor in zip(errors, floors, strict=True)])
    middle = np.median(ratios, axis=0)
    assert middle[0] <= forward and middle[1] <= inverse, ratios
    assert np.min(ratios) > 0.97


def test_the_candidates_hold_each_kind_of_law() -> None:
    assert {law.family for law in CANDIDATES} == {"logarithm", "power", "saturating"}
    for law in CANDIDATES:
        grown = law.of(np.arange(1.0, 30.0))
        assert (np.diff(grown) > 0).all() and (np.diff(grown, 2) <= 1e-12).all()
