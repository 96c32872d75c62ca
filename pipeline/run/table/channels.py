"""The channels of a run from its raw table, which may come in pieces: in our units, or refused."""

import sys
from decimal import Decimal
from pathlib import Path

import numpy as np
import pandas as pd

from ...formats.text_layout import with_point
from ...formats.time_stamps import Stamps, holds_stamps
from ...ground.errors import BadInput
from ...ground.input.cell_numbers import cell_numbers
from ...ground.input.complaint import key_name, short
from ...ground.units import conversion
from ..description import STRING_ACTUATORS, Channel, Run
from .column_places import check_columns, place_of
from .file_lines import FileLines, Where, by_row, called
from .named_units import in_its_unit
from .no_number import are_few, no_number


def _plain(value: object) -> object:
    """A cell as a number, a text or nothing; any other value becomes its text."""
    if isinstance(value, Decimal | np.number):
        return float(value)
    return (
        value
        if value is None or (isinstance(value, int | float | str) and not isinstance(value, bool))
        else short(value)
    )


class Channels:
    """The channels of a run by file `mapping`, from a raw table at `path`; its pieces must come in order.

    The first piece is looked at before it is told; where that says so, all others are looked at before that too.
    Where a recording is read `again`, nothing is said a second time. With `bear` few cells that are no numbers are
    taken as empty ones. Of a table in memory `where` says where a row stands.
    """

    def __init__(
        self, run: Run, path: Path, mapping: Path, again: bool = False, bear: bool = False, where: Where | None = None
    ) -> None:
        self.run, self.path, self.mapping, self._bear, self._where = run, path, mapping, bear, where
        self._rows = self._looked = 0  # of the pieces that were told so far, and of those that were looked at
        self._sample = 0  # of those that were told, that file.rows asks for
        self._stamps: Stamps | None = None
        self._said: set[str] = {*run.system.columns} if again else set()
        for name in run.channels:
            if name not in run.system.columns:
                mend = f"use one of {', '.join(run.system.columns)}"
                raise BadInput(mapping, f"channels.{key_name(name)}", "is not a known channel", mend)

    def entry(self, table: pd.DataFrame, name: str) -> Channel | None:
        """The entry by which a channel is read from such a table; None for one that is missing and not needed."""
        if name in self.run.channels:
            return self.run.channels[name]
        named = [channel.column for channel in self.run.channels.values()]
        if name not in table.columns:
            own_columns = self.run.system.columns
            free = [column for column in table.columns if column not in (*own_columns, *named)]
            if in_unit := in_its_unit(name, free):
                if name not in self._said:
                    self._said.add(name)
                    print(f"{self.path}: {name} is read from its column {in_unit[0]}, in {in_unit[1]}", file=sys.stderr)
                return Channel.model_validate({"column": in_unit[0], "unit": in_unit[1]})
            if name not in own_columns[:3]:
                return None
        return Channel.model_validate({})

    def _placed(self, table: pd.DataFrame, name: str, channel: Channel) -> int:
        return place_of(table, name, channel, self.path, name in self.run.channels, self.mapping)

    def _check_columns(self, table: pd.DataFrame) -> None:
        """Raise BadInput that names all missing columns at once, where several are missing."""
        channels = {name: self.entry(table, name) for name in self.run.system.columns}
        wanted = {name: channel for name, channel in channels.items() if channel and channel.step_s is None}
        check_columns(table, wanted, self.path, self.run.channels, self.mapping)

    def _asked(self, table: pd.DataFrame, first: int) -> pd.DataFrame:
        """The rows of a piece that `file.rows` asks for, or all; `first` is the number of its first row."""
        rows = self.run.file.rows
        if rows is None:
            return table
        return table.iloc[slice(*(max(row - first, 0) for row in rows))].reset_index(drop=True)

    def look(self, table: pd.DataFrame) -> bool:
        """Note the time stamps of a piece if they are dates or times; returns whether it needs the next piece too."""
        table, self._looked = self._asked(table, self._looked), self._looked + len(table)
        self._check_columns(table)
        channel = self.entry(table, "time_s")
        if channel is None or channel.step_s is not None:
            return False
        column = table.iloc[:, self._placed(table, "time_s", channel)]
        if self._stamps is None and not holds_stamps(column):
            return bool(column.isna().all())
        self._stamps = self._stamps or Stamps()
        self._stamps.look(column)
        return True

    def samples(self, table: pd.DataFrame) -> pd.DataFrame:
        """The next piece as `time_s` and the run's channels in our units; raises BadInput.

        A string without a `load_n` channel gets `rig.load_n`, or 0 N, as one.
        """
        table, self._rows = self._asked(table, self._rows), self._rows + len(table)
        samples: dict[str, pd.Series] = {}
        taken: dict[int, str] = {}
        for name in self.run.system.columns:
            channel = self.entry(table, name)
            if channel is None:
                continue
            if channel.step_s is not None:
                samples[name] = self._counted(table, name, channel)
                continue
            place, is_named = self._placed(table, name, channel), name in self.run.channels
            if place in taken:
                field, other = (name, taken[place]) if is_named else (taken[place], name)
                problem = f"is column {key_name(table.columns[place])}, which is {other} as well"
                mend = "give each channel a column of its own"
                raise BadInput(self.mapping, f"channels.{field}.column", problem, mend)
            taken[place] = name
            samples[name] = self._in_our_unit(table.iloc[:, place], name, channel)
        if self.run.actuator in STRING_ACTUATORS and "load_n" not in samples:
            samples["load_n"] = pd.Series(self.run.rig.get("load_n", 0.0), index=table.index)
        self._sample += len(table)
        return pd.DataFrame(samples).astype(float)

    def finish(self) -> None:
        """Raise BadInput where the pieces ended before the rows that `file.rows` asks for."""
        rows = self.run.file.rows
        if rows is not None and rows[1] > self._rows:
            problem = f"asks for rows up to {rows[1]} of {self._rows}"
            raise BadInput(self.path, "file.rows", problem, "correct file.rows")

    def _counted(self, table: pd.DataFrame, name: str, channel: Channel) -> pd.Series:
        """Time in s of rows without a clock; raises BadInput for another channel, or one with a column."""
        mend = "keep it for time_s alone, without column and unit, where the file has no column of time"
        step_s = channel.step_s or 0.0
        if name != "time_s" or channel != Channel.model_validate({"step_s": step_s}):
            problem = "says how far apart the rows are, and nothing else"
            raise BadInput(self.mapping, f"channels.{name}.step_s", problem, mend)
        return pd.Series(step_s * np.arange(self._sample, self._sample + len(table)), index=table.index)

    def _in_our_unit(self, column: pd.Series, name: str, channel: Channel) -> pd.Series:
        """A raw column in its channel's unit; raises BadInput."""
        try:
            factor, shift = conversion(name, channel.unit, channel.counts_per_turn)
            if name == "time_s" and factor != 1.0 and self._stamps is not None:
                raise ValueError("is not the unit of dates and times of day, which are read in s; take it out")
        except ValueError as error:
            problem, _, mend = str(error).partition("; ")
            unit_name = key_name(channel.unit)
            raise BadInput(self.mapping, f"channels.{name}.unit", f"{unit_name} {problem}", mend) from None
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused as no number
            return factor * (channel.scale * self._numbers(column, name) + channel.offset) + shift

    def _refuses(self, wrong: np.ndarray) -> bool:
        """Whether cells of this piece that are no numbers are refused instead of counting as empty."""
        return bool(wrong.any()) and not (self._bear and are_few(int(wrong.sum()), len(wrong)))

    def _clock(self, column: pd.Series, stamps: Stamps) -> pd.Series:
        """A raw column of dates or times of day in seconds, NaN where empty; raises BadInput for any other value."""
        seconds = stamps.seconds(column)
        wrong = (seconds.isna() & column.notna()).to_numpy()
        if self._refuses(wrong):
            wrong_cell, good = short(column.iloc[int(np.argmax(wrong))]), short(stamps.example)
            by = self._where or FileLines(self.path, self.run.file)
            where = by(self._sample + int(np.argmax(wrong)))
            problem = f"{where} holds {wrong_cell}, not a time of day like {good}"
            mend = f"write it as the others, or remove that {called(where)}"
            raise BadInput(self.path, "time_s", problem, mend)
        return seconds

    def _numbers(self, column: pd.Series, name: str) -> pd.Series:
        """A raw column as floats, NaN where empty; raises BadInput for a cell that is no number."""
        layout = self.run.file
        if name == "time_s" and self._stamps is not None:
            return self._clock(column, self._stamps)
        if column.dtype.kind not in "fiu" and not (
            column.dtype == object or pd.api.types.is_string_dtype(column.dtype)
        ):
            mend = "write them as numbers, time_s in seconds from the start"
            raise BadInput(self.path, name, f"holds values of type {column.dtype}, not numbers", mend)
        if column.dtype.kind not in "fiu":
            column = column.map(_plain)
            if layout.decimal == ",":  # pandas leaves a column as it stands where one of its cells is no number
                column = column.map(with_point)
        numbers = cell_numbers(column)
        wrong = (numbers.isna() & column.notna()).to_numpy()
        if self._refuses(wrong):
            first = self._sample + (layout.rows or (0, 0))[0]
            raise no_number(column, wrong, first, layout, self.path, name, self._where or by_row)
        return numbers.astype(float)
