"""A recording while it grows: append only, never over another one, and at most a second behind on the disk."""

import os
import shutil
import time
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.stored.files import make_folders
from ..run.description import RUN_NAME
from ..run.folder import RECORDINGS

try:
    import fcntl
except ImportError:  # no POSIX system: nothing tells that another program is recording
    fcntl = None  # type: ignore[assignment]

NAME = "recording.frames"
LINES = "recording.lines"  # of a rig that prints text
SYNC_S = 1.0


def check_folder(folder: Path) -> None:
    """Raise BadInput for a folder whose name is no run's, or which holds a recording already."""
    for name in (folder.name, folder.resolve().name):  # "..", whose name would be that of another folder
        if not RUN_NAME.fullmatch(name):
            mend = "use lower-case letters, digits and -, as in uhmwpe-20261121-01"
            raise BadInput(folder, "RUN_DIR", f"{name!r} is no name of a run", mend)
    _check_empty(folder)


def _check_empty(folder: Path, but: str = "") -> None:
    for name in (*RECORDINGS, LINES, "capture.json"):
        if name != but and os.path.lexists(folder / name):
            raise _is_there(folder, name)


def _is_there(folder: Path, name: str) -> BadInput:
    """The complaint on a recording that is in the folder, or that another capture is making there now."""
    if name in (NAME, LINES) and (folder / name).is_file() and in_use(folder / name):
        mend = "wait until that one has ended, or choose a new run name"
        return BadInput(folder, name, "is being recorded now by another capture", mend)
    return BadInput(folder, name, "is there already and is never overwritten", "choose a new run name")


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Allow only one program at a time to begin a recording in a folder, where the system can lock a folder."""
    if fcntl is None:
        yield
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        with suppress(OSError):
            fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield
    finally:
        os.close(descriptor)


def sync_folder(folder: Path) -> None:
    """Put a folder's entries on the disk, where the system lets a folder be opened."""
    if not hasattr(os, "O_DIRECTORY"):
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


class Log:
    """The recording of a new run: made on opening, locked while open; raises BadInput when it cannot be made."""

    def __init__(self, folder: Path, name: str = NAME) -> None:
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND | getattr(os, "O_BINARY", 0)
        self._folder = folder
        try:
            make_folders(folder)
            with _alone(folder):
                self._file = os.open(folder / name, flags, 0o644)
                self._withdraw_beside_another(name)
                if fcntl is not None:  # before another one may look whether it is in use
                    fcntl.flock(self._file, fcntl.LOCK_EX)
        except FileExistsError:
            raise _is_there(folder, name) from None
        except OSError as error:
            mend = "make room there, or choose a folder in which you may write"
            raise BadInput(folder, name, f"cannot be made ({error.strerror})", mend) from None
        sync_folder(folder)
        self._synced_s = time.monotonic()
        self._beside = ThreadPoolExecutor(max_workers=1)
        self._syncing: Future[None] | None = None

    def _withdraw_beside_another(self, name: str) -> None:
        """If two recordings are in one folder, remove the later one, which is still empty."""
        try:
            _check_empty(self._folder, but=name)
        except BadInput:
            os.close(self._file)
            (self._folder / name).unlink()
            raise

    def append(self, data: bytes) -> None:
        """Write bytes through to the kernel, and every second begin to put them on the disk.

        That goes on beside: a disk that is slow for a while keeps no rig waiting, and a rig that hears nothing stops.
        """
        while data:
            data = data[os.write(self._file, data) :]
        if time.monotonic() - self._synced_s >= SYNC_S and (self._syncing is None or self._syncing.done()):
            self._check()
            self._syncing, self._synced_s = self._beside.submit(_to_disk, self._file), time.monotonic()

    def _check(self) -> None:
        """Wait until no write to the disk is under way; raises OSError where one failed."""
        if self._syncing is not None:
            self._syncing.result()

    def sync(self) -> None:
        """Put everything written so far on the disk."""
        self._check()
        _to_disk(self._file)
        self._synced_s = time.monotonic()

    @property
    def free_bytes(self) -> int:
        """Room on its disk."""
        return shutil.disk_usage(self._folder).free

    def close(self) -> None:
        """Release it."""
        self._beside.shutdown()
        os.close(self._file)


def _to_disk(file: int) -> None:
    getattr(os, "fdatasync", os.fsync)(file)


def in_use(path: Path) -> bool:
    """Whether a capture program is still writing to a recording."""
    if fcntl is None:
        return False
    descriptor = os.open(path, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    finally:
        os.close(descriptor)
    return False
