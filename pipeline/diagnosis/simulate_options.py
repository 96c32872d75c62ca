"""The command line options of `simulate`."""

import shlex
from dataclasses import dataclass
from pathlib import Path

from ..ground.command import command
from ..ground.input.parser import Parser
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
    """The parsed command line; ends the program with status 2 where arguments exclude each other."""
    parser = Parser(prog=command("simulate"), description=description)
    parser.add_argument("run_dir", type=run_dir, metavar="RUN_DIR", help="the run whose motion and load are simulated")
    parser.add_argument(
        "--simulation", type=Path, metavar="FILE.json",
        help="a diagnosis.json: its mechanisms and dimensions, in place of those that run.yaml has adopted; default: "
        "what run.yaml has adopted",
    )  # fmt: skip
    parser.add_argument(
        "--motion", type=Path, metavar="PLAN.csv",
        help="a motion that nobody has recorded: time_s, motor_turns and, unless it stands still, load_n, or the "
        "names of run.yaml; corners of a string's motion will do. Nine of ten readings lie from low_mm to high_mm, if "
        "the explanation is right; outside is 1 where the motion leaves what was recorded",
    )  # fmt: skip
    parser.add_argument(
        AFTER_RECORDING, action="store_true",
        help="with --motion: the plan begins where the recording ended, crept, warm and worn as it left the string; "
        "default: as before its first stroke",
    )  # fmt: skip
    parser.add_argument(
        RESIDUAL, action="store_true",
        help="also what a black box, which is no physics, adds, and whether that helps on unseen strokes",
    )  # fmt: skip
    parser.add_argument(
        HOME, action="store_true",
        help="for a run of which the diagnosis was not made: home the motor's zero on its first stroke, and take what "
        "holds there; default: all of it, with the zero of the diagnosis' own run",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE",
        help="the file that is written, .parquet or .csv: time_s, and what the rig reads, such as displacement_mm; "
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
