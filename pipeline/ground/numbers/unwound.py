"""Whether the current stroke has unwound, so that its end counts though no event reported it."""

import math

PHASE_REVERSAL = 0.02  # of the range: what counts as moving the other way within a stroke
HOME = 0.05  # of the range, above the lowest twist: where a stroke that was not cut off ends


class Unwound:
    """Tell it when a stroke starts, and the twist as it comes; memory does not grow."""

    def __init__(self) -> None:
        self._low, self._high = math.inf, -math.inf
        self._peak, self._fell = -math.inf, 0.0  # of the stroke under way
        self._last = math.inf

    def starts(self) -> None:
        """A stroke starts."""
        self._peak, self._fell = -math.inf, 0.0

    def look(self, twist: float) -> None:
        """Take note of a twist, in any unit."""
        self._low, self._high = min(self._low, twist), max(self._high, twist)
        self._peak, self._last = max(self._peak, twist), twist
        self._fell = max(self._fell, self._peak - twist)

    @property
    def is_whole(self) -> bool:
        """Whether the current stroke has an unwinding, by the share of the range that defines strokes."""
        return self._fell > 0.0 and self._fell >= PHASE_REVERSAL * (self._high - self._low)

    @property
    def is_home(self) -> bool:
        """Whether the twist is back near its lowest value."""
        return self._last - self._low <= HOME * (self._high - self._low)
