"""A number of a question beyond a range, in words: which number, which end, and the value of that end."""

import math
from collections.abc import Sequence

from ....ground.units import unit_of

WORDS = {
    "motor_turns": "twist", "displacement_mm": "contraction", "load_n": "load", "separator_mm": "separator",
    "length_mm": "length", "radius_mm": "radius", "torsion_zone_mm": "torsion zone",
    "stiffness_n_per_mm": "stiffness",
}  # fmt: skip
DIGITS = 4  # of a limit


def beyond(name: str, value: float, low: float, high: float, range_is: str) -> str:
    """Say that a number, in its column's unit, is beyond a range; `range_is` such as "was recorded"."""
    if name == "direction":
        way = "winding" if value > 0 else "unwinding"
        return f"{way} (direction {value:g}) is nothing that {range_is}"
    above = value > high
    limit, end = (inward(high, up=False), "most") if above else (inward(low, up=True), "least")
    return f"{with_unit(name, value)} is {'above' if above else 'below'} {limit:g}, the {end} that {range_is}"


def with_unit(name: str, value: float) -> str:
    """A number with the word of its column and its unit."""
    unit = unit_of(name)
    return f"{WORDS.get(name, name)} {value:g}{'' if unit == '1' else f' {unit}'}"


def inward(limit: float, up: bool) -> float:
    """An end of a range to four digits, rounded into the range, so that a question with that number is inside."""
    if limit == 0.0 or not math.isfinite(limit):
        return limit
    scale = 10.0 ** (DIGITS - 1 - math.floor(math.log10(abs(limit))))
    steps = round(limit * scale, 6)  # 0.55 times 10,000 is a little more than 5,500
    return (math.ceil(steps) if up else math.floor(steps)) / scale


def also(sentence: str, reason: str, between: str = "; ") -> str:
    """A sentence with one more reason."""
    return between.join(filter(None, (sentence, reason)))


def held(
    turns: float, least_mm: float, most_mm: float, conditions: Sequence[str], around: str = "", whose: str = ""
) -> str:
    """Say that a twist, in turns, is held at an end of its range, since the range only gives contractions between two.

    `conditions` are the columns of those that a question tells; `around` those, in words, around which no more was
    recorded; `whose` names the string whose range it is, if others have another.
    """
    reached = f"{inward(least_mm, up=True):g} to {inward(most_mm, up=False):g} mm"
    at_end = held_at(turns, f"{whose}{around and f' recorded around {around}'}")
    state = ["stroke", "direction", *(WORDS.get(name, name) for name in conditions)]
    return f"{at_end}: its twists give {reached} at this {', '.join(state[:-1])} and {state[-1]}"


def held_at(turns: float, of_which: str = "") -> str:
    """Say that a twist, in turns, is held at an end of the range; `of_which` follows that word."""
    return f"HELD at {turns:.4g} turns, the end of the range{of_which}"
