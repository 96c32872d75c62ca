"""Removes plain drag from a residual, on a rig whose reading follows derivatives: drag hides other effects there.

Source: Janot, Gautier and Brunot, "Data set and reference models of EMPS", Workshop on Nonlinear System Identification
Benchmarks, 2019 (friction, losses and inertia by one linear regression).
"""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .shared_laws import pulled_in

SLOW = (0.01, 0.1)  # of the highest rate: below it plain friction closes its loop


def drag(drivers: Drivers) -> list[Array]:
    """Columns of plain drag and of a wrong inertia: friction of two widths, losses by the rate, acceleration.

    Each of shape (samples,), at most about 1, without a unit.
    """
    rate = drivers.rate / max(float(np.percentile(np.abs(drivers.rate), 99)), 1e-300)
    sharp, blunt = (np.tanh(rate / slow) for slow in SLOW)
    return [sharp, blunt, rate, np.abs(rate), scaled(drivers.acceleration)]


def scaled(signal: Array) -> Array:
    """A signal by its largest value, so without a unit. Shape (samples,)."""
    return np.asarray(signal / max(float(np.abs(signal).max()), 1e-300))


def drag_along(drivers: Drivers) -> list[Array]:
    """Friction that changes along the travel, linearly and by the square. Each of shape (samples,), without a unit."""
    sharp, place = drag(drivers)[0], (drivers.motion - drivers.motion.min()) / drivers.span
    return [sharp * place, sharp * np.square(place)]


def leaves(residual: Array, columns: list[Array]) -> float:
    """Mean square of a residual after a linear regression, outliers pulled in, in its unit squared.

    The residual has the shape (samples,); each column the shape (all samples,), in any unit.
    """
    target = pulled_in(residual, 6.0)
    table = np.column_stack([column[: len(residual)] for column in columns])
    return float(np.mean(np.square(target - table @ np.linalg.lstsq(table, target, rcond=None)[0])))
