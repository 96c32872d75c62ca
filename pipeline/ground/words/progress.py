"""The progress of a long piece of work: a line on the terminal that renews itself, or a line a minute in a log.

Programs say what they go through by `steps`; one inside another stands in the same line, as in "fit 3 of 8, epoch 20 of
60, 41 s so far". Everything goes to stderr. What is done within a minute says nothing in a log.
"""

import shutil
import sys
import time
from collections.abc import Iterable, Iterator, Sized
from dataclasses import dataclass, field
from typing import TypeVar

Item = TypeVar("Item")
RENEWED_S, LOGGED_S = 0.1, 60.0


@dataclass
class _Line:
    """The running pieces of work, the outermost first, and when they were last shown."""

    levels: list[list[str | int]] = field(default_factory=list)  # what, how many are done, how many there are
    began_s: float = 0.0
    said_s: float = 0.0
    drawn: bool = False


_line = _Line()


def steps(items: Iterable[Item], what: str, total: int | None = None) -> Iterator[Item]:
    """Pass on items one by one and show the current one, called `what`; `total` is their number if known."""
    count = total if total is not None else len(items) if isinstance(items, Sized) else 0
    if not _line.levels:
        _line.began_s = _line.said_s = time.monotonic()
    level: list[str | int] = [what, 0, count]
    _line.levels.append(level)
    try:
        for number, item in enumerate(items, start=1):
            level[1] = number
            _say()
            yield item
    finally:
        place = next((at for at, entry in enumerate(_line.levels) if entry is level), len(_line.levels))
        del _line.levels[place:]
        if not _line.levels:
            clear()


def words(elapsed_s: float) -> str:
    """What is under way, in words."""
    parts = [f"{what} {number} of {count}" if count else f"{what} {number}" for what, number, count in _line.levels]
    seconds = round(elapsed_s)
    spent = f"{seconds} s" if seconds < 120 else f"{seconds // 60} min {seconds % 60} s"
    return ", ".join([*parts, f"{spent} so far"])


def clear() -> None:
    """Take the line off the terminal, so that other output begins on an empty one."""
    if _line.drawn and sys.stderr is not None:
        sys.stderr.write("\r\x1b[K")
        sys.stderr.flush()
    _line.drawn = False


def _say() -> None:
    """Show the progress, unless that was done a moment ago."""
    now_s, stream = time.monotonic(), sys.stderr
    if stream is None or stream.closed:
        return
    terminal = stream.isatty()
    if now_s - _line.said_s < (RENEWED_S if terminal else LOGGED_S) and (_line.drawn or not terminal):
        return
    _line.said_s = now_s
    text = words(now_s - _line.began_s)
    if terminal:
        width = max(shutil.get_terminal_size().columns - 1, 20)
        stream.write(f"\r{text[:width]}\x1b[K\r")  # what is written next, an error, begins on top of it
        _line.drawn = True
    else:
        stream.write(f"{text}\n")
    stream.flush()
