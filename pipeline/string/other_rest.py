"""The rest that tells the zero of a run whose first rest is under another load than the last one of the run before.

A string whose load changes with each stroke often rested under the new run's load, or under loads about it, some
strokes before. Compared with that, the zero is known without what the string stretches between the two loads.

Source: Björck, Numerical Methods for Least Squares Problems, 1996 (a straight line over the loads). Which rests count
is our own; measured in docs/models.md, "Several runs of one string".
"""

from dataclasses import dataclass

import numpy as np

from ..ground.words.jump_notes import CARRIED, EARLIER_REST
from .recovered import SAME_LOAD, SAME_TWIST, alike
from .rests import LEAST_FLOOR_MM, Rests

LEAST_LOADS = 3  # that rests are under, for a straight line through them to be tested


@dataclass(frozen=True)
class OtherRest:
    """What an earlier run would have read at the first rest of a later one, `level_mm` relative to the model.

    `which` says by which rests, `doubt` what is unknown of it.
    """

    level_mm: float
    which: str
    doubt: str


def other_rest(earlier: Rests, after: Rests) -> OtherRest | None:
    """The latest rest of an earlier run like the first one of a run, or one carried to its load; None without."""
    turns, load_n = after.turns[0], after.load_n[0]
    for at in reversed(range(len(earlier.turns))):
        if alike([earlier.turns[at], turns], [earlier.load_n[at], load_n], earlier.range_turns):
            stroke = f"after its stroke {earlier.after[at]}" if earlier.after[at] else "before its first stroke"
            which = f"the rest of {earlier.run.run} {stroke}, under {earlier.load_n[at]:.3g} N too"
            return OtherRest(earlier.levels_mm[at], which, EARLIER_REST)
    return _carried(earlier, turns, load_n)


def _carried(earlier: Rests, turns: float, load_n: float) -> OtherRest | None:
    """The last rest at a twist, carried to a load by a straight line in load; None where the rests show no such line.

    They show it where they are under three loads at least, which enclose the other one, and stray from the line by no
    more than the noise.
    """
    near = np.abs(np.array(earlier.turns) - turns) <= SAME_TWIST * earlier.range_turns
    loads, levels_mm = np.array(earlier.load_n)[near], np.array(earlier.levels_mm)[near]
    if not len(loads) or not loads.min() <= load_n <= loads.max():
        return None
    if 1 + np.sum(np.diff(np.sort(loads)) > SAME_LOAD * np.abs(loads).max()) < LEAST_LOADS:
        return None
    slope, at_none_mm = np.polyfit(loads, levels_mm, 1)
    off_mm = np.sqrt(np.sum(np.square(levels_mm - at_none_mm - slope * loads)) / (len(loads) - 2))
    if off_mm > max(earlier.noise_mm, LEAST_FLOOR_MM):
        return None
    which = (
        f"the last rest of {earlier.run.run}, carried from {loads[-1]:.3g} to {load_n:.3g} N by the straight line of "
        f"its rests under {loads.min():.3g} to {loads.max():.3g} N ({abs(slope) * 10.0:.2g} mm per 10 N)"
    )
    return OtherRest(float(levels_mm[-1] + slope * (load_n - loads[-1])), which, CARRIED)
