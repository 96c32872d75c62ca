"""The likely channels of columns that a rig names in its own words, as one complete list of names."""

import re
from collections.abc import Mapping, Sequence

from ...ground.input.header_units import header_unit
from ...ground.units import unit_of
from ...run.table.named_units import in_its_unit
from .fields import is_known
from .naming import NEEDED

WORDS = {  # in the names that people give to a rig's columns
    "time_s": r"t|time|clock|sec|seconds",
    "motor_turns": r"motor|turns?|rev|rot|theta|phi|angle|twist|rad|deg",
    "displacement_mm": r"disp|displacement|mm|x|pos|position|contraction|stroke",
    "load_n": r"load|force|weight|n",
    "temperature_c": r"temp|temperature",
    "motor_current_a": r"current|amps?",
}
UNSURE = "time_ms where it prints milliseconds"


def likely(columns: Sequence[str], channels: Sequence[str], own: Mapping[object, str]) -> str:
    """The names of all columns, separated by commas, as a run's channels; with a remark if a clock is unsure.

    By the words in them; one that is left is the one that lacks. `own` are the channels of the columns that run.yaml
    gives. Nothing where a channel that a recording must have is not found, or a name says a unit of another quantity.
    """
    if 2 * sum(is_known((name,)) or name in own for name in columns) < len(columns):
        return ""  # a banner, not names
    channel_of = {name: own.get(name) or _held(name, channels, columns) for name in columns}
    taken = {name: channel for name, channel in channel_of.items() if channel}
    free = [channel for channel in channels if channel not in taken.values()]
    for name in columns:
        meant = next((each for each in free if says(name, each)), None)
        if name not in taken and meant is not None:
            taken[name] = meant
            free.remove(meant)
    unmatched = [name for name in columns if name not in taken]
    lacking = [channel for channel in channels[:NEEDED] if channel in free]
    if len(unmatched) == len(lacking) == 1:  # of several the order would be a guess
        taken[unmatched[0]] = lacking[0]
    names = [_called(name, taken[name], own) if name in taken else name for name in columns]
    if "" in names or not {*channels[:NEEDED]} <= {*taken.values()}:
        return ""
    open_clock = any(new == "time_s" != name for name, new in zip(columns, names, strict=True))
    return ",".join(names) + (f" ({UNSURE})" if open_clock and "time_s" not in columns else "")


def _held(name: str, channels: Sequence[str], columns: Sequence[str]) -> str:
    """The channel that a column is already read as; empty where it is none."""
    if name in channels:
        return name
    return next((each for each in channels if each not in columns and in_its_unit(each, [name])), "")


def says(name: str, channel: str) -> bool:
    """Whether a column's name has a word of a channel."""
    return bool(re.search(rf"(^|[_\W])({WORDS.get(channel, '(?!)')})($|[_\W\d])", name, re.IGNORECASE))


def _called(name: str, channel: str, own: Mapping[object, str]) -> str:
    """The new name of a column: its channel's, with the unit that its old name carries; empty for an unknown unit."""
    unit = header_unit(name)
    if name in own or in_its_unit(channel, [name]):
        return name
    if unit in (None, unit_of(channel)):
        return channel
    with_unit = f"time_{unit}" if channel == "time_s" else f"{channel.rpartition('_')[0]}_{str(unit).lower()}"
    return with_unit if in_its_unit(channel, [with_unit]) else ""
