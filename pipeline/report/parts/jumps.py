"""Jumps of the zero, and zeros not compared → a line beneath a table, a box on a page, a part of the index."""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

from markupsafe import Markup

from ...ground.words.jump_notes import Kind, gravest, read_jumps
from ..layout.plain_markdown import plain
from ..web.page import paragraph, together

Notes = Mapping[str, Sequence[str]]  # by material, what is said of its zero
NONE: Notes = {}
MEANING = {  # for the errors of models
    Kind.JUMP: (
        "Until then every model of that string learns the jump as if it were the string's own: the errors on this page,"
        " and the model to take, may be wrong."
    ),
    Kind.NOT_COMPARED: (
        "If the zero was moved there, every model of that string learns that as if it were the string's own: the errors"
        " on this page, and the model to take, may be wrong."
    ),
    Kind.SET_ANEW: "The contractions of all strokes from there on share that error, and so do the answers about them.",
}
TITLES = {
    Kind.JUMP: "The zero jumps",
    Kind.NOT_COMPARED: "The zero was not compared",
    Kind.SET_ANEW: "The zero was set anew",
}
HINTS = {
    Kind.JUMP: "jumps between runs: these errors may be of that",
    Kind.NOT_COMPARED: "was not compared between runs",
    Kind.SET_ANEW: "was set anew between runs, and is known in part",
}


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
    what = TITLES[gravest(notes)].replace("The", "the", 1) if notes else ""
    return [f"Beware: {what} between runs of one string; see the log of the dataset."] if notes else []


def quoted(notes: Sequence[str]) -> list[str]:
    """Lines of Markdown for the top of a page: a quotation, which a page shows as a box; none without a jump."""
    words = [*(plain(f"Beware: {note}") for note in notes), MEANING[gravest(notes)]] if notes else []
    return ["\n>\n".join(f"> {line}" for line in words), ""] if words else []


def box(notes: Sequence[str]) -> Markup:
    """The same as a box of HTML; empty without a jump."""
    words = [*(f"Beware: {note}" for note in notes), MEANING[gravest(notes)]] if notes else []
    return Markup("<blockquote>{}</blockquote>").format(together(map(paragraph, words))) if words else Markup("")


def hint(material: str, notes: Notes) -> Markup:
    """What stands in a material's row on its zero, and where the page says more; empty where nothing is said of it."""
    own = notes.get(material)
    return Markup('<br><a class="far" href="#jumps">its zero {}</a>').format(HINTS[gravest(own)]) if own else Markup("")


def title(notes: Notes) -> str:
    """The heading of that part of the index."""
    return TITLES[_gravest_of(notes)]


def section(notes: Notes) -> Markup:
    """A part of the index, by material; it is not folded, so that nobody overlooks it."""
    words = [
        paragraph(Markup("<b>{}</b>: {}").format(material, note)) for material, own in notes.items() for note in own
    ]
    boxed = Markup("<blockquote>{}</blockquote>").format(together([*words, paragraph(MEANING[_gravest_of(notes)])]))
    return together([Markup('<h2 id="jumps">{}</h2>').format(title(notes)), boxed])


def _gravest_of(notes: Notes) -> Kind:
    return gravest(note for own in notes.values() for note in own)
