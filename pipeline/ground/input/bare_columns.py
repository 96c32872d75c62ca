"""A channel that `run.yaml` gives as a column's name alone: `time_s: t` is short for `time_s: {column: t}`."""

from typing import Any

from ..units import conversion, ending_of, is_load_in_kg, unit_of
from .header_units import header_unit


def written_out(channel: str, as_written: Any) -> Any:
    """The keys of a channel that was given as a name, or an index from 0; any other value unchanged.

    A name that ends in another unit that the channel converts from is in that unit: `slide_cm` is read in cm, and
    `Zeit [ms]` or `Zeit (ms)` in ms.
    """
    if not isinstance(as_written, str | int) or isinstance(as_written, bool):
        return as_written
    unit = _unit(channel, as_written) if isinstance(as_written, str) else unit_of(channel)
    return {"column": as_written} if unit == unit_of(channel) else {"column": as_written, "unit": unit}


def _unit(channel: str, name: str) -> str:
    """The unit of a channel from its column's name: in brackets at the end or after the last `_`; else its own."""
    in_brackets = header_unit(name) if name.rstrip()[-1:] in ("]", ")") else None
    if in_brackets in (None, "V", "count"):
        return ending_of(name, channel) if "_" in name else unit_of(channel)
    try:
        conversion(channel, in_brackets)
    except ValueError:
        return in_brackets if is_load_in_kg(channel, in_brackets) else unit_of(channel)
    return in_brackets


def all_written_out(channels: Any) -> Any:
    """The `channels` of a `run.yaml` with each of them written out."""
    if not isinstance(channels, dict):
        return channels
    return {channel: written_out(str(channel), as_written) for channel, as_written in channels.items()}
