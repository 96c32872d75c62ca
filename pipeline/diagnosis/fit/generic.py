"""A dictionary without physics: smooth functions of every driver. They bound from below what any model could leave.

Source: de Boor, A Practical Guide to Splines, 1978 (piecewise linear bumps).
"""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers


def hats(signal: Array, count: int) -> Array:
    """Piecewise linear bumps over a signal's range, shape (count, samples), without a unit; the signal in any unit."""
    low, high = np.percentile(signal, [0.2, 99.8])
    if high <= low:
        return np.zeros((0, len(signal)))
    place = np.clip((signal - low) / (high - low), 0.0, 1.0) * (count - 1)
    return np.maximum(1.0 - np.abs(place - np.arange(count)[:, None]), 0.0)


def around(drivers: Drivers) -> Array:
    """Sines and cosines of the motor's turn and its harmonics; none where the motor turns too little.

    Shape (columns, samples), without a unit.
    """
    if drivers.turn is None or (not drivers.levered and drivers.span < drivers.turn):
        return np.zeros((0, len(drivers.motion)))
    turn = 2.0 * np.pi * drivers.motion / drivers.turn
    return np.vstack([wave(k * turn) for k in (1, 2, 3, 4) for wave in (np.sin, np.cos)])


def groups(drivers: Drivers) -> dict[str, Array]:
    """Columns by the driver that they follow, each of shape (columns, samples). Each without a unit."""
    side = drivers.directed(0.02 * drivers.span)
    rate, sine = drivers.rate if drivers.velocity is None else drivers.smooth(drivers.rate), drivers.sine
    bases = {
        "twist": hats(drivers.motion, 14)[1:],
        "direction": np.vstack([side * hats(drivers.motion, 8), drivers.directed(0.1 * drivers.span)]),
        "time": np.vstack([hats(drivers.elapsed_s, 14)[1:], sine * hats(drivers.elapsed_s, 8)[1:]]),
        "speed": np.vstack([rate, np.abs(rate), rate * sine, np.abs(rate) * sine]),
        "angle within the turn": around(drivers),
    }
    if drivers.velocity is None:  # otherwise it is the simulator's own, and a smoother one would quiet its noise
        bases["acceleration"] = np.vstack([drivers.slope(rate), drivers.slope(rate) * sine])
    if drivers.loaded:
        load = drivers.load - np.mean(drivers.load)
        bases["load"] = np.vstack(
            [hats(drivers.load, 4)[1:], load * hats(drivers.motion, 7), load * side, load * side * sine]
        )
    if drivers.temperature_c is not None:
        kelvin = drivers.smooth(drivers.temperature_c)
        bases["temperature"] = np.vstack([kelvin - kelvin.mean(), (kelvin - kelvin.mean()) * sine])
    if drivers.current_a is not None:
        bases["current"] = drivers.smooth(drivers.current_a)[None]
    return bases


def dictionary(drivers: Drivers) -> Array:
    """All columns, shape (columns, samples). Each without a unit."""
    return np.vstack(list(groups(drivers).values()))
