"""How many samples each step of a device's time hides: this tells losses from a clock that jitters.

A loss lengthens a step by whole usual steps and shortens none, so the short steps alone show how far jitter goes. A
stamp that is late makes one step long and the next one short: the stamps of both sides together do not move. So a step
is judged by how far the mean of the stamps after it is ahead of the mean of those before it, over as many of them as
make that steadiest.
"""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ...ground.kinematics import Array

SIDES = (1, 2, 4, 8)  # so many stamps of each side are taken together
STEADY = 0.2  # usual steps: a clock whose steps are never shorter by more needs no look at neighbours
WITHIN = 0.25  # usual steps by which a leap may miss a whole number, in any clock
BEYOND = 1.35  # times as far as jitter shortens it lengthens no step
ALIKE = 1.2  # times as far as jitter shortens a leap it may shorten one with a loss
OWN = 0.15  # usual steps by which a step that hides a loss is itself longer, at least
RARE = 4000  # of so many steps one may be shorter than jitter makes it
LONG = 2.5  # samples: of a longer hole the leap is believed
AROUND = 64  # steps of each side that tell the pace
PACED = 4  # times the pace is found, each time without the samples that seem to be lost
MAYBE = 0.5  # usual steps: no leap that is smaller can be a loss
ROUNDS = 50  # holes that are near each other are taken one after the other


def lost_in(excess: Array) -> Array:
    """How many samples each step hides, mostly 0, from its length beyond the usual step.

    `excess` is in usual steps, so without unit; shapes (steps,).
    """
    lost = np.zeros(len(excess))
    if not len(excess):
        return lost
    paced = [(side, *_paced(excess, side)) for side in SIDES]
    side, level, depth = paced[0] if paced[0][2] <= STEADY else min(paced, key=lambda each: each[2])
    return _taken(excess - level, side, max(BEYOND * depth, 1.0 - max(WITHIN, min(ALIKE * depth, MAYBE))))


def _paced(excess: Array, side: int) -> tuple[Array, float]:
    """The pace around each step, without likely losses, and how far jitter sets the stamps back."""
    level = np.zeros(len(excess)) if side == 1 else _level(np.minimum(excess, 1.0))
    for _ in range(PACED if side > 1 else 0):
        level = _level(excess - _taken(excess - level, side, MAYBE))
    return level, _depth(_ahead(excess - level, side))


def _level(excess: Array) -> Array:
    """The mean of the steps around each step: the pace of a clock, or of a rig's loop, may change."""
    around = np.ones(2 * AROUND + 1)
    sums = [np.convolve(np.pad(values, AROUND), around, "valid") for values in (excess, np.ones(len(excess)))]
    return np.asarray(sums[0] / sums[1])


def _taken(excess: Array, side: int, least: float) -> Array:
    """How many samples each step hides, with the highest leaps counted first, down to leaps of size `least`."""
    lost = np.zeros(len(excess))
    for _ in range(ROUNDS):
        residual = excess - lost
        ahead = _ahead(residual, side)
        score = np.where((ahead > least) & (residual > OWN), ahead + residual, -np.inf)
        peaks = _first_highest(score, side)
        if not peaks.any():
            break
        most = residual + (residual > LONG)  # the leap also holds some of a hole beside it, and the step its own jitter
        lost[peaks] += np.maximum(1.0, np.rint(np.minimum(ahead, most)[peaks]))
    return lost


def _ahead(excess: Array, side: int) -> Array:
    """By how many usual steps the mean of `side` stamps after each step is ahead of its expected time."""
    weights = 1.0 - np.abs(np.arange(1 - side, side)) / side
    return np.convolve(np.pad(excess, side - 1), weights, "valid")


def _depth(ahead: Array) -> float:
    """How far jitter sets the stamps back, rare steps left out."""
    rank = len(ahead) // RARE
    return max(0.0, -float(np.partition(ahead, rank)[rank]))


def _first_highest(score: Array, side: int) -> Array:
    """Which steps score highest among the steps within `side` of them; of equal ones the first."""
    padded = np.pad(score, side, constant_values=-np.inf)
    windows = sliding_window_view(padded, side)
    size = len(score)
    return (score > windows[:size].max(axis=1)) & (score >= windows[side + 1 : side + 1 + size].max(axis=1))
