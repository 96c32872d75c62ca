"""The compiled recursions against slow twins."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.optimize import lsq_linear
from scipy.signal import lfilter

from pipeline.diagnosis.numerics.bounded import boxed
from pipeline.diagnosis.numerics.recursions import CACHED, coloured, lowpass, play, resonator, whiten, whiten_from


def test_play_follows_with_a_dead_band() -> None:
    motion = np.concatenate([np.linspace(0, 5, 51), np.linspace(5, 0, 51)])
    followed = play(motion, np.full(102, 0.5))
    assert followed[50] == 4.5 and followed[60] == 4.5 and followed[-1] == 0.5


def test_lowpass_settles_exactly() -> None:
    time_s = np.cumsum(np.random.default_rng(0).uniform(0.01, 0.2, 400))
    out = lowpass(np.ones(400), time_s, 2.0, 0.0)
    np.testing.assert_allclose(out, 1.0 - np.exp(-(time_s - time_s[0]) / 2.0), atol=1e-12)


@pytest.mark.parametrize("hz", [0.5, 5.0, 20.0, 29.0])
def test_a_resonator_keeps_its_distance_from_a_drive_at_constant_rate_however_coarse_the_steps_are(hz: float) -> None:
    time_s, damping, rate = np.arange(0.0, 60.0, 0.015), 0.15, 7.0
    position, velocity = resonator(rate * time_s, time_s, np.full(len(time_s), hz), damping)
    ended = time_s > 40.0  # what its start from rest made has died away
    omega = 2.0 * np.pi * hz
    np.testing.assert_allclose((rate * time_s - position)[ended], 2.0 * damping * rate / omega, rtol=1e-6)
    np.testing.assert_allclose(velocity[ended], rate / omega, rtol=1e-6)


def test_a_resonator_answers_as_the_equation_does_whatever_the_steps() -> None:
    hz, damping = 3.0, 0.1
    corners_s, corners = np.array([0.0, 1.0, 1.7, 3.0]), np.array([0.0, 2.0, -1.0, -1.0])
    steps_s = np.random.default_rng(5).uniform(0.01, 0.06, 200)
    time_s = np.unique(np.r_[corners_s, np.cumsum(steps_s)])
    time_s = time_s[time_s <= 3.0]
    drive = np.interp(time_s, corners_s, corners)
    omega = 2.0 * np.pi * hz

    def moves(at_s: float, state: np.ndarray) -> list[float]:
        pull = omega**2 * (np.interp(at_s, corners_s, corners) - state[0])
        return [state[1], pull - 2.0 * damping * omega * state[1]]

    true = solve_ivp(moves, (0.0, 3.0), [0.0, 0.0], t_eval=time_s, rtol=1e-9, atol=1e-11, max_step=0.01).y
    position, velocity = resonator(drive, time_s, np.full(len(time_s), hz), damping)
    np.testing.assert_allclose(position, true[0], atol=1e-6)
    np.testing.assert_allclose(velocity, true[1] / omega, atol=1e-6)


def test_whitening_does_not_reach_across_runs() -> None:
    first = np.array([0, 1, 2, 0, 1, 2])
    out = whiten(np.arange(6.0)[None], np.array([0.5]), first)[0]
    assert out[3] == 3.0 and out[4] == 4.0 - 1.5


@pytest.mark.parametrize(("start", "samples"), [(0, 40), (3, 60), (25, 75), (91, 9)])
def test_a_whitened_stretch_is_that_of_the_plain_sum(start: int, samples: int) -> None:
    generator = np.random.default_rng(2)
    columns, ar = generator.standard_normal((3, 100)), np.array([0.5, -0.2, 0.1, 0.05, 0.02, 0.1, 0.03])
    first = np.r_[np.arange(30), np.arange(70)]
    plain = columns.copy()
    for i in range(100):
        for lag in range(1, min(first[i], len(ar)) + 1):
            plain[:, i] -= ar[lag - 1] * columns[:, i - lag]
    out = np.empty((3, samples))
    whiten_from(columns, ar, first, start, out)
    np.testing.assert_allclose(out, plain[:, start : start + samples], atol=1e-14)


def test_a_long_column_is_whitened_in_parts_and_no_part_shows() -> None:
    count = 2 * CACHED + 100
    column = np.random.default_rng(3).standard_normal((1, count))
    plain = column - 0.7 * np.r_[0.0, column[0, :-1]]
    np.testing.assert_allclose(whiten(column, np.array([0.7]), np.arange(count)), plain, atol=1e-14)


def test_drawn_noise_has_the_colour_that_a_filter_gives() -> None:
    draws, ar = np.random.default_rng(4).standard_normal((2, 500)), np.array([0.6, -0.2, 0.1])
    np.testing.assert_allclose(coloured(draws, ar, 0.3), lfilter([0.3], np.r_[1.0, -ar], draws, axis=1), atol=1e-14)
    np.testing.assert_allclose(whiten(coloured(draws, ar, 0.3), ar, np.arange(500)), 0.3 * draws, atol=1e-13)


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
