"""Settle a tie: record the run that would decide, diagnose all together, and go on until one explanation is left."""

from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput, program
from ..ground.input.outputs import folder_to_write
from ..ground.input.parser import Parser
from ..run.folder import read_run
from ..run.run_arguments import run_dir
from .approve import UNATTENDED, WAYS
from .choose import Budget
from .limits import EXAMPLE, Allowed
from .loop import Loop
from .loop_lock import alone
from .motor import Motor
from .step import Place

REPORTS = Path("reports/settle")


def check(folders: list[Path]) -> None:
    """Raise BadInput for a run folder whose motor this program cannot speak of."""
    for folder in folders:
        run = read_run(folder)
        if run.system.driver != "motor_turns":
            mend = "make the run that its diagnosis proposes by hand"
            raise BadInput(folder, "actuator", f"is {run.actuator}, whose motion is not in turns of a motor", mend)


@program
def main() -> int:
    """Exit 0 when it is settled or not approved, 1 after a fault of the rig, 2 on bad input, 130 when stopped."""
    parser = Parser(prog=command("settle"), description=__doc__)
    parser.add_argument(
        "run_dir",
        metavar="RUN_DIR",
        type=run_dir,
        nargs="+",
        help="recorded runs of one rig, or one that is not recorded yet",
    )
    parser.add_argument("--port", help="the rig's serial port; without one each run is a sheet for a person")
    parser.add_argument("--baud", type=int, default=1_000_000)
    parser.add_argument("--approve", choices=WAYS, default="ask", help="auto and page need --limits; default: ask")
    parser.add_argument("--limits", metavar="YAML", help=f"what no run may go beyond: {EXAMPLE}")
    parser.add_argument("--runs", type=int, default=3, help="at most so many, but for a first recording (3)")
    parser.add_argument("--minutes", type=float, default=30.0, help="of motion in all, at most (30)")
    parser.add_argument("--strokes", type=int, default=40, help="spent in all, at most (40)")
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="the folder in which its steps lie; default: reports/settle/<run>"
    )
    arguments = parser.parse_args()
    if arguments.approve in UNATTENDED and not arguments.limits:
        parser.error(f"--approve {arguments.approve} needs --limits, such as {EXAMPLE}: nothing moves without them")
    if arguments.runs < 1 or not arguments.minutes > 0 or arguments.strokes < 1:
        parser.error("--runs, --minutes and --strokes must be above 0")
    runs: list[Path] = arguments.run_dir
    check(runs)
    allowed = Allowed.read(arguments.limits or "{}")
    place = Place(folder_to_write(arguments.out or REPORTS / runs[0].name))
    motor = Motor(arguments.port, arguments.baud, allowed, arguments.approve in UNATTENDED)
    loop = Loop(runs, place, motor, arguments.approve, Budget(arguments.runs, arguments.minutes, arguments.strokes))
    try:
        with alone(place.out):
            return loop.go()
    except KeyboardInterrupt:
        print("stopped: nothing moves; started again it goes on from here")
        return 130


if __name__ == "__main__":
    main()
