"""The column of a channel in a raw table; missing columns are all named at once."""

from collections.abc import Container
from pathlib import Path

import pandas as pd

from ...ground.errors import BadInput
from ...ground.input.complaint import key_name
from ..description import Channel

SHOWN = 12  # columns of a table that are named


class NoColumn(BadInput):
    """A table lacks the column of a channel."""


def place_of(table: pd.DataFrame, name: str, channel: Channel, path: Path, is_named: bool, described: Path) -> int:
    """Index of a channel's column, as `described`; raises BadInput where the file has no such column, or two."""
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
        names = ", ".join(key_name(name) for name in table.columns[:SHOWN])
        where = f"correct channels.{name}.column" if is_named else f"name the column under channels.{name}"
        raise NoColumn(path, name, f"there is no column {key!r}, only {names}", f"{where} in {described.name}")
    return places[0]


def check_columns(
    table: pd.DataFrame, wanted: dict[str, Channel], path: Path, own_channels: Container[str], described: Path
) -> None:
    """Raise BadInput for all channels together if two or more name a column that the table lacks.

    `own_channels` are the channels whose columns the file `described` tells. One alone is for `place_of` to refuse.
    """
    keys = {name: name if channel.column is None else channel.column for name, channel in wanted.items()}
    lacking = {name: key for name, key in keys.items() if isinstance(key, str) and key not in table.columns}
    if len(lacking) < 2:
        return
    names = ", ".join(key_name(name) for name in table.columns[:SHOWN])
    verb = "correct" if all(name in own_channels for name in lacking) else "name the columns under"
    where = ", ".join(f"channels.{name}{'.column' * (name in own_channels)}" for name in lacking)
    *several, last = map(repr, lacking.values())
    problem = f"there are no columns {', '.join(several)} and {last}, only {names}"
    raise NoColumn(path, ", ".join(lacking), problem, f"{verb} {where} in {described.name}")
