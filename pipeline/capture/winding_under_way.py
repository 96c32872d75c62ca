"""The current winding: the displacement along it, from the point where the twist last turned back."""

import math
from itertools import pairwise

STEP_TURNS = 0.1  # what lies within so many turns is taken as one point
BACK_TURNS = 0.5  # by so much less than its most it has turned back
MOST_POINTS = 2000  # then every second is left out


class Sweep:
    """Points of the current winding, each the mean displacement within a small step of the twist."""

    def __init__(self) -> None:
        self.forward = True  # whether it winds in the sense of positive turns
        self._step_turns = STEP_TURNS
        self._turns: list[float] = []  # amounts, rising
        self._measured_mm: list[float] = []
        self._sum_mm, self._count = 0.0, 0  # of the step under way

    @property
    def wound(self) -> float:
        """How many turns it has wound so far."""
        return self._turns[-1] - self._turns[0] if self._turns else 0.0

    def take(self, turns: float, measured_mm: float) -> bool:
        """Take note of a sample, and say whether the winding has a new point."""
        amount, forward = abs(turns), turns >= 0
        if not self._turns or amount < self._turns[-1] - BACK_TURNS or amount < self._turns[0]:
            self._begin(amount, measured_mm, forward)
            return False
        self.forward = forward
        self._sum_mm, self._count = self._sum_mm + measured_mm, self._count + 1
        if amount < self._turns[-1] + self._step_turns:
            return False
        self._turns.append(amount)
        self._measured_mm.append(self._sum_mm / self._count)
        self._sum_mm, self._count = 0.0, 0
        if len(self._turns) > MOST_POINTS:
            self._turns, self._measured_mm = self._turns[::2], self._measured_mm[::2]
            self._step_turns *= 2
        return True

    def _begin(self, amount: float, measured_mm: float, forward: bool) -> None:
        self.forward, self._step_turns = forward, STEP_TURNS
        self._turns, self._measured_mm = [amount], [measured_mm]
        self._sum_mm, self._count = 0.0, 0

    @property
    def points(self) -> int:
        """How many points it has."""
        return len(self._turns)

    def noise_mm(self) -> float:
        """The standard deviation in mm of a point from the line through its neighbours."""
        before, middle, after = self._measured_mm[:-2], self._measured_mm[1:-1], self._measured_mm[2:]
        bends = [a - 2.0 * b + c for a, b, c in zip(before, middle, after, strict=True)]
        return math.sqrt(sum(bend * bend for bend in bends) / (6.0 * max(len(bends), 1)))

    def means_mm(self, parts: int) -> list[float]:
        """Mean displacement in mm of so many equal parts of the winding, the least twisted first."""
        size = len(self._turns)
        borders = [size * part // parts for part in range(parts + 1)]
        return [sum(self._measured_mm[begin:end]) / (end - begin) for begin, end in pairwise(borders)]
