"""Instants at which things let go."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench


def strained_instants(bench: Bench, rng: np.random.Generator, count: int) -> Array:
    """Instants at which the wound string pulls hard, one a stroke, in the run's middle; sorted, in s."""
    strokes = int(bench.stroke.max())
    middle = np.arange(2, max(3, strokes)) if strokes > 2 else np.array([1])
    chosen = np.sort(rng.choice(middle, size=min(count, len(middle)), replace=False))
    instants = []
    for stroke in chosen:
        moving_rows = np.flatnonzero((bench.stroke == stroke) & (bench.speed > 0.0))
        hard = moving_rows[bench.torque[moving_rows] > rng.uniform(0.4, 0.9) * bench.torque[moving_rows].max()]
        instants.append(bench.time_s[rng.choice(hard)])
    return np.array(instants)


def anywhen(bench: Bench, rng: np.random.Generator, count: int) -> Array:
    """Instants spread over the run whatever the motion does, in s."""
    return np.sort(rng.uniform(0.05, 0.95, count)) * bench.time_s[-1]
