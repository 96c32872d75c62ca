"""Record a rig: PORT → RUN_DIR/recording.frames, then capture.json. Ctrl-C ends it in good order: what came is used."""

import math
from pathlib import Path

from ..ground.command import command
from ..ground.errors import program
from ..ground.input.parser import Parser
from ..run.folder import capture_info
from ..run.run_arguments import run_dir
from .commit import recover
from .ended_run import tell, tell_finished
from .log import LINES
from .motion_program import read_legs
from .printed.fields import names
from .printed.lines_to_csv import Finished, recover_lines
from .printed.naming import GAP
from .printed.near_names import doubt
from .printed.printed_lines import WAIT_S
from .session import capture, capture_lines
from .undescribed_string import warn_undescribed


@program
def main() -> int:
    """Exit 0 when the recording is complete, was ended on request or is recovered, 1 after a fault, 2 on bad input.

    Nothing without a sample is exit 0, and no recording that its run.yaml does not fit, which is kept. Recovered lines
    of a described run are exit 0 where they can be used, whatever ended them, else 1 after a fault, and 2 without one.
    """
    parser = Parser(prog=command("capture"), description=__doc__)
    parser.add_argument("port", metavar="PORT", nargs="?", help="the rig's serial port")
    parser.add_argument("run_dir", metavar="RUN_DIR", nargs="?", type=run_dir, help="raw/<run>")
    parser.add_argument("--baud", type=int, default=1_000_000)
    parser.add_argument("--recover", metavar="RUN_DIR", type=run_dir, help="commit a run whose capture was killed")
    parser.add_argument("--text", action="store_true", help="the rig prints lines of numbers, not frames")
    parser.add_argument("--columns", default="", help="names, separated by commas, of what --text records")
    parser.add_argument("--longest", type=float, default=math.inf, metavar="SECONDS", help="then the run is ended")
    wait = f"how long --text waits for the first line of numbers ({WAIT_S:g})"
    parser.add_argument("--wait", type=float, metavar="SECONDS", help=wait)
    motion = "the motion, for a rig that takes one: a diagnosis.json, or a list of legs"
    parser.add_argument("--program", type=Path, metavar="FILE", help=motion)
    arguments = parser.parse_args()
    if arguments.program and arguments.text:
        parser.error("--program is for rigs that send frames")
    if not arguments.longest > 0:
        parser.error("--longest must be above 0 seconds")
    if arguments.wait is not None and not (arguments.text and 0 < arguments.wait < math.inf):
        parser.error("--wait goes with --text, and must be above 0 seconds")
    columns = names(arguments.columns.encode())
    if arguments.columns and not columns:
        gaps = f"; put a name in the place of each {GAP}" if GAP in arguments.columns else ""
        parser.error(f"--columns needs two names or more, separated by commas{gaps}")
    folder: Path
    if arguments.recover is not None:
        if arguments.port is not None:
            parser.error("--recover takes no port")
        folder = arguments.recover
        try:
            info = recover_lines(folder, columns) if (folder / LINES).is_file() else recover(folder)
            usable = tell(info, folder, is_recovered=True)
        except Finished as finished:
            usable, info = tell_finished(folder, finished), capture_info(folder)
        if usable and "lines" in info:
            return 0
    else:
        if arguments.run_dir is None:
            parser.error("PORT and RUN_DIR are needed")
        folder = arguments.run_dir
        warn_undescribed(folder)
        try:
            if arguments.text:
                if question := doubt(columns, folder):
                    print(question, flush=True)
                wait_s = arguments.wait or WAIT_S
                info = capture_lines(arguments.port, folder, arguments.baud, columns, arguments.longest, wait_s)
            else:
                legs = read_legs(arguments.program) if arguments.program else []
                info = capture(arguments.port, folder, arguments.baud, arguments.longest, legs)
        except KeyboardInterrupt:  # before START: nothing was recorded
            return 130
        usable = tell(info, folder)
    return 1 if info["exit_status"] == "fault" else 0 if usable else 2


if __name__ == "__main__":
    main()
