"""A printed clock that stands or falls back at a few samples: its stamps are mended like those of frames.

Nothing else is touched: where every stamp rises, the times stay as they were printed.
"""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pandas as pd

from ...ground.command import recover_command
from ...ground.errors import BadInput
from ...ground.kinematics import Array
from ...ground.words.counts import counted
from ...wire.mending import Mending, Steps
from ...wire.stamps import LEAP, no_clock

MOST_MOVED = 0.01  # of all stamps: where more are moved by ten usual steps, the clock itself was wrong
KEPT = 1 << 19  # samples that are kept for the next time that they are asked for
Read = Callable[[bool], Iterator[pd.DataFrame]]


def far_moved(moved: int, samples: int) -> bool:
    """Whether a large share of the stamps was moved so far that the clock itself must be wrong."""
    return moved > max(1, MOST_MOVED * samples)


class MendedTime:
    """Samples of a recording at `path` in pieces, with `time_s` mended; `read` reads them, and is told if it is again.

    `counted` says how often each rule of Mending was needed. Raises BadInput where the clock itself is wrong.
    """

    def __init__(self, read: Read, path: Path, first_row: int = 0) -> None:
        self._read, self._path, self._first_row = read, path, first_row
        self._kept: list[pd.DataFrame] | None = []
        self._samples = self._backward = self._repeated = 0
        finite, last_s = True, np.zeros(0)
        for table in read(False):
            time_s = np.append(last_s, table["time_s"].to_numpy())
            steps_s, last_s = _differences(time_s), time_s[-1:]
            finite = finite and bool(np.isfinite(steps_s).all() and np.isfinite(last_s).all())
            self._samples += len(table)
            self._backward += int((steps_s < 0).sum())
            self._repeated += int((steps_s == 0).sum())
            self._kept = None if self._kept is None or self._samples > KEPT else [*self._kept, table]
        wrong = finite and self._backward + self._repeated > 0
        if wrong and no_clock(self._samples, self._backward, self._repeated):
            raise self._none()
        self._mending = Mending.of(lambda: _steps(self._times())) if wrong else Mending()
        self.counted = self._mending.counted
        if self.counted:
            self._check()

    def pieces(self) -> Iterator[pd.DataFrame]:
        """The samples, piece by piece."""
        if not self.counted:
            yield from self._tables()
            return
        stamps, time_s = self._stamps_s(), np.zeros(0)
        for table in self._tables():
            while len(time_s) < len(table):
                time_s = np.append(time_s, next(stamps))
            yield table.assign(time_s=time_s[: len(table)])
            time_s = time_s[len(table) :]

    def _tables(self) -> Iterator[pd.DataFrame]:
        return self._read(True) if self._kept is None else iter(self._kept)

    def _times(self) -> Iterator[Array]:
        return (table["time_s"].to_numpy() for table in self._tables() if len(table))

    def _stamps_s(self) -> Iterator[Array]:
        """Mended stamps in s; a leap at the first stamp moves only that stamp. Shape (stamps,) each."""
        times = np.zeros(0)
        for piece in self._times():
            times = np.append(times, piece)[:2]
            if len(times) == 2:
                break
        start_s = times[1] - self._mending.ends[0] * 1e-6 if 0 in self._mending.ends else times[0]
        return (start_s + stamps_us * 1e-6 for stamps_us in self._mending.stamps(_steps(self._times())))

    def _check(self) -> None:
        """Raise BadInput where mending moves many stamps far: the clock was set anew."""
        far_s, moved, first, row = LEAP * 1e-6 * (self._mending.usual_us or 0.0), 0, 0, 0
        mended = self.pieces()
        for before_s in self._times():
            table = next(mended)
            far = np.abs(table["time_s"].to_numpy() - before_s) > far_s
            first = row + int(np.argmax(far)) if far.any() and not moved else first
            moved, row = moved + int(far.sum()), row + len(far)
        if far_moved(moved, self._samples):
            problem = f"falls back near row {first + 1}, which only moving {counted(moved, 'stamp')} would mend"
            parts = [(0, first), (first, self._samples)]
            begin, end = (self._first_row + at for at in max(parts, key=lambda part: part[1] - part[0]))
            mend = f"if the rig was reset there, use the rows of one side: file: {{rows: [{begin}, {end}]}} in run.yaml"
            raise BadInput(self._path, "time_s", problem, mend)

    def _none(self) -> BadInput:
        wrong, steps = self._backward + self._repeated, self._samples - 1
        problem = f"stands or runs backwards at {wrong} of {steps} steps from sample to sample"
        again = f"{recover_command(self._path.parent)} --columns ..."
        mend = f"if the time is another column, name them anew: {again}; else print micros() in each line"
        return BadInput(self._path, "time_s", problem, mend)


def _differences(time_s: Array) -> Array:
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused as no clock of a rig
        return np.diff(time_s) * 1e6


def _steps(times: Iterator[Array]) -> Iterator[Steps]:
    """Steps in us from sample to sample, each expected to be one usual step."""
    last_s = np.zeros(0)
    for time_s in times:
        steps_us, last_s = _differences(np.append(last_s, time_s)), time_s[-1:]
        yield steps_us, np.ones(len(steps_us))
