"""Where a printed time leaps ahead: samples that seem to be missing, found in memory that does not go by the length."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from ..run.capture_json import Lost

KEPT = 1 << 14  # steps from which the usual one is taken
HOLE = 1.5  # usual steps
LISTED = 1000
MOST = 10**9  # samples: no longer hole is told apart


@dataclass
class Steps:
    """Steps of a device's time; every so many rising ones are kept."""

    backward: int = 0  # how often it stands or falls back
    _before: float | None = None
    _kept: list[float] = field(default_factory=list)
    _rising: int = 0
    _every: int = 1

    def take(self, time: float) -> None:
        """Take note of the next sample's time."""
        step = 0.0 if self._before is None else time - self._before
        if self._before is not None and step <= 0:
            self.backward += 1
        elif step > 0:
            if self._rising % self._every == 0:
                self._kept.append(step)
            self._rising += 1
        self._before = time
        if len(self._kept) >= KEPT:
            self._kept, self._every = self._kept[::2], 2 * self._every

    @property
    def usual(self) -> float:
        """The usual step, 0 where there is none."""
        return sorted(self._kept)[len(self._kept) // 2] if self._kept else 0.0


def find(times: Iterable[float], usual: float) -> tuple[int, list[Lost]]:
    """How many holes there are, and the first of them: samples before it, that time, and about how many are missing."""
    holes: list[Lost] = []
    before, count = None, 0
    for number, time in enumerate(times):
        if before is not None and usual > 0 and time - before > HOLE * usual:
            count += 1
            missing = round(min((time - before) / usual, MOST)) - 1
            if len(holes) < LISTED:
                holes.append({"after_samples": number, "after_time": before, "samples_about": missing})
        before = time
    return count, holes
