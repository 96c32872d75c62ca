"""Files that are either whole or not there: every stage writes to a temporary name, then renames."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pipeline.errors import BadInput


@contextmanager
def whole(path: Path | str) -> Iterator[Path]:
    """Yield a temporary path beside `path`; on success rename it to `path`, on failure remove it.

    The temporary name keeps the suffix (writers go by it) and carries the process id, so that an orphan of a
    killed run and its successor never share a half-written file. Raises BadInput where no file can be written, or
    where something stands that is none: renaming would replace a device for everybody.
    """
    path = Path(path)
    mend = "give the name of a file in a folder in which you may write"
    try:
        if not path.name or (path.exists() and not path.is_file()):
            raise BadInput(path, "--out", "is a folder, a device or a pipe, not a file", mend)
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
        temporary.touch()
    except (OSError, ValueError) as error:
        said = getattr(error, "strerror", None) or error
        raise BadInput(ascii(str(path))[1:-1], "--out", f"cannot be written ({said})", mend) from None
    try:
        yield temporary
        with open(temporary, "rb") as file:
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def write_text(path: Path | str, text: str) -> None:
    """Write `text` as UTF-8, whole or not at all."""
    with whole(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
