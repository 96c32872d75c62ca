"""capture.json: the account of a recording, written last and whole; its existence is the commit."""

import hashlib
import json
from dataclasses import asdict
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from pipeline.capture.log import NAME, in_use, sync_folder
from pipeline.capture.losses import locate
from pipeline.capture.stream import Outcome
from pipeline.errors import BadInput
from pipeline.files import write_text
from pipeline.wire import Recording, read_recording

SCHEMA = 1
GAPS = 1000  # so many are listed; they are counted all


def opening(data: bytes, began: datetime, ended: datetime, outcome: Outcome) -> dict[str, Any]:
    """What capture.json says of any recording: when it was made, how it ended, and which bytes it is."""
    return {
        "schema": SCHEMA,
        "exit_status": outcome.status,
        "fault": outcome.fault,
        "started_utc": began.astimezone(UTC).isoformat(timespec="milliseconds"),
        "ended_utc": ended.astimezone(UTC).isoformat(timespec="milliseconds"),
        "bytes": len(data),
        "sha256": hashlib.sha256(data).hexdigest(),
    }


def account(data: bytes, recording: Recording, began: datetime, ended: datetime, outcome: Outcome) -> dict[str, Any]:
    """Content of capture.json; sent = received + lost holds for its frames."""
    frames = recording.account
    return {
        **opening(data, began, ended, outcome),
        "frames": {
            "sent": frames.sent,
            "received": frames.received,
            "lost": frames.lost,
            "bad": frames.bad,
            "repeated": frames.repeated,
            "resets": frames.resets,
            "tail_bytes": frames.tail_bytes,
        },
        "gaps": [asdict(gap) for gap in locate(recording)[:GAPS]],
        "samples": {
            "sent": frames.samples_sent,
            "received": len(recording.time_s),
            "out_of_order": frames.out_of_order,
        },
        "hello": asdict(recording.hello) if recording.hello else None,
    }


def commit(folder: Path, began: datetime, ended: datetime, outcome: Outcome) -> dict[str, Any]:
    """Account for `recording.frames` of a run folder and commit it; returns what capture.json says.

    Raises BadInput when it cannot be written.
    """
    data = (folder / NAME).read_bytes()
    return seal(folder, NAME, account(data, read_recording(data), began, ended, outcome))


def seal(folder: Path, name: str, info: dict[str, Any], csv: str | None = None) -> dict[str, Any]:
    """Write capture.json, after `csv` as recording.csv if given, and let nobody write to recording `name` any more.

    Raises BadInput when they cannot be written.
    """
    try:
        (folder / name).chmod(0o444)
        if csv is not None:
            write_text(folder / "recording.csv", csv)
        write_text(folder / "capture.json", json.dumps(info, indent=1, ensure_ascii=False) + "\n")
        sync_folder(folder)
    except OSError as error:
        mend = f"make room, then run python -m pipeline.capture --recover {folder}"
        problem = f"could not be written ({error.strerror}); the recording is whole and kept"
        raise BadInput(folder, "capture.json", problem, mend) from None
    return info


def recover(folder: Path) -> dict[str, Any]:
    """Commit a recording whose capture program was killed, as `recovered`; it is kept as it is.

    Its start is reckoned back from the file's last change. Raises BadInput when there is nothing to recover.
    """
    path = folder / NAME
    if not path.is_file():
        raise BadInput(path, NAME, "is not there", "name the folder of a run that was being captured")
    if (folder / "capture.json").exists():
        raise BadInput(folder, "capture.json", "is there, so the run is finished", "there is nothing to recover")
    if in_use(path):
        raise BadInput(path, NAME, "is still being captured", "wait for that program, or end it")
    recording = read_recording(path.read_bytes())
    if recording.hello is None:
        raise BadInput(path, NAME, "holds no HELLO, so nobody knows what was measured", "record again")
    ended = datetime.fromtimestamp(path.stat().st_mtime, UTC)
    seconds = float(recording.time_s[-1]) if len(recording.time_s) else 0.0
    return commit(folder, ended - timedelta(seconds=seconds), ended, Outcome("recovered"))
