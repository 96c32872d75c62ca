"""Columns whose names carry another unit than the channel's, such as time_ms for time_s."""

from collections.abc import Iterable

from ...ground.units import UNITS, conversion, unit_of

TIMES = {"time_ms": "ms", "t_ms": "ms", "time_us": "us", "t_us": "us", "millis": "ms", "micros": "us"}
UNITS_OF_TIME = {"s": "s", "ms": "ms", "us": "us"}  # a column that is called by it alone is a clock, if no other is


def time_unit(column: str) -> str | None:
    """The unit in which a column of this name holds the time; None where its name does not say so."""
    return TIMES.get(column) or UNITS_OF_TIME.get(column.lower())


def _unit(name: str, column: str) -> str | None:
    """The unit in which a column of this name holds the channel `name`; None where it does not say so."""
    if name == "time_s" and (unit := time_unit(column)):
        return unit
    own = unit_of(name)
    stem = name.rpartition("_")[0]
    start, _, suffix = column.rpartition("_")
    ending = next((unit for unit in UNITS if unit.lower() == suffix and unit not in ("V", "count")), None)
    if start != stem or ending in (None, own):
        return None
    try:
        conversion(name, ending)
    except ValueError:
        return None
    return ending


def in_its_unit(name: str, columns: Iterable[object]) -> tuple[str, str] | None:
    """The only column that holds the channel `name` in another unit, and that unit; None if none or several do."""
    with_units = [(column, unit) for column in columns if isinstance(column, str) and (unit := _unit(name, column))]
    if len(with_units) > 1:
        with_units = [(column, unit) for column, unit in with_units if column.lower() not in UNITS_OF_TIME]
    return with_units[0] if len(with_units) == 1 else None
