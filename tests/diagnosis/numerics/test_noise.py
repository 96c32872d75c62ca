"""Floor and colour of noise come back, although smooth columns swallow part of it."""

import numpy as np
import pytest
from scipy.signal import lfilter

from pipeline.diagnosis.numerics.noise import estimate


def test_floor_of_coloured_noise_comes_back_from_under_sixty_columns() -> None:
    generator = np.random.default_rng(3)
    rho = np.exp(-0.05 / 0.6)
    noise = 0.04 * np.sqrt(1 - rho**2) * lfilter([1.0], [1.0, -rho], generator.standard_normal(6500))[500:]
    noise = noise + 0.02 * generator.standard_normal(6000)
    phase = np.linspace(0, 1, 6000)
    columns = np.array([np.cos(np.pi * k * phase) for k in range(60)])
    target = noise + 0.5 * columns[3] + 0.2 * columns[20]
    noise_estimate = estimate(target, columns, np.arange(6000), 0.05)
    assert abs(noise_estimate.floor / np.hypot(0.04, 0.02) - 1.0) < 0.06
    assert 0.05 < noise_estimate.swallowed < 0.4


def test_a_column_of_zeros_and_the_scale_of_the_others_change_no_noise() -> None:
    generator = np.random.default_rng(5)
    columns = np.array([np.cos(np.pi * k * np.linspace(0, 1, 2000)) for k in range(8)])
    target = 0.1 * generator.standard_normal(2000) + columns[2]
    plain = estimate(target, columns, np.arange(2000), 0.05)
    scaled = np.vstack([1e4 * columns[:4], np.zeros(2000), 1e-4 * columns[4:]])
    kept = scaled.copy()
    other = estimate(target, scaled, np.arange(2000), 0.05)
    assert abs(other.floor / plain.floor - 1.0) < 1e-6 and np.allclose(other.ar, plain.ar, atol=1e-6)
    np.testing.assert_array_equal(scaled, kept)  # they are another's


@pytest.mark.parametrize(("draw", "most"), [("normal", 0.04), ("uniform", 0.04)])
def test_the_floor_of_noise_is_its_standard_deviation_whatever_its_shape(draw: str, most: float) -> None:
    generator = np.random.default_rng(3)
    noise = generator.standard_normal(4000) if draw == "normal" else generator.uniform(-(3**0.5), 3**0.5, 4000)
    columns = np.vander(np.linspace(-1.0, 1.0, 4000), 8).T.copy()
    assert estimate(noise, columns, np.arange(4000), 0.025, trim=0.25).floor == pytest.approx(1.0, abs=most)
