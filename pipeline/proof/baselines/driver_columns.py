"""Drivers as the columns of a table: the inputs on which a method without physics may regress a residual.

Each column says what it stands for. Sudden events have no driver, and therefore no column.
"""

from dataclasses import dataclass

import numpy as np

from ...diagnosis.numerics.recursions import lowpass
from ...diagnosis.recording.drivers import Drivers
from ...ground.kinematics import Array

DIRECTION = 0.02  # of the range of motion, over which a reversal is felt
WARM_S = 60.0  # over which a string keeps its heat, where nobody measured it
HIGH, LOW, END = 0.7, 0.25, 0.9  # of the highest twist, and of the contraction's range


@dataclass(frozen=True)
class Column:
    """One driver, of shape (samples,), and what a method may call a residual that follows it."""

    values: Array  # (samples,), in the unit of its name
    stands_for: str  # the mechanism, by its id
    if_above: str = ""  # the mechanism that a weight above 0 stands for, where the sign tells two of them apart

    def mechanism(self, weight: float) -> str:
        """The id of the mechanism that the column stands for with a weight."""
        return self.if_above if self.if_above and weight > 0.0 else self.stands_for


def plain(drivers: Drivers) -> dict[str, Column]:
    """One column for each driver, by name, in its driver's unit."""
    turn = 2.0 * np.pi * drivers.motion
    columns = {
        "twist": Column(drivers.motion, "radius_compaction"),
        "direction": Column(drivers.directed(DIRECTION * drivers.span), "backlash"),
        "rate": Column(drivers.rate, "viscous_loss"),
        "load": Column(drivers.load, "axial_elasticity"),
        "time": Column(drivers.elapsed_s, "sensor_drift"),
        "work": Column(drivers.worked(1.0), "plastic_elongation"),
        "travel": Column(drivers.path, "plastic_elongation"),
        "sine of the turn": Column(np.sin(turn), "eccentricity"),
        "cosine of the turn": Column(np.cos(turn), "eccentricity"),
    }
    if drivers.temperature_c is not None:
        columns["temperature"] = Column(drivers.smooth(drivers.temperature_c), "thermal")
    return columns


def products(drivers: Drivers) -> dict[str, Column]:
    """The plain columns and their physical combinations: powers, products, hinges, in the units of their names."""
    columns = plain(drivers)
    twist, load, rate, side = drivers.motion, drivers.load, drivers.rate, columns["direction"].values
    top = float(np.percentile(twist, 99.9))
    end_mm = drivers.contraction.min() + END * np.ptp(drivers.contraction)
    slow = float(np.median(np.abs(rate)[np.abs(rate) > 0.1 * np.abs(rate).max()]))
    columns |= {
        "twist squared": Column(twist**2, "radius_compaction"),
        "high twist": Column(np.maximum(twist - HIGH * top, 0.0), "jam", "overtwist"),
        "low twist": Column(np.maximum(LOW * top - twist, 0.0), "slack"),
        "contraction at its end": Column(np.maximum(drivers.contraction - end_mm, 0.0), "end_stop"),
        "direction x twist": Column(side * twist, "backlash"),
        "direction x load": Column(side * load, "friction_hysteresis"),
        "direction when slow": Column(side * np.exp(-np.square(rate / slow)), "stick_slip"),
        "rate x twist": Column(rate * twist, "sensor_lag"),
        "acceleration": Column(drivers.slope(rate), "load_swing"),
        "load x twist": Column(load * twist, "shaft_windup"),
        "load x time": Column(load * drivers.elapsed_s, "creep"),
        "load x work": Column(load * columns["work"].values, "stiffening"),
        "travel x twist": Column(columns["travel"].values * twist, "wear"),
    }
    if "temperature" not in columns:
        columns["heat"] = Column(lowpass(np.abs(rate) * load, drivers.time_s, WARM_S, 0.0), "thermal")
    return columns


def standard(columns: dict[str, Column], rows: int) -> tuple[Array, Array]:
    """Mean and spread of each column over the first rows, both of shape (columns,); a spread is never zero.

    In each column's unit.
    """
    table = np.vstack([column.values[:rows] for column in columns.values()])
    spread = table.std(axis=1)
    return table.mean(axis=1), np.where(spread > 1e-9, spread, 1.0)


def table(columns: dict[str, Column], mean: Array, spread: Array) -> Array:
    """The columns in standard units, shape (samples, columns)."""
    return np.ascontiguousarray((np.vstack([column.values for column in columns.values()]).T - mean) / spread)
