"""capture.json: the account of a recording, written last and whole; its existence is the commit."""

import hashlib
import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from pipeline.capture.log import NAME, in_use, sync_folder
from pipeline.capture.losses import locate
from pipeline.capture.stream import Outcome
from pipeline.errors import BadInput
from pipeline.files import write_text
from pipeline.wire import Account, Hello, read_account

SCHEMA = 1
PIECE = 1 << 20  # bytes that are read at once


def opening(size: int, sha256: str, began: datetime, ended: datetime, outcome: Outcome) -> dict[str, Any]:
    """What capture.json says of any recording: when it was made, how it ended, and which bytes it is."""
    return {
        "schema": SCHEMA,
        "exit_status": outcome.status,
        "fault": outcome.fault,
        "started_utc": began.astimezone(UTC).isoformat(timespec="milliseconds"),
        "ended_utc": ended.astimezone(UTC).isoformat(timespec="milliseconds"),
        "bytes": size,
        "sha256": sha256,
    }


@dataclass
class Read:
    """A recording read once from its beginning, piece by piece: its device, its account and which bytes it is."""

    hello: Hello | None
    frames: Account
    size: int
    sha256: str

    @staticmethod
    def of(path: Path) -> "Read":
        """Read a file; memory goes by what was lost in it, not by its length."""
        digest, size = hashlib.sha256(), 0

        def pieces() -> Iterator[bytes]:
            nonlocal size
            with open(path, "rb") as file:
                while piece := file.read(PIECE):
                    digest.update(piece)
                    size += len(piece)
                    yield piece

        hello, frames = read_account(pieces())
        return Read(hello, frames, size, digest.hexdigest())


def account(read: Read, began: datetime, ended: datetime, outcome: Outcome) -> dict[str, Any]:
    """Content of capture.json; sent = received + lost holds for its frames."""
    frames, hello = read.frames, read.hello
    return {
        **opening(read.size, read.sha256, began, ended, outcome),
        "frames": {
            "sent": frames.sent,
            "received": frames.received,
            "lost": frames.lost,
            "bad": frames.bad,
            "repeated": frames.repeated,
            "resets": frames.resets,
            "tail_bytes": frames.tail_bytes,
        },
        "gaps": [asdict(loss) for loss in locate(frames, hello.strokes if hello else 0)],
        "samples": {
            "sent": frames.samples_sent,
            "received": frames.samples,
            "out_of_order": frames.out_of_order,
        },
        "hello": asdict(hello) if hello else None,
    }


def commit(folder: Path, began: datetime, ended: datetime, outcome: Outcome) -> dict[str, Any]:
    """Account for `recording.frames` of a run folder and commit it; returns what capture.json says.

    Raises BadInput when it cannot be written.
    """
    return seal(folder, NAME, account(Read.of(folder / NAME), began, ended, outcome))


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
    read = Read.of(path)
    if read.hello is None:
        raise BadInput(path, NAME, "holds no HELLO, so nobody knows what was measured", "record again")
    ended = datetime.fromtimestamp(path.stat().st_mtime, UTC)
    began = ended - timedelta(seconds=read.frames.last_s)
    return seal(folder, NAME, account(read, began, ended, Outcome("recovered")))
