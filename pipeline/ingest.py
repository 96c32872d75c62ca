"""Recording → samples: a run's channels in our units, checked at the door."""

import argparse
from pathlib import Path

import numpy as np
import pandas as pd

from pipeline import schemas
from pipeline.errors import BadInput, program
from pipeline.kinematics import Geometry
from pipeline.left_out import noted
from pipeline.recording import read_recording
from pipeline.run_yaml import STRING_ACTUATORS, Run
from pipeline.runs import read_run, recording_path
from pipeline.strokes import segment

STEP_S = (0.5e-4, 0.2)  # 10 Hz to 10 kHz, with room for jitter
LEAST_SAMPLES = 20
# A simulated span this many times larger or smaller than the recorded one is a unit, not physics.
SPAN_RATIO = 4.0
ANGLE_UNITS = {"rad": 2.0 * np.pi, "deg": 360.0, "turns": 1.0}
LENGTH_UNITS = {"mm": 1.0, "cm": 0.1, "m": 0.001}


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


def check_clock(samples: pd.DataFrame, path: Path) -> None:
    """Raise BadInput for a clock that stands, runs backwards, or has a rate that no rig has."""
    step_s = np.diff(samples["time_s"])
    if (step_s <= 0).any():
        row = int(np.argmax(step_s <= 0)) + 2
        word = "runs backwards" if (step_s < 0).any() else "stands still"
        mend = "python -m pipeline.import_run mends repeated and backward time stamps and says so"
        raise BadInput(path, "time_s", f"{word} at row {row} ({(step_s <= 0).sum()} times in all)", mend)
    median_s = float(np.median(step_s))
    if not STEP_S[0] <= median_s <= STEP_S[1]:
        mend = "set channels.time_s.unit (s, ms or us), or record at 10 Hz to 10 kHz"
        raise BadInput(path, "time_s", f"a sample every {median_s:g} s is no rate of a rig", mend)


def check_string(samples: pd.DataFrame, base: Geometry, path: Path) -> None:
    """Raise BadInput where a channel cannot be what its name says: frozen, reversed, or in another unit."""
    turns, measured_mm = samples["motor_turns"].to_numpy(), samples["displacement_mm"].to_numpy()
    low, high = np.percentile(turns, [1, 99])
    if high - low < 0.05:
        return  # no stroke in it: the segmentation says so
    if high <= 0:
        raise BadInput(path, "motor_turns", "is negative throughout", "winding is positive: set its scale to -1")
    span_mm = float(np.subtract(*np.percentile(measured_mm, [99, 1])))
    if span_mm == 0:
        raise BadInput(path, "displacement_mm", "never changes while the motor turns", "check the sensor and its cable")
    if np.corrcoef(turns, measured_mm)[0, 1] < -0.5:
        mend = "contraction is positive: set its scale to -1"
        raise BadInput(path, "displacement_mm", "falls while the motor winds", mend)
    load_n = float(np.median(samples["load_n"]))

    def ratio(angle: float, length: float) -> float:
        ends_mm = base.contraction_mm(np.array([max(low, 0.0), high]) / angle, load_n)
        return span_mm / length / float(ends_mm[1] - ends_mm[0])

    as_named = ratio(1.0, 1.0)
    if 1.0 / SPAN_RATIO <= as_named <= SPAN_RATIO:
        return
    others = [
        (abs(np.log(ratio(angle, length))), angle_unit, length_unit)
        for angle_unit, angle in ANGLE_UNITS.items()
        for length_unit, length in LENGTH_UNITS.items()
        if 1.0 / SPAN_RATIO <= ratio(angle, length) <= SPAN_RATIO
    ]
    field, mend = (
        "motor_turns",
        "check the units of motor_turns and displacement_mm and the string's dimensions",
    )
    if others:
        _, angle_unit, length_unit = min(others)
        field = "motor_turns" if angle_unit != "turns" else "displacement_mm"
        unit = angle_unit if angle_unit != "turns" else length_unit
        mend = f"it looks like {unit}: set channels.{field}.unit to {unit}"
    expected = f"{span_mm / as_named:.3g} mm" if np.isfinite(as_named) else "more than the string is long"
    problem = f"{low:.3g} to {high:.3g} turns should contract the string by {expected}, recorded are {span_mm:.3g} mm"
    raise BadInput(path, field, problem, mend)


def check(run: Run, samples: pd.DataFrame, path: Path) -> None:
    """Raise BadInput unless the samples of a run, read from `path`, can be what their names say and hold a stroke."""
    check_finite(samples, path)
    check_clock(samples, path)
    if run.actuator not in STRING_ACTUATORS and samples[run.system.channel].nunique() == 1:
        raise BadInput(path, run.system.channel, "never changes", "check the sensor and its cable")
    if run.actuator in STRING_ACTUATORS:
        check_string(samples, geometry(run), path)
    segment(samples, run.system.driver, path)


def read_samples(folder: Path | str) -> tuple[Run, pd.DataFrame]:
    """A run and its samples (`time_s` and the channels, one row a sample), checked; raises BadInput."""
    folder = Path(folder)
    run = read_run(folder)
    samples = read_recording(run, folder)
    path = recording_path(folder)
    check(run, samples, path)
    return run, samples


@program
def main() -> None:
    """Write `samples.parquet` of one run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run_dir", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--note-refusals", action="store_true", help="write why the run is refused, and exit with 0")
    arguments = parser.parse_args()
    with noted(arguments.run_dir, arguments.out, arguments.note_refusals):
        run, samples = read_samples(arguments.run_dir)
        schemas.write(samples, schemas.samples(list(samples.columns)), arguments.out)
        print(f"{run.run}: {len(samples)} samples over {samples['time_s'].iloc[-1] - samples['time_s'].iloc[0]:.1f} s")


if __name__ == "__main__":
    main()
