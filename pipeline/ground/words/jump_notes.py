"""Notes of the dataset's stage on the zero of runs, for all who use its points: jumps, zeros that were set anew."""

import os
from collections.abc import Collection, Iterable, Mapping, Sequence
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
OFF = (
    "off by 0.02 to 0.08 mm (median, by how a string creeps and whether its loads vary), in one break of ten by more "
    "than 0.1 to 0.3 mm"
)
KNOWN_IN_PART = f"Such a zero is known in part: on simulated strings it was {OFF}, at worst by 1.3 mm."
EARLIER_REST = "Compared with an earlier rest, a zero is off by all that the string changed since that rest."
CARRIED = (
    "Carried to another load by the line of the rests, a zero is off by what they stray from that line (the noise at "
    "most) and by what the string took back in the break."
)
MODEL_VALUE = (
    "Set to the model's value, a zero is off by what the string stretches from its first load to this one beyond the "
    "model, and by all that it had changed before."
)
OTHERWISE = (EARLIER_REST, CARRIED, MODEL_VALUE)  # doubts of a zero that the last rest before it does not tell
NAMED = 4  # strings, where there are more: so many and the number of the others


class Kind(IntEnum):
    """What a sentence on the zero is about, the gravest first."""

    JUMP = 0  # it jumps, and nobody said why
    NOT_COMPARED = 1  # a jump would not be seen
    SET_ANEW = 2  # a person set it to zero, and said so


DID = {  # what the zero of a string did, for those who ask about others
    Kind.JUMP: "jumps between runs",
    Kind.NOT_COMPARED: "was not compared between runs",
    Kind.SET_ANEW: "was set anew between runs",
}


def kind(sentence: str) -> Kind:
    """What a sentence is about."""
    if sentence.startswith(NOT_COMPARED):
        return Kind.NOT_COMPARED
    return Kind.SET_ANEW if sentence.startswith(SET_ANEW) else Kind.JUMP


def gravest(sentences: Iterable[str]) -> Kind:
    """The gravest kind among sentences, of which there is one at least."""
    return min(map(kind, sentences))


def write_jumps(path: Path, by_string: Mapping[str, Sequence[str]]) -> None:
    """Write a note of each string's sentences, one a jump, with a check sum."""
    write_note(path, {string: list(sentences) for string, sentences in by_string.items() if sentences})


def read_jumps(notes: Sequence[Path]) -> list[str]:
    """The sentences of some notes; a missing note has none. Raises BadInput."""
    return [sentence for path in notes for sentences in _by_string(path).values() for sentence in sentences]


def beside_exports(path: Path, string: str = "") -> str:
    """What the note at a path says of the zero of one string, or of all: the gravest sentence, how many more there are.

    Empty where it says nothing, or is not there. Raises BadInput.
    """
    notes = _by_string(path)
    of_strings = [sentence for name in notes if string in ("", name) for sentence in notes[name]]
    return _in_one_line(of_strings, Path(path.name))


def beside_answers(path: Path, strings: Collection[str], learnt: Collection[str]) -> list[str]:
    """Lines beside answers about `strings`, from the note at a path; the model learnt from `learnt`.

    A string that nobody asks about is named with what its zero did, for its points shape the answers too. Raises
    BadInput.
    """
    notes = _by_string(path)
    own = _in_one_line([sentence for string in notes if string in strings for sentence in notes[string]], path)
    others = [string for string in notes if string in learnt and string not in strings]
    lines = [f"beware: {own}"] if own else []
    if others:
        did = DID[gravest(sentence for string in others for sentence in notes[string])]
        more = f" and {len(others) - NAMED} more" if len(others) > NAMED else ""
        which = f"string{'s' * (len(others) > 1)} {', '.join(others[:NAMED])}{more}"
        lines.append(f"note: the model that answers has learnt {which} too, whose zero {did}: {path}")
    return lines


def _in_one_line(sentences: Sequence[str], path: Path) -> str:
    """The gravest sentence, and how many more the note at a path has; empty for none."""
    if not sentences:
        return ""
    more = len(sentences) - 1
    others = f" {counted(more, 'more note')} on the zero of these runs: {path}" if more else ""
    return f"{min(sentences, key=kind)}{others}"


def _by_string(path: Path) -> dict[str, list[str]]:
    """The sentences on each string of a note; none where it is missing."""
    notes = read_note(path, LARGEST) if os.path.lexists(path) else {}
    if isinstance(notes, dict) and all(map(_are_sentences, notes.values())):
        return notes
    raise BadInput(path, "content", "is not what this version writes", schemas.MEND)


def _are_sentences(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(sentence, str) for sentence in value)
