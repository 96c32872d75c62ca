"""A made recording of nine strokes, cut into strokes, and the dataset of it."""

from pathlib import Path

from made_recording import content, recording

from pipeline.run.description import parse_run
from pipeline.run.strokes import segment
from pipeline.stages.dataset import make_dataset
from pipeline.string.history import Recorded


def recorded(name="a-01", started_utc="", samples=None, **changes):
    """A run with its strokes; nine of them unless samples are given."""
    samples = recording(9, rate_hz=50.0) if samples is None else samples
    run = parse_run(content(name, **changes), Path(f"raw/{name}/run.yaml"))
    return Recorded(run, started_utc, samples, segment(samples, "motor_turns", name))


NINE = make_dataset([recorded()])


def string(**changes):
    """The description of a string with some changes."""
    return {**content("x")["string"], **changes}
