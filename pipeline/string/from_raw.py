"""A run folder → the run as it was recorded, with its samples and strokes, by no stage before."""

from pathlib import Path

from ..ground.rows import opened
from ..run.folder import capture_info, recording_path
from ..run.samples import read_samples, stored_samples
from ..run.strokes import segment
from .history import Recorded


def read(folder: Path) -> Recorded:
    """A run with its samples and strokes; raises BadInput."""
    run, samples = read_samples(folder)
    strokes = segment(samples, run.system.driver, recording_path(folder))
    return Recorded(run, _started(folder), samples, strokes)


def read_long(folder: Path, temporary: Path) -> Recorded:
    """The same, whose samples are in a temporary file and read from there where they are many; raises BadInput."""
    run, _ = stored_samples(folder, temporary)
    samples = opened(temporary)
    strokes = segment(samples, run.system.driver, recording_path(folder))
    return Recorded(run, _started(folder), samples, strokes)


def _started(folder: Path) -> str:
    return str(capture_info(folder).get("started_utc", ""))
