"""A run folder → the run as it was recorded, with its samples and strokes, by no stage before."""

from pathlib import Path

from ..ground.stored.rows import opened
from ..run.folder import started_utc
from ..run.samples import read_strokes, stored_strokes
from .history import Recorded


def read(folder: Path) -> Recorded:
    """A run with its samples and strokes; raises BadInput."""
    run, samples, strokes = read_strokes(folder)
    return Recorded(run, started_utc(folder), samples, strokes, folder)


def read_long(folder: Path, temporary: Path) -> Recorded:
    """The same, whose samples are in a temporary file and read from there where they are many; raises BadInput."""
    run, _, strokes = stored_strokes(folder, temporary)
    return Recorded(run, started_utc(folder), opened(temporary), strokes, folder)
