"""The length that a string recovers between two runs and loses with the next strokes: no wear, and no zero change.

Under load a string creeps, at rest it takes some of it back. After the break its strokes work that out again: the rest
after each reads less than the one before it, by more than a stroke usually takes. Of a sensor that kept its
zero nobody need know it; one that was set to zero in between is tared without it (`zero.offsets_mm`).

Source: Findley, Lai and Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, 1976 (recovery after creep).
The rule is our own; measured in docs/models.md, "Several runs of one string".
"""

from dataclasses import dataclass

import numpy as np

from .rests import Rests

USUAL = 2  # last strokes of each run that tell how much the rest changes from stroke to stroke
LEAST, MOST = 3, 8  # strokes of the run itself: with fewer nothing is told, and later ones lose nothing of it
LEAST_FLOORS = 0.5  # noise floors: less than so much the rests of a few seconds cannot tell
LOST = 3.0  # times what the run before lost: more does not come back, though the string may have hung before
SAME_TWIST, SAME_LOAD = 0.05, 0.05  # of the range of twist, and of the load, within which two rests compare


def alike(turns: list[float], load_n: list[float], range_turns: float) -> bool:
    """Whether rests at these twists and under these loads compare."""
    return bool(np.ptp(turns) <= SAME_TWIST * range_turns and np.ptp(load_n) <= SAME_LOAD * max(map(abs, load_n)))


@dataclass(frozen=True)
class Recovered:
    """What a string took back in the break before a run: `mm`, as its first `strokes` lost it again.

    `rest_turns` is the twist of the rests that tell it.
    """

    run: str
    mm: float = 0.0
    strokes: int = 0
    rest_turns: float = 0.0

    @property
    def sentence(self) -> str:
        """Which readings tell it; empty where nothing was taken back."""
        if not self.mm:
            return ""
        turns = round(self.rest_turns, 1) + 0.0
        first = "its first stroke" if self.strokes == 1 else f"its first {self.strokes} strokes"
        return (
            f"The string took back {self.mm:.2g} mm in the break: at rest, at {turns:g} turns, {self.run} reads so "
            f"much less after {first} than before, beyond what a stroke usually takes."
        )


NOTHING = Recovered("")  # where no two runs are compared


def recovered(before: Rests, after: Rests) -> Recovered:
    """How much of a run's first rest was recovered in the break; 0 mm where the rests cannot tell.

    It takes two strokes of the run before and three of the run itself.
    """
    name, last, first = after.run.run, before.levels_mm[-USUAL - 1 :], _first(before, after)
    if len(last) <= USUAL or len(first) <= LEAST or not _regular(before, slice(-USUAL - 1, None)):
        return Recovered(name)
    end_mm, later_mm = ((levels[-USUAL - 1] - levels[-1]) / USUAL for levels in (last, first))
    usual_mm = max(min(end_mm, 0.5 * (end_mm + later_mm)), 0.0)
    beyond_mm = first[0] - np.array(first[1:]) - usual_mm * np.arange(1, len(first))
    least_mm = LEAST_FLOORS * max(before.noise_mm, after.noise_mm)
    mm = min(float(beyond_mm.max()), LOST * (before.levels_mm[0] - before.levels_mm[-1]))
    if mm <= least_mm:
        return Recovered(name)
    strokes = 1 + int(np.argmax(beyond_mm > beyond_mm.max() - least_mm))
    return Recovered(name, mm, strokes, after.turns[0])


def _first(before: Rests, after: Rests) -> tuple[float, ...]:
    """The first rests of a run that compare with the last ones of the run before."""
    turns, load_n = before.turns[-USUAL - 1 :], before.load_n[-USUAL - 1 :]
    for count in range(min(MOST + 1, len(after.after)), LEAST, -1):
        part = slice(count)
        both = [*turns, *after.turns[part]], [*load_n, *after.load_n[part]]
        if after.after[0] == 0 and _regular(after, part) and alike(*both, before.range_turns):
            return after.levels_mm[part]
    return ()


def _regular(rests: Rests, part: slice) -> bool:
    """Whether a rest follows every stroke of a part."""
    return set(np.diff(rests.after[part])) == {1}
