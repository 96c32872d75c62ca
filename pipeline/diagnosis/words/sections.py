"""Lines → a section of a text that a person reads: a heading, and lines no wider than a page."""

import re
import textwrap

from ...ground.command import START

WIDE, WIDEST = 112, 120
Sections = list[tuple[str, list[str]]]  # each a heading and its lines


def text(sections: Sections, last: tuple[str, list[str]], tight: bool = False) -> str:
    """Sections of a heading and its lines as a text: the first one, all others that have lines, and the last one.

    `tight`: lines as wide as a page can be, and no empty ones between sections, but for that after the first one.
    """
    first, *others = sections
    shown = [first, *(part for part in others if part[1]), last]
    headline, *parts = [section(*part, WIDEST if tight else WIDE) for part in shown]
    return "\n\n".join([headline, ("\n" if tight else "\n\n").join(parts)])


def section(head: str, lines: list[str], wide: int = WIDE) -> str:
    """A heading with its lines, wrapped."""
    return "\n".join([*wrapped(head, "", wide), *(row for line in lines for row in wrapped(line, "  ", wide))])


def wrapped(line: str, indent: str, wide: int = WIDE) -> list[str]:
    """A line within the width of a page, indented; a command stays whole."""
    bare = line.lstrip()
    if bare.startswith(START) and bare != line:
        return [f"{indent}{line}"]
    own = indent + " " * (len(line) - len(bare))
    hang = re.match(r"\d+\. ", bare)
    return textwrap.wrap(
        bare, wide, initial_indent=own, subsequent_indent=own + " " * (len(hang[0]) if hang else 2),
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip
