"""Recording → samples: a run's channels in our units, checked at the door."""

import sys
from pathlib import Path

import numpy as np
import pandas as pd

from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.kinematics import Geometry
from .description import STRING_ACTUATORS, Run
from .folder import checked_info, read_run, recording_path
from .plausible import check_string, doubts
from .recording import read_recording
from .strokes import segment
from .wild_samples import without_wild

STEP_S = (0.5e-4, 0.2)  # 10 Hz to 10 kHz, with room for jitter
SLOWEST_S = 600.0  # between samples of a rig that is no string: a tank may take a minute to fill
LEAST_SAMPLES = 20
LONGEST_GAP_S = 7 * 86_400.0


def geometry(run: Run) -> Geometry:
    """Nominal dimensions of a string run."""
    assert run.string is not None
    return Geometry(
        run.actuator,
        run.string.radius_mm,
        run.string.length_mm,
        run.string.nominal_stiffness_n_per_mm,
        run.rig.get("torsion_zone_mm", np.nan),
        run.rig.get("separator_mm", np.nan),
    )


def check_finite(samples: pd.DataFrame, path: Path) -> None:
    """Raise BadInput for a table too short to hold a stroke, a NaN or an infinity."""
    if len(samples) < LEAST_SAMPLES:
        problem = f"holds {len(samples)} samples, too few for a stroke"
        raise BadInput(path, "file", problem, "record at least one stroke at 10 Hz to 10 kHz")
    for name in samples.columns:
        bad = ~np.isfinite(samples[name].to_numpy())
        if bad.any():
            mend = "remove the rows without a reading; missing rows are no harm"
            problem = f"is not a number in {bad.sum()} rows, first in row {int(np.argmax(bad)) + 1}"
            raise BadInput(path, name, problem, mend)


def check_clock(samples: pd.DataFrame, path: Path, slowest_s: float = STEP_S[1]) -> None:
    """Raise BadInput for a clock that stands, runs backwards, or has a rate that no rig of this kind has."""
    with np.errstate(over="ignore"):
        step_s = np.diff(samples["time_s"])
    if (step_s <= 0).any():
        row = int(np.argmax(step_s <= 0)) + 2
        word = "runs backwards" if (step_s < 0).any() else "stands still"
        mend = f"{command('import_run')} mends repeated and backward time stamps and says so"
        raise BadInput(path, "time_s", f"{word} at row {row} ({(step_s <= 0).sum()} times in all)", mend)
    if step_s.max() > LONGEST_GAP_S:
        row = int(np.argmax(step_s))
        ends = (
            f"{samples['time_s'].iloc[row]:.6g} s in row {row + 1} and {samples['time_s'].iloc[row + 1]:.6g} s after it"
        )
        mend = "correct the stamp that is wrong, or cut the recording there into two runs"
        raise BadInput(path, "time_s", f"leaps by more than a week: {ends}", mend)
    median_s = float(np.median(step_s))
    if not STEP_S[0] <= median_s <= slowest_s:
        mend = f"set channels.time_s.unit (s, ms or us), or record a sample every {STEP_S[0]:g} to {slowest_s:g} s"
        raise BadInput(path, "time_s", f"a sample every {median_s:g} s is no rate of a rig", mend)


def check(run: Run, samples: pd.DataFrame, path: Path) -> pd.DataFrame:
    """Samples of a run, read from `path`, without the few that are impossible, which it says on standard error.

    Raises BadInput unless they can be what their names say and hold a stroke.
    """
    check_finite(samples, path)
    samples, wild_notes = without_wild(run, samples, path)
    for sentence in wild_notes:
        print(f"warning: {sentence}", file=sys.stderr)
    check_clock(samples, path, STEP_S[1] if run.actuator in STRING_ACTUATORS else SLOWEST_S)
    if run.actuator not in STRING_ACTUATORS and samples[run.system.channel].nunique() == 1:
        raise BadInput(path, run.system.channel, "never changes", "check the sensor and its cable")
    if run.actuator in STRING_ACTUATORS:
        check_string(run, samples, geometry(run), path)
    segment(samples, run.system.driver, path)
    return samples


def questions(run: Run, samples: pd.DataFrame, path: Path) -> list[BadInput]:
    """What of checked samples is possible, but more likely a mistake: nothing to refuse, all to be said."""
    return doubts(run, samples, geometry(run), path) if run.actuator in STRING_ACTUATORS else []


def read_samples(folder: Path | str) -> tuple[Run, pd.DataFrame]:
    """A run and its samples (`time_s` and the channels, one row a sample), checked; raises BadInput."""
    folder = Path(folder)
    run = read_run(folder)
    checked_info(folder)
    samples = read_recording(run, folder)
    path = recording_path(folder)
    return run, check(run, samples, path)
