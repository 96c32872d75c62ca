"""Jumps of the zero that nobody confirmed → a line beneath a table, a box at a page's top, a part of the index."""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

from markupsafe import Markup

from ...ground.words.jump_notes import read_jumps
from ..layout.plain_markdown import plain
from ..web.page import paragraph, together

Notes = Mapping[str, Sequence[str]]  # by material, what is said of jumps of its zero
NONE: Notes = {}
UNTIL = (
    "Until then every model of that string learns the jump as if it were the string's own: the errors on this page, and"
    " the model to take, may be wrong."
)


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the option for the jumps of the zero to a command line."""
    parser.add_argument("--jumps", type=Path, nargs="*", default=[], metavar="FILE", help="zero_jumps.json, as made")


def by_material(files: Sequence[Path]) -> dict[str, list[str]]:
    """The notes of materials, each from its folder; a material without a note has no entry."""
    notes = {path.parent.name: read_jumps([path]) for path in files}
    return {material: own for material, own in notes.items() if own}


def beneath(suffix: str, notes: Sequence[str]) -> list[str]:
    """The lines beneath a table in Markdown (`md`) or LaTeX (`tex`) on jumps; csv stays unchanged."""
    if suffix == "md":
        return [plain(f"Beware: {note}") for note in notes]
    return ["Beware: the zero jumps between runs of one string; see the log of the dataset."] if notes else []


def quoted(notes: Sequence[str]) -> list[str]:
    """Lines of Markdown for the top of a page: a quotation, which a page shows as a box; none without a jump."""
    words = [*(plain(f"Beware: {note}") for note in notes), UNTIL] if notes else []
    return ["\n>\n".join(f"> {line}" for line in words), ""] if words else []


def box(notes: Sequence[str]) -> Markup:
    """The same as a box of HTML; empty without a jump."""
    words = [*(f"Beware: {note}" for note in notes), UNTIL] if notes else []
    return Markup("<blockquote>{}</blockquote>").format(together(map(paragraph, words))) if words else Markup("")


def hint(material: str, notes: Notes) -> Markup:
    """The remark in a material's row that its zero jumps, and where to read more; else empty."""
    shape = Markup('<br><a class="far" href="#jumps">its zero jumps between runs: these errors may be of that</a>')
    return shape if notes.get(material) else Markup("")


def section(notes: Notes) -> Markup:
    """A part of the index, by material; it is not folded, so that nobody overlooks it."""
    words = [
        paragraph(Markup("<b>{}</b>: {}").format(material, note)) for material, own in notes.items() for note in own
    ]
    boxed = Markup("<blockquote>{}</blockquote>").format(together([*words, paragraph(UNTIL)]))
    return together([Markup('<h2 id="jumps">The zero jumps</h2>'), boxed])
