"""The length that a string recovers between two runs and loses with the first stroke: no wear, and no zero change.

Under load a string creeps, at rest it takes some of it back. After the break its first stroke works that out again:
the rest after the first stroke reads less than the one before it, by more than a stroke usually takes. Of a sensor that
kept its zero nobody need know it; one that was set to zero in between is tared without it (`zero.offsets_mm`).
Measured: docs/models.md, "Several runs of one string".
"""

import numpy as np

from .rests import Rests

EITHER_SIDE = 2  # strokes of each run that tell how much the rest changes from stroke to stroke
LEAST_FLOORS = 0.5  # noise floors: less than so much the rests of a few seconds cannot tell
SAME_TWIST, SAME_LOAD = 0.05, 0.05  # of the range of twist, and of the load, within which two rests compare


def alike(turns: list[float], load_n: list[float], range_turns: float) -> bool:
    """Whether rests at these twists and under these loads compare."""
    return bool(np.ptp(turns) <= SAME_TWIST * range_turns and np.ptp(load_n) <= SAME_LOAD * max(map(abs, load_n)))


def recovered_mm(before: Rests, after: Rests) -> float:
    """How much of a run's first rest was recovered in the break; 0 where the rests cannot tell.

    It takes two strokes of the run before and three of the run itself. No string takes back more than it had lost.
    """
    last, first = before.levels_mm[-EITHER_SIDE - 1 :], after.levels_mm[: EITHER_SIDE + 2]
    if len(last) <= EITHER_SIDE or len(first) <= EITHER_SIDE + 1 or not _regular(before, after):
        return 0.0
    usual_mm = 0.5 * ((last[0] - last[-1]) + (first[1] - first[-1])) / EITHER_SIDE
    lost_mm = before.levels_mm[0] - before.levels_mm[-1]
    taken_mm = min(first[0] - first[1] - usual_mm, lost_mm)
    return float(taken_mm) if taken_mm > LEAST_FLOORS * max(before.noise_mm, after.noise_mm) else 0.0


def measured_as(run: str, recovered: float, rest_turns: float) -> str:
    """Which readings tell what the string took back before a run, in mm, and what they do not tell."""
    turns = round(rest_turns, 1) + 0.0
    return (
        f"At rest, at {turns:g} turns, {run} reads {recovered:.2g} mm less after its first stroke than before it, "
        "beyond what a stroke around the break takes: the string took that back in the break, and later strokes may "
        "take more"
    )


def but_for(recovered: float, run: str, rest_turns: float) -> str:
    """The remark on the part that is not subtracted, of a run that rests at such a twist before its first stroke."""
    return f", but for {recovered:.2g} mm. {measured_as(run, recovered, rest_turns)}" if recovered else ""


def _regular(before: Rests, after: Rests) -> bool:
    """Whether a rest follows every compared stroke, all at one twist and under one load."""
    last, first = slice(-EITHER_SIDE - 1, None), slice(EITHER_SIDE + 2)
    strokes = before.after[last], after.after[first]
    turns, load_n = ([*getattr(before, name)[last], *getattr(after, name)[first]] for name in ("turns", "load_n"))
    each = strokes[1][0] == 0 and all(set(np.diff(numbers)) == {1} for numbers in strokes)
    return each and alike(turns, load_n, before.range_turns)
