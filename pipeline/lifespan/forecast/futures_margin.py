"""By how much to delay a question's futures before they pass a limit: measured on strings outside the scores.

Drifts slow down more than the laws foretell. So the futures later than the median are put later still, by a power of
how many times later they are. Each power is the least of 1, 1.1 … 2, 2.5 … 4 with which the 90 % intervals of that
question held in 90 of 100 on the synthetic strings of seed 3000; docs/lifespan.md has what it gives on other seeds.

Source: Vovk, Gammerman and Shafer, Algorithmic Learning in a Random World, 2005 (calibration on data set apart).
"""

import numpy as np

from ...ground.kinematics import Array

LATER = {"stroke_loss": 1.1, "model_error": 4.0}


def middle_of(when: Array) -> float:
    """The median time at which futures pass a limit, infinite if half of them do not. Shape (futures,), in strokes."""
    return float(np.quantile(when, 0.5, method="inverted_cdf")) if len(when) else np.inf


def put_later(times: Array, middle: float, power: float) -> Array:
    """Strokes ahead, with those after the median `middle` of the futures delayed. Any shape, in strokes."""
    if not 0.0 < middle < np.inf:
        return times
    return np.where(times > middle, middle * (times / middle) ** power, times)


def later(when: Array, horizon: float, power: float) -> Array:
    """The times at which futures pass a limit, delayed after the median; infinite beyond the horizon.

    Shape (futures,), in strokes.
    """
    moved = put_later(when, middle_of(when), power)
    return np.where(moved > horizon, np.inf, moved)
