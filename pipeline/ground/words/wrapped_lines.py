"""Lines no wider than a page in a terminal; a command stays whole, so that it can be pasted."""

import re
import textwrap

from ..command import START

WIDE = 112  # characters of a line
FURTHER = 2  # spaces by which the rest of a line is indented, where it is not told
COMMANDS = (START, "snakemake ")  # an indented line that begins so is a command


def wrapped(line: str, indent: str = "", further: int = FURTHER) -> list[str]:
    """A line within the width of a page, indented; its rest by `further` more spaces, or after its number."""
    bare = line.lstrip()
    if bare.startswith(COMMANDS) and bare != line:
        return [f"{indent}{line}"]
    own = indent + " " * (len(line) - len(bare))
    hang = re.match(r"\d+\. ", bare)
    return textwrap.wrap(
        bare, WIDE, initial_indent=own, subsequent_indent=own + " " * (len(hang[0]) if hang else further),
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip
