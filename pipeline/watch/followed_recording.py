"""A recording that another program writes, followed by reading only what was appended to it."""

import os
import shutil
import time
from collections import deque
from pathlib import Path

import numpy as np

from ..capture.log import in_use
from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..ground.numbers.unwound import Unwound
from ..run.description import Run
from ..run.ended_words import ending
from ..run.folder import CAPTURED, capture_info, read_run
from .appended import Counts, Frames, Printed, Source
from .arrival_rate import Coming
from .came_of_run import Means
from .column_names import stored_columns
from .envelope import Envelope
from .nominal import Nominal
from .page_content import State
from .reading_noise import Noise

PIECE = 1 << 20  # bytes that are read at once
BUDGET_S = 0.4  # a long recording is caught up with in steps of this
WHOLE, STROKE = 1200, 600  # parts that are kept of all, and of a stroke
KEPT = 3  # strokes
DRIVER, READING = "motor_turns", "displacement_mm"
STALE_S = 3.0  # so long after its last sample a recording is silent
CUT_S = 20.0  # what counts as a stroke where nothing tells of strokes


class Followed:
    """Counts, curves and state of a run folder; memory is bounded, and the files are opened for reading alone."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._names: tuple[str, ...] = ()
        self._growing = False  # a capture program writes to it
        self._forget(None)
        self.replaced = 0

    def _forget(self, identity: tuple[int, int] | None, name: str = CAPTURED[0]) -> None:
        self._identity, self._at, self.behind = identity, 0, 0
        self.source: Source = Printed(self._names, self.run()) if name == CAPTURED[1] else Frames()
        self.samples = 0
        self.last: Array = np.zeros(0)
        self.whole: Envelope | None = None
        self.strokes: deque[Envelope] = deque(maxlen=KEPT)
        self._cut_s, self._told = 0.0, False
        self._nominal: Nominal | None = None
        self.noise, self.means, self._coming = Noise(), Means(), Coming()
        self._new_s: float | None = None  # when the file was changed by the last sample, since the epoch

    def poll(self) -> None:
        """Read what was appended; a recording that was replaced or cut is begun anew."""
        path = next((self.folder / name for name in CAPTURED if (self.folder / name).is_file()), None)
        if path is None:
            if self._identity is not None:
                self.replaced += 1
                self._forget(None)
            return
        self._growing = in_use(path)
        names = stored_columns(self.folder) or self._names
        if names != self._names:  # they became known, or were corrected: all lines are read anew
            self._names, self._identity = names, None
        with open(path, "rb") as file:
            stat = os.fstat(file.fileno())
            identity = (stat.st_dev, stat.st_ino)
            if identity != self._identity or stat.st_size < self._at:
                self.replaced += self._identity is not None
                self._forget(identity, path.name)
            file.seek(self._at)
            began_s = time.monotonic()
            while time.monotonic() - began_s < BUDGET_S and (chunk := file.read(PIECE)):
                self._at += len(chunk)
                self._take(chunk, stat.st_mtime)
            self.behind = max(0, os.fstat(file.fileno()).st_size - self._at)
            self._coming.look(time.monotonic(), self.samples, self._growing and self.behind < PIECE)

    def _take(self, chunk: bytes, changed_s: float) -> None:
        piece = self.source.feed(chunk)
        if piece is None:
            return
        self._new_s = changed_s
        rows = piece.rows
        if self.whole is None or self.last.shape != rows[-1].shape:
            self.whole = Envelope(rows.shape[1], WHOLE)
            self.strokes.clear()
            self._begin_stroke()
            self._nominal = Nominal(self.run(), self.source.columns)
            if self._nominal.usable:
                self._nominal.at(rows)
        self.samples, self.last = self.samples + len(rows), rows[-1]
        self.whole.add(rows)
        self.means.add(rows)
        if READING in self.source.columns:
            self.noise.add(rows[:, 1 + self.source.columns.index(READING)])
        self._told |= bool(piece.strokes)
        begins = piece.strokes
        if not self._told and rows[-1, 0] - self._cut_s > CUT_S:
            begins, self._cut_s = [0], float(rows[-1, 0])
        self._cut(rows, begins)

    def _begin_stroke(self) -> None:
        columns = self.source.columns
        along = 1 + columns.index(DRIVER) if DRIVER in columns else 0
        self.strokes.append(Envelope(1 + len(columns), STROKE, along))

    def _cut(self, rows: Array, begins: list[int]) -> None:
        """Add samples to the last stroke, and begin another before each of `begins`."""
        at = 0
        for begin in begins:
            self.strokes[-1].add(rows[at:begin])
            self._begin_stroke()
            at = begin
        self.strokes[-1].add(rows[at:])

    def run(self) -> Run | None:
        """What run.yaml says, or None where it is missing or cannot be read."""
        try:
            return read_run(self.folder)
        except (BadInput, OSError):
            return None

    def simulated(self, rows: Array) -> Array | None:
        """Nominal displacement at samples, shape (samples,), or None where the simulator cannot compute it.

        In mm.
        """
        return self._nominal.at(rows) if self._nominal and self._nominal.usable and len(rows) else None

    def _waiting(self, age_s: float | None) -> str:
        """The state while the recording has no end."""
        if self._identity is None:
            return "no recording yet"
        if age_s is not None and age_s <= STALE_S:
            return "recording"
        if self._growing:
            return "recording" if age_s is None else "silent"
        unnamed = not self.samples and self.source.counts().unnamed
        return "kept; its columns have no names" if unnamed else "no end was written"

    def _empty(self) -> str:
        """Why there is no curve of displacement over twist, and what to do; empty where there is one."""
        if self._identity is None:
            return "Nothing is recorded yet."
        if not self.samples:
            return self.source.why_none(self.folder) or "No sample came yet."
        if not {DRIVER, READING} <= {*self.source.columns}:
            return f"Nothing here is {DRIVER} and {READING}; it has {', '.join(self.source.columns)}."
        return ""

    def _whole_strokes(self, counts: Counts) -> int | None:
        """The strokes of a recording that ended: a last one that unwinds counts, although its end was not reported."""
        if counts.strokes is None or self.whole is None or DRIVER not in self.source.columns:
            return counts.strokes
        at, unwound = 1 + self.source.columns.index(DRIVER), Unwound()
        for twist in [*self.whole.low[:, at].tolist(), *self.whole.high[:, at].tolist()]:
            unwound.look(twist)  # the range of all
        unwound.starts()
        for twist in self.strokes[-1].line(at)[1].tolist():
            unwound.look(twist)
        return counts.begun - (counts.is_open and not unwound.is_whole)

    def state(self) -> State:
        """How it stands, in words and numbers."""
        counts = self.source.counts()
        try:
            info = capture_info(self.folder)
        except (BadInput, OSError):
            info = {}
        status = info.get("exit_status")
        age_s = None if self._new_s is None else max(0.0, time.time() - self._new_s)
        return {
            "state": ending(info) if status else self._waiting(age_s),
            "ended": bool(status),
            "ended_utc": str(info.get("ended_utc", "")),
            "empty": self._empty(),
            "device": self.source.device,
            "samples": self.samples,
            "unnamed": counts.unnamed,
            "rate_hz": self.source.rate_hz,
            "come_hz": None if status else self._coming.rate_hz,
            "lost": counts.lost,
            "bad": counts.bad,
            "jumps": counts.jumps,
            "replaced": self.replaced,
            "behind_bytes": self.behind,
            "age_s": age_s,
            "free_bytes": shutil.disk_usage(self.folder).free,
            "strokes": self._whole_strokes(counts) if status else counts.strokes,
            "planned": counts.planned,
        }
