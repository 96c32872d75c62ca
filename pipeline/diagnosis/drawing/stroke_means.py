"""Means over whole strokes: they show slow effects, without a beat between strokes and bins of time."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from ..recording.working_samples import PHASES

LEAST, MOST = 4, 24  # strokes that make a line, and points of it: of more strokes several make one
ENOUGH = 5  # samples of a stroke in each direction


def stroke_means(drivers: Drivers, values: Array) -> Array:
    """Means of signals over whole strokes, winding and unwinding weighing alike, in order of time.

    However fast a stroke is, and however long it is held, what a direction does to it stays the same. Holds and rests
    do not count, nor does a stroke of one direction alone. `values` has the shape (signals, samples), the answer
    (signals, points), in the signals' units; no points where there are fewer than `LEAST` strokes.
    """
    last = int(drivers.stroke.max()) + 1
    sums, counts = [], []
    for phase in ("winding", "unwinding"):
        moving = (drivers.phase == PHASES.index(phase)) & (drivers.stroke > 0)
        which = drivers.stroke[moving]
        counts.append(np.bincount(which, minlength=last))
        sums.append(np.array([np.bincount(which, weights=each[moving], minlength=last) for each in values]))
    whole = np.min(counts, axis=0) >= ENOUGH
    if whole.sum() < LEAST:
        return np.zeros((len(values), 0))
    means = 0.5 * sum(total[:, whole] / count[whole] for total, count in zip(sums, counts, strict=True))
    together = -(-means.shape[1] // MOST)
    parts = np.arange(0, means.shape[1], together)
    return np.asarray(np.add.reduceat(means, parts, axis=1) / np.diff([*parts, means.shape[1]]))
