"""Record a rig: PORT → RUN_DIR/recording.frames, then capture.json. Ctrl-C ends it in good order: what came is used."""

import math
from pathlib import Path
from typing import TYPE_CHECKING

from ..ground.command import command
from ..ground.errors import BadInput, program
from ..ground.input.parser import Parser
from ..ground.names import SYNTHETIC_DEVICE
from ..ground.words.counts import counted
from ..run.capture_json import CaptureJson
from ..run.folder import capture_info, read_run
from ..run.run_arguments import run_dir
from .commit import recover
from .log import LINES
from .motion_program import read_legs
from .refused_run import reader_of, refusal, tell_refused
from .session import capture, capture_lines
from .text.clock_words import tell_clock
from .text.fields import names
from .text.fitting_columns import check_channels, unusable_columns
from .text.lines_to_csv import Finished, recover_lines
from .text.lines_words import clock_question, tell_lines
from .text.naming import GAP
from .text.near_names import doubt
from .text.printed_lines import WAIT_S
from .undescribed_string import warn_undescribed

if TYPE_CHECKING:
    from ..string.jumps_beside import Reader

GAPS_TOLD = 5


def tell(info: CaptureJson, folder: Path) -> bool:
    """Say what was recorded, and what is missing for the run to be used; whether what was recorded can be used.

    That nobody has described the run yet is no fault of its recording.
    """
    reader = refused = None
    if "lines" in info:
        usable = not unusable_columns(folder)
        if usable and not info["lines"]["time_backward"]:  # of a clock that falls back it is asked first
            reader = reader_of(folder)
            refused = refusal(folder, reader)
        if refused:
            tell_refused(refused, folder, info)
        tell_lines(info, folder, usable)
    else:
        tell_frames(info, folder)
    ended = f"ended by {info['ended_by']}" if info["ended_by"] else None
    if ended or info["fault"]:
        print(f"{folder}: {'; '.join(filter(None, (ended, info['fault'])))}; what had come is kept")
    if info["exit_status"] == "aborted":
        print(f"{folder}: aborted means ended before the rig was done; what was recorded is used like any run's")
    described = False
    try:
        run = read_run(folder)
        described = True
        if "lines" in info:
            check_channels(run, folder)
            tell_clock(run, folder, info)
    except BadInput as error:
        if "lines" in info and info["lines"]["time_backward"]:
            print(f"{folder}: {clock_question(info, folder)}")
        print(f"{error} Until then nothing can use this run.")
        return not described
    if refused is None:
        tell_of_its_string(folder, info, reader)
    return True


def tell_of_its_string(folder: Path, info: CaptureJson, reader: "Reader | None" = None) -> None:
    """Say whether the sensor's zero moved since the run of the same string before, and what comes next."""
    from ..string.jumps_beside import Beside, advice_on  # it needs pandas, for which no rig should wait
    from ..string.next_steps import next_steps
    from .use_after_fault import strokes_of_use, strokes_unwound

    reader = reader or reader_of(folder)
    beside = Beside(reader=reader)
    for sentence in advice_on(folder, beside):
        print(f"{folder}: {sentence}")
    if not info["samples"]["received"]:
        return
    hello = info.get("hello")
    try:
        if hello and info["exit_status"] == "complete":
            whole = hello["strokes"]
        elif info["exit_status"] != "fault":
            whole = strokes_unwound(folder, reader)
        else:
            whole = strokes_of_use(folder, reader)
    except BadInput as error:
        tell_refused(error, folder, info)
        return
    anew = hello is not None and hello["device"] == SYNTHETIC_DEVICE and "program" not in hello
    print("\n".join(next_steps(folder, whole, anew, beside.unreadable)))


def tell_frames(info: CaptureJson, folder: Path) -> None:
    """Say how many frames came, and where others were lost."""
    frames, samples = info["frames"], info["samples"]
    print(
        f"{folder}: {info['exit_status']}, {counted(samples['received'], 'sample')}; frames: {frames['sent']} sent = "
        f"{frames['received']} received + {frames['lost']} lost, {frames['bad']} bad"
    )
    for gap in info["gaps"][:GAPS_TOLD]:
        where = "before the first sample" if gap["after_s"] is None else f"after {gap['after_s']:g} s"
        strokes = ", ".join(map(str, gap["strokes"])) or "none"
        print(
            f"{folder}: {gap['frames']} frame{'s' * (gap['frames'] > 1)} lost {where}; strokes it may touch: {strokes}"
        )
    if len(info["gaps"]) > GAPS_TOLD:
        print(f"{folder}: and in {counted(len(info['gaps']) - GAPS_TOLD, 'more place')}, see capture.json")
    if samples["out_of_order"]:
        often = counted(samples["out_of_order"], "time")
        print(f"{folder}: samples came out of order ({often}); their numbers put them right")
    clock = {"backward": samples["backward_time_stamps"], "repeated": samples["repeated_time_stamps"]}
    if any(clock.values()) and info["exit_status"] != "fault":
        both = " and ".join(f"{times} {word}" for word, times in clock.items() if times)
        stamps = f"{both} time stamp{'s' * (sum(clock.values()) != 1)}"
        print(f"{folder}: the device's clock gave {stamps}, mended when the run is read")
    sent = samples["sent"]
    if sent is not None and not 0 <= sent - samples["received"] <= frames["lost"]:
        print(
            f"{folder}: warning: the device counted {counted(sent, 'sample')}, {samples['received']} can be read, and "
            "lost frames do not explain it: check its firmware against docs/protocol.md"
        )


@program
def main() -> int:
    """Exit 0 when the recording is complete, was ended on request or is recovered, 1 after a fault, 2 on bad input.

    Nothing without a sample is exit 0, and no recording that its run.yaml does not fit, which is kept.
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
        except Finished:
            if refusal(folder, reader_of(folder)) is None:
                raise
            print(f"{folder}: nothing is to be recovered: it is read by these columns already")
            tell(capture_info(folder), folder)
            return 2
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
