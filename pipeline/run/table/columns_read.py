"""Which column of a recording was read as which channel: it shows a person a wrong unit or column."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd

from ...ground.input.complaint import key_name
from ...ground.input.header_units import header_unit
from ...ground.units import unit_of
from ...ground.words.counts import counted
from ..description import Channel, Run
from .named_units import in_its_unit

FORCES = ("N", "kN", "gf", "kgf")  # units of a column that may be the load
NAMED = 8  # columns that nothing is read from


def read_as(
    run: Run, samples: pd.DataFrame, path: Path, recorded: int | None = None, columns: Sequence[object] = ()
) -> str:
    """The number of samples, and a line a channel with its column, its unit there, and its range in our units.

    `samples` are the table with a column a channel, as `to_samples` gives it; where those that no rig can
    have read are not among them, `recorded` says how many there were. `columns` are all of the file, of which those
    that are no channel's are named.
    """
    sentences = []
    for name in samples.columns:
        channel = run.channels.get(name)
        column = key_name(channel.column) if channel and channel.column is not None else name
        parts = [f"from {column}"] if column != name else []
        changed = _changed(channel) if channel else ""
        unit = channel.unit or (unit_of(name) if changed else "") if channel else ""
        parts += [f"in {unit}"] if unit else []
        whence = f" ({' '.join(parts)}{changed})" if parts else ""
        sentences.append(f"{name} {samples[name].min():.4g} to {samples[name].max():.4g}{whence}")
    unread = [key_name(column) for place, column in enumerate(columns) if not {place, column} & _keys(run, columns)]
    if has_no_load(run) and not np.any(samples.get("load_n", 0.0)):
        force = next((f" (is it {column}?)" for column in unread if header_unit(column) in FORCES), "")
        sentences.append(f"no load: taken as 0 N; if one hangs, name its column{force} as load_n, or write rig.load_n")
    if unread:
        more = f" and {len(unread) - NAMED} more" if len(unread) > NAMED else ""
        sentences.append(f"not read: {', '.join(unread[:NAMED])}{more}")
    count = len(samples) if recorded is None else recorded
    wild = f", of which {count - len(samples)} will not count (see the warning)" if count > len(samples) else ""
    return "\n  ".join([f"{path.name} has {counted(count, 'sample')}{wild}. They are read as:", *sentences])


def _changed(channel: Channel) -> str:
    """What is done to a column's numbers in its own unit, such as ", × -1 + 12"; empty where nothing is."""
    times = f", × {channel.scale:g}" if channel.scale != 1.0 else ""
    if not channel.offset:
        return times
    return f"{times or ','} {'-' if channel.offset < 0 else '+'} {abs(channel.offset):g}"


def _keys(run: Run, columns: Sequence[object]) -> set[object]:
    """Names, and indices from 0, of the columns that are read as channels."""
    keys: set[object] = set()
    for name in run.system.columns:
        channel = run.channels.get(name)
        named = in_its_unit(name, columns) if channel is None and name not in columns else None
        keys.add(channel.column if channel and channel.column is not None else named[0] if named else name)
    return keys


def has_no_load(run: Run) -> bool:
    """Whether a string's run has no load: neither a key for it nor a column load_n."""
    return run.system.load == "load_n" and "load_n" not in run.channels and not run.rig.get("load_n")
