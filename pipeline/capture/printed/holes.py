"""Leaps of a printed time, where samples seem to be missing; memory does not grow with the length of the recording."""

import random
from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import islice

import numpy as np

from ...ground.kinematics import Array
from ...run.capture_json import Lost
from .jitter import lost_in

KEPT = 1 << 14  # steps from which the usual one is taken
MIDDLE = 0.1  # so many of the shortest and of the longest steps are left out of the usual one
PIECE = 1 << 14  # steps that are judged together
MARGIN = 64  # steps at the end of a piece that are judged with those after them
LISTED = 1000
MOST = 10**9  # samples: no longer hole is told apart


@dataclass
class Steps:
    """A random sample of the steps of a device's time; steps that fall back are not kept."""

    backward: int = 0  # how often it stands or falls back
    _before: float | None = None
    _kept: list[float] = field(default_factory=list)
    _seen: int = 0
    _draw: random.Random = field(default_factory=lambda: random.Random(1))

    def take(self, time: float) -> None:
        """Take note of the next sample's time."""
        step = -1.0 if self._before is None else time - self._before
        self.backward += self._before is not None and step <= 0
        self._before = time
        if step < 0:
            return
        self._seen += 1
        if len(self._kept) < KEPT:
            self._kept.append(step)
        elif (at := self._draw.randrange(self._seen)) < KEPT:
            self._kept[at] = step

    @property
    def usual(self) -> float:
        """The usual step, 0 where there is none: the mean of the middle ones, as 1.5 ms are printed as 1 and 2."""
        if not self._kept:
            return 0.0
        out = min((len(self._kept) - 1) // 2, max(2, int(MIDDLE * len(self._kept))))
        middle = sorted(self._kept)[out : len(self._kept) - out]
        return sum(step / len(middle) for step in middle)


def find(times: Iterable[float], usual: float) -> tuple[int, list[Lost]]:
    """The number of holes, and the first ones: samples before each, its time, and about how many are missing."""
    holes: list[Lost] = []
    count, number = 0, 0  # of the buffer's first sample
    times_left, stamps, excess, judged = iter(times), np.empty(0), np.empty(0), 0
    while 0 < usual < np.inf:
        piece = np.fromiter(islice(times_left, PIECE), np.float64)
        excess = np.append(excess, _excess(np.append(stamps[-1:], piece), usual))
        stamps = np.append(stamps, piece)
        over = len(piece) < PIECE
        until = len(excess) - (0 if over else MARGIN)
        lost = lost_in(excess)
        for at in judged + np.flatnonzero(lost[judged:until]):
            count += 1
            excess[at] -= lost[at]
            if len(holes) < LISTED:
                missing = int(lost[at])
                holes.append(
                    {"after_samples": number + int(at) + 1, "after_time": float(stamps[at]), "samples_about": missing}
                )
        if over:
            break
        dropped = max(0, len(excess) - PIECE)
        stamps, excess, judged, number = stamps[dropped:], excess[dropped:], until - dropped, number + dropped
    return count, holes


def _excess(stamps: Array, usual: float) -> Array:
    """Each step's length beyond the usual one, in usual steps; a time that falls far back counts as one usual step."""
    with np.errstate(over="ignore"):
        steps = np.diff(stamps)
        return np.where(steps > -usual, np.minimum(steps / usual, float(MOST)) - 1.0, 0.0)
