"""A run folder → the run as it was recorded, with its samples and strokes, by no stage before."""

from pathlib import Path

from ..run.folder import capture_info, recording_path
from ..run.samples import read_samples
from ..run.strokes import segment
from .history import Recorded


def read(folder: Path) -> Recorded:
    """A run with its samples and strokes; raises BadInput."""
    run, samples = read_samples(folder)
    started = str(capture_info(folder).get("started_utc", ""))
    return Recorded(run, started, samples, segment(samples, run.system.driver, recording_path(folder)))
