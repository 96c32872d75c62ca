"""The units in our column names, and conversions of a recording's units to them."""

import difflib
import math

# What one of each unit is in the base of its quantity: turn, mm, N, Nm, s, A, Pa.
_TURN, _LENGTH, _FORCE, _TORQUE, _TIME, _CURRENT, _PRESSURE = (
    {"turns": 1.0, "rad": 1.0 / math.tau, "deg": 1.0 / 360.0},
    {"mm": 1.0, "cm": 10.0, "m": 1000.0, "um": 1e-3, "in": 25.4},
    {
        "N": 1.0,
        "kN": 1e3,
        "mN": 1e-3,
        "kgf": 9.80665,
        "gf": 9.80665e-3,
        "g": 9.80665e-3,  # g: a force on a scale
        "lbf": 4.4482216152605,
        "ozf": 0.27801385095378125,
    },
    {"Nm": 1.0, "Nmm": 1e-3},
    {"s": 1.0, "ms": 1e-3, "us": 1e-6},
    {"A": 1.0, "mA": 1e-3},
    {"Pa": 1.0, "bar": 1e5},
)
_QUANTITIES = (_TURN, _LENGTH, _FORCE, _TORQUE, _TIME, _CURRENT, _PRESSURE, {"degC": 0.0, "K": 0.0})
SAID = {  # what people write for them
    "revolution": "turns", "rev": "turns", "round": "turns", "radian": "rad", "degree": "deg", "second": "s",
    "sec": "s", "millisecond": "ms", "msec": "ms", "microsecond": "us", "\u00b5s": "us", "millimeter": "mm",
    "millimetre": "mm", "gram": "g", "gramm": "g", "grams-force": "g", "kilogram": "kgf", "kp": "kgf", "newton": "N",
    "lb": "lbf", "pound": "lbf", "pounds": "lbf", "pound-force": "lbf", "oz": "ozf", "ounce": "ozf", "ounces": "ozf",
    "kilonewton": "kN", "millinewton": "mN",
    "\u00b5m": "um", "\u03bcm": "um", "micrometer": "um", "micrometre": "um", "micron": "um",
    "inch": "in", "inches": "in",
}  # fmt: skip
UNIT_BY_ENDING = {  # by the ending of a column's name
    "_s": "s", "_turns": "turns", "_mm": "mm", "_n": "N", "_c": "degC", "_a": "A",
    "_deg": "deg", "_rad": "rad", "_nm": "Nm", "_m": "m", "_n_per_mm": "N/mm", "_v": "V", "_kg": "kg",
    "_cm": "cm", "_ms": "ms", "_pa": "Pa", "_bar": "bar", "_hz": "Hz", "_w": "W", "_k": "K",
}  # fmt: skip
UNITS = sorted({"count", "V", "W", "Hz", "kg"}.union(*_QUANTITIES))


def unit_of(column: str) -> str:
    """Unit that a column's name ends in, or "1" for a count, a label or a share; a `_turns_per_s` is in turns/s."""
    endings = [ending for ending in UNIT_BY_ENDING if column.endswith(ending)]
    if not endings:
        return "1"
    ending = max(endings, key=len)
    stem, per, _ = column.rpartition(f"_per{ending}")
    over = unit_of(stem) if per else "1"
    return UNIT_BY_ENDING[ending] if over == "1" else f"{over}/{UNIT_BY_ENDING[ending]}"


def _near(unit: str) -> str:
    """Known units close to an unknown one, as a question; empty where none is close."""
    lower = {unit_name.lower(): unit_name for unit_name in UNITS} | SAID
    close = difflib.get_close_matches(unit.lower().removesuffix("s")[:40], lower, n=3, cutoff=0.6)
    close = [unit.lower()] if unit.lower() in lower else close
    near = dict.fromkeys(lower[name] for name in close)
    return f"did you mean {' or '.join(map(repr, near))}? " if near else ""


def is_load_in_kg(column: str, unit: str | None) -> bool:
    """Whether a force is given in kg, as some load cells show it."""
    return unit == "kg" and unit_of(column) == "N"


def conversion(column: str, unit: str | None, counts_per_turn: float | None = None) -> tuple[float, float]:
    """Factor and shift that convert a value in `unit` to the unit that `column` ends in.

    A reading in V has no unit of its own to convert: the channel's scale must have made it the column's.
    Raises ValueError, with the mend in its text, for a unit that is unknown or of another quantity.
    """
    own = unit_of(column)
    if unit is None or unit == own or unit == "V":
        return 1.0, 0.0
    if unit == "count":
        if own not in _TURN:
            raise ValueError("counts belong to angles; use `scale` for what one count is, and its unit")
        if counts_per_turn is None:
            raise ValueError("counts need counts_per_turn; add it")
        return 1.0 / counts_per_turn / _TURN[own], 0.0
    if {unit, own} == {"degC", "K"}:
        return 1.0, (-273.15 if unit == "K" else 273.15)
    for quantity in _QUANTITIES:
        if unit in quantity and own in quantity:
            return quantity[unit] / quantity[own], 0.0
    if unit not in UNITS:
        raise ValueError(f"is not a known unit; {_near(unit)}known are {', '.join(UNITS)}")
    is_load = is_load_in_kg(column, unit)
    aside = ": a load cell that shows kg shows kilograms of force, so write kgf" if is_load else ""
    raise ValueError(f"does not measure what the channel is; give a unit that converts to {own}{aside}")


def ending_of(column: str, channel: str) -> str:
    """The unit at the end of a foreign column such as `slide_cm`, if the channel converts from it; else its own."""
    suffix = column.rpartition("_")[2].lower()
    for unit in UNITS:
        if unit.lower() == suffix and unit not in ("V", "count", "in"):  # x_in is an input as likely
            try:
                conversion(channel, unit)
            except ValueError:
                if not is_load_in_kg(
                    channel, unit
                ):  # which is refused: as newtons it would be wrong by a factor of 9.8
                    continue
            return unit
    return unit_of(channel)
