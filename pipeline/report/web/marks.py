"""The mark of a configuration: its look on a page and beneath a table, and its command line option."""

import argparse
from pathlib import Path

from ...ground.errors import BadInput
from ...ground.stored.files import write_text
from ..layout.made_by import MadeBy, unpacked
from ..layout.plain_markdown import note
from .markdown import web_page


def add_mark(parser: argparse.ArgumentParser) -> None:
    """Add the option for the mark of a configuration to a command line."""
    parser.add_argument("--made-by", metavar="JSON", default=MadeBy().packed(), help="the mark of the configuration")


def mark_from(text: str, option: str = "--made-by") -> MadeBy:
    """The mark from a command line; raises BadInput for an invalid one."""
    try:
        return unpacked(text)
    except ValueError as error:
        raise BadInput("arguments", option, str(error), "leave it out, or let the workflow give it") from None


def write_page(path: Path, text: str, mark: MadeBy) -> None:
    """Write a page as Markdown with the mark beneath, and beside it as HTML with the mark above."""
    write_text(path, f"{text.rstrip()}\n\n{note(mark)}\n")
    write_text(path.with_suffix(".html"), web_page(text, mark))
