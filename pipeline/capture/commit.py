"""capture.json: the account of a recording, written last and whole; its existence is the commit."""

import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path

from ..ground.command import command, recover_command
from ..ground.errors import BadInput
from ..ground.stored.files import write_text
from ..run.capture_json import CaptureJson
from ..run.ended_words import ABORTED
from ..run.folder import capture_info
from ..wire import Account, Hello, Reason, read_account
from . import uncommitted_note
from .log import NAME, in_use, sync_folder
from .losses import locate
from .stream import Outcome

SCHEMA = 1
PIECE = 1 << 20  # bytes that are read at once


def judged(outcome: Outcome, frames: Account) -> Outcome:
    """An outcome after the recording was read: a recording that nobody can use is a fault, whatever the device said."""
    wrong = None
    if frames.no_clock:
        bad, steps = frames.backward_stamps + frames.repeated_stamps, frames.samples - 1
        wrong = f"the device's clock stands or runs backwards at {bad} of {steps} steps from sample to sample"
    elif not frames.samples and outcome.status != "fault":
        wrong = "it holds no sample"
    if wrong is None:
        return outcome
    return Outcome("fault", "; ".join(filter(None, (outcome.fault, wrong))), outcome.ended_by)


def told(frames: Account) -> Outcome:
    """How a recording ended, from what the device said in it; without an END it is `recovered`."""
    if frames.end is None:
        return Outcome("recovered")
    if frames.end.reason == Reason.FAULT:
        return Outcome("fault", "the device reported a fault")
    return Outcome("complete" if frames.end.reason == Reason.COMPLETE else ABORTED)


def opening(size: int, sha256: str, began: datetime, ended: datetime, outcome: Outcome) -> CaptureJson:
    """The part of capture.json that every recording has: when it was made, how it ended, and which bytes it is."""
    return {
        "schema": SCHEMA,
        "exit_status": outcome.status,
        "fault": outcome.fault,
        "ended_by": outcome.ended_by,
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


def account(read: Read, began: datetime, ended: datetime, outcome: Outcome) -> CaptureJson:
    """Content of capture.json; sent = received + lost holds for its frames."""
    frames, hello = read.frames, read.hello
    return {
        **opening(read.size, read.sha256, began, ended, judged(outcome, frames)),
        "frames": {
            "sent": frames.sent,
            "received": frames.received,
            "lost": frames.lost,
            "bad": frames.bad,
            "repeated": frames.repeated,
            "resets": frames.resets,
            "tail_bytes": frames.tail_bytes,
        },
        "gaps": locate(frames, hello.strokes if hello else 0),
        "samples": {
            "sent": frames.samples_sent,
            "received": frames.samples,
            "out_of_order": frames.out_of_order,
            "backward_time_stamps": frames.backward_stamps,
            "repeated_time_stamps": frames.repeated_stamps,
        },
        "hello": hello.content if hello else None,
    }


def commit(folder: Path, began: datetime, ended: datetime, outcome: Outcome) -> CaptureJson:
    """Account for `recording.frames` of a run folder and commit it; returns what capture.json says.

    Raises BadInput when it cannot be written.
    """
    return seal(folder, NAME, account(Read.of(folder / NAME), began, ended, outcome))


def seal(folder: Path, name: str, info: CaptureJson) -> CaptureJson:
    """Write capture.json, and make the recording `name` read-only.

    Raises BadInput when they cannot be written, or capture.json is that of another recording.
    """
    text = json.dumps(info, indent=1, ensure_ascii=False) + "\n"
    try:
        (folder / name).chmod(0o444)
        try:
            write_text(folder / "capture.json", text, new=True)
        except FileExistsError:
            check_own(folder, name, info["sha256"])
            write_text(folder / "capture.json", text)
        sync_folder(folder)
    except OSError as error:
        raise unwritten(folder, "capture.json", error) from None
    return info


def check_own(folder: Path, name: str, sha256: str) -> None:
    """Raise BadInput where capture.json belongs to other bytes than those of recording `name`."""
    if committed(folder).get("sha256", sha256) != sha256:
        files = f"{name} and {uncommitted_note.NAME}" if (folder / uncommitted_note.NAME).exists() else name
        mend = f"move {files} into the folder of a new run, and run {command('capture')} --recover on that"
        problem = f"is there already, of another recording; {name} is whole and kept"
        raise BadInput(folder, "capture.json", problem, mend)


def unwritten(folder: Path, name: str, error: OSError) -> BadInput:
    """The message that a file of a recording could not be written when the recording had ended."""
    mend = f"make room, then run {recover_command(folder)}"
    problem = f"could not be written ({error.strerror}); the recording is whole and kept"
    return BadInput(folder, name, problem, mend)


def committed(folder: Path) -> CaptureJson:
    """Content of capture.json; nothing where there is none, or an unreadable one that is to be made again."""
    try:
        return capture_info(folder)
    except BadInput:
        return {}


def recover(folder: Path) -> CaptureJson:
    """Commit a recording whose capture program was killed, as `recovered` or as its END says; it is kept as it is.

    Its start is reckoned back from the file's last change. Raises BadInput when there is nothing to recover.
    """
    path = folder / NAME
    if not path.is_file():
        raise BadInput(path, NAME, "is not there", "name the folder of a run that was being captured")
    if committed(folder):
        raise BadInput(folder, "capture.json", "is there, so the run is finished", "there is nothing to recover")
    if in_use(path):
        raise BadInput(path, NAME, "is still being captured", "wait for that program, or end it")
    read = Read.of(path)
    if read.hello is None:
        raise BadInput(path, NAME, "holds no HELLO, so nobody knows what was measured", "record again")
    ended = datetime.fromtimestamp(path.stat().st_mtime, UTC)
    began = ended - timedelta(seconds=read.frames.last_s)
    return seal(folder, NAME, account(read, began, ended, told(read.frames)) | {"recovered": True})
