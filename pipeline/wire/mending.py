"""Mends the stamps of a recording that comes in pieces: one pass over all steps plans it, a second one mends them.

Stamps rise strictly when they are mended, by the numbers of their frames. Stamps that fall back, or leap ahead and fall
back to where they should be, are put between the neighbours that are right; where the clock falls back for good, what
follows is moved to a usual step after the sample before. Samples that share a stamp are spread up to the next. A first
or last stamp that stands apart by ten usual steps is put beside its neighbour. No sample is dropped. Where there is no
clock at all the stamps stay as they are.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from .counters import Whole, steps_of
from .stamps import BURST, LEAP, Array, mend_one, no_clock

Steps = tuple[Array, Array]  # us from each sample to the next, and how many usual steps that is by their numbers
Pieces = Callable[[], Iterable[Steps]]


def steps_between(pieces: Iterable[tuple[Whole, NDArray[np.uint32]]]) -> Iterator[Steps]:
    """Steps from sample to sample, one fewer than there are samples, from pieces of numbers and stamps in us.

    Each given has the shape (samples,), each made (steps,).
    """
    before, at = np.zeros(0, np.int64), np.zeros(0, np.uint32)  # the last number so far, and its stamp
    for more, later in pieces:
        numbers, stamps = np.append(before, more), np.append(at, later)
        yield steps_of(stamps, int(stamps[0]))[1:].astype(np.float64), usual_steps(np.diff(numbers))
        before, at = numbers[-1:], stamps[-1:]


def usual_steps(apart: Whole) -> Array:
    """The time between samples in usual steps, at least 1, from the difference of their numbers.

    Shape (steps,), a count.
    """
    return np.where(apart <= 2, 1.0, apart)  # an EVENT between two samples takes a number and no time


@dataclass
class _Tally:
    """Statistics of all steps of a recording; the size grows with the number of different steps."""

    count: int = 0
    backward: int = 0
    repeated: int = 0
    ratios: Array = field(default_factory=lambda: np.zeros(0))  # the rising steps by what is expected
    times: Whole = field(default_factory=lambda: np.zeros(0, np.int64))  # how often each ratio came
    ends: list[float] = field(default_factory=list)  # ratio of the first step, and of the last

    def enter(self, steps: Array, apart: Array) -> None:
        """Note a piece of the steps."""
        if not len(steps):
            return
        self.count += len(steps)
        self.backward += int((steps < 0).sum())
        self.repeated += int((steps == 0).sum())
        self.ends = [*(self.ends[:1] or [float(steps[0] / apart[0])]), float(steps[-1] / apart[-1])]
        rising = steps > 0
        ratios, times = np.unique(steps[rising] / apart[rising], return_counts=True)
        self.ratios, place = np.unique(np.append(self.ratios, ratios), return_inverse=True)
        self.times = np.bincount(place, np.append(self.times, times), len(self.ratios)).astype(np.int64)

    @property
    def usual_us(self) -> float:
        """The usual step; a clock that ticks at every fifth sample has steps five times too long."""
        upto = np.cumsum(self.times)
        rising = int(upto[-1])
        low, high = (float(self.ratios[np.searchsorted(upto, rising / 2, side)]) for side in ("left", "right"))
        return (low + high) / 2.0 * rising / (rising + self.repeated)


@dataclass(frozen=True)
class Mending:
    """The mends of a recording's steps, and how often each rule is needed."""

    usual_us: float | None = None  # None: nothing is
    ends: dict[int, float] = field(default_factory=dict)  # the first or the last step by its place, in us
    counted: dict[str, int] = field(default_factory=dict)

    @staticmethod
    def of(pieces: Pieces) -> "Mending":
        """The mends, from all steps of a recording, which are read a second time where something is wrong."""
        tally = _Tally()
        for steps, apart in pieces():
            tally.enter(steps, apart)
        wrong = tally.backward + tally.repeated
        if not len(tally.ratios) or no_clock(tally.count + 1, tally.backward, tally.repeated):
            return Mending()
        usual_us = tally.usual_us
        may_leap = wrong or max(tally.ends) > LEAP * usual_us
        ends = _leaping(pieces(), usual_us, tally.count) if may_leap else {}
        counted = {
            "backward_time_stamps": tally.backward,
            "repeated_time_stamps": tally.repeated,
            "leaping_time_stamps": len(ends),
        }
        counted = {rule: times for rule, times in counted.items() if times}
        return Mending(usual_us if counted else None, ends, counted)

    def stamps(self, pieces: Iterable[Steps]) -> Iterator[Array]:
        """Mended stamps in us since the first sample: as many in all as there are samples, from all their steps.

        Each comes at most two bursts after its sample. Shape (stamps,).
        """
        passed_us, place, begun = 0.0, 0, False
        for steps, _ in _mended(pieces, self.usual_us):
            for end, step_us in self.ends.items():
                if place <= end < place + len(steps):
                    steps[end - place] = step_us
            sums = np.cumsum(np.append(passed_us, steps))
            yield sums[1:] if begun else sums
            passed_us, place, begun = float(sums[-1]), place + len(steps), True


def _mended(pieces: Iterable[Steps], usual_us: float | None) -> Iterator[Steps]:
    """The steps, with standing and backward ones mended, and the expected length of each."""
    if usual_us is None:
        yield from pieces
        return
    steps = expected = np.zeros(0)
    looked = 0
    for piece in chain(pieces, [None]):
        more, apart = piece or (np.zeros(0), np.zeros(0))
        steps, expected = np.append(steps, more), np.append(expected, usual_us * apart)
        ready = max(len(steps) - BURST + 1, looked) if piece else len(steps)
        for at in (looked + np.flatnonzero(steps[looked:ready] <= 0)).tolist():
            if steps[at] <= 0:  # else it was mended with the one before
                mend_one(steps, expected, at)
        done = max(ready - BURST + 1, 0) if piece else len(steps)  # no later one reaches back to these
        yield steps[:done], expected[:done]
        steps, expected, looked = steps[done:], expected[done:], ready - done


def _leaping(pieces: Iterable[Steps], usual_us: float, count: int) -> dict[int, float]:
    """The first and the last of `count` steps if they leap, by place, with the expected length in us."""
    most, place = -np.inf, 0
    ends: dict[int, tuple[float, float]] = {}
    for steps, expected in _mended(pieces, usual_us):
        for end in (0, count - 1):
            if place <= end < place + len(steps):
                ends[end] = (float(steps[end - place]), float(expected[end - place]))
                steps[end - place] = -np.inf
        most, place = steps.max(initial=most), place + len(steps)
    leaps: dict[int, float] = {}
    for end, other in ((0, count - 1), (count - 1, 0)):
        step_us, expected_us = ends[end]
        if step_us > max(LEAP * expected_us, most, leaps.get(other, ends[other][0])):
            leaps[end] = expected_us
    return leaps
