"""Lines → a section of a text that a person reads: a heading, and lines no wider than a page."""

import re

from ....ground.words.wrapped_lines import wrapped

FEW = 2  # sentences that need no numbers
Sections = list[tuple[str, list[str]]]  # each a heading and its lines


def text(sections: Sections, last: tuple[str, list[str]]) -> str:
    """Sections of a heading and its lines as a text: the first one, all others that have lines, and the last one."""
    first, *others = sections
    return "\n\n".join(section(*part) for part in [first, *(part for part in others if part[1]), last])


def shortened(line: str, most: int) -> str:
    """The first sentences of a line that have no more than `most` letters together; the first one in any case."""
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
    """What is to be known of an answer, a line each; of many each with a number, what to report first."""
    if len(sentences) <= FEW:
        return sentences
    return [f"{number}. {sentence}" for number, sentence in enumerate(sentences, start=1)]
