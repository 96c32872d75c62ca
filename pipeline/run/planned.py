"""A motion that nobody has recorded: a table of time, motion and load → samples of a run, whose reading is 0."""

from pathlib import Path

import pandas as pd

from ..formats.stored import read_table
from ..ground.errors import BadInput
from ..ground.text_file import TextFile
from .description import Run
from .samples import check_clock, check_finite


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
