"""Where a mismatch sits: the smallest box of twist × strokes × phase that holds four fifths of its energy."""

import numpy as np
from numpy.typing import NDArray

from ..ground.kinematics import Array
from .perform import Performed
from .sealed import Box

SHARE = 0.80
BINS = 24  # of the twist
PHASES = ("winding", "hold", "unwinding", "rest", "all")


def location(performed: Performed, residual_mm: Array) -> Box:
    """The box as `location` in `diagnosis.json` has it (diagnosis/fit/locate.py); its size is its number of samples.

    The residual has the shape (samples,), in mm.
    """
    edges = np.linspace(performed.motor_turns.min(), performed.motor_turns.max(), BINS + 1)
    turn = np.clip(np.searchsorted(edges, performed.motor_turns, side="right") - 1, 0, BINS - 1)
    energy, whole = np.square(residual_mm), float(np.square(residual_mm).sum())
    strokes = int(performed.stroke.max()) + 1
    best: Box = {}
    least = np.inf
    for phase in PHASES:
        in_phase = np.full(len(turn), True) if phase == "all" else performed.phase == phase
        energy_inside = _summed(turn[in_phase], performed.stroke[in_phase], energy[in_phase], strokes)
        size = _summed(turn[in_phase], performed.stroke[in_phase], np.ones(in_phase.sum()), strokes)
        size = np.where(energy_inside >= SHARE * whole, size, np.inf)
        if size.min() < least:
            least = float(size.min())
            low, high, first, last = np.unravel_index(int(size.argmin()), size.shape)
            best = {
                "motor_turns": [float(edges[low]), float(edges[high + 1])],
                "strokes": [int(first), int(last)],
                "phase": phase,
                "share": float(energy_inside[low, high, first, last] / whole),
                "of_samples": least / len(turn),
            }
    return best


def _summed(turn: NDArray[np.intp], stroke: NDArray[np.intp], value: Array, strokes: int) -> Array:
    """Sum over every box, shape (lowest bin, highest bin, first stroke, last stroke); no box is inside out."""
    table = np.zeros((BINS + 1, strokes + 1))
    np.add.at(table, (turn + 1, stroke + 1), value)
    table = table.cumsum(0).cumsum(1)
    low, high = table[:-1], table[1:]
    rows = high[None, :, :] - low[:, None, :]  # (low, high, strokes + 1)
    boxes = rows[:, :, None, 1:] - rows[:, :, :-1, None]
    proper = np.triu(np.ones((BINS, BINS), bool))[:, :, None, None] & np.triu(np.ones((strokes, strokes), bool))
    return np.where(proper, boxes, 0.0)
