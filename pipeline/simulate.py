"""The improved simulator alone: inputs and a diagnosis → predicted displacement; no measurement but for the tare."""

import argparse
import shlex
import sys
from pathlib import Path

import numpy as np
import pandas as pd

from .diagnosis.own_rate import at_own_rate
from .diagnosis.simulation import compared, has_zero, measured_since, of_run, off, read_diagnosis, tared
from .diagnosis.words.dimensions import name_of
from .diagnosis.words.quantity import listing, size
from .ground import schemas
from .ground.command import command
from .ground.complaint import key_name
from .ground.errors import program
from .ground.files import write_text
from .ground.outputs import file_to_write
from .run.description import Run
from .run.folder import RECORDINGS, read_run
from .run.planned import beyond, planned
from .run.samples import read_samples


def warn_of_dimensions(run: Run, folder: Path) -> None:
    """Say where a dimension of run.yaml is another than it was when effects were adopted, which fit no more."""
    changed = measured_since(run)
    if changed:
        names = listing([f"the {name_of(name)}" for name in changed])
        print(
            f"warning: {names} in run.yaml changed since the effects were adopted. The dimensions of run.yaml are "
            "taken, and the effects may not fit them. Mend: take the effects out, diagnose again and adopt anew: "
            f"{command('adopt')} --remove {shlex.quote(str(folder))}",
            file=sys.stderr,
        )


def of_plan(arguments: argparse.Namespace) -> tuple[Run, pd.DataFrame]:
    """The run that is described, and the samples of the motion that is planned for it. Raises BadInput."""
    run = read_run(arguments.run_dir)
    there = any((arguments.run_dir / name).exists() for name in RECORDINGS)
    recorded = read_samples(arguments.run_dir)[1] if there else None
    samples = planned(run, arguments.motion, recorded)
    leaves = beyond(run, samples, recorded) if recorded is not None else ""
    if leaves:
        said = f"{leaves}. Nothing says how well the simulator does there"
        print(f"warning: {arguments.motion}: {said}", file=sys.stderr)
    return run, samples


def write(table: pd.DataFrame, path: Path) -> None:
    """Write what was simulated, whole or not at all: as text where the name ends like that, else as Parquet."""
    if path.suffix.lower() == ".csv":
        write_text(path, table.to_csv(index=False, float_format="%.9g"))
    else:
        schemas.write(table, schemas.samples(list(table.columns)), path)


@program
def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog=command("simulate"), description=__doc__)
    parser.add_argument("run_dir", type=Path, metavar="RUN_DIR", help="the run whose motion and load are simulated")
    parser.add_argument(
        "--simulation", type=Path, metavar="FILE.json",
        help="a diagnosis.json: its mechanisms and dimensions, in place of those of run.yaml, so that nothing counts "
        "twice; default: the mechanisms that run.yaml has adopted with the dimensions that fit with them",
    )  # fmt: skip
    parser.add_argument(
        "--motion", type=Path, metavar="PLAN.csv",
        help="a motion that nobody has recorded, in place of the run's: .csv or .parquet with time_s, motor_turns and, "
        "unless it stands still, load_n (as a string's channels are called); corners of a motion will do",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE",
        help="the file that is written, .parquet or .csv, with a row for each sample and two columns: time_s, and what "
        "the rig reads, displacement_mm of a string (jaw_deg of a cable_drive, force_n of a moving_mass, …); required",
    )  # fmt: skip
    arguments = parser.parse_args()
    source = arguments.simulation or arguments.run_dir / "run.yaml"
    file_to_write(arguments.out, reads=[source, *([arguments.motion] if arguments.motion else [])])
    run, samples = read_samples(arguments.run_dir) if arguments.motion is None else of_plan(arguments)
    content = read_diagnosis(source) if arguments.simulation else of_run(run)
    problem = at_own_rate([run], [samples], thin=False, to_fit=False)
    predicted = tared(problem, content, source, run.run)
    error, _ = off(*compared(run, problem, predicted))
    if isinstance(content.get("run"), list) and content["run"][0] != run.run:
        print(
            f"warning: {source} counts time from the start of {key_name(content['run'][0])}",
            file=sys.stderr,
        )
    write(pd.DataFrame({"time_s": samples["time_s"].to_numpy(), problem.system.channel: predicted}), arguments.out)
    acting = listing(list(dict.fromkeys(entry["id"] for entry in content["simulation"]))) or "no mechanism"
    fitted = "that fit with them, in" if content["parameters"] and not arguments.simulation else "of"
    print(f"{run.run}: {len(samples)} samples simulated with {acting} and the dimensions {fitted} {source}")
    print(f"{arguments.out} holds time_s and {problem.system.channel}")
    if arguments.motion is not None and problem.system.free_zero:
        as_there = has_zero(content, problem.system, run.run)
        zero = f"that of the recording of {run.run}" if as_there else "the reading in the first second"
        print(f"its zero is {zero}; the string is taken to be as it was before its first stroke")
    tied = run.adopted[-1].tied if run.adopted and not arguments.simulation else content.get("alternatives", [])
    if isinstance(tied, list) and tied:
        print(f"beware: {acting} is one of {1 + len(tied)} likely explanations, and another may say otherwise here")
    if np.ptp(problem.measured) > 0.0:  # else nobody recorded it
        where = "as it was fitted" if has_zero(content, problem.system, run.run) else "set in the first second"
        zero = f", its zero {where}" if problem.system.free_zero else ""
        print(f"rms error against the recording{zero}: {size(error, problem.drivers.units.reading)}")
    if not arguments.simulation:
        warn_of_dimensions(run, arguments.run_dir)


if __name__ == "__main__":
    main()
