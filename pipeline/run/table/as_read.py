"""The entry of `channels` by which a channel of a recording is read, also where run.yaml has none."""

from pathlib import Path

import pandas as pd

from ...formats.own_table import table_pieces
from ...ground.units import unit_of
from ..description import Run
from ..folder import has_recording, recording_path
from ..run_yaml import ChannelYaml
from .captured import frame_pieces
from .channels import Channels


def entry_as_read(run: Run, folder: Path, name: str) -> ChannelYaml:
    """The column and the unit of a channel that run.yaml does not name; empty where they are the channel's own.

    Raises BadInput where the recording cannot be read.
    """
    if not has_recording(folder):
        return {}
    path = recording_path(folder)
    entry: ChannelYaml = {}
    if path.suffix == ".frames":
        unit = frame_pieces(path)[0].get(name)
    else:
        table = pd.DataFrame(columns=next(table_pieces(path, run.file)).columns)
        channel = Channels(run, path, folder / "run.yaml", again=True).entry(table, name)
        unit = channel.unit if channel else None
        if channel and channel.column is not None:
            entry["column"] = channel.column
    if unit not in (None, unit_of(name)):
        entry["unit"] = unit
    return entry
