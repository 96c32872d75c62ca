"""Noise floor and colour: the residual of a saturated model, corrected for the noise that the model itself swallows.

Source: Walker, "On periodicity in series of related terms", Proceedings of the Royal Society A 131, 1931 (colour);
Gouriéroux, Monfort and Renault, "Indirect inference", Journal of Applied Econometrics 8, 1993 (mending by drawn noise).
"""

from dataclasses import dataclass, replace

import numpy as np
from numba import njit
from scipy.linalg import cho_factor, cho_solve, solve_toeplitz

from ...ground.kinematics import Array
from .recursions import coloured, whiten, whiten_from

MEMORY_S, FEWEST, MOST = 1.2, 6, 30  # lags of the colour: those within this time, but at least and at most so many
FADING = 0.98  # per lag: factor on the autocovariance
# of noise fed through the fit; estimates of the colour, each from the last; parts of a recording
DRAWS, ROUNDS, BLOCKS = 6, 3, 40
FLAT = 0.9  # times the robust spread: noise with a smaller standard deviation is not normal
SETTLED = 300  # samples after which drawn noise no longer depends on its beginning


@dataclass(frozen=True)
class Noise:
    """Floor (standard deviation), autoregressive coefficients and standard deviation of the innovations.

    `swallowed` is the share of it that the columns beside which it was estimated took for signal, mended for.
    """

    floor: float
    ar: Array  # (lags,), without a unit
    innovation: float
    swallowed: float = 0.0


def white(floor: float) -> Noise:
    """Noise without colour."""
    return Noise(floor, np.zeros(0), floor)


@njit(cache=True)
def autocovariance(signal: Array, lags: int) -> Array:
    """Autocovariance at lags 0…lags about zero.

    From shape (samples,) to shape (lags + 1,), in the signal's unit squared.
    """
    n, out = signal.size, np.empty(lags + 1)
    for k in range(lags + 1):
        out[k] = np.dot(signal[: n - k], signal[k:]) / n
    return out


def resolution(readings: Array) -> float:
    """Smallest step between readings, in their unit; 0 where hardly any reading comes twice.

    They have the shape (samples,).
    """
    fine = 1e-7 * max(float(np.ptp(readings)), 1e-300)
    levels = np.unique(np.round(readings / fine))
    return float(np.diff(levels).min() * fine) if 1 < len(levels) < len(readings) / 4 else 0.0


