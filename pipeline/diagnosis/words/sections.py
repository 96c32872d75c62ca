"""Lines → a section of a text that a person reads: a heading, and lines no wider than a page."""

import textwrap

from ...ground.command import START

PROGRAM = f"  {START}"
WIDE = 112


def section(head: str, lines: list[str]) -> str:
    """A heading with its lines, wrapped."""
    return "\n".join([*wrapped(head, ""), *(row for line in lines for row in wrapped(line, "  "))])


def wrapped(line: str, indent: str) -> list[str]:
    """A line within the width of a page, indented; a command stays whole."""
    if line.startswith(PROGRAM):
        return [f"{indent}{line}"]
    own = indent + " " * (len(line) - len(line.lstrip()))
    return textwrap.wrap(
        line.lstrip(), WIDE, initial_indent=own, subsequent_indent=f"{own}  ", break_long_words=False,
        break_on_hyphens=False,
    )  # fmt: skip
