"""What `simulate` may be told on its command line."""

import shlex
from dataclasses import dataclass
from pathlib import Path

from ..ground.command import command
from ..ground.parser import Parser
from ..run.run_arguments import run_dir
from .prediction.motor_zero import HOME
from .words.foretold.prediction import AFTER_RECORDING
from .words.foretold.residual import RESIDUAL


@dataclass(frozen=True)
class SimulateOptions:
    """What a person asks of `simulate`: each option by its name, None or false where it is not given."""

    run_dir: Path
    simulation: Path | None
    motion: Path | None
    after_recording: bool
    residual: bool
    home: bool
    out: Path


def parsed(description: str) -> SimulateOptions:
    """The command line; it ends the program with 2 where arguments do not go together."""
    parser = Parser(prog=command("simulate"), description=description)
    parser.add_argument("run_dir", type=run_dir, metavar="RUN_DIR", help="the run whose motion and load are simulated")
    parser.add_argument(
        "--simulation", type=Path, metavar="FILE.json",
        help="a diagnosis.json: its mechanisms and dimensions, in place of those of run.yaml, so that nothing counts "
        "twice; default: the mechanisms that run.yaml has adopted with the dimensions that fit with them",
    )  # fmt: skip
    parser.add_argument(
        "--motion", type=Path, metavar="PLAN.csv",
        help="a motion that nobody has recorded, in place of the run's: .csv or .parquet with time_s, "
        "motor_turns and, unless it stands still, load_n (a string's channels), or the names of channels in "
        "run.yaml; corners of a string's motion will do. The answer has a band too: nine of ten readings lie from "
        "low_mm to high_mm, if the explanation is right. Where the motion leaves what was recorded the column outside "
        "is 1, and the band is empty",
    )  # fmt: skip
    parser.add_argument(
        AFTER_RECORDING, action="store_true",
        help="with --motion: the recorded motion of the run goes before the plan, so that creep, wear and heat are as "
        "the recording left them. The plan begins at once, from where the recording ended. Default: the string as "
        "before its first stroke",
    )  # fmt: skip
    parser.add_argument(
        RESIDUAL, action="store_true",
        help="also what a black box, which is no physics, adds: residual_mm, and residual_low_mm to residual_high_mm, "
        "where nine of ten readings lie. It says whether it helps on strokes that it has not seen",
    )  # fmt: skip
    parser.add_argument(
        HOME, action="store_true",
        help="for a run of which the diagnosis was not made: take that part of it which holds on the first stroke of "
        "the recording, a motor's zero homed there anew. Default: all of it, with the zero of the diagnosis' own run",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE",
        help="the file that is written, .parquet or .csv, with a row for each sample and two columns: time_s, and what "
        "the rig reads, displacement_mm of a string (jaw_deg of a cable_drive, force_n of a moving_mass, …); "
        "with --motion more; required",
    )  # fmt: skip
    arguments = parser.parse_args()
    if arguments.after_recording and not arguments.motion:
        parser.error(f"{AFTER_RECORDING} goes with --motion PLAN.csv")
    if arguments.home and arguments.motion:
        folder = shlex.quote(str(arguments.run_dir))
        parser.error(
            f"{HOME} homes the motor on a recorded motion, and goes without --motion. To predict a plan for a run that "
            f"the diagnosis was not made of, diagnose that run: {command('diagnose')} {folder} --out DIR (of the same "
            "string: both runs with --together). Then: "
            f"{command('simulate')} {folder} --simulation DIR/{arguments.run_dir.name}/diagnosis.json "
            f"--motion {shlex.quote(str(arguments.motion))} --out {shlex.quote(str(arguments.out))}"
        )
    return SimulateOptions(**vars(arguments))
