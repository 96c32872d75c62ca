"""One printed line: its fields, its numbers, or the names that it gives to columns."""

import math
import re
from collections.abc import Sequence

NAME = re.compile(r"[A-Za-z_][\w .()\[\]/%°-]{0,63}")
LABELLED = re.compile(r"([A-Za-z_][\w ()\[\]/%-]{0,63}?)\s*[:=]\s*([+-]?[\d.]+(?:[eE][+-]?\d+)?)(?:\s*[,;]\s*|\s+|$)")
LABELS = 3  # so many at least: a banner may say its version and a number as well
KNOWN = re.compile(  # what somebody calls a column of such a rig, and hardly a word of a greeting
    r"(^|[_\W])(t|time|millis|micros|theta|phi|angle|turns?|rev|rad|deg|x|mm|ms|us|n|load|force|torque|temp\w*|"
    r"current|motor_\w+|displacement|disp|pos|position|contraction|length)($|[_\W])",
    re.IGNORECASE,
)
TIME = re.compile(r"(t|time|millis|micros)(_?(s|ms|us))?", re.IGNORECASE)
UNIT_OF_TIME = re.compile(r"s|ms|us", re.IGNORECASE)  # a clock where it is all that a column is called
DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+([eE][+-]?\d+)?")
WHOLE_OR_COMMA = re.compile(r"[+-]?\d+(,\d+)?([eE][+-]?\d+)?")
MAX_LINE = 1024  # bytes; what is longer is no line of numbers


def fields(line: bytes) -> tuple[list[str], str]:
    """Fields of a line and their separator, ";", "," or " "; none if the line is no text or too long."""
    if len(line) > MAX_LINE or not line.isascii():
        return [], ""
    text = line.decode("ascii").strip()
    if ";" in text:
        return [part.strip() for part in text.split(";")], ";"
    if "," not in text:
        return text.split(), " "
    apart = text.split()
    if len(apart) > 1 and all(WHOLE_OR_COMMA.fullmatch(part) for part in apart):
        return apart, " "  # "12,5 3,4": every comma stands inside a number
    return [part.strip() for part in text.split(",")], ","


def names(line: bytes) -> tuple[str, ...]:
    """Names of the columns if a line can be a header, else nothing."""
    return names_of(fields(line)[0])


def names_of(parts: list[str]) -> tuple[str, ...]:
    """The fields of a line if they can be names of columns, else nothing."""
    good = len(parts) > 1 and len(set(parts)) == len(parts) and all(NAME.fullmatch(part) for part in parts)
    return tuple(parts) if good else ()


def clock_at(columns: Sequence[str], time_column: str | int | None = None) -> int:
    """Which column is the device's time, -1 if none is: `time_column` of run.yaml, else by the columns' names."""
    if time_column in columns:
        return columns.index(str(time_column))
    if isinstance(time_column, int) and 0 <= time_column < len(columns):
        return time_column
    by_name = [at for clock in (TIME, UNIT_OF_TIME) for at, name in enumerate(columns) if clock.fullmatch(name)]
    return by_name[0] if by_name else -1


def labelled(line: bytes) -> dict[str, str]:
    """Numbers by their names if each has its name before it, `t:20 turns:1.5 x:3.2` as plotters read it, else none."""
    text = line.decode("ascii", "replace").strip() if len(line) <= MAX_LINE else ""
    numbers_by_name: dict[str, str] = {}
    at = 0
    while at < len(text):
        field = LABELLED.match(text, at)
        if field is None or field[1] in numbers_by_name:
            return {}
        numbers_by_name[field[1]] = field[2]
        at = field.end()
    return numbers_by_name if len(numbers_by_name) >= LABELS and is_known(tuple(numbers_by_name)) else {}


def is_known(header: tuple[str, ...]) -> bool:
    """Whether one of the names is a known column of a rig."""
    return any(KNOWN.search(name) for name in header)


def points(parts: list[str]) -> list[str]:
    """The fields with decimal points in place of decimal commas."""
    return [part.replace(",", ".") if DECIMAL_COMMA.fullmatch(part) else part for part in parts]


def numbers(parts: list[str]) -> list[float] | None:
    """The fields as numbers, None unless all of them are finite ones."""
    try:
        values = [float(part) for part in parts]
    except ValueError:
        return None
    good = bool(values) and all(map(math.isfinite, values)) and not any("_" in part for part in parts)
    return values if good else None
