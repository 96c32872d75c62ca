"""How far a planned motion may leave the recorded range: limits of speed and of stands, and their words."""

import math
from collections.abc import Callable

SHORT_S = 1.0  # not worth a word
LONGER = 2.0  # times the longest stand that was recorded: what is slow goes on in a longer one
SLOWER = 0.5  # of the slowest stroke's speed: what lasts goes on in a slower one
OTHER = 1.25  # times as slow or as fast as any stroke: another speed, where it matters or nobody knows whether it does
NEAR = 0.1  # of the recorded range: a reversal so near a recorded one was recorded
ROOM = 0.05  # of what was recorded, or of a limit: a motion that leaves it by less stays inside, however it was rounded

STILL = 0.02  # of a load: one that varies by less stands still but for noise, and so much is no other load


def stands_still(least: float, most: float) -> bool:
    """Whether a recorded range from `least` to `most`, in one unit, is constant up to noise; 0 never is."""
    return 0.0 < most - least <= STILL * max(abs(least), abs(most)) or least == most != 0.0


def share_of_slowest(other: bool) -> float:
    """The lowest speed of a plan inside, as a share of the slowest stroke's; `other`: new speeds count sooner."""
    return 1.0 / OTHER if other else SLOWER


def least_speed(slowest: float, other: bool) -> float:
    """The speed from which on a plan is inside, room included, in the unit of the slowest stroke's speed."""
    return (1.0 - ROOM) * share_of_slowest(other) * slowest


def most_speed(fastest_stroke: float, fastest: float, other: bool) -> float:
    """The speed up to which a plan is inside, room included; by the fastest stroke and the fastest moment."""
    return (1.0 + ROOM) * (min(OTHER * fastest_stroke, fastest) if other else fastest)


def longest_stand_s(longest_s: float) -> float:
    """How long a hold or a rest is inside, room included, in s, by the longest that was recorded."""
    return max((1.0 + ROOM) * LONGER * longest_s, SHORT_S)


def from_on(limit: float) -> str:
    """A lower limit with three digits, rounded up, so that the stated value is inside."""
    return _said(limit, math.ceil)


def up_to(limit: float) -> str:
    """An upper limit with three digits, rounded down, so that the stated value is inside."""
    return _said(limit, math.floor)


def _said(limit: float, whole: Callable[[float], int]) -> str:
    if not limit > 0.0:
        return "0"
    step = 10.0 ** (math.floor(math.log10(limit)) - 2)
    return f"{whole(limit / step) * step:.6g}"
