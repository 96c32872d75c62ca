"""A recording, in whatever form it lies in a run folder or came from a logger, as a table of channels in our units."""

import sys
from decimal import Decimal
from pathlib import Path

import numpy as np
import pandas as pd

from ..formats.stored import read_table
from ..formats.text_layout import DECIMAL_COMMA, with_point
from ..formats.time_stamps import holds_stamps, stamps_s
from ..ground.complaint import key_name, short
from ..ground.errors import BadInput
from ..ground.text_file import TextFile
from ..ground.units import conversion
from .captured import check_lines, read_frames
from .description import STRING_ACTUATORS, Channel, Run
from .folder import recording_path
from .named_units import in_its_unit


def _place(table: pd.DataFrame, name: str, channel: Channel, path: Path, given: bool, described: Path) -> int:
    """Index of a channel's column, which `described` tells; raises BadInput where the file has none, or two."""
    key = name if channel.column is None else channel.column
    if isinstance(key, int):
        if not 0 <= key < table.shape[1]:
            mend = f"correct channels.{name}.column"
            raise BadInput(path, f"column {key}", f"is not among its {table.shape[1]} columns", mend)
        return key
    places = [place for place, column in enumerate(table.columns) if column == key]
    if len(places) > 1:
        mend = f"give the index of the right one under channels.{name}.column"
        raise BadInput(path, name, f"the column {key!r} is there {len(places)} times", mend)
    if not places:
        there = ", ".join(key_name(name) for name in table.columns[:12])
        where = f"correct channels.{name}.column" if given else f"name the column under channels.{name}.column"
        raise BadInput(path, name, f"there is no column {key!r}, only {there}", f"{where} in {described.name}")
    return places[0]


def _plain(value: object) -> object:
    """A cell as a number, a text or nothing: what is neither of the first two becomes the text that shows it."""
    if isinstance(value, Decimal | np.number):
        return float(value)
    return (
        value
        if value is None or (isinstance(value, int | float | str) and not isinstance(value, bool))
        else short(value)
    )


def _clock(column: pd.Series, path: Path) -> pd.Series:
    """A raw column of dates or times of day in seconds, NaN where it is empty; raises BadInput for what is none."""
    stamps = stamps_s(column)
    wrong = (stamps.isna() & column.notna()).to_numpy()
    if wrong.any():
        row = int(np.argmax(wrong))
        problem = (
            f"row {row + 1} holds {short(column.iloc[row])}, not a time of day like {short(column.dropna().iloc[0])}"
        )
        raise BadInput(path, "time_s", problem, "write it as the others, or remove that row")
    return stamps


def _numbers(column: pd.Series, name: str, path: Path, layout: TextFile) -> pd.Series:
    """A raw column as floats, NaN where it is empty; raises BadInput for what is no number."""
    if name == "time_s" and holds_stamps(column):
        return _clock(column, path)
    if column.dtype.kind not in "fiu" and not (column.dtype == object or pd.api.types.is_string_dtype(column.dtype)):
        mend = "write them as numbers, time_s in seconds from the start"
        raise BadInput(path, name, f"holds values of type {column.dtype}, not numbers", mend)
    if column.dtype.kind not in "fiu":
        column = column.map(_plain)
        if layout.decimal == ",":  # pandas leaves a column as it stands where one of its cells is no number
            column = column.map(with_point)
    numbers = pd.to_numeric(column, errors="coerce")
    wrong = (numbers.isna() & column.notna()).to_numpy()
    if wrong.any():
        row = int(np.argmax(wrong))
        held = column.iloc[row]
        mend = "write numbers with a decimal point" if "," in str(held) else "remove that row"
        if DECIMAL_COMMA.fullmatch(str(held).strip()) and layout.delimiter != ",":
            mend = 'set file.decimal to ","'
        raise BadInput(path, name, f"row {row + 1} holds {short(held)}, not a number", mend)
    return numbers.astype(float)


def _asked_rows(table: pd.DataFrame, layout: TextFile, path: Path) -> pd.DataFrame:
    """The rows that `file.rows` asks for, or all; raises BadInput where the file ends before them."""
    if layout.rows is None:
        return table
    if layout.rows[1] > len(table):
        raise BadInput(path, "file.rows", f"asks for rows up to {layout.rows[1]} of {len(table)}", "correct file.rows")
    return table.iloc[slice(*layout.rows)].reset_index(drop=True)


