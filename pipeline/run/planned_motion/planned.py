"""A motion that nobody has recorded: a table of time, motion and load → samples of a run with a reading of 0."""

from pathlib import Path

import numpy as np
import pandas as pd

from ...formats.own_table import read_table
from ...ground.errors import BadInput
from ...ground.input.cell_numbers import cell_numbers
from ...ground.input.text_file import TextFile
from ...ground.kinematics import Array
from ...ground.units import unit_of
from ...ground.words.counts import counted
from ..checked_clock import check_clock
from ..description import STRING_ACTUATORS, Run
from ..samples import LEAST_SAMPLES, check_numbers
from ..table.file_lines import Where, by_row
from ..table.recorded_table import to_samples

STILL = 0.05  # of a load that hangs still: what its cell may read more and less
ENDS = (1.0, 99.0)  # per cent of the samples of a load: what is beyond is the noise of its cell
SPARSE_S, STEP_S = 0.2, 0.02  # between points: from which on they are corners of a motion; between points that are made
SAME = 0.01  # of a step: a point that is so near to a corner is that corner, but for rounding
RATE = " at your controller's rate: what is predicted needs the acceleration, so corners are not enough"
LONGEST_S = 86_400.0  # a plan that is made of corners


def read_plan(path: Path) -> pd.DataFrame:
    """The table of a planned motion in a .csv or .parquet, as it stands there; raises BadInput."""
    return read_table(path, TextFile.model_validate({}))


def planned(
    run: Run, plan_table: pd.DataFrame, path: Path, recorded: pd.DataFrame | None = None, where: Where = by_row
) -> tuple[pd.DataFrame, bool]:
    """The samples of a planned motion for a run's rig, and whether the table gives only its corners.

    The table, which messages call `path`, has `time_s`, the motion (`motor_turns` of a string) and, where the rig has
    them, load and temperature, under these names and in these units, or under the names that run.yaml gives to the
    columns of the recording, and in the units that it gives to them. Points of a string that lie further apart than
    samples do are joined by straight lines. Other columns are left out. A load that it lacks is that of what was
    `recorded` if it stood still, or `rig.load_n`; `where` says where a row stands. Raises BadInput, also where nothing
    tells the load.
    """
    system, table = run.system, _by_own_names(run, plan_table.reset_index(drop=True), path, where)
    lacking = [name for name in ("time_s", system.driver) if name not in table.columns]
    if lacking:
        columns_there = ", ".join(map(str, plan_table.columns[:12]))
        mend = f"give a table with time_s, {system.driver}{f', {system.load}' if system.load else ''} in these units"
        own = [f"{run.channels[name].column} for {name}" for name in lacking if _own_column(run, name)]
        own_names = f", or with the columns of the recording: {' and '.join(own)}" if own else ""
        no = "are no such columns" if len(lacking) > 1 else "is no such column"
        raise BadInput(path, ", ".join(lacking), f"there {no}, only {columns_there}", f"{mend}{own_names}")
    kept = [name for name in system.columns if name in table.columns and name != system.channel]
    samples = table[kept].apply(cell_numbers).astype(float)
    if system.load and system.load not in samples:
        samples[system.load] = _load(run, recorded, path)
    check_numbers(samples, path, where)
    _check_times(samples["time_s"].to_numpy(), path, where)
    joined = _joined(samples) if run.actuator in STRING_ACTUATORS else samples
    if len(joined) < LEAST_SAMPLES:
        problem = f"holds {counted(len(joined), 'sample')}, too few for a stroke"
        corners = f"corners that lie more than {SPARSE_S:g} s apart, or " if run.actuator in STRING_ACTUATORS else ""
        rate = RATE if system.differentiates else ""
        raise BadInput(path, "file", problem, f"give {corners}at least {LEAST_SAMPLES} samples of the motion{rate}")
    if system.differentiates and float(np.diff(joined["time_s"]).max()) > SPARSE_S:
        apart = f"has rows {float(np.diff(joined['time_s']).max()):.3g} s apart, and these are corners of a motion"
        raise BadInput(path, "time_s", apart, f"give the motion{RATE}")
    check_clock(joined, path, float("inf"), where)
    return joined.assign(**{system.channel: 0.0}), joined is not samples


