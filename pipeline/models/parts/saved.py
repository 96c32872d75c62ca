"""What a fitted model's file holds: JSON or a program's own bytes, with a check sum that reading verifies.

Behind the content may stand a note on it, which readers of the content do not see.
"""

import json
import struct
from pathlib import Path
from typing import Any

from ...ground.errors import BadInput
from ...ground.stored import files, seal

NOTED = b"twistbench fitted to"  # the end of a content that has a note
TAIL = struct.Struct(f"<Q{len(NOTED)}s")  # the note's length, then the mark


def write_bytes(path: Path, content: bytes) -> None:
    """Write a model's bytes with their check sum, whole or not at all."""
    with files.whole(path) as temporary:
        temporary.write_bytes(seal.sealed(content))


def read_bytes(path: Path) -> bytes:
    """The bytes of a saved model; raises OSError, and BadInput for a file that was changed since."""
    return _parted(path)[0]


def write_note(path: Path, note: Any) -> None:
    """Put a note of plain values into a saved model's file, in place of one that it has; raises as `read_bytes`."""
    text = json.dumps(note).encode()
    write_bytes(path, read_bytes(path) + text + TAIL.pack(len(text), NOTED))


def read_note(path: Path) -> Any:
    """The note in a saved model's file, None where it has none; raises as `read_bytes`."""
    text = _parted(path)[1]
    return json.loads(text) if text else None


def write_json(path: Path, content: Any) -> None:
    """Write a model that is plain values."""
    write_bytes(path, json.dumps(content).encode() + b"\n")


def read_json(path: Path) -> Any:
    """The plain values of a saved model; raises BadInput, and ValueError for a model of another kind."""
    return json.loads(read_bytes(path))


def _parted(path: Path) -> tuple[bytes, bytes]:
    """A file's content and its note, which is empty where it has none."""
    try:
        content = bytes(seal.opened(seal.content_of(path)))
    except seal.Damaged as error:
        raise BadInput(path, "model", f"is not a saved model, or is damaged: {error}", "train it again") from None
    if not content.endswith(NOTED) or len(content) < TAIL.size:
        return content, b""
    end = len(content) - TAIL.size
    length = min(TAIL.unpack(content[end:])[0], end)
    return content[: end - length], content[end - length : end]
