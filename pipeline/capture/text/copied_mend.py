"""The mend of wrongly named columns as a complete command, so that a person can copy it."""

import re
from collections.abc import Sequence
from pathlib import Path

from ...ground.command import recover_command
from ...ground.errors import BadInput
from ...ground.input.strict_yaml import parse_yaml
from ...run.description import Channel, Run
from ...run.option_mend import in_file
from ...run.run_yaml import RunYaml
from .read_channels import ReadChannels

EXCHANGE = re.compile(r"exchange the columns of (\w+) and (\w+)")


def copied_mend(mend: str, folder: Path, columns: Sequence[str]) -> str:
    """The command, or the line of run.yaml, that carries out a mend for the run in a folder; empty if there is none."""
    channels = ReadChannels(folder, columns)
    if channels.run is None:
        return ""
    if pair := EXCHANGE.search(mend):
        return _exchanged(channels, channels.run, pair[1], pair[2])
    path = folder / "run.yaml"
    try:
        content: RunYaml = parse_yaml(path.read_text(encoding="utf-8"), path)
    except (OSError, ValueError, BadInput):
        return ""
    return in_file(mend, _with_units(mend, content, channels), path)


def is_by_columns(command: str) -> bool:
    """Whether such a mend names the columns anew, which reads the recording again."""
    return " --columns " in command


def _exchanged(channels: ReadChannels, run: Run, *pair: str) -> str:
    """The command that exchanges the names of two columns; none where run.yaml finds them by their places."""
    if any(isinstance(run.channels.get(name, Channel.model_validate({})).column, int) for name in pair):
        return ""
    column_of = {place.channel: column for column, place in channels.places.items()}
    if not {*pair} <= column_of.keys():
        return ""
    first, second = (column_of[name] for name in pair)
    names = [{first: second, second: first}.get(name, name) for name in channels.columns]
    return f"{recover_command(channels.folder)} --columns {','.join(names)}"


def _with_units(mend: str, content: RunYaml, channels: ReadChannels) -> RunYaml:
    """The content with an entry for each channel of the mend that only its column's name and unit told so far."""
    entries = {**content.get("channels", {})}
    for column, place in channels.places.items():
        if f"channels.{place.channel}." in mend and place.channel not in entries and column != place.channel:
            entries[place.channel] = {"column": column, "unit": place.unit}
    return {**content, "channels": entries}
