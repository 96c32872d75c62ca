"""Notes of the dataset's stage on the zero of runs, for all who use its points: jumps, zeros that were set anew."""

import os
from collections.abc import Iterable, Sequence
from enum import IntEnum
from pathlib import Path

from ..errors import BadInput
from ..stored import schemas
from ..stored.notes import read_note, write_note
from .counts import counted

NAME = "zero_jumps.json"  # of the note, beside the dataset
LARGEST = 10_000_000  # bytes of a note
NOT_COMPARED = "zero not compared between"  # how a sentence begins on runs of which a jump is not seen
SET_ANEW = "zero set anew at"  # how one begins on a run whose run.yaml says `tare: run`
KNOWN_IN_PART = (
    "Such a zero is known in part: on simulated strings it was off by 0.02 to 0.05 mm (median, by how a string creeps)"
    ", in one break of ten by more than 0.1 to 0.3 mm, at worst by 0.8 mm."
)


class Kind(IntEnum):
    """What a sentence on the zero is about, the gravest first."""

    JUMP = 0  # it jumps, and nobody said why
    NOT_COMPARED = 1  # a jump would not be seen
    SET_ANEW = 2  # a person set it to zero, and said so


def kind(sentence: str) -> Kind:
    """What a sentence is about."""
    if sentence.startswith(NOT_COMPARED):
        return Kind.NOT_COMPARED
    return Kind.SET_ANEW if sentence.startswith(SET_ANEW) else Kind.JUMP


def gravest(sentences: Iterable[str]) -> Kind:
    """The gravest kind among sentences, of which there is one at least."""
    return min(map(kind, sentences))


def write_jumps(path: Path, sentences: Sequence[str]) -> None:
    """Write a note of sentences, one a jump, with a check sum."""
    write_note(path, list(sentences))


def read_jumps(notes: Sequence[Path]) -> list[str]:
    """The sentences of some notes; a missing note has none. Raises BadInput."""
    return [sentence for path in notes if os.path.lexists(path) for sentence in _sentences(path)]


def in_one_line(sentences: Sequence[str], path: Path) -> str:
    """The gravest sentence, and how many more the note at a path has; empty for none."""
    if not sentences:
        return ""
    more = len(sentences) - 1
    others = f" {counted(more, 'more note')} on the zero of these runs: {path}" if more else ""
    return f"{min(sentences, key=kind)}{others}"


def _sentences(path: Path) -> list[str]:
    sentences = read_note(path, LARGEST)
    if isinstance(sentences, list) and all(isinstance(sentence, str) for sentence in sentences):
        return sentences
    raise BadInput(path, "content", "is not what this version writes", schemas.MEND)
