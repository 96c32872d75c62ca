"""The proof's page as HTML, and beside each of its tables which configuration made it."""

import argparse
import csv
from pathlib import Path

from ..ground.errors import BadInput, program
from ..ground.stored.files import write_text
from .layout.plain_markdown import note
from .layout.sidecar import Column, describe
from .web.markdown import web_page
from .web.marks import add_mark, mark_from

TABLES = {
    "authors": "Scores by who made the recordings",
    "laws": "Single effects by the law that hid in them",
    "cases": "Every concealed case and its verdict",
    "sizes": "Every hidden effect's size beside the size that was named",
    "scores": "Every score with its interval",
    "beside": "Other methods on the same recordings",
}


def is_number(text: str) -> bool:
    """Whether a cell holds a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def columns(table: Path) -> list[Column]:
    """Heads of a table, numbers where every filled cell is one; what they hold `docs/proof.md` says."""
    with open(table, encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    filled = [[row[at] for row in rows if row[at] != ""] for at in range(len(head))]
    kinds = ["number" if cells and all(map(is_number, cells)) else "string" for cells in filled]
    return [(name, kind, name) for name, kind in zip(head, kinds, strict=True)]


@program
def main() -> None:
    """Write `proof.html`, and `<table>.csv-metadata.json` for every table."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.proof", description=__doc__)
    parser.add_argument("folder", type=Path, help="reports/proof")
    add_mark(parser)
    arguments = parser.parse_args()
    folder, mark = arguments.folder, mark_from(arguments.made_by)
    if not (folder / "proof.md").is_file():
        raise BadInput(folder / "proof.md", "file", "is not there", "run snakemake proof")
    text = (folder / "proof.md").read_text(encoding="utf-8").rstrip().removesuffix(note(mark))
    write_text(folder / "proof.html", web_page(text, mark))
    for name, title in TABLES.items():
        if (folder / f"{name}.csv").is_file():
            describe(folder / f"{name}.csv", title, columns(folder / f"{name}.csv"), mark)


if __name__ == "__main__":
    main()
