"""Time stamps written as dates or times of day, such as 2026-11-23 16:14:34.120, as seconds."""

import datetime
import re
from typing import Any

import numpy as np
import pandas as pd

DATE = r"(?P<date>\d{4}[-/.]\d{1,2}[-/.]\d{1,2}|\d{1,2}[-/.]\d{1,2}[-/.]\d{4})"
CLOCK = r"(?P<hour>\d{1,2}):(?P<minute>[0-5]\d):(?P<second>(?:[0-5]\d|60)(?:[.,]\d+)?)"
STAMP = re.compile(rf"(?:{DATE}[T ]\s*)?{CLOCK}\s*(?P<half>[AaPp][Mm])?\s*(?P<zone>Z|[+-]\d{{2}}:?\d{{2}})?")
DAY_S = 86_400.0


def is_stamp(cell: Any) -> bool:
    """Whether a cell is a date with a time of day, or a time of day."""
    return isinstance(cell, str) and STAMP.fullmatch(cell.strip()) is not None


def holds_stamps(column: pd.Series) -> bool:
    """Whether a raw column is of dates or durations by its type, or its first cell that is not empty is a stamp."""
    kind = column.dtype.kind
    return kind in "Mm" or (kind not in "fiu" and is_stamp(next(iter(column.dropna().head(1)), None)))


def _day(date: str, month_first: bool) -> int | None:
    """A date as a count of days; None where the calendar has no such day."""
    parts = [int(part) for part in re.split(r"[-/.]", date)]
    if parts[0] > 31:
        year, month, day = parts
    else:
        year, month, day = parts[2], *(parts[:2] if month_first else parts[1::-1])
    try:
        return datetime.date(year, month, day).toordinal()
    except ValueError:
        return None


def _days(dates: list[str]) -> dict[str, float]:
    """The different dates of a column, in its order, as days: of day and month the order that puts them closer."""
    readings = [[_day(date, month_first) for date in dates] for month_first in (False, True)]
    whole = [[day for day in days if day is not None] for days in readings]
    spans = [max(days) - min(days) if len(days) == len(dates) else np.inf for days in whole]
    days = readings[int(spans[1] < spans[0])]
    return {date: np.nan if day is None else float(day) for date, day in zip(dates, days, strict=True)}


def _zone_s(zone: str) -> float:
    """The offset of a zone's clock from universal time."""
    if zone == "Z":
        return 0.0
    minutes = 60 * int(zone[1:3]) + int(zone[-2:])
    return 60.0 * (minutes if zone[0] == "+" else -minutes)


class Stamps:
    """Stamps of one column that comes in pieces: each is looked at first, then all are told in seconds, in order.

    Dates are told from all that the column has, and times of day without one from those before them.
    """

    def __init__(self) -> None:
        self.example: Any = None  # the first stamp
        self._dates: dict[str, None] = {}  # the different dates, in the column's order
        self._days: dict[str, float] = {}
        self._least: Any = None  # of dates or durations by their type
        self._first_s: float | None = None
        self._before_s, self._midnights = np.nan, 0  # the last time of day, and how often midnight was passed

    def look(self, column: pd.Series) -> None:
        """Note what is needed of all pieces before the first of them is told."""
        self.example = next(iter(column.dropna().head(1)), None) if self.example is None else self.example
        if column.dtype.kind in "Mm":
            least = column.min()
            self._least = least if pd.isna(self._least) or least < self._least else self._least
        else:
            self._dates |= dict.fromkeys(_parts(column)["date"].dropna().unique())

    def seconds(self, column: pd.Series) -> pd.Series:
        """The next piece in seconds from the column's first stamp; NaN for what is none."""
        if column.dtype.kind in "Mm":
            passed = column if column.dtype.kind == "m" else column - self._least
            seconds = passed.dt.total_seconds()
        else:
            seconds = self._since_midnight_s(column)
        if self._first_s is None:
            self._first_s = next(iter(seconds.dropna().head(1)), None)
        return seconds - (self._first_s or 0.0)

    def _since_midnight_s(self, column: pd.Series) -> pd.Series:
        """Stamps as seconds from the first date's midnight; times without a date pass midnight where they fall back."""
        parts = _parts(column)
        hour = parts["hour"].astype(float)
        half = parts["half"].str.lower()
        hour = hour.where(half.isna(), hour % 12 + 12 * (half == "pm").astype(float))
        seconds = 3600 * hour + 60 * parts["minute"].astype(float) + parts["second"].str.replace(",", ".").astype(float)
        zones = {zone: _zone_s(zone) for zone in parts["zone"].dropna().unique()}
        seconds = (seconds - parts["zone"].map(zones).astype(float).fillna(0.0)).astype(float)
        if self._dates:
            self._days = self._days or _days(list(self._dates))
            days = parts["date"].map(self._days).astype(float)
            return seconds + DAY_S * (days - np.nanmin(list(self._days.values())))
        filled_s = seconds.ffill().fillna(self._before_s).to_numpy()
        passed = self._midnights + np.cumsum(np.diff(filled_s, prepend=self._before_s) < -DAY_S / 2)
        if len(filled_s):
            self._before_s, self._midnights = float(filled_s[-1]), int(passed[-1])
        return seconds + DAY_S * passed


def _parts(column: pd.Series) -> pd.DataFrame:
    """The parts of a column of stamps."""
    return column.astype("string").str.strip().str.extract(rf"^{STAMP.pattern}$")


def stamps_s(column: pd.Series) -> pd.Series:
    """A column of stamps, dates or durations as seconds from its first one; NaN for what is none."""
    stamps = Stamps()
    stamps.look(column)
    return stamps.seconds(column)
