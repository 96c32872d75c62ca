"""What a string took back between two runs and lost again with the first stroke: no wear, and no move of the zero.

Under load a string creeps, at rest it takes some of it back. After the break its first stroke works that out again:
the rest after the first stroke reads less than the one before it, by more than a stroke usually takes. Of a sensor that
kept its zero nobody need know it; one that was set to zero in between is tared without it (`zero.offsets_mm`).
Measured: docs/models.md, "Several runs of one string".
"""

import numpy as np

from .rests import Rests

EITHER_SIDE = 2  # strokes of each run that tell how much the rest changes from stroke to stroke
SHOWN_MM = 0.001  # the least that is said
SAME_TWIST, SAME_LOAD = 0.05, 0.05  # of the range of twist, and of the load, within which two rests compare


def alike(turns: list[float], load_n: list[float], range_turns: float) -> bool:
    """Whether rests at these twists and under these loads compare."""
    return bool(np.ptp(turns) <= SAME_TWIST * range_turns and np.ptp(load_n) <= SAME_LOAD * max(map(abs, load_n)))


def recovered_mm(before: Rests, after: Rests) -> float:
    """How much of what the first rest of a run reads was taken back in the break; 0 where the rests cannot tell.

    It takes two strokes of the run before and three of the run itself. No string takes back more than it had lost.
    """
    last, first = before.levels_mm[-EITHER_SIDE - 1 :], after.levels_mm[: EITHER_SIDE + 2]
    if len(last) <= EITHER_SIDE or len(first) <= EITHER_SIDE + 1 or not _regular(before, after):
        return 0.0
    usual_mm = 0.5 * ((last[0] - last[-1]) + (first[1] - first[-1])) / EITHER_SIDE
    lost_mm = before.levels_mm[0] - before.levels_mm[-1]
    return float(np.clip(first[0] - first[1] - usual_mm, 0.0, max(lost_mm, 0.0)))


def but_for(recovered: float) -> str:
    """What is said, after what is taken off, of what is left in."""
    back = f"the {recovered:.2g} mm that the string took back in the break and lost again with its first stroke"
    return f", but for {back}" if recovered >= SHOWN_MM else ""


def _regular(before: Rests, after: Rests) -> bool:
    """Whether a rest follows every stroke that is compared, all of them at one twist and under one load."""
    last, first = slice(-EITHER_SIDE - 1, None), slice(EITHER_SIDE + 2)
    strokes = before.after[last], after.after[first]
    turns, load_n = ([*getattr(before, name)[last], *getattr(after, name)[first]] for name in ("turns", "load_n"))
    each = strokes[1][0] == 0 and all(set(np.diff(numbers)) == {1} for numbers in strokes)
    return each and alike(turns, load_n, before.range_turns)
