"""A recording from a run folder or a logger, in any format, as a table of channels in our units."""

from collections.abc import Callable, Iterator
from itertools import chain
from pathlib import Path

import pandas as pd

from ...formats.own_table import table_pieces
from ..description import Channel, Run
from ..folder import recording_path
from .captured import check_lines, frame_pieces, read_frames, say_mended
from .channels import Channels
from .file_lines import Where
from .mended_time import MendedTime

__all__ = ["asked_columns", "check_lines", "read_frames", "read_recording", "recording_pieces", "to_samples"]


def asked_columns(run: Run) -> list[str]:
    """Names of the columns that a run's channels are read from, where it has them by name."""
    columns_given = {name: channel.column for name, channel in run.channels.items()}
    stepped = {name for name, channel in run.channels.items() if channel.step_s is not None}
    columns = [
        columns_given.get(name) if columns_given.get(name) is not None else name
        for name in run.system.columns
        if name not in stepped
    ]
    return [column for column in columns if isinstance(column, str)]


def to_samples(
    run: Run, table: pd.DataFrame, path: Path, mapping: Path, bear: bool = False, where: Where | None = None
) -> pd.DataFrame:  # fmt: skip
    """A raw table from `path` as `time_s` and the run's channels in our units, by the channels of file `mapping`.

    A string without a `load_n` channel gets `rig.load_n`, or 0 N, as one. With `bear` few cells that are no numbers
    are NaN, as empty ones are. Of a table in memory `where` says where a row stands. Raises BadInput.
    """
    (samples,) = _samples(run, lambda: iter([table]), path, mapping, bear=bear, where=where)
    return samples


def _samples(
    run: Run,
    pieces: Callable[[], Iterator[pd.DataFrame]],
    path: Path,
    mapping: Path,
    again: bool = False,
    bear: bool = False,
    where: Where | None = None,
) -> Iterator[pd.DataFrame]:
    """The result of `to_samples` for a raw table that comes in pieces, and may come twice; raises BadInput."""
    channels, tables = Channels(run, path, mapping, again, bear, where), pieces()
    first = next(tables)
    if channels.look(first):
        any(not channels.look(table) for table in tables)
        tables = pieces()
    else:
        tables = chain([first], tables)
    for table in tables:
        yield channels.samples(table)
    channels.finish()


def recording_pieces(run: Run, folder: Path) -> Iterator[pd.DataFrame]:
    """Samples of a run folder, piece by piece: `time_s` and its channels; only that they are numbers is checked."""
    path = recording_path(folder)
    if path.suffix == ".frames":
        units, pieces = frame_pieces(path)
        on_the_wire = {name: Channel.model_validate({"unit": unit}) for name, unit in units.items()}
        run = run.model_copy(update={"channels": {**on_the_wire, **run.channels}})
        return _samples(run, pieces, path, folder / "run.yaml")
    if check_lines(path):
        recorded = printed_samples(run, folder)
        say_mended(path, recorded.counted)
        return recorded.pieces()
    return _samples(run, lambda: table_pieces(path, run.file), path, folder / "run.yaml")


def printed_samples(run: Run, folder: Path) -> MendedTime:
    """Samples of lines that the capture program recorded, their time stamps mended; raises BadInput."""
    path, mapping, first_row = recording_path(folder), folder / "run.yaml", (run.file.rows or (0, 0))[0]
    return MendedTime(
        lambda again: _samples(run, lambda: table_pieces(path, run.file), path, mapping, again), path, first_row
    )


def read_recording(run: Run, folder: Path) -> pd.DataFrame:
    """Samples of a run folder, one row a sample: `time_s` and its channels; only that they are numbers is checked."""
    pieces = list(recording_pieces(run, folder))
    return pieces[0] if len(pieces) == 1 else pd.concat(pieces, ignore_index=True)
