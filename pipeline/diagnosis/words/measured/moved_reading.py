"""By how much an effect, or one of its numbers, moves the reading, in words and in cells of a table."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from ..language.quantity import at, said_unit, size, to_the_band
from ..language.text_table import UNKNOWN
from ..language.vocabulary import Vocabulary

UNSEEN = 0.01  # of the rms of an effect: a difference between two motions that is less is none
CANCELS = 1.5  # times the rms of the whole effect, from which a part of it cannot stand without the others
PLACES = 3  # decimals of a size in a table


@dataclass(frozen=True)
class Size:
    """An effect on the reading: rms; the value at the highest motion less that at the lowest; and these `ends`."""

    rms: float
    at_top: float
    ends: tuple[float, float]


def change(moved: Size, words: Vocabulary) -> str:
    """The head of a column: between which motions the reading changes."""
    return f"change {_way(moved, words)}"


def moves(moved: Size, words: Vocabulary, loops: bool = False) -> str:
    """By how much something moves the reading, without a full stop; the ends are left out for a loop."""
    typical, by = size(moved.rms, words.unit), cells(moved, words, moved.rms)[1]
    ends = "" if loops or by == UNKNOWN else f", and by {by} {_way(moved, words)}"
    return f"moves the reading by {typical} rms{ends}"


def cells(moved: Size, words: Vocabulary, whole_rms: float) -> list[str]:
    """By how much something moves the reading, in cells; a difference too small to see is left out."""
    least = 10.0 ** math.floor(math.log10(whole_rms)) if whole_rms > 0.0 else 0.0
    by = f"{'+' if moved.at_top > 0.0 else '-'}{_in_unit(abs(moved.at_top), least, words.unit)}"
    return [_in_unit(moved.rms, least, words.unit), by if abs(moved.at_top) > UNSEEN * whole_rms else UNKNOWN]


def not_added_up(whole: Size, each: Sequence[Size], words: Vocabulary) -> list[str]:
    """The remarks that numbers cancel, and that their column does not add up since they depend on each other.

    A difference that comes from rounding is not mentioned.
    """
    least, most = UNSEEN * whole.rms, max((moved.rms for moved in each), default=0.0)
    sizes = f"up to {size(most, words.unit)} rms each, where the whole effect is {size(whole.rms, words.unit)}"
    cancel = [f"    The numbers cancel each other in part: {sizes}."] * (len(each) > 1 and most > CANCELS * whole.rms)
    total = sum(moved.at_top for moved in each)
    ways = [cells(replace(whole, at_top=value), words, whole.rms)[1] for value in (total, whole.at_top)]
    if abs(total - whole.at_top) < least or ways[0] == ways[1] or UNKNOWN in ways:
        return cancel
    why = "what each number does depends on the others"
    return [*cancel, f"    The rows of the last column add up to {ways[0]}, not to {ways[1]}: {why}."]


def _way(moved: Size, words: Vocabulary) -> str:
    low, high = moved.ends
    return f"from {at(low, '', high - low)} to {at(high, words.motion_unit, high - low)}"


def _in_unit(value: float, least: float, unit: str) -> str:
    """A size in the common unit of its column, to a hundredth of `least`: 0.0003 mm beside 0.0268 mm."""
    shown = to_the_band(value, 0.1 * least, PLACES)
    if value > 0.0 and not shown.strip("0."):
        shown = f"less than {10.0 ** -len(shown.partition('.')[2]):g}"
    return f"{shown} {said_unit(unit)}".rstrip()
