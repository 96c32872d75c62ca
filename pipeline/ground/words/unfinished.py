"""The mend for a recording without an end: the command, with names for columns that have none."""

import json
from pathlib import Path

from ..command import recover_command

NOTE = "capture-pending.json"  # the capture program's, beside a recording that is not committed
NAMES = "names"  # in it: what the columns are likely called, where nothing has named them


def mend_of_unfinished(folder: Path) -> str:
    """The mend; `--recover` alone is not enough for lines whose columns have no names."""
    try:
        content = json.loads((folder / NOTE).read_bytes())
        names = content.get(NAMES)
    except (OSError, ValueError, AttributeError, RecursionError):
        names = None
    if isinstance(names, str) and names:
        ended = "its columns have no names yet: put them in the order in which the rig prints them"
        return f"{ended}: {recover_command(folder)} --columns {names}"
    return f"wait for the capture to end, or run {recover_command(folder)}"
