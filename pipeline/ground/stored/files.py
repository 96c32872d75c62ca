"""Files that are either whole or not there: every stage writes to a temporary name, then renames; and check sums."""

import errno
import hashlib
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from ..errors import BadInput

DEEPEST = 200  # folders in each other: of a few hundred new ones Python makes none, and no person names as many


def make_folders(folder: Path) -> None:
    """Make a folder and those that it lies in, which may be there; raises OSError, also where they are too many."""
    if len(folder.absolute().parts) > DEEPEST:
        raise OSError(errno.ENAMETOOLONG, f"more than {DEEPEST} folders in each other", str(folder))
    folder.mkdir(parents=True, exist_ok=True)


@contextmanager
def whole(path: Path | str, new: bool = False) -> Iterator[Path]:
    """Yield a temporary path beside `path`; on success rename it to `path`, on failure remove it and its new folders.

    The temporary name keeps the suffix (writers go by it) and carries the process id, so that an orphan of a
    killed run and its successor never share a half-written file. Raises BadInput where no file can be written, or
    where something stands that is none: renaming would replace a device for everybody. With `new` an earlier file
    is never replaced: FileExistsError.
    """
    path = Path(path)
    mend = "give the name of a file in a folder in which you may write"
    new_folders = [folder for folder in path.parents if not folder.exists()]
    try:
        if not path.name or (path.exists() and not path.is_file()):
            raise BadInput(path, "--out", "is a folder, a device or a pipe, not a file", mend)
        make_folders(path.parent)
        temporary = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
        temporary.touch()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise BadInput(ascii(str(path))[1:-1], "--out", f"cannot be written ({reason})", mend) from None
    try:
        yield temporary
        with open(temporary, "rb") as file:
            os.fsync(file.fileno())
        _place(temporary, path, new)
    finally:
        temporary.unlink(missing_ok=True)
        for folder in new_folders if not path.exists() else ():
            with suppress(OSError):  # somebody else wrote there
                folder.rmdir()


def _place(temporary: Path, path: Path, new: bool) -> None:
    if new:
        try:
            os.link(temporary, path)
            return
        except OSError:  # a file is there, or the file system has no links
            if os.path.lexists(path):
                raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(path)) from None
    os.replace(temporary, path)


def write_text(path: Path | str, text: str, new: bool = False) -> None:
    """Write `text` as UTF-8, whole or not at all; with `new` FileExistsError where a file is there."""
    with whole(path, new) as temporary:
        temporary.write_text(text, encoding="utf-8")


def write_over(path: Path, text: str) -> None:
    """Write a file that is there anew, whole or not at all, with its rights and with the ends of lines of `text`."""
    with whole(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="")
        shutil.copymode(path, temporary)


def sha256(path: Path) -> str:
    """Check sum of a file's bytes, in hexadecimal digits."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
