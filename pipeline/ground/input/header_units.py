"""The unit in a column's name: `angle [deg]`, `t (ms)`, `weg_mm`, `Zeit in ms`, `Kraft kgf`."""

import re

from ..units import SAID, UNITS

SIGNS = {"°": "deg", "grad": "deg", "u": "turns", "umdrehungen": "turns", "turn": "turns", "rot": "turns"}
SIGNS |= {"°c": "degC", "c": "degC", "amp": "A", "sekunden": "s", "counts": "count", "ticks": "count"}
SIGNS |= {"\u03bcs": "us", "usec": "us", "micros": "us", "millis": "ms", "n*m": "Nm", "meter": "m", "metre": "m"}
KNOWN = {**SIGNS, **SAID, **{unit.lower(): unit for unit in UNITS}}
SPACE = r"\s((?!in\s*$)[^\W\d_]{2,}|N)\s*$"  # another single letter after a space is a number's or an axis' as likely
ENDING = r"_([^_\W]+)$"
PLACES = (
    r"\[\s*([^\]]+?)\s*\]\s*$",
    r"\(\s*([^)]+?)\s*\)\s*$",
    r"\bin\s+(\S+)\s*$",
    r"/\s*([^/\s]+)\s*$",
    ENDING,
    SPACE,
)
WHOLE = {"millis": "ms", "micros": "us"}


def unit_word(text: str) -> str | None:
    """The unit that a word stands for, None if it stands for none."""
    word = text.strip().strip("[]()").lower()
    return KNOWN.get(word) or KNOWN.get(word.removesuffix("s"))


def header_unit(name: str) -> str | None:
    """The unit in a column's name, None where it has none."""
    last = re.split(r"[.\s]", name.strip().lower())[-1]
    if last in WHOLE:
        return WHOLE[last]
    for place in PLACES:
        match = re.search(place, name)
        if match and (unit := unit_word(match[1])) and (match[1], place) != ("in", ENDING):  # x_in may be an input
            return unit
    return None