def in_blocks(signal: Array, lags: int) -> list[Array]:
    """A signal cut into blocks that are well longer than its memory.

    Each of shape (samples,), in the signal's unit.
    """
    return np.array_split(signal, max(min(BLOCKS, len(signal) // (2 * (lags + 1))), 1))


def trimmed(signal: Array, lags: int, trim: float) -> Array:
    """Mean autocovariance of the quieter blocks: a share `trim` of the loudest is left out, for they hold surprises.

    From shape (samples,) to shape (lags + 1,), in the signal's unit squared.
    """
    if trim == 0.0:
        return autocovariance(signal, lags)
    blocks = np.array([autocovariance(block, lags) for block in in_blocks(signal, lags)])
    order = np.argsort(blocks[:, 0], kind="stable")
    return np.asarray(blocks[order[: max(round(len(blocks) * (1.0 - trim)), 1)]].mean(axis=0))


def from_covariance(covariance: Array) -> Noise:
    """Yule-Walker; an autocovariance that no noise can have is faded with the lag until it is possible.

    It has the shape (lags + 1,), in the noise's unit squared.
    """
    order = len(covariance) - 1
    covariance = covariance * np.concatenate([[1.0 + 1e-6], np.ones(order)])
    ar = solve_toeplitz(covariance[:-1], covariance[1:])
    while np.abs(np.roots(np.concatenate([[1.0], -ar]))).max(initial=0.0) >= 1.0:
        covariance = covariance * FADING ** np.arange(order + 1)
        ar = solve_toeplitz(covariance[:-1], covariance[1:])
    variance = float(covariance[0] - ar @ covariance[1:])
    return Noise(float(np.sqrt(covariance[0])), ar, float(np.sqrt(max(variance, 1e-6 * covariance[0]))))


def robust(residual: Array) -> Array:
    """A residual with outliers pulled to 5 robust spreads. Shape (samples,), in the residual's unit."""
    spread = 1.4826 * float(np.median(np.abs(residual - np.median(residual))))
    return np.clip(residual, -5.0 * spread, 5.0 * spread) if spread > 0 else residual


def estimate(
    target: Array, columns: Array, first: np.ndarray, step_s: float, trim: float = 0.0, seed: int = 0
) -> Noise:
    """The noise of a target after a fit of columns, shape (columns, samples).

    The columns swallow part of coloured noise; how much is found by feeding noise of the estimated colour through the
    same fit, and added back. In the reading's unit, time in s.
    """
    samples = len(target)
    order = int(np.clip(np.ceil(MEMORY_S / step_s), FEWEST, MOST))
    order = min(order, samples // 20)
    scale = np.sqrt(np.einsum("ij,ij->i", columns, columns))
    if not scale.all():
        columns, scale = columns[scale > 0], scale[scale > 0]
    per = scale[:, None]  # the columns stay as they are, for they are large: what is made of them is scaled
    whitened = np.empty(columns.shape)
    generator = np.random.default_rng(seed)
    draws = generator.standard_normal((DRAWS, samples + SETTLED))
    noise, swallowed = white(float(np.std(target))), 0.0
    covariance = np.zeros(order + 1)
    for _ in range(ROUNDS):
        whiten_from(columns, noise.ar, first, 0, whitened)
        factor = cho_factor(whitened @ whitened.T / (per * scale) + 1e-8 * np.eye(len(columns)))

        def rest(signals: Array, factor: object = factor, ar: Array = noise.ar) -> Array:
            solution = cho_solve(factor, whitened @ whiten(signals, ar, first).T / per) / per
            return np.asarray(signals - solution.T @ columns)

        own = robust(rest(target[None])[0])
        seen = trimmed(own, order, trim)
        if not covariance.any():
            covariance = seen
        for _inner in range(2):
            guess = from_covariance(covariance)
            signals = coloured(draws, guess.ar, guess.innovation)[:, SETTLED:]
            residuals = rest(signals)
            gap = np.mean(
                [autocovariance(a, order) - trimmed(b, order, trim) for a, b in zip(signals, residuals, strict=True)], 0
            )
            swallowed = float(gap[0] / max(guess.floor**2, 1e-300))
            covariance = seen + gap
        noise = from_covariance(covariance)
    noise = replace(noise, swallowed=swallowed)
    return louder(noise, own, first) if trim else noise


def louder(noise: Noise, own: Array, first: np.ndarray) -> Noise:
    """The noise of the quieter blocks, scaled to the mean loudness of all by the changes from sample to sample.

    Noise that grows loud for a while does so in its innovations; something that happened does not.
    Both of shape (samples,), in the reading's unit; `first` counts samples since the start of each run.
    """
    blocks = in_blocks(whiten(own[None], noise.ar, first)[0], len(noise.ar))
    spreads = 1.4826 * np.array([np.median(np.abs(block)) for block in blocks])
    factor = max(float(np.sqrt(np.mean(np.square(spreads)))) * flatter(blocks, spreads) / noise.innovation, 1.0)
    return replace(noise, floor=noise.floor * factor, innovation=noise.innovation * factor)


def flatter(blocks: list[Array], spreads: Array) -> float:
    """Standard deviation of noise over its robust spread: 1 for normal noise, 0.78 for a uniform one.

    A reading that hops among the steps of a coarse sensor is like that. It is that of the middle block, and 1 where it
    may be a normal one's. Blocks of shape (samples,), spreads of shape (blocks,), both in the reading's unit.
    """
    shapes = [float(np.std(block)) / spread for block, spread in zip(blocks, spreads, strict=True) if spread > 0.0]
    shape = float(np.median(shapes)) if shapes else 1.0
    return shape if shape < FLAT else 1.0
