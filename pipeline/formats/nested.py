"""Values inside values, as JSON, MATLAB and HDF5 hold them, as named columns: `rig.motor` is a field, `x[0]` a first.

Of several columns of different lengths those that are asked for make the table.
"""

import sys
from collections.abc import Iterator, Sequence
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ..ground.errors import BadInput
from ..ground.input.complaint import key_name
from ..ground.words.counts import counted
from .interface import Columns

DEEPEST = 30
MOST_PARTS = 1_000  # columns of a matrix, or elements of a list of runs
SHOWN = 12


def _join(name: str, key: str) -> str:
    return f"{name}.{key}" if name else key


def flat(record: Any, name: str = "", depth: int = 0) -> Iterator[tuple[str, Any]]:
    """Numbers and texts of one record, each under the path to it."""
    if isinstance(record, dict) and depth < DEEPEST:
        for key, value in record.items():
            yield from flat(value, _join(name, key), depth + 1)
    elif isinstance(record, list) and depth < DEEPEST and len(record) <= MOST_PARTS:
        for index, value in enumerate(record):
            yield from flat(value, f"{name}[{index}]", depth + 1)
    else:
        yield name, record if not isinstance(record, bool | list | dict) else None


def records(rows: Sequence[Any], name: str = "") -> Columns:
    """Columns of records, one a sample; empty where a record has no such field."""
    table = pd.DataFrame.from_records([dict(flat(row)) for row in rows])
    return {_join(name, str(key)): table[key].to_numpy() for key in table.columns}


def _holds_series(value: Any, depth: int = 0) -> bool:
    """Whether a value is or holds more than one reading of a kind, so that it is a run and not a sample."""
    if isinstance(value, dict):
        return depth < DEEPEST and any(_holds_series(part, depth + 1) for part in value.values())
    return isinstance(value, list | np.ndarray) and len(np.atleast_1d(np.asarray(value, object)).ravel()) > SHOWN


def _of_list(values: list[Any], name: str, depth: int) -> Iterator[tuple[str, np.ndarray]]:
    if all(value is None or isinstance(value, Real) for value in values):
        yield name, np.array([np.nan if value is None else value for value in values], np.float64)
    elif all(isinstance(value, str | Real) or value is None for value in values):
        yield name, np.array(values, object)
    elif all(isinstance(value, dict) for value in values) and not any(map(_holds_series, values[:SHOWN])):
        yield from records(values, name).items()
    elif all(isinstance(value, list) and len(value) == len(values[0]) for value in values) and all(
        part is None or isinstance(part, Real) for value in values for part in value
    ):
        yield from columns_of(np.array(values, np.float64), name, depth + 1)
    else:
        for index, value in enumerate(values[:MOST_PARTS]):
            yield from columns_of(value, f"{name}[{index}]", depth + 1)


def columns_of(value: Any, name: str = "", depth: int = 0) -> Iterator[tuple[str, np.ndarray]]:
    """Every series in a value of dicts, lists and arrays, with its name; single numbers and words are left out.

    Each of shape (rows,) or (rows, columns), in the file's own unit.
    """
    if depth > DEEPEST:
        return
    if isinstance(value, dict):
        for key, part in value.items():
            yield from columns_of(part, _join(name, str(key)), depth + 1)
    elif isinstance(value, np.ndarray) and value.dtype.names:
        for key in value.dtype.names:
            yield from columns_of(value[key], _join(name, key), depth + 1)
    elif isinstance(value, np.ndarray) and value.dtype.kind in "fiub":
        if value.size in value.shape and value.size > 1:
            yield name, value.ravel()
        elif value.ndim == 2 and value.size:
            rows = value if value.shape[0] >= value.shape[1] else value.T  # a sample is the shorter side
            for index in range(min(rows.shape[1], MOST_PARTS)):
                yield f"{name}[{index}]", np.ascontiguousarray(rows[:, index])
    elif isinstance(value, np.ndarray) and value.dtype.kind in "OU" and value.size > 1:
        yield from _of_list(value.ravel().tolist(), name, depth)
    elif isinstance(value, list) and len(value) > 1:
        yield from _of_list(value, name, depth)
    elif isinstance(value, list | np.ndarray) and len(np.atleast_1d(value)) == 1 and depth:
        inside = np.atleast_1d(value).ravel()[0] if isinstance(value, np.ndarray) else value[0]
        if isinstance(inside, dict | list | np.ndarray):
            yield from columns_of(inside, name, depth + 1)


def _found(wanted: str, columns: Columns) -> str | None:
    """The column of that name, or the only one whose path ends in it."""
    if wanted in columns:
        return wanted
    ends = [name for name in columns if name.endswith(f".{wanted}")]
    return ends[0] if len(ends) == 1 else None


def table_of(columns: Columns, wanted: Sequence[str], path: Path) -> pd.DataFrame:
    """The columns that are as long as those asked for, which keep the name by which they were asked.

    Raises BadInput where the file holds no series, or those asked for are of different lengths.
    """
    series = {name: values for name, values in columns.items() if len(values) > 1}
    if not any(values.dtype.kind in "fiub" for values in series.values()):
        raise BadInput(path, "file", "holds no series of numbers", "save each channel as a series of its own")
    places = {name: place for name in wanted if (place := _found(name, series)) is not None}
    lengths = {name: len(series[place]) for name, place in places.items()}
    if len(set(lengths.values())) > 1:
        first, *others = lengths
        other = next(name for name in others if lengths[name] != lengths[first])
        problem = f"has {counted(lengths[other], 'value')}, but {key_name(first)} has {lengths[first]}"
        mend = "map columns that were recorded together, one value each a sample"
        raise BadInput(path, key_name(other), problem, mend)
    longest = max(len(values) for values in series.values() if values.dtype.kind in "fiub")
    length = next(iter(lengths.values()), longest)
    names = {place: name for name, place in places.items()}
    table = pd.DataFrame({names.get(name, name): values for name, values in series.items() if len(values) == length})
    empty = table[list(places)].isna().all(axis="columns") if places else pd.Series(False, index=table.index)
    if empty.any():
        print(f"{path}: {empty.sum()} of its records hold none of these channels and were left out", file=sys.stderr)
    return table[~empty].reset_index(drop=True)
