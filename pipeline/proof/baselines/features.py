"""Drivers as the columns of a table: all that a method without physics may regress a residual on."""

import numpy as np

from ...diagnosis.drivers import Drivers
from ...diagnosis.recursions import lowpass
from ...ground.kinematics import Array

DIRECTION = 0.02  # of the range of motion, over which a reversal is felt
WARM_S = 60.0  # over which a string keeps its heat, where nobody measured it
HIGH, LOW, END = 0.7, 0.25, 0.9  # of the highest twist, and of the contraction's range


def plain(drivers: Drivers) -> dict[str, Array]:
    """One column for each driver, by name, each of shape (samples,). Each in its driver's unit."""
    turn = 2.0 * np.pi * drivers.motion
    columns = {
        "twist": drivers.motion,
        "direction": drivers.directed(DIRECTION * drivers.span),
        "rate": drivers.rate,
        "load": drivers.load,
        "time": drivers.elapsed_s,
        "work": drivers.worked(1.0),
        "travel": drivers.path,
        "sine of the turn": np.sin(turn),
        "cosine of the turn": np.cos(turn),
    }
    if drivers.temperature_c is not None:
        columns["temperature"] = drivers.smooth(drivers.temperature_c)
    return columns


def products(drivers: Drivers) -> dict[str, Array]:
    """The plain columns and what physics would make of them: powers, products, hinges; each of shape (samples,).

    Each in the units of its name.
    """
    columns = plain(drivers)
    twist, load, rate, side = drivers.motion, drivers.load, drivers.rate, columns["direction"]
    top = float(np.percentile(twist, 99.9))
    end_mm = drivers.contraction.min() + END * np.ptp(drivers.contraction)
    slow = float(np.median(np.abs(rate)[np.abs(rate) > 0.1 * np.abs(rate).max()]))
    columns |= {
        "twist squared": twist**2,
        "high twist": np.maximum(twist - HIGH * top, 0.0),
        "low twist": np.maximum(LOW * top - twist, 0.0),
        "contraction at its end": np.maximum(drivers.contraction - end_mm, 0.0),
        "direction x twist": side * twist,
        "direction x load": side * load,
        "direction when slow": side * np.exp(-np.square(rate / slow)),
        "rate x twist": rate * twist,
        "acceleration": drivers.slope(rate),
        "load x twist": load * twist,
        "load x time": load * drivers.elapsed_s,
        "load x work": load * columns["work"],
        "travel x twist": columns["travel"] * twist,
    }
    if "temperature" not in columns:
        columns["heat"] = lowpass(np.abs(rate) * load, drivers.time_s, WARM_S, 0.0)
    return columns


def standard(columns: dict[str, Array], rows: int) -> tuple[Array, Array]:
    """Mean and spread of each column over the first rows, both of shape (columns,); a spread is never zero.

    In each column's unit.
    """
    table = np.vstack([column[:rows] for column in columns.values()])
    spread = table.std(axis=1)
    return table.mean(axis=1), np.where(spread > 1e-9, spread, 1.0)


def table(columns: dict[str, Array], mean: Array, spread: Array) -> Array:
    """The columns in standard units, shape (samples, columns)."""
    return np.ascontiguousarray(((np.vstack(list(columns.values())).T) - mean) / spread)
