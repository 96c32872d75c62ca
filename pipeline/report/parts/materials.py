"""A material's part of the pages: its tables, its figures, its runs, and the ways to its other pages."""

from collections.abc import Sequence
from pathlib import Path

from markupsafe import Markup

from ..layout import paper
from ..layout.table_forms import OF_WHAT, from_markdown
from ..shown.shown_strokes import SHOWN
from ..shown.strings_together import TOGETHER
from ..shown.stroke_conditions import OTHERWISE
from ..web.page import Text, link, paragraph, picture, together
from ..web.sortable_table import table

FIGURES = {
    "figure_4": "Figure 4: strokes against the traditional model, and its errors. Where x falls below 0 that model's"
    " inverse has no real root and answers one and the same twist: its error can have a spike there.",
    "figure_5": "Figure 5: models against the measurement, and their errors. The paper's figure has no error rows: a"
    " bar is the root mean square over one of 24 equal parts of the stroke, where points of it were held out. Beside"
    " the INN stand the model of the least forward error on this material's held-out points and, where it is another,"
    " the model to take.",
    "figure_leak": "Leak: why an invertible network (INN) can be good forward and bad on its way back. Each row is one"
    " way to train it. Made of the synthetic rig alone.",
}
PAGES = {
    "models.html": "which model to take: every model's error by stroke, direction and twist, beside the least possible"
    " one; where the fitted models lie",
    "comparison.html": "the errors beside the paper's numbers, with the spread over the seeds, and on later strokes",
}


def html_table(folder: Path, number: int, up: str) -> Markup:
    """Table I or II, with a model's name once until the table is sorted, and links to its files."""
    stem = f"table_{number}"
    caption, head, rows, notes = from_markdown((folder / f"{stem}.md").read_text(encoding="utf-8"))
    head = [title.replace("(θ/2π)", "(turns)") for title in head]  # the paper's word for them
    files = Markup(", ").join(
        Markup('<a href="{}">{}</a>').format(up + link(folder.name, f"{stem}.{suffix}"), suffix)
        for suffix in ("csv", "tex", "md")
    )
    words = caption.replace(paper.TITLES[number], paper.TITLES[number].lower()).replace("TABLE", "Table")
    below = " ".join(line for line in notes if line.startswith((OF_WHAT, SHOWN, TOGETHER, OTHERWISE)))
    apart = _apart((folder / f"{stem}.csv").read_text(encoding="utf-8"), number)
    shape = Markup('\n<p class="soft">n is the number of the stroke. {} The same numbers as {}{}.</p>')
    once = [[Markup('<span class="again">{}</span>').format(row[0]) if is_again else row[0], *row[1:]]
            for row, is_again in zip(rows, _again(rows), strict=True)]  # fmt: skip
    return table(head, once, words, (0, 1)) + shape.format(below, files, apart)


def _again(rows: Sequence[Sequence[str]]) -> list[bool]:
    """Whether each row has the same model as the row above, so that its name is not repeated."""
    return [place > 0 and row[0] == rows[place - 1][0] for place, row in enumerate(rows)]


def _apart(csv: str, number: int) -> str:
    """How the files of Table I or II differ from the page; empty where they do not."""
    empty = sorted({line.split(",")[-4] for line in csv.splitlines()[1:] if line.endswith(",,")})
    differences = ["the files call the turns θ/2π, as the paper does"] if paper.UNITS[number] == "θ/2π" else []
    if empty:
        differences.append(f"the csv has {' and '.join(empty)} too, in empty cells")
    return "".join(f"; {difference}" for difference in differences)


def part(reports: Path, material: str, runs: Sequence[Text] = (), up: str = "") -> Markup:
    """The part of one material, with the links to its runs; missing files are left out.

    `up` leads from the page to `reports/`.
    """
    folder, parts = reports / material, list[Text]()
    for page, words in PAGES.items():
        if (folder / page).is_file():
            parts.append(paragraph(Markup('<a href="{}">{}</a>').format(up + link(material, page), words.capitalize())))
    for number in paper.TABLES:
        if (folder / f"table_{number}.md").is_file():
            parts.append(html_table(folder, number, up))
    for stem in FIGURES:
        if (folder / f"{stem}.png").is_file():
            source, target = (up + link(material, f"{stem}.{suffix}") for suffix in ("png", "pdf"))
            parts.append(picture(source, f"{stem.replace('_', ' ')} of {material}", target, FIGURES[stem]))
    if not parts:
        parts.append(paragraph("Nothing was made of it."))
    if runs:
        parts.append(paragraph(Markup("Runs: {}").format(Markup(" · ").join(runs))))
    return together(parts)
