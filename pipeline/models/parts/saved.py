"""What a fitted model's file holds: JSON or a program's own bytes, with a check sum that reading verifies."""

import json
from pathlib import Path
from typing import Any

from ...ground.errors import BadInput
from ...ground.stored import files, seal


def write_bytes(path: Path, content: bytes) -> None:
    """Write a model's bytes with their check sum, whole or not at all."""
    with files.whole(path) as temporary:
        temporary.write_bytes(seal.sealed(content))


def read_bytes(path: Path) -> bytes:
    """The bytes of a saved model; raises OSError, and BadInput for a file that was changed since."""
    try:
        return bytes(seal.opened(seal.content_of(path)))
    except seal.Damaged as error:
        raise BadInput(path, "model", f"is not a saved model, or is damaged: {error}", "train it again") from None


def write_json(path: Path, content: Any) -> None:
    """Write a model that is plain values."""
    write_bytes(path, json.dumps(content).encode() + b"\n")


def read_json(path: Path) -> Any:
    """The plain values of a saved model; raises BadInput, and ValueError for a model of another kind."""
    return json.loads(read_bytes(path))
