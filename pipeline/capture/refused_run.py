"""A recording that cannot be used as described: the reason and a mend to copy; no other command is shown before."""

import io
from contextlib import redirect_stderr
from pathlib import Path

from ..ground.errors import BadInput
from ..run.capture_json import CaptureJson
from ..run.next_command import following
from .text.copied_mend import copied_mend, is_by_columns

UNTIL = "Until then nothing can use this run."


def tell_refused(error: BadInput, folder: Path, info: CaptureJson) -> None:
    """Tell the reason and the mend; where no command can mend it, as for a too short recording, none is shown."""
    mend = copied_mend(error.mend, folder, info["columns"]) if "lines" in info else ""
    about = "" if info["exit_status"] == "fault" else "warning: "
    print(f"{about}{error} {UNTIL}")
    if not mend:
        return
    print(f"Next: mend it, and record nothing anew: {mend}")
    if not is_by_columns(mend):  # which says itself what comes next
        print("\n".join(following(folder, recorded=True)).replace("Next:", "Then:", 1))


def is_refused(folder: Path) -> bool:
    """Whether a recording that is described cannot be used as it is read."""
    from ..string.from_raw import read  # it needs pandas, for which no rig should wait

    try:
        with redirect_stderr(io.StringIO()):  # what is read as what is said when the run is used
            read(folder)
    except BadInput:
        return (folder / "run.yaml").is_file()
    return False
