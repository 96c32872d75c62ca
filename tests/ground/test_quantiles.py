"""Percentiles in pieces are numpy's, whatever the numbers, and however few of them are held."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pipeline.ground.numbers import quantiles

NUMBERS = st.floats(allow_nan=False, allow_infinity=False, width=64).filter(lambda value: abs(value) < 1e300)
Q = [0, 0.1, 0.5, 25, 50, 99.9, 100]


@pytest.fixture(autouse=True)
def few_are_held(monkeypatch):
    monkeypatch.setattr(quantiles, "HELD", 4)
    monkeypatch.setattr(quantiles, "DIGITS", (8,) * 8)  # as many passes as there can be, and small ones


def pieces(values):
    return lambda: np.array_split(values, 3)


@settings(deadline=None)
@given(st.lists(NUMBERS | st.sampled_from([0.0, -0.0, 1.0, 5e-324]), min_size=1, max_size=60))
def test_percentiles_and_the_median_are_numpys(numbers):
    values = np.array(numbers)
    assert np.array_equal(quantiles.percentiles(pieces(values), len(values), Q), np.percentile(values, Q))
    assert quantiles.median(pieces(values), len(values)) == np.median(values)


@settings(deadline=None)
@given(st.lists(st.integers(0, 1000), min_size=1, max_size=60))
def test_half_of_a_sum_is_reached_where_it_is_when_all_is_sorted(numbers):
    values = np.array(numbers, float)
    sums = np.cumsum(np.sort(values))
    assert quantiles.half_of_sum(pieces(values), len(values)) == np.sort(values)[np.searchsorted(sums, sums[-1] / 2)]


def test_it_reads_pieces_and_never_all(monkeypatch):
    read = []

    def one_by_one():
        for piece in np.array_split(np.random.default_rng(0).normal(size=10_000), 100):
            read.append(len(piece))
            yield piece

    monkeypatch.setattr(quantiles, "HELD", 200)
    values = np.concatenate(list(one_by_one()))
    read.clear()
    assert quantiles.median(one_by_one, 10_000) == np.median(values)
    assert max(read) == 100 and len(read) <= 400  # passes of a hundred pieces
