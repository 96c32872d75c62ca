"""Run folders → the health of every string in them."""

from pathlib import Path

from pipeline.lifespan.health import Health, health
from pipeline.recorded import Recorded
from pipeline.recorded_run import read


def strings(folders: list[Path]) -> list[Health]:
    """Health of every string in run folders; raises BadInput."""
    runs: dict[str, list[Recorded]] = {}
    for folder in folders:
        one = read(folder if folder.name else folder.resolve())
        runs.setdefault(one.run.string_id, []).append(one)
    return [health(of_one) for of_one in runs.values()]
