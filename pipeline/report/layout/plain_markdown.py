"""Text that Markdown shows as it is, and the mark of a configuration as a paragraph of Markdown."""

import re

from .made_by import MadeBy, sentence

SPECIAL = re.compile(r"([\\`*\[\]<|])")
ESCAPED = re.compile(r"\\([\\`*\[\]<|])")


def plain(text: str) -> str:
    """One line of text in which no name can become a link, a table's border or HTML."""
    return SPECIAL.sub(r"\\\1", " ".join(text.splitlines()))


def line(cells: list[str]) -> str:
    """One row of a Markdown table, of cells that are Markdown."""
    return f"| {' | '.join(cells)} |"


def spoken(text: str) -> str:
    """Markdown as a terminal shows it: the inverse of `plain`."""
    return ESCAPED.sub(r"\1", text)


def note(mark: MadeBy) -> str:
    """The mark as a paragraph of Markdown, in bold unless the configuration is the default one."""
    words = plain(sentence(mark))
    return words if mark.kind == "default" else f"**{words}**"
