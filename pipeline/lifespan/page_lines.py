"""Lines → a text no wider than a page: as wide as what `diagnose` and `adopt` print (a test compares)."""

import textwrap

from ..ground.command import START

WIDE = 112  # characters of a line
FURTHER = 4  # spaces by which the rest of a wrapped line is indented: a fact of its own is indented by 2 more
COMMANDS = (START, "snakemake ")  # a line that begins so is pasted whole


def page(lines: str) -> str:
    """A text of which each line is within the width of a page, its rest indented further; commands stay whole."""
    return "\n".join(row for line in lines.splitlines() for row in wrapped(line))


def wrapped(line: str) -> list[str]:
    """A line within the width of a page; a command stays whole."""
    bare = line.lstrip()
    if bare.startswith(COMMANDS):
        return [line]
    own = " " * (len(line) - len(bare))
    return textwrap.wrap(
        bare, WIDE, initial_indent=own, subsequent_indent=own + " " * FURTHER,
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip
