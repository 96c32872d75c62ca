"""The note beside a recording that is not committed yet: when it began, what --columns gave, and how it ended.

It is there from the first byte to the commit, so that a recording that is recovered has its own start and end.
"""

import json
import os
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path

from ..ground.words.unfinished import NAMES, NOTE
from .stream import Outcome
from .text.fields import names

NAME = NOTE


def note(
    folder: Path,
    began: datetime,
    columns: tuple[str, ...] = (),
    ended: datetime | None = None,
    outcome: Outcome | None = None,
) -> None:
    """Write it, over an earlier one; it waits for no disk, and a folder that is full keeps no rig waiting."""
    content: dict[str, object] = {"started_utc": began.astimezone(UTC).isoformat(), "columns": list(columns)}
    if ended is not None and outcome is not None:
        content |= {"ended_utc": ended.astimezone(UTC).isoformat()}
        content |= {"exit_status": outcome.status, "fault": outcome.fault, "ended_by": outcome.ended_by}
    _put(folder, content)


def propose(folder: Path, likely: str) -> None:
    """Note beside a recording what its columns are likely called, where nothing has named them: programs say it."""
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
    """When a recording began and ended, and by what; where nothing tells, at its file's last change, `recovered`."""
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
