"""Every public rig's rows → one table beside the black boxes, and the section that says where the tool can be wrong."""

import argparse
import html
import io
from pathlib import Path

import pandas as pd

from ...ground.errors import BadInput, program
from ...ground.stored.files import whole, write_text
from ...ground.stored.regular_file import read_regular
from ...real.rigs import Rig, read_rigs
from ..web.page import STYLE, link
from .page import WIDE, sizes, table
from .results import BLACK_BOXES, CARRIED, ELSEWHERE, OTHERS, TITLES

LARGEST = 10_000_000  # bytes of a rig's table

BLOCKS = (("", list(TITLES)), (ELSEWHERE, CARRIED), (OTHERS, CARRIED))
INTRODUCTION = """\
<p>Each recording was imported as it was published and diagnosed from its base model alone. Errors are rms. The first
block: the last 30 % of a recording's strokes, after learning from the strokes before. The second: the whole of a
recording after learning from another one of the same thing, zero set on the first second, median over the others;
a motor that may count its turns from elsewhere is homed on the first stroke, for the nominal simulator too.
The third: the same after learning from all others of that thing together.
The black boxes (boosted trees, a Gaussian process on 1,000 points, a neural network of 2 × 64, median of three
seeds) get motion, its rate and acceleration, which way the motion came, delayed motion and load, and correct a straight
line over these. They name nothing. Smallest of each block in bold.</p>
"""


def numbers(row: pd.Series, prefix: str, methods: list[str]) -> dict[str, float]:
    """Errors of the methods that a row holds."""
    return {name: float(row[f"{prefix}{name}"]) for name in methods if pd.notna(row.get(f"{prefix}{name}"))}


def blocks(row: pd.Series) -> list[str]:
    """Cells of all the blocks of errors, the smallest of each in bold."""
    return [cell for prefix, methods in BLOCKS for cell in sizes(numbers(row, prefix, methods), methods)]


def overview(rows: pd.DataFrame, rigs: dict[str, Rig]) -> str:
    """The table over all rigs: single recordings, then those together, then the median of each rig."""
    head = ["Recording", "Verdict", "Left out", "Unit", *(TITLES[name] for _, methods in BLOCKS for name in methods)]
    titles = ("its last strokes", "after learning from another recording", "after learning from all others")
    over = "".join(f"<th colspan={len(of)}>{title}</th>" for title, (_, of) in zip(titles, BLOCKS, strict=True))
    over = f"<tr><th colspan=4></th>{over}</tr>\n"
    text = []
    for rig, rig_rows in rows.groupby("rig", sort=False):
        title = html.escape(rigs[str(rig)].title)
        text.append(f'<h3><a href="{link(f"{rig}.html")}">{title}</a></h3>')
        lines = []
        for _, row in rig_rows.iterrows():
            ties = f" (or {int(row['ties'])} other{'s' * (row['ties'] > 1)})" if row["ties"] else ""
            first_cells = [row["recording"], row["verdict"], f"{row['named']}{ties}", row["unit"]]
            cells = [html.escape(str(cell)) for cell in first_cells]
            lines.append([*cells, *blocks(row)])
        single = rig_rows[rig_rows["together"] == "no"].median(numeric_only=True)
        unit = html.escape(str(next(iter(rig_rows["unit"][rig_rows["unit"] != ""]), "")))
        middle = ["median", "", "", unit]
        lines.append([*middle, *blocks(single)])
        text.append(table(head, lines, texts=4, over=over))
    return "\n".join(text)


def doubts(rows: pd.DataFrame) -> str:
    """The verdicts that are not firm or not expected, and the reasons."""
    doubted = rows[rows["doubt"] != ""]
    count = (
        f"{len(doubted)} of {len(rows)} verdicts are ambiguous, unknown or missing, or disagree with the literature."
    )
    lines = [
        [html.escape(str(cell)) for cell in (row["recording"], row["doubt"], row["why"])]
        for _, row in doubted.iterrows()
    ]
    return f"<p>{count}</p>" + (table(["Recording", "Kind", "Why"], lines, texts=3) if lines else "")


def beaten(rows: pd.DataFrame) -> str:
    """How often a black box predicts better than the explained simulator, on either kind of unseen data."""
    sentences = []
    for prefix, words in (
        ("", "unseen strokes of the same recording"),
        (ELSEWHERE, "another recording"),
        (OTHERS, "a recording left out, learnt from all others"),
    ):
        both = [
            (row[f"{prefix}explained"], min(others.values()))
            for _, row in rows.iterrows()
            if pd.notna(row[f"{prefix}explained"]) and (others := numbers(row, prefix, list(BLACK_BOXES)))
        ]
        if both:
            lost = sum(other < own for own, other in both)
            sentences.append(
                f"On {words} the best of the three black boxes is better on {lost} of {len(both)} recordings."
            )
    return f"<p>{' '.join(sentences)}</p>"


def ignored(files: list[str]) -> str:
    """The files that were not used, and the reasons."""
    if not files:
        return ""
    listed = "".join(f"<li>{html.escape(name)}</li>" for name in files)
    why = "No pattern of <code>pipeline/config/real.yaml</code> knows their names:"
    return f"<h2>Files that were passed over</h2><p>{why}</p><ul>{listed}</ul>"


def page(rows: pd.DataFrame, rigs: dict[str, Rig], passed_over: list[str]) -> str:
    """The page's HTML."""
    return "\n".join([
        "<!doctype html>\n<html lang=en><meta charset=utf-8><title>public rigs</title>",
        f"<style>{STYLE}{WIDE}</style><h1>Recordings of public rigs</h1>", INTRODUCTION,
        "<p>All numbers: <a href=table.csv>table.csv</a></p>",
        overview(rows, rigs), beaten(rows),
        "<h2>The tool can be wrong in public</h2>", doubts(rows),
        ignored(passed_over),
    ]) + "\n"  # fmt: skip


@program
def main() -> None:
    """Write the page over all rigs and its table as csv."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.real.index", description=__doc__)
    parser.add_argument("tables", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True, help="the file of the page; required")
    parser.add_argument("--table", type=Path, required=True)
    parser.add_argument("--passed-over", nargs="*", default=[], help="files of which nothing was made")
    arguments = parser.parse_args()
    rows = pd.concat(
        [pd.read_csv(io.BytesIO(read_regular(path, LARGEST))) for path in arguments.tables], ignore_index=True
    )
    texts = ["verdict", "named", "expected", "unit", "doubt", "why"]
    missing = [name for name in texts if name not in rows]
    if missing:
        raise BadInput(arguments.tables[0], missing[0], "is not among its columns", "make the rigs' tables again")
    rows[texts] = rows[texts].astype(object).fillna("").astype(str)
    write_text(arguments.out, page(rows, read_rigs(), arguments.passed_over))
    with whole(arguments.table) as temporary:
        rows.to_csv(temporary, index=False, float_format="%.5g")


if __name__ == "__main__":
    main()
