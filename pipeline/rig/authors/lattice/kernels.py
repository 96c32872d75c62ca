"""Loops over the fine clock that several laws share: ordinary differential equations, stepped without overshoot."""

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

Array = NDArray[np.float64]
stepped: Any = njit(cache=True)


@stepped
def relaxed(drive: Array, step_s: float, tau_s: float, start: float) -> Array:
    """A state that follows its drive with one time constant, exact for a drive that is even within a step."""
    kept = np.exp(-step_s / tau_s)
    out = np.empty_like(drive)
    state = start
    for i in range(drive.size):
        state = drive[i] + (state - drive[i]) * kept
        out[i] = state
    return out


@stepped
def play(drive: Array, half_width: Array, start: float) -> Array:
    """A follower that moves only when its drive pushes it at either end of a play, whose width may change."""
    out = np.empty_like(drive)
    state = start
    for i in range(drive.size):
        state = min(max(state, drive[i] - half_width[i]), drive[i] + half_width[i])
        out[i] = state
    return out


@stepped
def oscillation(push: Array, step_s: float, omega: float, damping: float, drag_per_mm: float) -> Array:
    """Deflection of a mass on a spring under an acceleration, with linear damping and drag by the speed squared.

    Stepped half implicitly, which neither damps nor feeds it.
    """
    out = np.empty_like(push)
    at, speed = 0.0, 0.0
    for i in range(push.size):
        loss = 2.0 * damping * omega + drag_per_mm * abs(speed)
        speed = (speed + step_s * (push[i] - omega * omega * at)) / (1.0 + step_s * loss)
        at += step_s * speed
        out[i] = at
    return out


def pink(rng: np.random.Generator, count: int, step_s: float, taus_s: tuple[float, ...]) -> Array:
    """A noise of rms 1 made of states that relax with the given time constants and are kicked at random."""
    total = np.zeros(count)
    for tau_s in taus_s:
        total += wandering(rng, count, step_s, tau_s)
    return total / np.sqrt(len(taus_s))


def wandering(rng: np.random.Generator, count: int, step_s: float, tau_s: float) -> Array:
    """A noise of rms 1 that forgets itself in `tau_s`."""
    kept = np.exp(-step_s / tau_s)
    kicks = rng.normal(size=count) * np.sqrt(1.0 - kept**2)
    return np.asarray(_summed(kicks, kept, float(rng.normal())))


@stepped
def _summed(kicks: Array, kept: float, start: float) -> Array:
    out = np.empty_like(kicks)
    state = start
    for i in range(kicks.size):
        state = state * kept + kicks[i]
        out[i] = state
    return out
