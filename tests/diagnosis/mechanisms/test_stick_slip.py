"""Jerks of a string that sticks come at any twist; those of coils come past a critical twist alone."""

import numpy as np
import pytest
from coils_made import coils

from pipeline.diagnosis.mechanisms.library import mechanisms


def sticking(problem) -> np.ndarray:
    """A residual that falls behind the motion and slips ahead by chance, in mm."""
    generator, predicted = np.random.default_rng(3), problem.drivers.contraction
    behind, way, residual = 0.0, 1.0, np.zeros(len(predicted))
    for place in range(1, len(predicted)):
        moved = predicted[place] - predicted[place - 1]
        way = np.sign(moved) if abs(moved) > 1e-3 else way
        behind += 0.5 * abs(moved)
        behind = 0.0 if behind > 0.06 * generator.uniform(0.6, 1.2) else behind
        residual[place] = -behind * way
    return residual


def coiling(problem) -> np.ndarray:
    """A residual that leaps ahead with each coil that is born, and back with each that melts, in mm."""
    turns = problem.drivers.motion
    return 0.1 * coils(turns, 0.6 * turns.max(), turns.max(), 16, 0.09 * turns.max())


@pytest.mark.parametrize(("jerks", "seen"), [(sticking, True), (coiling, False)])
def test_jerks_past_a_critical_twist_alone_are_no_sticking(problem, jerks, seen) -> None:
    noise = 0.006 * np.random.default_rng(4).standard_normal(len(problem.record))
    residual, predicted = jerks(problem) + noise, problem.drivers.contraction
    stick_slip = mechanisms()["stick_slip"]
    assert stick_slip.mark(problem.drivers, residual, predicted) == 6.0
    assert (stick_slip.random(problem.drivers, residual, predicted) is not None) == seen
