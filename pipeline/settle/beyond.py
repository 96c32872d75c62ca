"""The samples of a made run beside the simulator without a mechanism: data for a figure and for the page."""

import numpy as np

from ..ground.kinematics import Array
from .proposed import Curves

STANDS_TURNS = 0.02
SMOOTH_S = 0.25  # over which a recording is averaged before the small differences are drawn


def zero_mm(turns: Array, reading_mm: Array) -> float:
    """The reading before the motor began to move: a single first sample would carry its noise into all others.

    Both of shape (samples,).
    """
    moved = np.flatnonzero(np.abs(turns - turns[0]) > STANDS_TURNS)
    return float(np.median(reading_mm[: max(1, int(moved[0]) if len(moved) else len(turns))]))


def simulated_mm(curves: Curves, at_s: Array, turns: Array) -> Array:
    """The simulator without a mechanism at the motor's true twist, shape (samples,).

    Its curve over the twist is taken under the load that hangs then: a motor that runs a moment late is no effect.
    """
    time_s, load = np.array(curves["time_s"]), np.array(curves["load"])
    foretold_turns, foretold_mm = np.array(curves["motor_turns"]), np.array(curves["calibrated"])
    hangs = np.interp(at_s, time_s, load)
    reading_mm = np.interp(at_s, time_s, foretold_mm)
    for load_n in np.unique(load):
        under = load == load_n
        order = np.argsort(foretold_turns[under], kind="stable")
        under_load = np.abs(hangs - load_n) <= 1e-9 * max(abs(load_n), 1.0)
        reading_mm[under_load] = np.interp(turns[under_load], foretold_turns[under][order], foretold_mm[under][order])
    return reading_mm
