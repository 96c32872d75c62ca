"""The numbers in the table above a formula's letters, and what a letter's row says of them."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from ..language.quantity import listing, number

UNUSED, UNLOADED = "not in this one", "not used here: the load did not vary"


@dataclass(frozen=True)
class Numbers:
    """The numbers in the table above the letters: strengths in their order, other numbers by their keys.

    Each as it is said, with its unit. `rms` is that of the whole effect, in the unit of the reading. `names` are those
    of the strengths; `dimensions` has by name each as it was adopted, and as run.yaml has it.
    """

    strengths: tuple[str, ...]
    others: Mapping[str, str]
    rms: float
    names: tuple[str, ...] = ()
    dimensions: Mapping[str, tuple[float, float]] = field(default_factory=dict)


def rows(pattern: str, numbers: Numbers) -> str:
    """The rows of the strengths that a letter stands for, found by a pattern of names; for a single one its value."""
    count = len(numbers.strengths)
    names = numbers.names or ("",) * count
    places = [place for place, name in enumerate(names, 1) if not numbers.names or re.search(pattern, name)]
    if not places:
        return UNLOADED if "load" in pattern and numbers.others.get("loaded") == "0" else UNUSED
    if len(places) == 1:
        return f"{numbers.strengths[places[0] - 1]}{f', row {places[0]} above' if count > 1 else ''}"
    if len(places) > 2 and places[-1] - places[0] == len(places) - 1:
        return f"rows {places[0]} to {places[-1]} above"
    return f"rows {listing([str(place) for place in places])} above"


def adopted(value_mm: float, nominal_mm: float) -> str:
    """A dimension as it was adopted, and as run.yaml has it where the two read differently."""
    value, nominal = number(value_mm, 4), number(nominal_mm, 4)
    return f"{value} mm" + (f", as adopted (measured {nominal})" if value != nominal else "")
