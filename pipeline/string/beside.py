"""What the zero did between the runs that are asked about and the other runs of the same string beside them."""

from pathlib import Path

import pandas as pd

from ..ground.errors import BadInput
from ..run.description import STRING_ACTUATORS, Run
from ..run.folder import capture_info, find_runs, read_run
from ..run.strokes import segment
from .from_raw import read
from .history import Recorded
from .zero import Jump, jumps


def jumps_into(folders: list[Path], runs: list[Run], tables: list[pd.DataFrame]) -> list[Jump]:
    """Jumps of the zero into any of these runs, from one of them or from a run in the same folder as they.

    `tables` holds the runs' samples. A run beside them that cannot be read tells nothing.
    """
    if runs[0].actuator not in STRING_ACTUATORS:
        return []
    known = {
        run.run: Recorded(run, _started(folder), table, segment(table, run.system.driver, folder))
        for folder, run, table in zip(folders, runs, tables, strict=True)
    }
    every = list(known.values())
    places = {folder.resolve() for folder in folders}
    for place in sorted({folder.parent for folder in places}):
        every += [
            recorded
            for recorded in _beside(place, {run.string_id for run in runs}, places)
            if recorded.run.run not in known
        ]
    jumps_found = []
    for string in sorted({run.string_id for run in runs}):
        jumps_found += jumps([recorded for recorded in every if recorded.run.string_id == string])
    return [jump for jump in jumps_found if jump.run in known]


def _beside(place: Path, strings: set[str], but: set[Path]) -> list[Recorded]:
    """Runs in a folder of runs, `but` some, that name one of these strings."""
    runs_beside = []
    for folder in find_runs(place):
        if folder.resolve() in but:
            continue
        try:
            text = (folder / "run.yaml").read_text(encoding="utf-8")
            if any(string in text for string in strings) and read_run(folder).string_id in strings:
                runs_beside.append(read(folder))
        except (BadInput, OSError, ValueError):
            continue
    return runs_beside


def _started(folder: Path) -> str:
    """When a run began, by the capture program, or nothing."""
    return str(capture_info(folder).get("started_utc", ""))
