"""A motion that nobody has recorded: a table of time, motion and load → samples of a run, whose reading is 0."""

from pathlib import Path

import numpy as np
import pandas as pd

from ..formats.stored import read_table
from ..ground.errors import BadInput
from ..ground.text_file import TextFile
from .description import Run
from .samples import check_clock, check_finite

ROOM = 0.05  # of what was recorded: a motion that leaves it by less stays inside


def planned(run: Run, path: Path) -> pd.DataFrame:
    """Samples of a motion that a .csv or .parquet at `path` plans for a run's rig; other columns are left out.

    The file has `time_s`, the motion (`motor_turns` of a string) and, where the rig has them, load and temperature,
    under these names and in these units. A load that it lacks is `rig.load_n`, or 0. Raises BadInput.
    """
    table, system = read_table(path, TextFile.model_validate({})), run.system
    lacking = [name for name in ("time_s", system.driver) if name not in table.columns]
    if lacking:
        there = ", ".join(map(str, table.columns[:12]))
        mend = f"give a table with time_s, {system.driver}{f', {system.load}' if system.load else ''} in these units"
        raise BadInput(path, lacking[0], f"there is no such column, only {there}", mend)
    kept = [name for name in system.columns if name in table.columns and name != system.channel]
    samples = table[kept].apply(pd.to_numeric, errors="coerce").astype(float)
    if system.load and system.load not in samples:
        samples[system.load] = run.rig.get("load_n", 0.0)
    check_finite(samples, path)
    check_clock(samples, path, float("inf"))
    return samples.assign(**{system.channel: 0.0})


def beyond(run: Run, samples: pd.DataFrame, recorded: pd.DataFrame) -> str:
    """Where a planned motion leaves what was recorded, in words: nothing there says how well a simulator does.

    Nothing where it stays inside; a share `ROOM` of what was recorded is no leaving.
    """
    driver, said = run.system.driver, []
    kept = [name for name in samples.columns if name not in ("time_s", run.system.channel) and name in recorded]
    for name in kept:
        least, most = float(recorded[name].min()), float(recorded[name].max())
        room = ROOM * max(most - least, abs(most) * ROOM)
        low, high = float(samples[name].min()), float(samples[name].max())
        if low < least - room or high > most + room:
            said.append(f"{name} of {low:.4g} to {high:.4g} ({least:.4g} to {most:.4g} were recorded)")
    planned_speed, recorded_speed = _fastest(samples, driver), _fastest(recorded, driver)
    if planned_speed > (1.0 + ROOM) * recorded_speed:
        said.append(
            f"{driver} that change by {planned_speed:.3g} a second (at most {recorded_speed:.3g} were recorded)"
        )
    return f"it asks for {'; '.join(said)}" if said else ""


def _fastest(samples: pd.DataFrame, driver: str) -> float:
    """The highest speed of a motion that lasts for more than a moment, per second."""
    step_s, way = np.diff(samples["time_s"]), np.abs(np.diff(samples[driver]))
    return float(np.percentile(way / step_s, 99.0))
