"""The class of permanent elongation: a string that yields, and one that flows, beyond a yield point."""

from dataclasses import replace

import numpy as np
import pytest
from left_by_class import left_by_class

from pipeline.diagnosis.mechanisms.library import mechanisms


def tension(drivers, steeper: float) -> np.ndarray:
    """A tension that grows with the square of the twist, as shares of its highest."""
    pull = np.abs(drivers.load) * (1.0 + steeper * (drivers.motion / drivers.motion.max()) ** 2)
    return pull / pull.max()


@pytest.mark.parametrize("steeper", [0.8, 2.3])
@pytest.mark.parametrize("yield_point", [0.55, 0.75])
def test_what_yields_or_flows_beyond_a_point_is_in_it(problem, steeper, yield_point) -> None:
    beyond = np.maximum(tension(problem.drivers, steeper) - yield_point, 0.0)
    flowed = np.cumsum(beyond) / np.sum(beyond)
    assert left_by_class(problem, "plastic_elongation", np.maximum.accumulate(beyond)) < 0.08
    assert left_by_class(problem, "plastic_elongation", flowed) < 0.03


def test_under_one_load_nothing_yields_by_the_load_alone(problem) -> None:
    """A constant load beyond a yield point would be a straight line in time, which is drift."""
    plastic = mechanisms()["plastic_elongation"]
    drivers = replace(problem.drivers, load=np.full(len(problem.record), 1.6), loaded=False)
    names = [term.name for term in plastic.terms(drivers, plastic.candidates(drivers)[0])]
    assert any("twice" in name for name in names) and not any("flat" in name for name in names)


def test_a_shape_of_an_earlier_version_can_still_be_simulated(problem) -> None:
    plastic = mechanisms()["plastic_elongation"]
    old = {"load_power": 1.0, "work": 5.0, "loaded": 1.0}
    assert len(plastic.terms(problem.drivers, old)) > 5


def test_nothing_flows_between_two_runs(problem) -> None:
    """Hours between two runs would count as hours under the tension of the first sample after them."""
    plastic, half = mechanisms()["plastic_elongation"], len(problem.record) // 2
    late_s = problem.drivers.time_s + 36_000.0 * (np.arange(len(problem.record)) >= half)
    first = np.concatenate([np.arange(half), np.arange(len(problem.record) - half)])
    drivers = replace(problem.drivers, time_s=late_s, first=first)
    (nonlinear, *_) = plastic.candidates(problem.drivers)
    for before, after in zip(plastic.terms(problem.drivers, nonlinear), plastic.terms(drivers, nonlinear), strict=True):
        if before.name.startswith("flows"):
            assert after.signal[-1] == pytest.approx(before.signal[-1], rel=1e-3, abs=1e-3)
