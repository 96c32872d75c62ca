"""The part of a model's error that each break takes back, and that each run loses again: it is fitted and set apart.

Its size over the strokes since the break is that of a creep, an exponential or a logarithm; what lasts is fitted beside
it. With that part the same at every stroke, what is left over strokes is wear.

Source: Findley, Lai and Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, 1976 (recovery).
"""

from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ..stroke_health.recovery import CALIBRATED

SETTLES = np.geomspace(0.1, 1.0, 12)  # strokes of the longest run, as shares, in which an exponential settles
BENDS = np.geomspace(0.3, 30.0, 12)  # strokes after which a logarithm bends


@dataclass(frozen=True)
class Recovering:
    """`size` mm times an exponential or a logarithm of the strokes since a break, with `scale` strokes.

    Each stroke seen is `since` strokes after the break before it, shape (strokes,).
    """

    since: Array  # (strokes,), in strokes
    size: float = 0.0
    scale: float = 1.0
    is_log: bool = False

    def at(self, since: Array) -> Array:
        """What has come since the break, in mm, after so many strokes; any shape."""
        return self.size * shape(since, self.scale, self.is_log)

    def ahead(self, ahead: Array, futures: int) -> Array:
        """What is to come of it beyond the last stroke, in mm, so many strokes `ahead`, shape (steps,).

        Every second future goes on without a break, the others have runs as long as the longest one seen. The answer
        has the shape (futures, steps).
        """
        further = self.since[-1] + ahead
        both = np.stack([self.at(further), self.at(np.minimum(further, self.since.max()))]) - self.at(self.since[-1:])
        return np.asarray(both[np.arange(futures) % 2])


def shape(since: Array, scale: float, is_log: bool) -> Array:
    """A creep of size 1 over the strokes since a break, of any shape, without a unit."""
    return np.asarray(np.log1p(since / scale) if is_log else -np.expm1(-since / scale))


def recovering(n: Array, values: Array, since: Array) -> Recovering:
    """The part of `values` over strokes n that begins anew with each break, after which each stroke is `since`.

    All of shape (strokes,); values in mm. What lasts is a constant, a logarithm and a line of the strokes beside it.
    The first strokes after a break are left out: the model was calibrated on such, and its error there has no sign.
    """
    used = since > CALIBRATED
    n, values, later = n[used] - n[0] + 1.0, values[used], since[used]
    lasts = np.column_stack([np.ones(len(n)), np.log(n), n])
    least, best = np.inf, Recovering(since)
    forms = [(float(share * since.max()), False) for share in SETTLES] + [(float(bend), True) for bend in BENDS]
    for scale, is_log in forms:
        table = np.column_stack([lasts, shape(later, scale, is_log)])
        coefficients = np.linalg.lstsq(table, values, rcond=None)[0]
        squares = float(np.square(values - table @ coefficients).sum())
        if squares < least and coefficients[-1] > 0.0:
            least, best = squares, Recovering(since, float(coefficients[-1]), scale, is_log)
    return best
