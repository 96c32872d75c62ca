"""One linearisation of a simulator: what it says beside the simulator itself."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnosis.fit.problem import Act, State
from pipeline.diagnosis.fit.slopes import column, linearised
from pipeline.diagnosis.mechanisms.library import mechanisms


@pytest.fixture
def at_work(problem):
    """A state in which an operator and something at a port act, and what is linearised there."""
    acts = tuple(
        Act(id_, (nonlinear,), tuple(size for _ in problem.terms(mechanisms()[id_], nonlinear)))
        for id_, size in (("sensor_lag", 0.02), ("creep", 0.05))
        for nonlinear in mechanisms()[id_].candidates(problem.drivers)[:1]
    )
    nominal = problem.nominal()
    state = State(nominal.values, nominal.zeros + 0.3, acts)
    return state, linearised(problem, state)


def test_what_is_linearised_is_the_simulator_at_its_state(problem, at_work):
    state, linearisation = at_work
    np.testing.assert_array_equal(linearisation.predicted, problem.simulate(state))
    assert (
        np.ptp(linearisation.predicted - linearisation.clean) > 0.1
    )  # the operator is at work, and no part of what it reads


def test_slopes_of_dimensions_are_those_of_the_simulator(problem, at_work):
    state, linearisation = at_work
    for index in problem.movable:
        parameter = problem.parameters[index]
        moved = state.values.copy()
        moved[index] += 0.02 * parameter.sigma
        by_hand = (problem.simulate(replace(state, values=moved)) - linearisation.predicted) / (0.02 * parameter.sigma)
        scale = np.abs(by_hand).max()
        np.testing.assert_allclose(linearisation.slopes[parameter.name], by_hand, atol=1e-3 * scale)


@pytest.mark.parametrize("id_", ["shaft_windup", "radius_compaction", "creep", "viscous_loss", "eccentricity"])
def test_columns_of_terms_are_what_a_little_of_them_does(problem, id_):
    mechanism, nominal = mechanisms()[id_], problem.nominal()
    nonlinear = mechanism.candidates(problem.drivers)[0]
    linearisation = linearised(problem, nominal)
    terms = problem.terms(mechanism, nonlinear)
    for number, term in enumerate(terms):
        size = 1e-4 / max(float(np.abs(term.signal).max()), 1e-9)
        act = Act(id_, (nonlinear,), tuple(size * (place == number) for place in range(len(terms))))
        by_hand = (problem.simulate(replace(nominal, acts=(act,))) - linearisation.predicted) / size
        np.testing.assert_allclose(column(problem, term, linearisation), by_hand, atol=2e-3 * np.abs(by_hand).max())
