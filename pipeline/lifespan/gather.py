"""Run folders → the health of every string in them."""

import os
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.progress import steps
from ..string.from_raw import read
from ..string.history import Recorded
from .health import Health, health


def strings(folders: list[Path]) -> list[Health]:
    """Health of every string in run folders; raises BadInput."""
    runs: dict[str, list[Recorded]] = {}
    told = [Path(os.path.realpath(folder)) for folder in folders]
    for folder in told:
        if told.count(folder) > 1:
            raise BadInput(folder, "run_dir", "is named twice", "name each run once: its strokes would count twice")
    for folder in steps(folders, "run read"):
        one = read(folder if folder.name else folder.resolve())
        runs.setdefault(one.run.string_id, []).append(one)
    return [health(of_one) for of_one in runs.values()]
