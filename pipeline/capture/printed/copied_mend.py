"""The mends of wrongly read columns as complete commands, so that a person can copy them."""

from collections.abc import Sequence
from pathlib import Path

from ...ground.command import recover_command
from ...run.description import Channel, Run
from ...run.mend_command import EXCHANGE, mend_command
from .likely_names import says
from .read_channels import ReadChannels


def copied_mends(mends: Sequence[str], folder: Path, columns: Sequence[str], named_by_rig: bool) -> list[str]:
    """The commands that carry out mends for the run in a folder: one for run.yaml, one a name.

    Two columns are exchanged in run.yaml where it reads them wrongly, else by `--columns`. A mend that no command
    carries out is left out. `named_by_rig`: the rig itself printed the names of the columns.
    """
    channels = ReadChannels(folder, columns)
    if channels.run is None:
        return []
    to_write, commands = [], []
    for mend in mends:
        pair = EXCHANGE.search(mend)
        if pair is None or (mend := _read_anew(channels, channels.run, pair[1], pair[2], named_by_rig)):
            to_write.append(mend)
        else:
            commands.append(_called_anew(channels, pair[1], pair[2]))
    joined = ", and ".join(mend for mend in to_write if mend_command(mend, folder))
    return list(filter(None, [mend_command(joined, folder), *commands]))


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
