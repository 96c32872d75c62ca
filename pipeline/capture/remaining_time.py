"""The remaining time of a recording, from finished strokes or the program's legs; it never rises."""

import math

PACE_KNOWN_S = 1.0  # of a recording, from when its pace is known


class Left:
    """Tell it when strokes start and end; times are in s since the recording began.

    `motion_s` is what the legs of a program take by the rig's clock; None where no program moves it.
    """

    def __init__(self, strokes: int, motion_s: float | None = None) -> None:
        self.strokes, self.motion_s = strokes, motion_s
        self.done = 0
        self._rest_s: float | None = None  # before the first stroke
        self._first_s = self._ends_s = 0.0
        self._shown_s = math.inf

    def starts(self, at_s: float) -> None:
        """A stroke starts."""
        self._rest_s = at_s if self._rest_s is None else self._rest_s

    def ends(self, at_s: float) -> None:
        """A stroke ends: the rest are expected to take as long as those before, with the rest before the first one."""
        self.done += 1
        self._first_s = at_s if self.done == 1 else self._first_s
        each_s = at_s if self.done == 1 else (at_s - self._first_s) / (self.done - 1)
        self._ends_s = at_s + each_s * max(self.strokes - self.done, 0) + (self._rest_s or 0.0)

    def at(self, now_s: float, recorded_s: float = 0.0) -> float | None:
        """Time left in s, or None while nothing tells; it stands still where a stroke takes longer than expected.

        `recorded_s` is the time by the rig's clock.
        """
        if self.motion_s is not None:
            if recorded_s < PACE_KNOWN_S:
                return None
            ends_s = now_s * self.motion_s / recorded_s  # its clock may go at another pace
        elif self.strokes and self.done:
            ends_s = self._ends_s
        else:
            return None
        self._shown_s = min(self._shown_s, max(0.0, ends_s - now_s))
        return self._shown_s
