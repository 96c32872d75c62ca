"""A channel that `run.yaml` gives as a column's name alone: `time_s: t` is short for `time_s: {column: t}`."""

from typing import Any

from .units import ending_of, unit_of


def written_out(channel: str, given: Any) -> Any:
    """The keys and values of a channel of which a name, or an index from 0, was given; all else as it is.

    A name that ends in another unit that the channel converts from is in that unit: `slide_cm` is read in cm.
    """
    if not isinstance(given, str | int) or isinstance(given, bool):
        return given
    unit = ending_of(given, channel) if isinstance(given, str) and "_" in given else unit_of(channel)
    return {"column": given} if unit == unit_of(channel) else {"column": given, "unit": unit}


def all_written_out(channels: Any) -> Any:
    """The `channels` of a `run.yaml` with each of them written out."""
    if not isinstance(channels, dict):
        return channels
    return {channel: written_out(str(channel), given) for channel, given in channels.items()}
