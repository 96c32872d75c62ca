"""A material's part of the index, folded: both tables, the figures, and the ways to its other pages."""

from pathlib import Path

from markupsafe import Markup

from . import paper
from .strokes_there import NOT_SHOWN
from .table_forms import from_markdown
from .web.page import Text, anchor, folded, link, paragraph, picture, together
from .web.table import table

FIGURES = {
    "figure_4": "Figure 4: strokes against the traditional model, and its errors.",
    "figure_5": "Figure 5: models against the measurement, and their errors. The paper's figure has no error rows.",
    "figure_leak": "What training on the forward error alone does to the INN's inverse, by chance of its permutations,"
    " and two cures: the error of both ways, or permutations that undo each other. A constant input comes out of the"
    " network with a small error, and where θ had to pass through that output, the inverse magnifies it.",
}
PAGES = {
    "models.html": "every model by stroke, direction and angle, beside the floor",
    "comparison.html": "beside the paper's numbers, with the spread over the seeds, and later strokes",
}


def html_table(folder: Path, number: int) -> Markup:
    """Table I or II, the model's name in every row, and where to take it from."""
    stem = f"table_{number}"
    caption, head, rows, notes = from_markdown((folder / f"{stem}.md").read_text(encoding="utf-8"))
    files = Markup(", ").join(
        Markup('<a href="{}">{}</a>').format(link(folder.name, f"{stem}.{suffix}"), suffix)
        for suffix in ("csv", "tex", "md")
    )
    words = caption.replace(paper.TITLES[number], paper.TITLES[number].lower()).replace("TABLE", "Table")
    below = " ".join(line for line in notes if line.startswith(NOT_SHOWN))
    told = Markup('\n<p class="soft">{} The same as {}.</p>').format(below, files)
    return table(head, rows, words, (0, 1)) + told


def section(reports: Path, material: str) -> Markup:
    """The part of one material; what was not made is not shown."""
    folder, parts = reports / material, list[Text]()
    there = {page: words for page, words in PAGES.items() if (folder / page).is_file()}
    for page, words in there.items():
        parts.append(paragraph(Markup('<a href="{}">{}</a>').format(link(material, page), words.capitalize())))
    for number in paper.TABLES:
        if (folder / f"table_{number}.md").is_file():
            parts.append(html_table(folder, number))
    for stem, words in FIGURES.items():
        if (folder / f"{stem}.png").is_file():
            source, target = link(material, f"{stem}.png"), link(material, f"{stem}.pdf")
            parts.append(picture(source, f"{stem.replace('_', ' ')} of {material}", target, words))
    aside = "tables, figures, every model" if parts else "nothing was made of it"
    return folded(anchor("material", material), material, aside, together(parts))
