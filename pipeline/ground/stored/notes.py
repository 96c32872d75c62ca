"""Notes of a stage for the stages after it: JSON with a check sum, which reading verifies."""

from pathlib import Path
from typing import Any

from . import schemas, seal
from .files import write_text
from .regular_file import read_regular


def write_note(path: Path, content: Any) -> None:
    """Write plain values with their check sum, whole or not at all."""
    write_text(path, seal.sealed_json(content))


def read_note(path: Path, largest: int) -> Any:
    """Plain values of a note of at most `largest` bytes; raises BadInput for a file that is not what was written."""
    try:
        return seal.opened_json(read_regular(path, largest))
    except seal.Damaged as error:
        raise schemas.damaged(path, error) from None
