"""Coils of a string by a formula of the tests' own."""

import numpy as np


def coils(turns: np.ndarray, critical: float, top: float, count: int, loop_turns: float) -> np.ndarray:
    """How many coils there are: each is born at its twist, and melts `loop_turns` below it."""
    coil_counts = np.zeros(len(turns))
    for born in np.linspace(critical, top, count, endpoint=False):
        is_there = False
        for place, twist in enumerate(turns):
            is_there = twist > born or (is_there and twist > born - loop_turns)
            coil_counts[place] += is_there
    return coil_counts
