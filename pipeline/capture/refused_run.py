"""A recording that cannot be used as described: the reason and a mend to copy; no other command is shown before."""

import io
from contextlib import redirect_stderr
from pathlib import Path
from typing import TYPE_CHECKING

from ..ground.command import recover_command
from ..ground.errors import BadInput
from ..run.capture_json import CaptureJson
from ..run.mend_command import without_command
from .printed.copied_mend import copied_mends, is_by_columns
from .printed.lines_to_csv import CSV
from .printed.live_faults import WHEN, LiveFaults

if TYPE_CHECKING:
    from ..string.jumps_beside import Reader

UNTIL = "Until then nothing can use this run."


def tell_refused(error: BadInput, folder: Path, info: CaptureJson) -> bool:
    """Tell the reason and the mend; whether that mend names the columns of all printed lines anew.

    Where no command can mend it, as for a too short recording, none is shown.

    An impossible time hides what else is wrong with printed lines: those faults and their mends are told too.
    """
    about = "" if info["exit_status"] == "fault" else "warning: "
    of_lines = "lines" in info
    error = without_command(error) if of_lines else error  # of lines it is told below
    print(f"{about}{error} {UNTIL}")
    if not of_lines:
        return False
    sentences = _seen_besides(folder, info, " to '" not in error.mend) if error.field == "time_s" else []
    for sentence in sentences:
        print(f"warning: {sentence}")
    mends = [error.mend, *(sentence.rpartition("; ")[2] for sentence in sentences)]
    commands = copied_mends(mends, folder, info["columns"], not info["columns_given"])
    if not commands:
        return False
    print(f"Next: mend it, and record nothing anew: {commands[0]}")
    for command in commands[1:]:
        print(f"Then: mend it further: {command}")
    if not is_by_columns(commands[-1]):  # which says itself what comes next
        print(f"Then: see that it can be used, and what comes next: {recover_command(folder)}")
    return is_by_columns(commands[-1])


def _seen_besides(folder: Path, info: CaptureJson, of_time: bool) -> list[str]:
    """What is said of the samples while they come, by all of them; of the time only where `of_time`."""
    faults = LiveFaults(folder, info["columns"], not info["columns_given"])
    with open(folder / CSV, encoding="ascii") as file:
        next(file)
        sentences = [faults.look(row.strip().split(",")) for row in file]
    sentences.insert(0, faults.clock() if of_time else "")
    return [sentence.partition(WHEN)[0] for sentence in (*sentences, faults.exchange(last=True)) if sentence]


def reader_of(folder: Path) -> "Reader":
    """What reads the run in a folder once in this program; it needs pandas, for which no rig should wait."""
    from .use_after_fault import once

    return once(folder)


def refusal(folder: Path, reader: "Reader") -> BadInput | None:
    """Why a described recording cannot be used as `reader` reads it; None where it can be, or is not described."""
    try:
        with redirect_stderr(io.StringIO()):  # what is read as what is said when the run is used
            reader(folder)
    except BadInput as error:
        return error if (folder / "run.yaml").is_file() else None
    return None
