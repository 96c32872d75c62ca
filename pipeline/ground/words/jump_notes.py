"""Notes of the dataset's stage on unconfirmed jumps of the zero, for all who use its points."""

import json
import os
from collections.abc import Sequence
from pathlib import Path

from ..command import REMAKE
from ..errors import BadInput
from ..stored.regular_file import read_regular

NAME = "zero_jumps.json"  # of the note, beside the dataset
LARGEST = 10_000_000  # bytes of a note
NOT_COMPARED = "zero not compared between"  # how a sentence begins on runs of which a jump is not seen


def to_json(notes: Sequence[str]) -> str:
    """A note of sentences, one a jump."""
    return json.dumps(list(notes), ensure_ascii=False)


def from_json(content: bytes, source: Path) -> list[str]:
    """The sentences of a note, which is read from `source`; raises BadInput for anything else."""
    try:
        notes = json.loads(content.decode("utf-8"))
    except (ValueError, RecursionError):
        notes = None
    if isinstance(notes, list) and all(isinstance(note, str) for note in notes):
        return notes
    raise BadInput(source, "JSON", "is not what the dataset's stage writes", REMAKE)


def read_jumps(notes: Sequence[Path]) -> list[str]:
    """The sentences of some notes; a missing note has none. Raises BadInput."""
    present = (path for path in notes if os.path.lexists(path))
    return [note for path in present for note in from_json(read_regular(path, LARGEST), path)]
