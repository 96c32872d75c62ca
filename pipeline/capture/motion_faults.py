"""While recording: whether the displacement follows the twist as that of a string does."""

import math
from collections.abc import Callable
from itertools import pairwise

from .winding_under_way import Sweep

LEAST_TURNS = 3.0  # near the untwisted string a turn contracts less than a sensor can see
BACKWARD_TURNS = 10.0  # wound to below 0 by so much it is no string that began with some turns and unwinds
WRONG_QUANTA = 5.0  # a displacement that moves less is noise
WRONG_MM = 0.3  # a string that creeps, or hangs slack, falls by less within a winding
WRONG_NOISE = 6.0  # standard deviations of the mean of a part
PARTS = 5  # of a winding, in each of which it is to fall
LEAST_SHARE = 0.04  # of the whole fall that each part has; a curved one has 0.1 at its flat end
STANDS_MM = 3.0  # so far a string is to contract before its reading is said to stand; slack takes up less
WHOLE_SHARE = 0.5  # of what it contracted in the whole recording: a play, or a stop at one end, takes less
STANDS_SHARE = 0.125  # of that: what moves less is noise
AGAIN_TURNS = 0.5  # of further twist, after which it is asked again whether it stands

FROZEN, REVERSED = "frozen", "reversed"


def stands_words(turned: float) -> str:
    """The warning that the displacement stands still while the motor has turned that many turns, and what to check."""
    turned_whole = f"displacement_mm has not changed while the motor turned {turned:.3g} turns"
    return f"{turned_whole}: check the sensor and its cable"


class MotionFaults:
    """Twist and displacement, sample by sample; `quantum_mm` is the least step of the displacement.

    `contraction_mm` is what the run's own string contracts by at a twist in turns, where that is known: then a
    reading is said to stand only where such a string has contracted by far more.
    """

    def __init__(self, quantum_mm: float, contraction_mm: Callable[[float], float] | None = None) -> None:
        self._quantum_mm, self._contraction_mm = quantum_mm, contraction_mm
        self._sweep = Sweep()
        self._anchor_mm = math.nan  # the displacement when it last changed
        self._least = self._most = 0.0  # turns since then
        self._nearest, self._farthest = math.inf, -math.inf  # turns of the whole recording
        self._asked = 0.0  # of how many turns it was asked last

    @property
    def stood_turns(self) -> float:
        """How many turns the motor has turned since the displacement last changed."""
        return self._most - self._least

    def look(self, turns: float, measured_mm: float) -> str:
        """Take note of a sample; returns `frozen` or `reversed` if the displacement is so now, else nothing."""
        self._nearest, self._farthest = min(self._nearest, turns), max(self._farthest, turns)
        if self._stands(turns, measured_mm):
            return FROZEN
        return REVERSED if self._sweep.take(turns, measured_mm) and self._falls() else ""

    def _stands(self, turns: float, measured_mm: float) -> bool:
        if not abs(measured_mm - self._anchor_mm) <= self._noise_mm:
            self._anchor_mm, self._least, self._most, self._asked = measured_mm, turns, turns, 0.0
            return False
        self._least, self._most = min(self._least, turns), max(self._most, turns)
        if self.stood_turns < max(LEAST_TURNS, self._asked + AGAIN_TURNS):
            return False
        if self._contraction_mm is None:
            return True
        self._asked = self.stood_turns
        stood_mm = self._contraction_mm(self._most) - self._contraction_mm(self._least)
        whole_mm = self._contraction_mm(self._farthest) - self._contraction_mm(self._nearest)
        return stood_mm >= max(STANDS_MM, WHOLE_SHARE * whole_mm, WRONG_QUANTA * self._quantum_mm)

    @property
    def _noise_mm(self) -> float:
        return 0.0 if self._contraction_mm is None else STANDS_SHARE * STANDS_MM

    def _falls(self) -> bool:
        """Whether it fell all along a winding of at least so many turns, by more than noise."""
        sweep = self._sweep
        enough_turns = sweep.wound >= (LEAST_TURNS if sweep.forward else BACKWARD_TURNS)
        if not enough_turns or sweep.points < 2 * PARTS:
            return False
        means = sweep.means_mm(PARTS)
        fall_mm = means[0] - means[-1]
        noise_mm = WRONG_NOISE * sweep.noise_mm() / math.sqrt(sweep.points / PARTS)
        if fall_mm <= max(WRONG_QUANTA * self._quantum_mm, WRONG_MM, noise_mm):
            return False
        return all(before - after >= LEAST_SHARE * fall_mm for before, after in pairwise(means))
