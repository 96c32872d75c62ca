"""The output for the person at the rig: a line that renews itself on a terminal, or a line a minute in a log file.

The first line of a log file comes sooner: whoever looks into it wants to see that the recording grows.
"""

import contextlib
import shutil
import sys
import time

RENEW_S = 0.25
LOG_S, FIRST_S = 60.0, 5.0
CLEAR = "\r\x1b[K"


class Screen:
    """Standard output while a recording grows; if nobody reads it any more, the recording goes on."""

    def __init__(self) -> None:
        self.live = sys.stdout.isatty()
        self._shown_s = time.monotonic()
        self._every_s = RENEW_S if self.live else FIRST_S
        self._open = False  # whether the line that renews itself stands there

    @property
    def due(self) -> bool:
        """Whether it is time for the next line."""
        return time.monotonic() - self._shown_s >= self._every_s

    def say(self, sentence: str) -> None:
        """A sentence that stays."""
        self._write((CLEAR if self._open else "") + sentence + "\n")
        self._open = False

    def show(self, parts: list[str]) -> None:
        """The line that renews itself: as many of its parts, from the first on, as the terminal has room for."""
        self._shown_s = time.monotonic()
        if not self.live:
            self._every_s = LOG_S
            self._write(", ".join(parts) + "\n")
            return
        width = shutil.get_terminal_size().columns - 1
        while len(parts) > 1 and len(", ".join(parts)) > width:
            parts = parts[:-1]
        self._write(CLEAR + ", ".join(parts)[:width])
        self._open = True

    def close(self, parts: list[str]) -> None:
        """The last line, whole."""
        self.say(", ".join(parts))

    def _write(self, text: str) -> None:
        with contextlib.suppress(OSError):
            sys.stdout.write(text)
            sys.stdout.flush()


def clock(seconds: float) -> str:
    """Minutes and seconds, and hours where there are any: 1:05, 2:00:00."""
    whole = int(seconds)
    hours, minutes, rest = whole // 3600, whole // 60 % 60, whole % 60
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
