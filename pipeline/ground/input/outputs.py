"""The output paths of a program, refused before its work begins rather than after it."""

import os
import stat
from collections.abc import Iterable
from pathlib import Path

from ..errors import BadInput
from ..stored.files import DEEPEST

LONGEST_PATH = 3500  # bytes in all: 4096 are taken, and names go under a folder
LONGEST_NAME = 200  # bytes: file systems take 255, and a temporary name beside it is longer
OF_A_RUN = ("run.yaml", "capture.json")  # what makes a folder a run's; only the programs that record write these


def file_to_write(path: Path, field: str = "--out", reads: Iterable[Path] = ()) -> Path:
    """A path at which a file can be made; raises BadInput naming the option.

    A file that the program `reads`, and a run's own description and recording, are never replaced.
    """
    _refuse_names(path, field, "a file")
    if path.is_dir():
        raise BadInput(field, str(path), "is a folder", "name a file in it")
    if path.exists() and not stat.S_ISREG(path.stat().st_mode):
        raise BadInput(field, str(path), "is a device, a pipe or a socket", "name a file")
    _refuse_place(path.parent, field)
    if any(_same(path, read) for read in reads):
        raise BadInput(field, str(path), "is a file that this program reads", "name another file")
    of_a_run = path.name in OF_A_RUN or path.name.startswith("recording")
    if of_a_run and any((path.parent / name).exists() for name in OF_A_RUN):
        raise BadInput(field, str(path), "belongs to a run, whose files are never replaced", "name another file")
    return path


def folder_to_write(path: Path, field: str = "--out") -> Path:
    """A path at which a folder is, or can be made; raises BadInput naming the option."""
    _refuse_names(path, field, "a folder")
    if path.exists() and not path.is_dir():
        raise BadInput(field, str(path), "is a file", "name a folder, which may be new")
    _refuse_place(path, field)
    return path


def _same(path: Path, other: Path) -> bool:
    """Whether two paths lead to one file; False where one of them leads nowhere."""
    try:
        return os.path.samefile(path, other)
    except (OSError, ValueError):
        return False


def _refuse_names(path: Path, field: str, wanted: str) -> None:
    """Raise BadInput for a path without a name, or one that no file system accepts."""
    if str(path) in ("", ".") and wanted == "a file":
        raise BadInput(field, "path", "is empty or the folder itself", f"name {wanted}")
    if "\0" in str(path):
        raise BadInput(field, "path", "holds a NUL character", f"name {wanted} without it")
    if len(os.fsencode(path.absolute())) > LONGEST_PATH:
        problem = f"is {len(os.fsencode(path.absolute()))} bytes long"
        raise BadInput(field, f"{str(path)[:40]}…", problem, f"name {wanted} in at most {LONGEST_PATH}")
    if (deep := len(path.absolute().parts)) > DEEPEST:
        problem = f"lies {deep} folders deep"
        raise BadInput(field, f"{str(path)[:40]}…", problem, f"name {wanted} in at most {DEEPEST}")
    for part in path.parts:
        if len(os.fsencode(part)) > LONGEST_NAME:
            problem = f"is {len(os.fsencode(part))} bytes long"
            raise BadInput(field, f"{part[:40]}…", problem, f"name {wanted} in at most {LONGEST_NAME}")


def _refuse_place(folder: Path, field: str) -> None:
    """Raise BadInput unless a folder is there and may be written to, or can be made."""
    try:
        existing = folder
        while not existing.exists():
            existing = existing.parent
        if not existing.is_dir():
            raise BadInput(field, str(existing), "is a file, and nothing can lie under it", "name another place")
        if not os.access(existing, os.W_OK | os.X_OK):
            raise BadInput(field, str(existing), "may not be written to", "name another place, or ask for the right")
    except OSError as error:  # too long in all, a loop of links, a disk that is gone
        raise BadInput(field, str(folder)[:80], error.strerror or "cannot be used", "name another place") from None
