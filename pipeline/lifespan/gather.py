"""Run folders → the health of every string in them."""

from pathlib import Path

from pipeline.ingest import read_samples
from pipeline.lifespan.health import Health, health
from pipeline.recorded import Recorded
from pipeline.runs import capture_info, recording_path
from pipeline.strokes import segment


def read(folder: Path) -> Recorded:
    """A run with its samples and strokes; raises BadInput."""
    run, samples = read_samples(folder)
    started = str(capture_info(folder).get("started_utc", ""))
    return Recorded(run, started, samples, segment(samples, run.system.driver, recording_path(folder)))


def strings(folders: list[Path]) -> list[Health]:
    """Health of every string in run folders; raises BadInput."""
    runs: dict[str, list[Recorded]] = {}
    for folder in folders:
        one = read(folder if folder.name else folder.resolve())
        runs.setdefault(one.run.string_id, []).append(one)
    return [health(of_one) for of_one in runs.values()]