def _check_times(time_s: Array, path: Path, where: Where) -> None:
    """Raise BadInput where two times of a plan, shape (rows,), in s, are equal, or run backwards."""
    wrong = np.flatnonzero(np.diff(time_s) <= 0.0)
    if not len(wrong):
        return
    row = int(wrong[0]) + 1
    both = f"in {where(row - 1)} and {where(row)}"
    if time_s[row] < time_s[row - 1]:
        problem = f"runs backwards from {time_s[row - 1]:g} s to {time_s[row]:g} s {both}"
        raise BadInput(path, "time_s", problem, "put the rows in the order of their times")
    problem = f"is {time_s[row]:g} s {both}: a motor takes time for a step"
    raise BadInput(path, "time_s", problem, f"give {where(row)} the time at which the motor is to be there")


def _own_column(run: Run, name: str) -> str | None:
    """The column name of a channel in a run's recording; None where the channel has no column."""
    column = run.channels[name].column if name in run.channels else None
    return column if isinstance(column, str) and column != name else None


def _by_own_names(run: Run, table: pd.DataFrame, path: Path, where: Where) -> pd.DataFrame:
    """A table whose channels have the recording's column names, in our names and units."""
    own = {
        name: run.channels[name]
        for name in run.system.columns
        if name != run.system.channel and name not in table.columns and _own_column(run, name) in table.columns
    }
    if not own:
        return table
    raw = table[list(dict.fromkeys(channel.column for channel in own.values()))]
    absent = {name: 0.0 for name in run.system.columns if name not in own}
    reader = run.model_copy(update={"channels": own, "file": TextFile.model_validate({})})
    read = to_samples(reader, raw.assign(**absent), path, Path("run.yaml"), where=where)
    return table.assign(**{name: read[name] for name in own})


def _load(run: Run, recorded: pd.DataFrame | None, path: Path) -> float:
    """The load of a plan that gives none; raises BadInput where the recorded load changed."""
    name = run.system.load or ""
    if recorded is None or name not in recorded:  # else its channel wins over rig.load_n, which fills in for none
        return run.rig.get(name, 0.0)
    low, high = (float(end) for end in np.percentile(recorded[name], ENDS))
    if high - low > STILL * abs(low):
        problem = f"there is no such column, and the load of {run.run} was not always the same"
        raise BadInput(path, name, problem, f"add it: {low:.4g} to {high:.4g} were recorded")
    return float(recorded[name].median())


def load_taken(run: Run, plan_table: pd.DataFrame, samples: pd.DataFrame, recorded: pd.DataFrame | None) -> list[str]:
    """The sentence on the load that the `samples` of a plan have and its table does not; none where it has one.

    `recorded` are the samples of the run, if it has some.
    """
    name = run.system.load
    if not name or {name, _own_column(run, name)} & {*plan_table.columns}:
        return []
    load = float(samples[name].iloc[0])
    if not (load or run.system.needs_string):
        return []
    by_rig = run.rig.get(name) == load and (recorded is None or recorded[name].eq(load).all())
    origin = f"the median of the recording of {run.run}"
    if by_rig:
        origin = f"rig.{name} of run.yaml"
    elif recorded is None:
        origin = f"as run.yaml has no rig.{name}"
    return [f"The plan has no column {name}: its load is {load:.5g} {unit_of(name)} throughout, {origin}."]


def _joined(samples: pd.DataFrame) -> pd.DataFrame:
    """The samples unchanged; or, for a motion given by corners, one every `STEP_S` on the lines between them."""
    time_s = samples["time_s"].to_numpy()
    rises = len(time_s) > 1 and bool((np.diff(time_s) > 0.0).all()) and bool(np.isfinite(time_s).all())
    if not rises or float(np.diff(time_s).max()) <= SPARSE_S or time_s[-1] - time_s[0] > LONGEST_S:
        return samples
    between_s = np.arange(time_s[0], time_s[-1], STEP_S)
    corners = np.searchsorted(time_s, between_s + SAME * STEP_S) - np.searchsorted(time_s, between_s - SAME * STEP_S)
    fine_s = np.union1d(time_s, between_s[corners == 0])
    return pd.DataFrame({name: np.interp(fine_s, time_s, samples[name]) for name in samples} | {"time_s": fine_s})
