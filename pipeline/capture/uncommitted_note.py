"""The note beside an uncommitted recording: when it began, the names from --columns, and how it ended.

It is there from the first byte to the commit, so that a recording that is recovered has its own start and end.
"""

import json
import os
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path

from ..ground.words.unfinished import NAMES, NOTE
from .printed.fields import names
from .stream import Outcome

NAME = NOTE


def note(
    folder: Path,
    began: datetime,
    columns: tuple[str, ...] = (),
    ended: datetime | None = None,
    outcome: Outcome | None = None,
) -> None:
    """Write the note over an earlier one. It does not wait for the disk, and a full folder does not stop the rig."""
    content: dict[str, object] = {"started_utc": began.astimezone(UTC).isoformat(), "columns": list(columns)}
    if ended is not None and outcome is not None:
        content |= {"ended_utc": ended.astimezone(UTC).isoformat()}
        content |= {"exit_status": outcome.status, "fault": outcome.fault, "ended_by": outcome.ended_by}
    _put(folder, content)


def propose(folder: Path, likely: str) -> None:
    """Add the likely names of unnamed columns to the note; other programs read them there."""
    try:
        content = json.loads((folder / NAME).read_bytes())
    except (OSError, ValueError, RecursionError):
        content = None
    _put(folder, {**(content if isinstance(content, dict) else {}), NAMES: likely})


def _put(folder: Path, content: dict[str, object]) -> None:
    temporary = folder / f".{NAME}.{os.getpid()}"
    with suppress(OSError):
        try:
            temporary.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
            os.replace(temporary, folder / NAME)
        finally:
            temporary.unlink(missing_ok=True)


def noted(folder: Path, last_change: datetime) -> tuple[datetime, datetime, Outcome]:
    """When a recording began and ended, and why; without a note, the file's last change and `recovered`."""
    try:
        content = json.loads((folder / NAME).read_bytes())
        began = datetime.fromisoformat(content["started_utc"]).astimezone(UTC)
    except (OSError, ValueError, KeyError, TypeError, OverflowError, RecursionError):
        return last_change, last_change, Outcome("recovered")
    cut_off = min(began, last_change), last_change, Outcome("recovered")
    try:
        ended = datetime.fromisoformat(content["ended_utc"]).astimezone(UTC)
        status, fault, ended_by = (content[key] for key in ("exit_status", "fault", "ended_by"))
    except (ValueError, KeyError, TypeError, OverflowError):
        return cut_off
    if status not in ("ended", "fault") or not all(
        words is None or isinstance(words, str) for words in (fault, ended_by)
    ):
        return cut_off
    return began, ended, Outcome(status, fault, ended_by)


def noted_columns(folder: Path) -> tuple[str, ...]:
    """The names that --columns gave, or none."""
    try:
        columns = json.loads((folder / NAME).read_bytes())["columns"]
        return names(",".join(columns).encode())
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return ()


def withdraw(folder: Path) -> None:
    """Remove it: the recording is committed."""
    with suppress(OSError):
        (folder / NAME).unlink(missing_ok=True)
