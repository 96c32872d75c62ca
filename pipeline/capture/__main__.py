"""Record a rig: PORT → RUN_DIR/recording.frames, then RUN_DIR/capture.json. Ctrl-C ends it in good order."""

import argparse
import signal
from datetime import UTC, datetime
from pathlib import Path
from types import FrameType
from typing import Any

from pipeline.capture.commit import commit, recover
from pipeline.capture.handshake import check_rate, greet
from pipeline.capture.log import NAME, Log, check_folder
from pipeline.capture.port import Port
from pipeline.capture.stream import record
from pipeline.errors import BadInput, program
from pipeline.runs import read_run

GAPS_TOLD = 5


def capture(name: str, folder: Path, baud: int) -> dict[str, Any]:
    """Record one run and commit it; returns what capture.json says. Raises BadInput before anything is written."""
    asked = 0

    def ask(number: int, frame: FrameType | None) -> None:
        nonlocal asked
        asked += 1

    check_folder(folder)
    with Port(name, baud) as port:
        hello, beginning = greet(port, name)
        check_rate(hello, baud, name)
        print(f"{hello.device}, firmware {hello.firmware}: {hello.rate_hz:g} Hz, ", end="")
        print(", ".join(f"{channel.name} [{channel.unit}]" for channel in hello.channels), flush=True)
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, ask)
        log = Log(folder)
        try:
            log.append(beginning)
            began = datetime.now(UTC)
            outcome = record(port, log, hello, lambda: asked)
        except OSError as error:
            mend = f"make room, then run python -m pipeline.capture --recover {folder}"
            raise BadInput(folder, NAME, f"could not be written ({error}); what it has is kept", mend) from None
        finally:
            log.close()
    return commit(folder, began, datetime.now(UTC), outcome)


def tell(info: dict[str, Any], folder: Path) -> None:
    """Say what was recorded, and what is missing for the run to be used."""
    frames, samples = info["frames"], info["samples"]
    print(
        f"{folder}: {info['exit_status']}, {samples['received']} samples; frames: {frames['sent']} sent = "
        f"{frames['received']} received + {frames['lost']} lost, {frames['bad']} bad"
    )
    for gap in info["gaps"][:GAPS_TOLD]:
        where = "before the first sample" if gap["after_s"] is None else f"after {gap['after_s']:g} s"
        strokes = ", ".join(map(str, gap["strokes"])) or "none"
        print(
            f"{folder}: {gap['frames']} frame{'s' * (gap['frames'] > 1)} lost {where}; strokes it may touch: {strokes}"
        )
    if len(info["gaps"]) > GAPS_TOLD:
        print(f"{folder}: and in {len(info['gaps']) - GAPS_TOLD} more places, see capture.json")
    if samples["out_of_order"]:
        print(f"{folder}: samples came out of order ({samples['out_of_order']} times), so their clock runs backwards")
    if info["fault"]:
        print(f"{folder}: {info['fault']}; what had come is kept")
    try:
        read_run(folder)
    except BadInput as error:
        print(f"{error} Until then nothing can use this run; python -m pipeline.new_run writes its run.yaml.")


@program
def main() -> int:
    """Exit 0 when the recording is complete, was ended on request or is recovered, 1 after a fault, 2 on bad input."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.capture", description=__doc__)
    parser.add_argument("port", metavar="PORT", nargs="?", help="the rig's serial port")
    parser.add_argument("run_dir", metavar="RUN_DIR", nargs="?", type=Path, help="raw/<run>")
    parser.add_argument("--baud", type=int, default=1_000_000)
    parser.add_argument("--recover", metavar="RUN_DIR", type=Path, help="commit a run whose capture was killed")
    arguments = parser.parse_args()
    folder: Path
    if arguments.recover is not None:
        if arguments.port is not None:
            parser.error("--recover takes no port")
        folder = arguments.recover
        info = recover(folder)
    else:
        if arguments.run_dir is None:
            parser.error("PORT and RUN_DIR are needed")
        folder = arguments.run_dir
        try:
            info = capture(arguments.port, folder, arguments.baud)
        except KeyboardInterrupt:  # before START: nothing was recorded
            return 130
    tell(info, folder)
    return 1 if info["exit_status"] == "fault" else 0


if __name__ == "__main__":
    main()
