"""What the person at the rig sees while it records."""

import contextlib
import time

from pipeline.wire import Frame, Hello, Kind
from pipeline.wire.frames import EVENT, Event

EVERY_S = 1.0


class Progress:
    """Counts what comes and says so once a second."""

    def __init__(self, hello: Hello) -> None:
        self.hello = hello
        self.samples = self.done = 0
        self._shown_s = self._began_s = time.monotonic()

    def count(self, frame: Frame) -> None:
        """Take note of one frame."""
        if frame.kind == Kind.SAMPLE:
            self.samples += 1
        elif frame.kind == Kind.EVENT and len(frame.payload) == EVENT.size:
            _, code, _ = EVENT.unpack(frame.payload)
            self.done += code == Event.STROKE_END

    def show(self, last: bool = False) -> None:
        """Print the line, if it is time for it."""
        now_s = time.monotonic()
        if not last and now_s - self._shown_s < EVERY_S:
            return
        self._shown_s = now_s
        of = f" of {self.hello.strokes}" if self.hello.strokes else ""
        rate_hz = self.samples / max(now_s - self._began_s, 1e-3)
        line = (
            f"{self.samples / self.hello.rate_hz:7.1f} s recorded, {self.done}{of} strokes done, "
            f"{self.samples} samples, {rate_hz:.0f} samples/s"
        )
        with contextlib.suppress(OSError):  # nobody reads it any more: no reason to stop recording
            print(line, flush=True)