def _counted(table: pd.DataFrame, name: str, channel: Channel, mapping: Path) -> pd.Series:
    """Time in s of the rows of a file without a clock; raises BadInput for another channel, or one with a column."""
    mend = "keep it for time_s alone, without column and unit, where the file has no column of time"
    step_s = channel.step_s or 0.0
    if name != "time_s" or channel != Channel.model_validate({"step_s": step_s}):
        raise BadInput(mapping, f"channels.{name}.step_s", "says how far apart the rows are, and nothing else", mend)
    return pd.Series(step_s * np.arange(len(table)), index=table.index)


def asked_columns(run: Run) -> list[str]:
    """Names of the columns that a run's channels are read from, where it has them by name."""
    told = {name: channel.column for name, channel in run.channels.items()}
    made = {name for name, channel in run.channels.items() if channel.step_s is not None}
    columns = [
        told.get(name) if told.get(name) is not None else name for name in run.system.columns if name not in made
    ]
    return [column for column in columns if isinstance(column, str)]


def to_samples(run: Run, table: pd.DataFrame, path: Path, mapping: Path) -> pd.DataFrame:
    """A raw table from `path` as `time_s` and the run's channels in our units, by the channels of file `mapping`.

    A string without a `load_n` channel gets `rig.load_n`, or 0 N, as one. Raises BadInput.
    """
    table = _asked_rows(table, run.file, path)
    known = run.system.columns
    required = known[:3]
    for name in run.channels:
        if name not in known:
            mend = f"use one of {', '.join(known)}"
            raise BadInput(mapping, f"channels.{key_name(name)}", "is not a known channel", mend)
    asked = [channel.column for channel in run.channels.values()]
    samples: dict[str, pd.Series] = {}
    taken: dict[int, str] = {}
    for name in known:
        given = name in run.channels
        channel = run.channels.get(name, Channel.model_validate({}))
        if channel.step_s is not None:
            samples[name] = _counted(table, name, channel, mapping)
            continue
        if not given and name not in table.columns:
            free = [column for column in table.columns if column not in (*known, *asked)]
            if there := in_its_unit(name, free):
                channel = Channel.model_validate({"column": there[0], "unit": there[1]})
                print(f"{path}: {name} is read from its column {there[0]}, in {there[1]}", file=sys.stderr)
            elif name not in required:
                continue
        place = _place(table, name, channel, path, given, mapping)
        if place in taken:
            field = name if given else taken[place]
            problem = f"is column {key_name(table.columns[place])}, which is {taken[place] if given else name} as well"
            raise BadInput(mapping, f"channels.{field}.column", problem, "give each channel a column of its own")
        taken[place] = name
        try:
            factor, shift = conversion(name, channel.unit, channel.counts_per_turn)
            if name == "time_s" and factor != 1.0 and holds_stamps(table.iloc[:, place]):
                raise ValueError("is not the unit of dates and times of day, which are read in s; take it out")
        except ValueError as error:
            problem, _, mend = str(error).partition("; ")
            said = key_name(channel.unit)
            raise BadInput(mapping, f"channels.{name}.unit", f"{said} {problem}", mend) from None
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused as no number
            samples[name] = (
                factor * (channel.scale * _numbers(table.iloc[:, place], name, path, run.file) + channel.offset) + shift
            )
    if run.actuator in STRING_ACTUATORS and "load_n" not in samples:
        samples["load_n"] = pd.Series(run.rig.get("load_n", 0.0), index=table.index)
    return pd.DataFrame(samples).astype(float)


def read_recording(run: Run, folder: Path) -> pd.DataFrame:
    """Samples of a run folder, one row a sample: `time_s` and its channels, unchecked but for being numbers."""
    path = recording_path(folder)
    if path.suffix == ".frames":
        table, units = read_frames(path)
        told = {name: Channel.model_validate({"unit": unit}) for name, unit in units.items()}
        run = run.model_copy(update={"channels": {**told, **run.channels}})
    else:
        check_lines(path)
        table = read_table(path, run.file)
    return to_samples(run, table, path, folder / "run.yaml")
