"""What the person at the rig sees while it records."""

import contextlib
import time

from pipeline.capture.watch import Watch
from pipeline.wire import Frame, Hello, Kind
from pipeline.wire.frames import EVENT, Event

EVERY_S = 1.0
LATE = 1000  # so many missing frames may still come late and be no loss
SHOWN = {"displacement_mm": "mm", "load_n": "N"}


def say(line: str) -> None:
    """Print a line."""
    with contextlib.suppress(OSError):  # nobody reads it any more: no reason to stop recording
        print(line, flush=True)


class Progress:
    """Counts what comes and says so once a second; what is wrong it says at once."""

    def __init__(self, hello: Hello) -> None:
        self.hello = hello
        self.samples = self.done = self.lost = self.bad = 0
        self.watch = Watch(hello)
        self._top = 0  # highest number of a frame
        self._missing: set[int] = set()
        self._shown_s = self._began_s = time.monotonic()
        self._shown_samples = self._shown_bad = 0

    def count(self, frame: Frame) -> None:
        """Take note of one frame."""
        ahead = (frame.seq - self._top) % 2**32
        if 0 < ahead < 2**31:
            self.lost += ahead - 1
            if 1 < ahead <= LATE and len(self._missing) < LATE:
                self._missing.update((self._top + step) % 2**32 for step in range(1, ahead))
            self._top = frame.seq
        elif frame.seq in self._missing:
            self._missing.remove(frame.seq)
            self.lost -= 1
        if frame.kind == Kind.SAMPLE:
            self.samples += 1
            wrong = self.watch.look(frame)
            if wrong:
                say(f"warning: {wrong}")
        elif frame.kind == Kind.EVENT and len(frame.payload) == EVENT.size:
            _, code, _ = EVENT.unpack(frame.payload)
            self.done += code == Event.STROKE_END

    def show(self, free_bytes: int = 0, last: bool = False) -> None:
        """Print the line, if it is time for it."""
        now_s = time.monotonic()
        if not last and now_s - self._shown_s < EVERY_S:
            return
        passed_s = now_s - self._began_s
        of = f" of {self.hello.strokes}" if self.hello.strokes else ""
        parts = [
            f"{self.samples / self.hello.rate_hz:7.1f} s recorded",
            f"{self.done}{of} strokes done",
            f"{self.samples} samples",
            f"{self.samples / max(passed_s, 1e-3):.0f} samples/s",
            *(f"{self.watch.now[name]:.2f} {unit}" for name, unit in SHOWN.items() if name in self.watch.now),
            f"{self.lost} frames lost",
        ]
        if free_bytes:
            parts.append(f"{free_bytes / 1e9:.1f} GB free")
        if 0 < self.done < self.hello.strokes and not last:
            parts.append(f"about {passed_s / self.done * (self.hello.strokes - self.done):.0f} s left")
        say(", ".join(parts))
        if self.bad - self._shown_bad > self.samples - self._shown_samples:
            say("warning: most of what comes is damaged: check the cable, the ground and the baud rate")
        self._shown_s, self._shown_samples, self._shown_bad = now_s, self.samples, self.bad
