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

    It takes three rests of the run before and four of the run itself that compare with that first one; between them
    there may be strokes under other loads.
    """
    name = after.run.run
    last, first = _like_first(before, after)[-USUAL - 1 :], _first(after)
    if len(last) <= USUAL or last[-1] != len(before.after) - 1 or len(first) <= LEAST:
        return Recovered(name)
    end_mm, later_mm = (_lost_mm(rests, places[-USUAL - 1 :]) for rests, places in ((before, last), (after, first)))
    usual_mm = max(min(end_mm, 0.5 * (end_mm + later_mm)), 0.0)
    strokes = np.array([after.after[at] for at in first[1:]])
    beyond_mm = after.levels_mm[0] - np.array([after.levels_mm[at] for at in first[1:]]) - usual_mm * strokes
    least_mm = LEAST_FLOORS * max(before.noise_mm, after.noise_mm)
    mm = min(float(beyond_mm.max()), LOST * (before.levels_mm[0] - before.levels_mm[-1]))
    if mm <= least_mm:
        return Recovered(name)
    return Recovered(name, mm, int(strokes[np.argmax(beyond_mm > beyond_mm.max() - least_mm)]), after.turns[0])


def _like_first(rests: Rests, after: Rests) -> list[int]:
    """The places of the rests that compare with the first one of the run `after`."""
    each = enumerate(zip(rests.turns, rests.load_n, strict=True))
    first_turns, first_n = after.turns[0], after.load_n[0]
    return [at for at, (turns, load_n) in each if alike([first_turns, turns], [first_n, load_n], rests.range_turns)]


def _first(after: Rests) -> list[int]:
    """The places of a run's first rests that tell what it recovered, its very first one among them."""
    return [at for at in _like_first(after, after) if after.after[0] == 0 and after.after[at] <= MOST]


def _lost_mm(rests: Rests, places: list[int]) -> float:
    """How much the rest changes from stroke to stroke between the first and the last of some rests."""
    first, last = places[0], places[-1]
    return (rests.levels_mm[first] - rests.levels_mm[last]) / (rests.after[last] - rests.after[first])
