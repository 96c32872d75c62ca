"""Notes of the dataset's stage on unconfirmed jumps of the zero, for all who use its points."""

import os
from collections.abc import Sequence
from pathlib import Path

from ..errors import BadInput
from ..stored import schemas
from ..stored.notes import read_note, write_note
from .counts import counted

NAME = "zero_jumps.json"  # of the note, beside the dataset
LARGEST = 10_000_000  # bytes of a note
NOT_COMPARED = "zero not compared between"  # how a sentence begins on runs of which a jump is not seen


def write_jumps(path: Path, sentences: Sequence[str]) -> None:
    """Write a note of sentences, one a jump, with a check sum."""
    write_note(path, list(sentences))


def read_jumps(notes: Sequence[Path]) -> list[str]:
    """The sentences of some notes; a missing note has none. Raises BadInput."""
    return [sentence for path in notes if os.path.lexists(path) for sentence in _sentences(path)]


def in_one_line(sentences: Sequence[str], path: Path) -> str:
    """The first sentence on a jump, or else the first, and how many more the note at a path has; empty for none."""
    jumps = [sentence for sentence in sentences if not sentence.startswith(NOT_COMPARED)]
    if not sentences:
        return ""
    more = len(sentences) - 1
    others = f" {counted(more, 'more note')} on the zero of these runs: {path}" if more else ""
    return f"{(jumps or sentences)[0]}{others}"


def _sentences(path: Path) -> list[str]:
    sentences = read_note(path, LARGEST)
    if isinstance(sentences, list) and all(isinstance(sentence, str) for sentence in sentences):
        return sentences
    raise BadInput(path, "content", "is not what this version writes", schemas.MEND)
