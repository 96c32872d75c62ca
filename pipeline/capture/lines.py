"""Lines of numbers that a rig prints, as a table, and an account of every line that is none."""

import math
import re
from dataclasses import dataclass, field

NAME = re.compile(r"[A-Za-z_][\w .()/%°-]{0,63}")
TIME = re.compile(r"(t|time|millis|micros)(_?(s|ms|us))?", re.IGNORECASE)
MAX_LINE = 1024  # bytes; what is longer is no line of numbers
LISTED = 1000  # so many places are kept; all are counted
HOLE = 1.5  # usual steps of the device's time


def fields(line: bytes) -> list[str]:
    """Fields of a line, by its semicolons, else commas, else white space; none for what is no text or too long."""
    if len(line) > MAX_LINE or not line.isascii():
        return []
    text = line.decode("ascii").strip()
    return [part.strip() for part in text.split(";" if ";" in text else "," if "," in text else None)] if text else []


def names(line: bytes) -> tuple[str, ...]:
    """Names of the columns if a line is a header, else nothing."""
    found = tuple(fields(line))
    good = len(found) > 1 and len(set(found)) == len(found) and all(NAME.fullmatch(name) for name in found)
    return found if good else ()


def _numbers(parts: list[str]) -> list[float] | None:
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        return None
    return numbers if all(map(math.isfinite, numbers)) and not any("_" in part for part in parts) else None


@dataclass
class Table:
    """Good lines of a text log, and what is wrong with the others; lines are counted from 1."""

    columns: tuple[str, ...]
    rows: list[list[str]] = field(default_factory=list)
    bad: int = 0
    bad_lines: list[int] = field(default_factory=list)
    tail_bytes: int = 0
    time_s: list[float] = field(default_factory=list)  # the device's, in the unit that it prints

    @property
    def csv(self) -> str:
        """Content of recording.csv."""
        return "\n".join(",".join(row) for row in [list(self.columns), *self.rows]) + "\n"

    def holes(self) -> list[dict[str, float | int]]:
        """Where the device's time leaps ahead: samples before it, that time, and about how many samples are missing."""
        steps = [after - before for before, after in zip(self.time_s, self.time_s[1:], strict=False)]
        rising = sorted(step for step in steps if step > 0)
        if not rising:
            return []
        usual = rising[len(rising) // 2]
        leaps = [(place + 1, step) for place, step in enumerate(steps) if step > HOLE * usual]
        return [
            {"after_samples": after, "after_time": self.time_s[after - 1], "samples_about": round(step / usual) - 1}
            for after, step in leaps
        ]

    @property
    def backward(self) -> int:
        """How often the device's time stands or falls back."""
        return sum(after <= before for before, after in zip(self.time_s, self.time_s[1:], strict=False))


def read_lines(data: bytes, columns: tuple[str, ...] = ()) -> Table:
    """Table of a text log; without `columns` its first header names them. Never raises, whatever the bytes.

    What stands before the first line's end is no sample: the port may have been opened in the middle of a line, and
    half a number looks like a number. Empty lines and comments (#) are passed over.
    """
    *lines, tail = data.split(b"\n")
    table = Table(columns, tail_bytes=len(tail))
    time_at: int | None = None
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.lstrip().startswith(b"#"):
            continue
        header = names(line)
        if header and table.columns in ((), header):
            table.columns = header
            continue
        if number == 1 or not table.columns:
            continue
        parts = fields(line)
        numbers = _numbers(parts) if len(parts) == len(table.columns) else None
        if numbers is None:
            table.bad += 1
            table.bad_lines += [number] if len(table.bad_lines) < LISTED else []
            continue
        if time_at is None:
            time_at = next((at for at, name in enumerate(table.columns) if TIME.fullmatch(name)), -1)
        table.rows.append(parts)
        table.time_s += [numbers[time_at]] if time_at >= 0 else []
    return table
