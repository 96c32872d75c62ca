"""A search asks for what many explanations leave at once; one by one it gives the same."""

import numpy as np
import pytest

from pipeline.diagnosis.choice.search import Search
from pipeline.diagnosis.fit.linear import Linear
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.numerics.noise import white

IDS = ("axial_elasticity", "creep", "sensor_drift")
SETS = [("creep",), ("sensor_drift", "creep"), ("axial_elasticity", "sensor_drift")]


@pytest.fixture
def linear(problem):
    catalogue = {id_: mechanisms()[id_].candidates(problem.drivers)[:2] for id_ in IDS}
    return lambda: Linear(problem, problem.nominal(), white(0.05), catalogue)


def test_what_is_explained_at_once_is_what_is_explained_one_by_one(linear):
    at_once, one_by_one = Search(linear()), Search(linear())
    for explanation, ids in zip(at_once.explained(SETS), SETS, strict=True):
        alone = one_by_one.explain(ids)
        assert (
            explanation.ids == alone.ids == tuple(sorted(ids))
            and explanation.keys == alone.keys
            and explanation.cost == alone.cost
        )
        assert explanation.energy == pytest.approx(alone.energy, rel=1e-9)


def test_what_an_explanation_leaves_is_what_is_left_of_the_samples(linear):
    search = Search(linear())
    explanation = search.explain(SETS[1])
    plain = search.linear.plain(explanation.fit.columns)
    residual = search.linear.table[-1] - plain.coefficients @ search.linear.table[plain.columns]
    assert explanation.energy == pytest.approx(float(np.mean(np.square(residual))), rel=1e-6)


def test_known_are_the_asked_sets_and_the_smaller_ones_that_they_stand_on(linear):
    search = Search(linear())
    search.explained(SETS)
    assert {explanation.ids for explanation in search.known} == {
        ("axial_elasticity",),
        ("creep",),
        ("sensor_drift",),
    } | {tuple(sorted(ids)) for ids in SETS}
