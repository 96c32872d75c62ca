"""Lines → a section of a text that a person reads: a heading, and lines no wider than a page."""

import re

from ....ground.words.wrapped_lines import wrapped

FEW = 2  # sentences that need no numbers
Sections = list[tuple[str, list[str]]]  # each a heading and its lines


def text(sections: Sections, last: tuple[str, list[str]]) -> str:
    """Sections, each a heading and lines, as a text: the first, all others that have lines, and the last."""
    first, *others = sections
    return "\n\n".join(section(*part) for part in [first, *(part for part in others if part[1]), last])


def shortened(line: str, most: int) -> str:
    """The first sentences of a line with no more than `most` letters in all; at least the first one."""
    first, *others = re.split(r"(?<=[.:]) (?=[A-Z])", line)
    kept = first
    for sentence in others:
        if len(kept) + 1 + len(sentence) > most:
            break
        kept += f" {sentence}"
    return kept


def section(head: str, lines: list[str]) -> str:
    """A heading with its lines, wrapped."""
    return "\n".join([*wrapped(head), *(row for line in lines for row in wrapped(line, "  "))])


def numbered(sentences: list[str]) -> list[str]:
    """The remarks on an answer, a line each; several are numbered, so that a report can refer to them."""
    if len(sentences) <= FEW:
        return sentences
    return [f"{number}. {sentence}" for number, sentence in enumerate(sentences, start=1)]
