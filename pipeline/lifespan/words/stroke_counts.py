"""Whole strokes in words: lower bounds are rounded down and upper bounds up, so that neither promises too much."""

import math

from ...ground.words.counts import counted

HAIR = 1e-6  # of a stroke: what arithmetic adds to a whole number makes it no other


def at_least(strokes: float) -> str:
    """A lower bound, or a stroke that is not reached: `9` of 9.52."""
    return f"{math.floor(strokes + HAIR)}"


def at_most(strokes: float) -> str:
    """An upper bound: `10` of 9.52."""
    return f"{math.ceil(strokes - HAIR)}"


def strokes_at_least(bound: float) -> str:
    """A lower bound with its word: `1 stroke` of 1.7."""
    return strokes(int(at_least(bound)))


def strokes_at_most(bound: float) -> str:
    """An upper bound with its word."""
    return strokes(int(at_most(bound)))


def strokes(count: int) -> str:
    """A number of strokes: `1 stroke`, `4 strokes`."""
    return counted(count, "stroke")
