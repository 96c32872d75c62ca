"""Jumps of the zero that nobody confirmed → a line beneath a table and a part of the page."""

import argparse
from collections.abc import Sequence
from pathlib import Path

from markupsafe import Markup

from .plain_markdown import plain
from .web.page import paragraph, together


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add to a command line where the jumps stand that the dataset's stage saw."""
    parser.add_argument("--jumps", type=Path, nargs="*", default=[], metavar="FILE", help="zero_jumps.json, as made")


def beneath(suffix: str, notes: Sequence[str]) -> list[str]:
    """What stands beneath a table in Markdown (`md`) or LaTeX (`tex`); csv stays as it is."""
    if suffix == "md":
        return [plain(f"Beware: {note}") for note in notes]
    return ["Beware: the zero jumps between runs of one string; see the log of the dataset."] if notes else []


def section(notes: Sequence[str]) -> Markup:
    """A part of the page; it is not folded, so that nobody overlooks it."""
    words = [paragraph(note) for note in notes]
    more = paragraph("Until then every model of that string learns the jump as if it were the string's own.")
    return together([Markup('<h2 id="jumps">The zero jumps</h2>'), *words, more])
