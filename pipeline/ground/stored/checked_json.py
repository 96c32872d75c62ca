"""JSON that a person may edit or move, with its check sum in a file beside it: `sha256sum --check` reads that too."""

import hashlib
import json
import os
from pathlib import Path
from typing import Any

from ..errors import BadInput
from .files import write_text
from .regular_file import read_regular

LARGEST = 100_000_000  # bytes of the JSON
LARGEST_SUM = 10_000  # bytes of the file of its check sum


def sum_file(path: Path) -> Path:
    """The file of a file's check sum; where it is not there, nothing is known of damage."""
    return path.with_name(f"{path.name}.sha256")


def write_checked(path: Path, text: str) -> None:
    """Write JSON, whole or not at all, then its check sum; a kill between them leaves none."""
    sum_file(path).unlink(missing_ok=True)
    write_text(path, text)
    write_text(sum_file(path), _line(path, text.encode()))


def read_checked(path: Path, mend: str) -> Any:
    """The values of JSON; raises BadInput where it is none, or where a check sum is there and is another."""
    stored = read_regular(path, LARGEST)
    beside = sum_file(path)
    if os.path.lexists(beside) and read_regular(beside, LARGEST_SUM) != _line(path, stored).encode():
        raise BadInput(path, "content", f"is damaged: its check sum is not that of {beside.name}", mend)
    try:
        return json.loads(stored)
    except (ValueError, RecursionError):
        raise BadInput(path, "content", "is damaged: it is no JSON", mend) from None


def _line(path: Path, stored: bytes) -> str:
    """What `sha256sum` prints of a file."""
    return f"{hashlib.sha256(stored).hexdigest()}  {path.name}\n"
