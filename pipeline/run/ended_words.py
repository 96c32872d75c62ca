"""How a recording ended, in words for a person; `capture.json` keeps the terms of its contract."""

from .capture_json import CaptureJson

PERSON = "person"  # who asked for the end, in capture.json
ABORTED = "aborted"  # in capture.json: it ended before the rig was done


def cause(info: CaptureJson) -> str:
    """What ended a recording, such as Ctrl-C; empty where nothing but the rig did."""
    ended_by = info.get("ended_by") or ""
    return "Ctrl-C or kill" if ended_by == PERSON else ended_by


def ending(info: CaptureJson) -> str:
    """How a recording ended: its status, or, of one that ended before the rig was done, what ended it."""
    status = info.get("exit_status", "")
    if status != ABORTED:
        return status
    return f"ended by {cause(info)}" if cause(info) else "ended early"
