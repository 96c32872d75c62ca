"""Numbers of a JSON value rounded, so that it reads well and repeats exactly."""

import math
from typing import Any

import numpy as np

from .made_keys import Interval

DIGITS = 5  # more of them would be rounding, which processors do each in their own way
WIDTH_DIGITS = 2  # of an interval's width


def tidy(value: Any) -> Any:
    """A JSON value with its numbers rounded to five digits, so that it reads well and repeats exactly."""
    if isinstance(value, dict):
        return {key: tidy(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [tidy(entry) for entry in value]
    if isinstance(value, float | np.floating):
        return float(f"{value:.{DIGITS}g}") + 0.0 if np.isfinite(value) else None
    return int(value) if isinstance(value, np.integer) else value


def to_its_width(interval: Interval) -> Interval:
    """A number with its interval, rounded to two digits of the interval's width, or as `tidy` does if that is finer.

    A zero far from 0 has a width in digits that `tidy` takes off.
    """
    width = interval["high"] - interval["low"]
    if not math.isfinite(width) or width <= 0.0:
        return {"value": tidy(interval["value"]), "low": tidy(interval["low"]), "high": tidy(interval["high"])}

    def rounded(number: float) -> float:
        finer = max(_decimals(width, WIDTH_DIGITS), _decimals(number, DIGITS) if number else 0)
        return round(float(number), finer) + 0.0

    return {"value": rounded(interval["value"]), "low": rounded(interval["low"]), "high": rounded(interval["high"])}


def _decimals(number: float, digits: int) -> int:
    """How many decimals a number of so many digits has."""
    return digits - 1 - math.floor(math.log10(abs(number)))
