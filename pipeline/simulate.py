"""The improved simulator alone: inputs and a diagnosis → predicted displacement; no measurement but for the tare."""

import argparse
import shlex
import sys
from pathlib import Path

import numpy as np
import pandas as pd

from .adoption.before_after import waits
from .diagnosis.own_rate import at_own_rate
from .diagnosis.simulation import compared, of_run, off, read_diagnosis, tared
from .diagnosis.words.quantity import listing, size
from .ground import schemas
from .ground.command import command
from .ground.complaint import key_name
from .ground.errors import program
from .ground.outputs import file_to_write
from .run.description import Run
from .run.samples import read_samples


def warn_of_dimensions(run: Run) -> None:
    """Say where the effects that a run has adopted were fitted with dimensions far from those of its run.yaml."""
    source = next((Path(one.diagnosis) for one in reversed(run.adopted) if one.diagnosis), None)
    if source is None or not source.is_file() or not waits(read_diagnosis(source)):
        return
    print(
        "warning: run.yaml has the adopted effects, and not the dimensions that they were fitted with; to simulate "
        f"with those too, add --simulation {shlex.quote(str(source))}",
        file=sys.stderr,
    )


@program
def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog=command("simulate"), description=__doc__)
    parser.add_argument("run_dir", type=Path, metavar="RUN_DIR", help="the run whose motion and load are simulated")
    parser.add_argument(
        "--simulation", type=Path, metavar="FILE.json",
        help="a diagnosis.json: its mechanisms and dimensions, in place of those of run.yaml, so that nothing counts "
        "twice; default: the mechanisms that run.yaml has adopted, and its dimensions as they were measured",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE.parquet",
        help="the file that is written, with a row for each sample of the recording and two columns: time_s, and what "
        "the rig reads, displacement_mm of a string (jaw_deg of a cable_drive, force_n of a moving_mass, …); required",
    )  # fmt: skip
    arguments = parser.parse_args()
    source = arguments.simulation or arguments.run_dir / "run.yaml"
    file_to_write(arguments.out, reads=[source])
    run, samples = read_samples(arguments.run_dir)
    content = read_diagnosis(source) if arguments.simulation else of_run(run)
    problem = at_own_rate([run], [samples], thin=False)
    predicted = tared(problem, content, source, run.run)
    error, _ = off(*compared(run, problem, predicted))
    if isinstance(content.get("run"), list) and content["run"][0] != run.run:
        print(
            f"warning: {source} counts time from the start of {key_name(content['run'][0])}",
            file=sys.stderr,
        )
    table = pd.DataFrame({"time_s": samples["time_s"].to_numpy(), problem.system.channel: predicted})
    schemas.write(table, schemas.samples(list(table.columns)), arguments.out)
    acting = listing(list(dict.fromkeys(entry["id"] for entry in content["simulation"]))) or "no mechanism"
    print(f"{run.run}: {len(table)} samples simulated with {acting} and the dimensions of {source}")
    if np.ptp(problem.measured) > 0.0:  # else nobody recorded it
        zero = ", its zero set in the first second" if problem.system.free_zero else ""
        print(f"rms error against the recording{zero}: {size(error, problem.drivers.units.reading)}")
    if not arguments.simulation:
        warn_of_dimensions(run)


if __name__ == "__main__":
    main()
