"""Drivers as the columns of a table: the inputs on which a method without physics may regress a residual.

Which mechanism a column stands for, the mechanism's own file says (`Mechanism.columns`). Sudden events have no driver,
and therefore no column.
"""

import numpy as np

from ...diagnosis.mechanisms.library import mechanisms
from ...diagnosis.numerics.recursions import lowpass
from ...diagnosis.recording.drivers import Drivers
from ...ground.kinematics import Array

DIRECTION = 0.02  # of the range of motion, over which a reversal is felt
WARM_S = 60.0  # over which a string keeps its heat, where nobody measured it
HIGH, LOW, END = 0.7, 0.25, 0.9  # of the highest twist, and of the contraction's range
PRODUCT = " x "  # between the names of columns that are multiplied
MORE, LESS = ", more", ", less"  # after a column's name, where the sign of its weight tells two mechanisms apart


def stands_for(column: str, weight: float) -> list[str]:
    """The ids of the mechanisms that a column with a weight stands for, as their own files say."""
    names = {column, column + (MORE if weight > 0.0 else LESS)}
    return [id_ for id_, mechanism in mechanisms().items() if names & {*mechanism.columns}]


def plain(drivers: Drivers) -> dict[str, Array]:
    """One column for each driver, by name, in its driver's unit. Shape (samples,) each."""
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
    """The plain columns, their powers and hinges, and every product of them that a mechanism's file asks for.

    Shape (samples,) each, in the units of their names.
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
        "direction when slow": side * np.exp(-np.square(rate / slow)),
        "acceleration": drivers.slope(rate),
    }
    if "temperature" not in columns:
        columns["heat"] = lowpass(np.abs(rate) * load, drivers.time_s, WARM_S, 0.0)
    wanted = {column for mechanism in mechanisms().values() for column in mechanism.columns}
    for name in sorted({column.removesuffix(MORE).removesuffix(LESS) for column in wanted}):
        factors = name.split(PRODUCT)
        if len(factors) > 1 and columns.keys() >= set(factors):  # a temperature may not have been measured
            columns[name] = np.prod([columns[factor] for factor in factors], axis=0)
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
    return np.ascontiguousarray((np.vstack(list(columns.values())).T - mean) / spread)
