"""The mends of wrongly read columns as complete commands, so that a person can copy them."""

import re
from collections.abc import Sequence
from pathlib import Path

from ...ground.command import recover_command
from ...ground.errors import BadInput
from ...ground.input.strict_yaml import parse_yaml
from ...run.description import Channel, Run
from ...run.option_mend import in_file
from ...run.run_yaml import RunYaml
from .likely_names import says
from .read_channels import ReadChannels

EXCHANGE = re.compile(r"exchange the columns of (\w+) and (\w+)")


def copied_mends(mends: Sequence[str], folder: Path, columns: Sequence[str], named_by_rig: bool) -> list[str]:
    """The commands, or lines of run.yaml, that carry out mends for the run in a folder: one for run.yaml, one a name.

    Two columns are exchanged in run.yaml where it reads them wrongly, else by `--columns`. A mend that no command
    carries out is left out. `named_by_rig`: the rig itself printed the names of the columns.
    """
    channels = ReadChannels(folder, columns)
    if channels.run is None:
        return []
    path = folder / "run.yaml"
    try:
        content: RunYaml = parse_yaml(path.read_text(encoding="utf-8"), path)
    except (OSError, ValueError, BadInput):
        return []
    to_write, commands = [], []
    for mend in mends:
        pair = EXCHANGE.search(mend)
        if pair is None or (mend := _read_anew(channels, channels.run, pair[1], pair[2], named_by_rig)):
            to_write.append(mend)
        else:
            commands.append(_called_anew(channels, pair[1], pair[2]))
    to_write = [mend for mend in to_write if in_file(mend, _with_units(mend, content, channels), path)]
    joined = ", and ".join(to_write)
    return list(filter(None, [in_file(joined, _with_units(joined, content, channels), path), *commands]))


def is_by_columns(command: str) -> bool:
    """Whether such a mend names the columns anew, which reads the recording again."""
    return " --columns " in command


def _column_of(channels: ReadChannels) -> dict[str, str]:
    return {place.channel: column for column, place in channels.places.items()}


def _read_anew(channels: ReadChannels, run: Run, first: str, second: str, named_by_rig: bool) -> str:
    """The mend in run.yaml where that reads two exchanged columns wrongly; empty where their names are wrong.

    It does so where it finds them by their places, or where its choice is against the words in their names. Where the
    words tell nothing, the names that a rig gives to its own columns are right.
    """
    column_of = _column_of(channels)
    if not {first, second} <= column_of.keys():
        return ""
    own = {name: run.channels.get(name, Channel.model_validate({})).column for name in (first, second)}
    by_place = any(isinstance(column, int) for column in own.values())
    if not by_place:
        if all(column_of[name] == name for name in (first, second)):
            return ""  # run.yaml chooses nothing
        right = says(column_of[first], first) or says(column_of[second], second)
        wrong = says(column_of[first], second) or says(column_of[second], first)
        if (right is wrong and not named_by_rig) or (right and not wrong):
            return ""
    places = {name: column_of[name] if own[name] is None else own[name] for name in (first, second)}
    return f"set channels.{first}.column to {places[second]!r} and channels.{second}.column to {places[first]!r}"


def _called_anew(channels: ReadChannels, first: str, second: str) -> str:
    """The command that exchanges the names of two columns, empty where one has none."""
    column_of = _column_of(channels)
    if not {first, second} <= column_of.keys():
        return ""
    changed = {column_of[first]: column_of[second], column_of[second]: column_of[first]}
    names = [changed.get(name, name) for name in channels.columns]
    return f"{recover_command(channels.folder)} --columns {','.join(names)}"


def _with_units(mend: str, content: RunYaml, channels: ReadChannels) -> RunYaml:
    """The content with an entry for each channel of the mend that only its column's name and unit told so far."""
    entries = {**content.get("channels", {})}
    for column, place in channels.places.items():
        if f"channels.{place.channel}." in mend and place.channel not in entries and column != place.channel:
            entries[place.channel] = {"column": column, "unit": place.unit}
    return {**content, "channels": entries}
