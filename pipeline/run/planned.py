"""A motion that nobody has recorded: a table of time, motion and load → samples of a run, whose reading is 0."""

from pathlib import Path

import numpy as np
import pandas as pd

from ..formats.stored import read_table
from ..ground.errors import BadInput
from ..ground.text_file import TextFile
from .description import STRING_ACTUATORS, Run
from .samples import check_clock, check_finite

STANDS, UNWOUND, SHORT_S = 0.02, 0.05, 1.0  # of the highest speed: slower stands; of the range; not worth a word
LONGER = 2.0  # times the longest hold that was recorded: what is slow goes on in a longer one
ROOM = 0.05  # of what was recorded: a motion that leaves it by less stays inside
STILL = 0.05  # of a load that hangs still: what its cell may read more and less
SPARSE_S, STEP_S = 0.2, 0.02  # between points: from which on they are corners of a motion; between points that are made
LONGEST_S = 86_400.0  # a plan that is made of corners


def planned(run: Run, path: Path, recorded: pd.DataFrame | None = None) -> pd.DataFrame:
    """Samples of a motion that a .csv or .parquet at `path` plans for a run's rig; other columns are left out.

    The file has `time_s`, the motion (`motor_turns` of a string) and, where the rig has them, load and temperature,
    under these names and in these units. Points of a string that lie further apart than samples do are joined by
    straight lines. A load that it lacks is `rig.load_n`, or that of what was `recorded` if it stood still. Raises
    BadInput, also where nothing tells the load.
    """
    table, system = read_table(path, TextFile.model_validate({})), run.system
    lacking = [name for name in ("time_s", system.driver) if name not in table.columns]
    if lacking:
        columns_there = ", ".join(map(str, table.columns[:12]))
        mend = f"give a table with time_s, {system.driver}{f', {system.load}' if system.load else ''} in these units"
        raise BadInput(path, lacking[0], f"there is no such column, only {columns_there}", mend)
    kept = [name for name in system.columns if name in table.columns and name != system.channel]
    samples = table[kept].apply(pd.to_numeric, errors="coerce").astype(float)
    if system.load and system.load not in samples:
        samples[system.load] = _load(run, recorded, path)
    if run.actuator in STRING_ACTUATORS:
        samples = _joined(samples)
    check_finite(samples, path)
    check_clock(samples, path, float("inf"))
    return samples.assign(**{system.channel: 0.0})


def _load(run: Run, recorded: pd.DataFrame | None, path: Path) -> float:
    """The load of a plan that gives none; raises BadInput where it was recorded, and changed."""
    name = run.system.load or ""
    if name in run.rig or recorded is None or name not in recorded:
        return run.rig.get(name, 0.0)
    low, high = float(recorded[name].min()), float(recorded[name].max())
    if high - low > STILL * abs(low):
        problem = f"there is no such column, and the load of {run.run} was not always the same"
        raise BadInput(path, name, problem, f"add it: {low:.4g} to {high:.4g} were recorded")
    return float(recorded[name].median())


def _joined(samples: pd.DataFrame) -> pd.DataFrame:
    """Samples as they are; of points that are a motion's corners, one every `STEP_S` on the straight lines between."""
    time_s = samples["time_s"].to_numpy()
    rises = len(time_s) > 1 and bool((np.diff(time_s) > 0.0).all()) and bool(np.isfinite(time_s).all())
    if not rises or float(np.diff(time_s).max()) <= SPARSE_S or time_s[-1] - time_s[0] > LONGEST_S:
        return samples
    fine_s = np.union1d(time_s, np.arange(time_s[0], time_s[-1], STEP_S))
    return pd.DataFrame({name: np.interp(fine_s, time_s, samples[name]) for name in samples} | {"time_s": fine_s})


def beyond(run: Run, samples: pd.DataFrame, recorded: pd.DataFrame) -> str:
    """Where a planned motion leaves what was recorded, in words: nothing there says how well a simulator does.

    Nothing where it stays inside; a share `ROOM` of what was recorded is no leaving.
    """
    driver, ranges = run.system.driver, []
    kept = [name for name in samples.columns if name not in ("time_s", run.system.channel) and name in recorded]
    for name in kept:
        least, most = float(recorded[name].min()), float(recorded[name].max())
        room = ROOM * max(most - least, abs(most) * ROOM)
        low, high = float(samples[name].min()), float(samples[name].max())
        if low < least - room or high > most + room:
            ranges.append(f"{name} of {low:.4g} to {high:.4g} ({least:.4g} to {most:.4g} were recorded)")
    planned_speed, recorded_speed = _fastest(samples, driver), _fastest(recorded, driver)
    if planned_speed > (1.0 + ROOM) * recorded_speed:
        ranges.append(
            f"{driver} that change by {planned_speed:.3g} a second (at most {recorded_speed:.3g} were recorded)"
        )
    for name, wound in (("hold", True), ("rest", False)):
        stands_s, stood_s = (_longest_stand(table, driver, wound) for table in (samples, recorded))
        if stands_s > LONGER * stood_s and stands_s > SHORT_S:
            ranges.append(f"a {name} of {stands_s:.3g} s (at most {stood_s:.3g} s were recorded)")
    return f"it asks for {'; '.join(ranges)}" if ranges else ""


def _longest_stand(samples: pd.DataFrame, driver: str, wound: bool) -> float:
    """The longest time, in s, that a motion stands `wound`, or unwound: within a part of its range of its lowest."""
    time_s, way = samples["time_s"].to_numpy(), samples[driver].to_numpy()
    step_s = np.diff(time_s)
    speed = np.abs(np.diff(way)) / step_s
    high = way[:-1] > way.min() + UNWOUND * np.ptp(way)
    stands = (speed < STANDS * max(float(np.percentile(speed, 99.0)), 1e-9)) & (high == wound)
    edges = np.flatnonzero(np.diff(stands)) + 1
    spans = np.split(step_s, edges)
    first = [0, *edges]
    return max((float(span.sum()) for span, at in zip(spans, first, strict=True) if stands[at]), default=0.0)


def _fastest(samples: pd.DataFrame, driver: str) -> float:
    """The highest speed of a motion that lasts for more than a moment, per second."""
    step_s, way = np.diff(samples["time_s"]), np.abs(np.diff(samples[driver]))
    return float(np.percentile(way / step_s, 99.0))
