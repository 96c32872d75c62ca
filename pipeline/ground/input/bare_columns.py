"""A channel that `run.yaml` gives as a column's name alone: `time_s: t` is short for `time_s: {column: t}`."""

import re
from typing import Any

from ..units import conversion, ending_of, is_load_in_kg, unit_of
from .header_units import SPACE, header_unit, unit_word

APART = re.compile(rf"[\])]\s*$|\bin\s+\S+\s*$|/\s*[^/\s]+\s*$|{SPACE}")  # a unit that stands apart from the name
UNSURE = ("V", "count")  # of these a channel says how many make its unit
OTHER_THINGS = ("in", "u", "rot")  # names of an input, a voltage and an angle as likely as of a unit


def written_out(channel: str, as_written: Any) -> Any:
    """The keys of a channel that was given as a name, or an index from 0; any other value unchanged.

    A name that is another unit that the channel converts from, or ends in it, is in that unit: `ms` and `Zeit [ms]`,
    `Zeit (ms)` or `Zeit ms` are read in ms, `slide_cm` in cm.
    """
    if not isinstance(as_written, str | int) or isinstance(as_written, bool):
        return as_written
    unit = _unit(channel, as_written) if isinstance(as_written, str) else unit_of(channel)
    return {"column": as_written} if unit == unit_of(channel) else {"column": as_written, "unit": unit}


def _unit(channel: str, name: str) -> str:
    """The unit of a channel, by its column's name: in brackets, after `in`, `/`, `_`, a space, or all; else its own."""
    unit = header_unit(name) if APART.search(name) else _whole(name)
    if unit is None or unit in UNSURE:
        return ending_of(name, channel) if "_" in name else unit_of(channel)
    try:
        conversion(channel, unit)
    except ValueError:
        return unit if is_load_in_kg(channel, unit) else unit_of(channel)
    return unit


def _whole(name: str) -> str | None:
    """The unit that a column, or the last part of `data.ms`, is called by alone; None for what may be another thing."""
    word = name.rpartition(".")[2].strip()
    return None if word.lower() in OTHER_THINGS else unit_word(word)


def all_written_out(channels: Any) -> Any:
    """The `channels` of a `run.yaml` with each of them written out."""
    if not isinstance(channels, dict):
        return channels
    return {channel: written_out(str(channel), as_written) for channel, as_written in channels.items()}
