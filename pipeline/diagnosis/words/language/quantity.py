"""Numbers as a person reads them: two or three digits, a unit that suits, no exponents."""

import math
import re
from collections.abc import Sequence

from ....ground.words.counts import listing as listing  # its home is below: models make lists of words too

SMALLER = {"mm": "µm", "m": "mm", "cm": "µm", "N": "mN", "Nm": "mNm", "V": "mV", "A": "mA", "rad": "mrad", "s": "ms"}
FACTOR = {"cm": 1e4}  # 1e3 else
NEAR_0 = 0.01  # of an axis: what is nearer to 0 is said to be there
LEAST = 1e-3  # in a unit, below which the smaller one reads better


def number(value: float, digits: int = 2, whole: bool = False) -> str:
    """A number with that many digits and no exponent: 0.034, 5.3, 120, 5,300; `whole` keeps zeros: 0.10."""
    rounded = float(f"{value:.{digits}g}")
    if rounded == 0.0:
        return "0"
    if abs(rounded) < 1e-6:
        mantissa, exponent = f"{rounded:.{digits - 1}e}".split("e")
        return f"{mantissa} × 10^{int(exponent)}"
    decimals = max(digits - 1 - math.floor(math.log10(abs(rounded))), 0) if whole else 0
    while decimals < 9 and round(rounded, decimals) != rounded:
        decimals += 1
    return f"{rounded:,.{decimals}f}"


def said_unit(unit: str) -> str:
    """A unit as it is written: `mm/10 N` for `mm/10N`, `mm/turn²` for `mm/turn^2`; nothing for a share or a count."""
    if unit in ("", "1"):
        return ""
    unit = re.sub(r"([A-Za-z])\^?2\b", r"\1²", unit)
    return re.sub(r"([0-9.]+)([A-Za-z])", r"\1 \2", unit)


def size(value: float, unit: str) -> str:
    """A measured size with its unit: two digits, zeros included."""
    return quantity(value, unit, whole=True)


def quantity(value: float, unit: str, digits: int = 2, whole: bool = False) -> str:
    """A number with its unit, or with a smaller unit where that reads better; nothing but the number for a share."""
    if unit in SMALLER and 0.0 < abs(value) < LEAST:
        value, unit = value * FACTOR.get(unit, 1e3), SMALLER[unit]
    shown = number(value, digits, whole)
    return f"{shown} {said_unit(f'turn{unit[5:]}' if shown == '1' and unit.startswith('turns') else unit)}".strip()


def plus_minus(value: float, half_width: float, unit: str) -> str:
    """A number with half of its interval, to the first digit of that, or two where it begins with 1: 0.42 ± 0.06 mm."""
    if unit in SMALLER and 0.0 < max(abs(value), half_width) < LEAST:
        factor = FACTOR.get(unit, 1e3)
        value, half_width, unit = value * factor, half_width * factor, SMALLER[unit]
    exponent = math.floor(math.log10(half_width)) if half_width > 0.0 else -3
    first = math.floor(half_width / 10.0**exponent + 1e-9)
    decimals = max((1 if first == 1 else 0) - exponent, 0)
    return f"{value:,.{decimals}f} ± {half_width:,.{decimals}f} {said_unit(unit)}".strip()


def of_column(value: float, unit: str, highest: float, digits: int = 2) -> str:
    """A size in a column whose highest is known: in the unit of that one, so that no column mixes two units."""
    small = abs(value) < LEAST <= abs(highest)
    if small:
        return f"{number(value, digits, whole=True)} {said_unit(unit)}".strip()
    return quantity(value, unit, digits, whole=True)


def to_tell(values: Sequence[float], apart: float, unit: str) -> list[str]:
    """Numbers to the second digit of their difference, to four digits at most, each with as many decimals."""
    highest = max(abs(value) for value in values)
    if not apart > 0.0 or highest < LEAST:
        return [quantity(value, unit, 4) for value in values]
    places = max(min(1 - math.floor(math.log10(apart)), 3 - math.floor(math.log10(highest))), 0)
    return [f"{value:,.{places}f} {said_unit(unit)}".strip() for value in values]


def to_the_band(value: float, half_width: float, digits: int = 6) -> str:
    """A number with one decimal more than the first digit of half its interval; without one, that many digits."""
    if not half_width > 0.0:
        return f"{value + 0.0:.{digits}g}"
    shown = f"{value:.{min(max(1 - math.floor(math.log10(half_width)), 0), 9)}f}"
    return shown if float(shown) else shown.removeprefix("-")  # no -0.0


def span(low: float, high: float, unit: str, whole: float) -> str:
    """A range on an axis `whole` wide."""
    return f"{at(low, '', whole)} to {re.sub('^1 turn(?!s)', '1 turns', at(high, unit, whole))}"


def ends(low: float, high: float, unit: str, digits: int = 3) -> str:
    """A range of a quantity, so many digits each, said as one where both read alike: 17.4 N, 1.3 to 4.1 turns/s."""
    least, most = number(low, digits), quantity(high, unit, digits)
    return most if most.startswith(f"{least} ") else f"{least} to {re.sub('^1 turn(?!s)', '1 turns', most)}"


def at(value: float, unit: str, whole: float) -> str:
    """A place on an axis `whole` wide, to a hundredth of the axis or finer; a value that is nearly 0 is written 0."""
    decimals = -math.floor(math.log10(whole / 100.0)) if whole > 0.0 else 3
    shown = number(round(value, decimals), 12)
    return f"{shown} {said_unit(f'turn{unit[5:]}' if shown == '1' and unit.startswith('turns') else unit)}".strip()


def place_near(value: float, unit: str, whole: float) -> str:
    """A place on an axis `whole` wide, for use after `near`; within a hundredth of the axis from 0 it is 0."""
    return at(0.0, unit, whole) if abs(value) < NEAR_0 * whole else quantity(value, unit)


def duration(seconds: float) -> str:
    """A time as a clock shows it: 0.5 s, 30 s, 2 min, 2 min 30 s."""
    if seconds < 10.0:
        return f"{number(seconds)} s"
    whole = round(seconds)
    if whole < 120:
        return f"{whole} s"
    minutes, rest = divmod(whole, 60)
    return f"{minutes} min" + (f" {rest} s" if rest else "")


def times(ratio: float) -> str:
    """How many times: 1.0, 2.4, 12, 140."""
    return f"{ratio:.1f}" if ratio < 10.0 else number(ratio)


def percent(share: float) -> str:
    """A share as `26 %`; a share that would round to 0 or 100 is written as less or more."""
    if 0.0 < share < 0.01:
        return "less than 1 %"
    return "more than 99 %" if 0.99 < share < 1.0 else f"{100.0 * share:.0f} %"


def reaches(share: float, limit: float) -> bool:
    """Whether a share is at least a limit, as a page prints both: 0.796 is 80 %."""
    return round(100.0 * share) >= round(100.0 * limit)


def first_upper(phrase: str) -> str:
    """A phrase as a sentence begins."""
    return f"{phrase[:1].upper()}{phrase[1:]}"
