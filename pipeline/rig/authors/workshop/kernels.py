"""Measured responses convolved on the clock: to a step, to an impulse, to a ramp."""

from collections.abc import Callable

import numpy as np
from scipy.signal import fftconvolve

from pipeline.ground.kinematics import Array

Response = Callable[[Array], Array]


def after_steps(drive: Array, response: Response, time_s: Array, hung_s: float = 0.0) -> Array:
    """Answer to a drive of something whose answer to a unit step was measured.

    Its first value was put on `hung_s` before the clock's start.
    """
    steps = np.diff(drive, prepend=drive[0])
    return fftconvolve(steps, response(time_s))[: len(drive)] + drive[0] * response(time_s + hung_s)


def after_impulses(drive: Array, response: Array) -> Array:
    """Answer to a drive of something whose answer to one tick of drive was recorded, tick by tick."""
    return np.asarray(fftconvolve(drive, response)[: len(drive)])


def after_ramps(signal: Array, ramp_response: Response, tick_s: float, reach_s: float) -> Array:
    """A signal as a late instrument shows it whose answer to a unit ramp is known; it stood still before the start.

    Exact where the signal is straight between ticks. `reach_s` is when the instrument has caught up.
    """
    ticks = int(np.ceil(reach_s / tick_s)) + 2
    knots = np.arange(-1, ticks + 1) * tick_s
    weights = np.diff(np.where(knots > 0.0, ramp_response(np.maximum(knots, 0.0)), 0.0), 2) / tick_s
    weights[-1] += 1.0 - weights.sum()
    still = np.concatenate([np.full(ticks, signal[0]), signal])
    return np.asarray(fftconvolve(still, weights)[ticks : ticks + len(signal)])
