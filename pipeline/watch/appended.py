"""The samples that were appended to a recording since it was read last, as frames or as printed lines."""

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..capture.printed.lines import Lines, Splitter
from ..ground.command import recover_command
from ..ground.kinematics import Array
from ..ground.units import conversion
from ..run.description import Run
from ..run.table.named_units import time_unit
from ..wire import Event, Ledger
from ..wire.counters import Whole, steps_of
from .column_names import channel_of

LONGEST_STEP_US = 60_000_000  # a clock that goes on by more was set anew


@dataclass(frozen=True)
class Piece:
    """Samples in the order of reading; `strokes` says before which of them a stroke begins."""

    rows: Array  # (samples, 1 + channels): time in s, then the channels
    strokes: list[int]


@dataclass(frozen=True)
class Counts:
    """What a page says of losses; `lost` is None where the rig does not number what it sends.

    `unnamed` lines of numbers are no samples, since nothing has named their columns. `begun` strokes have begun, the
    last of them `is_open` while nothing told of its end.
    """

    bad: int
    lost: int | None
    jumps: int
    strokes: int | None
    planned: int
    unnamed: int = 0
    begun: int = 0
    is_open: bool = False


class Source(Protocol):
    """Bytes in, samples out; memory does not grow with their number. `rate_hz` is by the device's clock."""

    columns: tuple[str, ...]
    rate_hz: float | None
    device: str

    def feed(self, chunk: bytes) -> Piece | None:
        """Samples that end in a chunk."""

    def counts(self) -> Counts:
        """What was lost so far."""

    def why_none(self, folder: Path) -> str:
        """Why none of the bytes is a sample, and what to do; empty if that is unknown."""


class Frames:
    """`recording.frames`."""

    def __init__(self) -> None:
        self.columns: tuple[str, ...] = ()
        self.rate_hz: float | None = None
        self.device = ""
        self._ledger = Ledger(counts_only=True)
        self._stamp, self._time_us, self._jumps = -1, 0.0, 0
        self._event = -1

    def feed(self, chunk: bytes) -> Piece | None:
        """Samples whose frames end in a chunk, scaled as the device's HELLO says."""
        heard, hello = self._ledger.feed(chunk), self._ledger.hello
        if hello is None:
            return None
        self.columns, self.rate_hz = tuple(c.name for c in hello.channels), hello.rate_hz
        self.device = f"{hello.device}, firmware {hello.firmware}"
        if heard is None or not len(heard[0]):
            return None
        numbers, raw = heard
        rows = np.empty((len(raw), 1 + len(hello.channels)))
        rows[:, 0] = self._clock(raw["t_us"], 1e6 / hello.rate_hz)
        for at, channel in enumerate(hello.channels, 1):
            rows[:, at] = raw[channel.name] * channel.scale + channel.offset
        return Piece(rows, self._begins(numbers))

    def _clock(self, t_us: NDArray[np.uint32], usual_us: float) -> Array:
        """Time in s since the first sample; an impossible step counts as a usual one."""
        before = int(t_us[0]) if self._stamp < 0 else self._stamp
        steps = steps_of(t_us, before).astype(np.float64)
        wrong = (steps < 0) | (steps > LONGEST_STEP_US)
        self._jumps += int(wrong.sum())
        steps[wrong] = usual_us
        time_us = self._time_us + np.cumsum(steps)
        self._stamp, self._time_us = int(t_us[-1]), float(time_us[-1])
        return np.asarray(time_us * 1e-6)

    def _begins(self, numbers: Whole) -> list[int]:
        """Before which samples strokes begin that were not reported before."""
        new = [(number, code) for number, code, _ in self._ledger.tally().events if number > self._event]
        self._event = new[-1][0] if new else self._event
        return [int(np.searchsorted(numbers, number)) for number, code in new if code == Event.STROKE_START]

    def counts(self) -> Counts:
        """Frames that are missing, and byte stretches that were no frames."""
        tally, hello = self._ledger.tally(), self._ledger.hello
        marks = [(code, value) for _, code, value in tally.events if code in (Event.STROKE_START, Event.STROKE_END)]
        done = sum(code == Event.STROKE_END for code, _ in marks)
        begun, is_open = len({value for _, value in marks}), bool(marks) and marks[-1][0] == Event.STROKE_START
        planned = hello.strokes if hello else 0
        return Counts(tally.bad, tally.lost, self._jumps, done, planned, begun=begun, is_open=is_open)

    def why_none(self, folder: Path) -> str:
        """Empty: frames name their own channels."""
        return ""


class Printed:
    """`recording.lines` of a `run`, its columns named by `given`, or by the rig where `given` is empty."""

    def __init__(self, column_names: tuple[str, ...] = (), run: Run | None = None) -> None:
        self.columns: tuple[str, ...] = ()
        self.rate_hz: float | None = None
        self.device = "a rig that prints lines"
        self._splitter, self._lines, self._run = Splitter(), Lines(column_names), run
        self._time_s, self._clock_s, self._jumps, self._timed = 0.0, float("nan"), 0, 0

    def feed(self, chunk: bytes) -> Piece | None:
        """Samples whose lines end in a chunk, as they were printed."""
        rows = [row for line in self._splitter.feed(chunk) if (row := self._lines.take(line)) is not None]
        if not rows:
            return None
        printed, values = self._lines.columns, np.array(rows, dtype=np.float64)
        channels = [channel_of(self._run, printed, place) for place in range(len(printed))]
        names = [name for name, *_ in channels]
        at = names.index("time_s") if "time_s" in names else self._lines.time_at
        values = values * [factor for _, factor, _ in channels] + [shift for *_, shift in channels]
        if at < 0:
            self.columns = tuple(names)
            return Piece(np.column_stack([[self._next(None) for _ in rows], values]), [])
        if names[at] != "time_s":
            values[:, at] *= conversion("time_s", time_unit(printed[at]))[0]
        self.columns = tuple(names[:at] + names[at + 1 :])
        time_s = [self._next(stamp) for stamp in values[:, at].tolist()]
        self._timed += len(rows)
        self.rate_hz = (self._timed - 1) / self._time_s if self._time_s else None
        return Piece(np.column_stack([time_s, np.delete(values, at, axis=1)]), [])

    def _next(self, clock_s: float | None) -> float:
        """Time in s since the first sample; without a clock the number of the sample."""
        step = 1.0
        if clock_s is not None:
            step = clock_s - self._clock_s if self._clock_s == self._clock_s else 0.0
            self._clock_s = clock_s
            if not 0.0 <= step <= LONGEST_STEP_US * 1e-6:
                self._jumps, step = self._jumps + 1, 0.0
        self._time_s += step
        return self._time_s

    def counts(self) -> Counts:
        """Lines that are no samples."""
        return Counts(self._lines.bad, None, self._jumps, None, 0, self._lines.unnamed.count)

    def why_none(self, folder: Path) -> str:
        """What came instead of samples, and the command that names the columns when the recording has ended."""
        if self._lines.good or not self._lines.not_read:
            return ""
        problem, mend = self._lines.problem(0.0, recover_command(folder))
        return f"No line is read yet, but all are kept: {problem}. When the recording has ended: {mend}"
