"""The compiled recursions against slow twins."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import lsq_linear

from pipeline.diagnosis.bounded import boxed
from pipeline.diagnosis.recursions import lowpass, play, whiten


def test_play_follows_with_a_dead_band() -> None:
    motion = np.concatenate([np.linspace(0, 5, 51), np.linspace(5, 0, 51)])
    followed = play(motion, np.full(102, 0.5))
    assert followed[50] == 4.5 and followed[60] == 4.5 and followed[-1] == 0.5


def test_lowpass_settles_exactly() -> None:
    time_s = np.cumsum(np.random.default_rng(0).uniform(0.01, 0.2, 400))
    out = lowpass(np.ones(400), time_s, 2.0, 0.0)
    np.testing.assert_allclose(out, 1.0 - np.exp(-(time_s - time_s[0]) / 2.0), atol=1e-12)


def test_whitening_does_not_reach_across_runs() -> None:
    first = np.array([0, 1, 2, 0, 1, 2])
    out = whiten(np.arange(6.0)[None], np.array([0.5]), first)[0]
    assert out[3] == 3.0 and out[4] == 4.0 - 1.5


@settings(max_examples=40)
@given(seed=st.integers(0, 10_000), count=st.integers(1, 12))
def test_boxed_least_squares_is_the_bounded_optimum(seed: int, count: int) -> None:
    generator = np.random.default_rng(seed)
    a, b = generator.normal(size=(40, count)), generator.normal(size=40)
    low = np.where(generator.random(count) < 0.3, -np.inf, 0.0)
    high = np.where(generator.random(count) < 0.5, np.inf, 0.2)
    ours = boxed(a.T @ a, a.T @ b, low, high, np.zeros(count))
    best = lsq_linear(a, b, (low, high), tol=1e-12)
    assert np.sum((a @ ours - b) ** 2) <= 2.0 * best.cost + 1e-6
    assert (ours >= low - 1e-12).all() and (ours <= high + 1e-12).all()
