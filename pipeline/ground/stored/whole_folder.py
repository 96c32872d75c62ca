"""Folders that are either whole or not there, as `files` does it for files."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import BadInput
from .files import make_folders


@contextmanager
def whole_folder(folder: Path, field: str, mend: str) -> Iterator[Path]:
    """Yield a folder beside `folder`; on success rename it to `folder`, on failure remove it.

    Raises BadInput of the field, with the mend, when `folder` is there already; and when it cannot be made.
    """
    if folder.exists():
        raise BadInput(folder, field, "is there already", mend)
    temporary = folder.with_name(f".{folder.name}.{os.getpid()}")
    try:
        try:
            make_folders(folder.parent)
            temporary.mkdir()
        except OSError as error:
            problem = f"cannot be written ({error.strerror or error})"
            raise BadInput(folder.parent, "--out", problem, "choose another folder") from None
        yield temporary
        os.rename(temporary, folder)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
