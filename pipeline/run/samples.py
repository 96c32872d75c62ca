"""Recording → samples: a run's channels in our units, checked at the door, and cut into strokes there."""

import sys
from collections.abc import Iterator
from itertools import chain
from pathlib import Path

import numpy as np
import pandas as pd

from ..ground.errors import BadInput
from ..ground.kinematics import Places
from ..ground.stored import schemas
from ..ground.stored.files import whole
from ..ground.stored.rows import Rows, Stored, rows_of
from ..ground.words.counts import counted
from .checked_clock import SLOWEST_S, check_clock
from .description import STRING_ACTUATORS, Run
from .dimensions import geometry
from .doubts.plausible import check_string, doubts
from .doubts.wild_samples import wild_samples
from .doubts.wrapping import wrapped
from .folder import checked_info, read_run, recording_path
from .mend_command import commanded
from .strokes import segment
from .table.file_lines import FileLines, Where, by_row, called
from .table.rate import STEP_S
from .table.recorded_table import read_recording, recording_pieces

LEAST_SAMPLES = 20


def check_finite(samples: pd.DataFrame | Rows, path: Path, where: Where = by_row) -> None:
    """Raise BadInput for a table too short to hold a stroke, a NaN or an infinity; `where` says where a row stands."""
    rows = rows_of(samples)
    if len(rows) < LEAST_SAMPLES:
        problem = f"holds {counted(len(rows), 'sample')}, too few for a stroke"
        raise BadInput(path, "file", problem, "record at least one stroke at 10 Hz to 10 kHz")
    check_numbers(rows, path, where)


def check_numbers(samples: pd.DataFrame | Rows, path: Path, where: Where = by_row) -> None:
    """Raise BadInput for a NaN or an infinity in a table; `where` says where a row stands."""
    rows = rows_of(samples)
    for name in rows.columns:
        bad = [np.flatnonzero(~np.isfinite(piece)) for piece in rows.pieces(name)]
        if count := sum(map(len, bad)):
            first = next(
                begin + int(places[0]) for (begin, _), places in zip(rows.spans, bad, strict=True) if len(places)
            )
            what = called(where(first))
            mend = f"remove the {what}s without a reading; missing {what}s are no harm"
            problem = f"is not a number in {count} of {counted(len(rows), what)}, first in {where(first)}"
            raise BadInput(path, name, problem, mend)


def _cut(run: Run, samples: Rows, path: Path, where: Where) -> pd.DataFrame:
    """Strokes of finite samples; raises BadInput if a channel cannot be what its name says, or no stroke is there."""
    slowest_s = STEP_S[1] if run.actuator in STRING_ACTUATORS else SLOWEST_S
    check_clock(samples, path, slowest_s, where, _unit_of_time(run))
    if run.actuator not in STRING_ACTUATORS and len(set(samples.extremes(run.system.channel))) == 1:
        raise BadInput(path, run.system.channel, "never changes", "check the sensor and its cable")
    if run.actuator in STRING_ACTUATORS:
        try:
            check_string(run, samples, geometry(run), path)
        except BadInput as mistake:  # of an angle that wraps any unit and any direction is wrong
            raise wrapped(samples, path) or mistake from None
    return segment(samples, run.system.driver, path)


def _unit_of_time(run: Run) -> str | None:
    """The unit in which run.yaml reads a column as the time; None where it does not say it."""
    channel = run.channels.get("time_s")
    return None if channel is None or channel.step_s is not None else channel.unit or "s"


def check(run: Run, samples: pd.DataFrame, path: Path, where: Where = by_row) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Samples of a run, read from `path`, without the few that are impossible, and its strokes.

    What is left out is said on standard error; `where` says where a row stands. Raises BadInput unless the samples can
    be what their names say and hold a stroke.
    """
    check_finite(samples, path, where)
    gone, warnings = wild_samples(run, rows_of(samples), path, where)
    _warn(warnings)
    if warnings:
        samples = samples.drop(index=samples.index[gone])
    samples = samples.reset_index(drop=True)
    return samples, _cut(run, rows_of(samples), path, _beyond(gone, where))


def _beyond(gone: Places, where: Where) -> Where:
    """Where a row stands, as a function of its number in a table without the rows `gone`."""
    before = gone - np.arange(len(gone))  # how many rows are left before each that is gone
    return lambda row: where(row + int(np.searchsorted(before, row, side="right")))


def _warn(sentences: list[str]) -> None:
    for sentence in sentences:
        print(f"warning: {sentence}", file=sys.stderr)


def questions(run: Run, samples: pd.DataFrame | Rows, path: Path) -> list[BadInput]:
    """Likely mistakes in checked samples: they are no reason to refuse, and all are told."""
    return doubts(run, rows_of(samples), geometry(run), path) if run.actuator in STRING_ACTUATORS else []


def read_samples(folder: Path | str) -> tuple[Run, pd.DataFrame]:
    """A run and its samples (`time_s` and the channels, one row a sample), checked; raises BadInput."""
    run, samples, _ = read_strokes(folder)
    return run, samples


def read_strokes(folder: Path | str) -> tuple[Run, pd.DataFrame, pd.DataFrame]:
    """A run, its samples as `read_samples` gives them, and its strokes (`schemas.STROKES`); raises BadInput."""
    folder = Path(folder)
    run = read_run(folder)
    checked_info(folder)
    with commanded(folder):
        samples = read_recording(run, folder)
        path = recording_path(folder)
        return run, *check(run, samples, path, FileLines(path, run.file))


def stored_strokes(folder: Path, temporary: Path) -> tuple[Run, Stored, pd.DataFrame]:
    """The result of `read_strokes`, but with the samples in a file that is written and read by row groups.

    However long the recording, no more than a few row groups are held. Raises BadInput.
    """
    with commanded(folder):
        return _stored(folder, temporary)


def _stored(folder: Path, temporary: Path) -> tuple[Run, Stored, pd.DataFrame]:
    run = read_run(folder)
    checked_info(folder)
    pieces = recording_pieces(run, folder)
    path, first = recording_path(folder), next(pieces)
    schema = schemas.samples(list(first.columns))
    schemas.put(chain([first], pieces), schema, temporary)
    samples = Stored(temporary)
    where = FileLines(path, run.file)
    check_finite(samples, path, where)
    gone, warnings = wild_samples(run, samples, path, where)
    _warn(warnings)
    if warnings:
        with whole(temporary) as other:
            schemas.put(_without(samples, gone), schema, other)
        samples = Stored(temporary)
    return run, samples, _cut(run, samples, path, _beyond(gone, where))


def _without(samples: Rows, gone: Places) -> Iterator[pd.DataFrame]:
    """Samples without some rows, piece by piece."""
    for first, stop in samples.spans:
        begin, end = np.searchsorted(gone, [first, stop])
        yield samples.frame(first, stop).drop(index=gone[begin:end] - first)
