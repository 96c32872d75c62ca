"""How many samples come each second of the person's own clock, over the last looks at a recording that grows."""

from collections import deque

OVER_S, LEAST_S = 5.0, 1.0


class Coming:
    """Tell it at each look how many samples there are; a rig at another pace sends more or fewer than its own rate."""

    def __init__(self) -> None:
        self._looks: deque[tuple[float, int]] = deque()

    def look(self, now_s: float, samples: int, growing: bool) -> None:
        """Take note of a look; a look that did not reach the end of the recording, or found no growth, begins anew."""
        if not growing:
            self._looks.clear()
            return
        self._looks.append((now_s, samples))
        while now_s - self._looks[0][0] > OVER_S:
            self._looks.popleft()

    @property
    def rate_hz(self) -> float | None:
        """Samples each second, or None before it is known or while none come."""
        if not self._looks:
            return None
        (began_s, before), (now_s, after) = self._looks[0], self._looks[-1]
        return (after - before) / (now_s - began_s) if now_s - began_s >= LEAST_S and after > before else None
