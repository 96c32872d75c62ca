"""A file from a person, opened only if it is a plain file: a folder, a pipe or a device would fail or hang."""

import os
import stat
from pathlib import Path
from typing import BinaryIO

from ..errors import BadInput

KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}


def open_regular(path: Path, field: str = "file") -> BinaryIO:
    """The plain file at `path`, open for reading bytes; raises BadInput if it is missing or something else."""
    try:
        kind = stat.S_IFMT(os.stat(path).st_mode)
        if kind == stat.S_IFREG:
            return open(path, "rb")
    except (FileNotFoundError, NotADirectoryError):
        raise BadInput(path, field, "is not there", "check the path") from None
    except ValueError:  # a NUL in the name
        raise BadInput(repr(path), field, "is no name of a file", "check the path") from None
    except OSError as error:
        problem = f"cannot be read ({error.strerror or error})"
        raise BadInput(path, field, problem, "check its name, its links and who may read it") from None
    problem = f"is {KINDS.get(kind, 'something else')}, not a file"
    raise BadInput(path, field, problem, "give the file itself")


def read_regular(path: Path, largest: int, field: str = "file") -> bytes:
    """Bytes of the plain file at `path`; raises BadInput if it is no plain file or has more than `largest` bytes."""
    with open_regular(path, field) as file:
        try:
            content = file.read(largest + 1)
        except OSError as error:
            problem = f"cannot be read ({error.strerror or error})"
            raise BadInput(path, field, problem, "copy it again") from None
    if len(content) > largest:
        problem = f"has more than {largest / 1e6:.3g} MB"
        raise BadInput(path, field, problem, "check that it is the file that you mean")
    return content
