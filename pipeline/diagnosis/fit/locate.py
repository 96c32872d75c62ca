"""Where the mismatch is: the smallest box of twist, strokes and phase that holds 80 % of its energy."""

import numpy as np
from numba import njit

from ...ground.kinematics import Array
from ..document.effects_named import Location
from ..document.made_keys import with_made
from ..recording.working_samples import PHASES
from .problem import Problem

SHARE = 0.8  # of the mismatch's energy, that its box holds
TURN_BINS, STROKE_BINS = 48, 60  # of the motion and of the strokes, in which the box is looked for


@njit(cache=True)
def _smallest(energy: Array, samples: Array, needed: float) -> tuple[float, int, int, int, int]:
    """The rectangle of a (strokes, turns) table that holds at least `needed` energy in the fewest samples."""
    best, place = 1e300, (0, energy.shape[0] - 1, 0, energy.shape[1] - 1)
    for a in range(energy.shape[0]):
        energy_by_turn, size = np.zeros(energy.shape[1]), np.zeros(energy.shape[1])
        for b in range(a, energy.shape[0]):
            energy_by_turn += energy[b]
            size += samples[b]
            if energy_by_turn.sum() < needed:
                continue
            c, inside, count = 0, 0.0, 0.0
            for d in range(energy.shape[1]):
                inside += energy_by_turn[d]
                count += size[d]
                while inside - energy_by_turn[c] >= needed and c < d:
                    inside -= energy_by_turn[c]
                    count -= size[c]
                    c += 1
                if inside >= needed and count < best:
                    best, place = count, (a, b, c, d)
    return best, place[0], place[1], place[2], place[3]


def box(mismatch: Array, problem: Problem, share: float = SHARE) -> Location:
    """The place of a mismatch, noise taken off: motion, strokes, phase, and the share of the energy within it.

    The box is the smallest that holds `share` of the energy: the whole recording with a share of 0 where there is no
    mismatch. The mismatch has the shape (samples,), in the reading's unit.
    """
    drivers = problem.drivers
    low, high = float(drivers.motion.min()), float(drivers.motion.max())
    width = max(high - low, 1e-9) / TURN_BINS
    column = np.minimum(((drivers.motion - low) / width).astype(int), TURN_BINS - 1)
    strokes = np.unique(drivers.stroke)
    per_bin = -(-len(strokes) // STROKE_BINS)
    row = np.searchsorted(strokes, drivers.stroke) // per_bin
    squared = np.square(mismatch)
    whole = float(squared.sum())
    if not 0.0 < whole < np.inf:  # nothing is anywhere: a mechanism that refining took back
        ends = [int(max(strokes[0], 1)), int(max(strokes[-1], 1))]
        nowhere: Location = {"strokes": ends, "phase": "all", "share": 0.0}
        return with_made(nowhere, {problem.system.driver: [low, high]}, "strokes")
    shape = (int(row.max()) + 1, TURN_BINS)
    best: tuple[float, Location] | None = None
    for phase in ("all", *PHASES):
        inside = np.ones(len(row), bool) if phase == "all" else drivers.phase == PHASES.index(phase)
        energy, samples = np.zeros(shape), np.zeros(shape)
        np.add.at(energy, (row[inside], column[inside]), squared[inside])
        np.add.at(samples, (row[inside], column[inside]), 1.0)
        if energy.sum() < share * whole:
            continue
        count, a, b, c, d = _smallest(energy, samples, share * whole)
        if best is None or count < best[0]:
            last = min((b + 1) * per_bin, len(strokes)) - 1
            motion = [low + c * width, low + (d + 1) * width]
            location: Location = {
                "strokes": [int(max(strokes[a * per_bin], 1)), int(max(strokes[last], 1))],
                "phase": phase,
                "share": float(energy[a : b + 1, c : d + 1].sum() / whole),
            }
            best = (count, with_made(location, {problem.system.driver: motion}, "strokes"))
    assert best is not None  # the whole recording always qualifies
    return best[1]
