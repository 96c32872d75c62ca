"""Metrics → Tables I and II in the paper's layout, as csv, Markdown and LaTeX."""

import argparse
import csv
import io
from pathlib import Path

import pandas as pd

from pipeline import schemas
from pipeline.errors import program
from pipeline.files import write_text
from pipeline.report import left_out, paper
from pipeline.report.titles import titles_of

Row = tuple[str, str, list[str]]  # model's title, stroke, cells


def cell(metrics: pd.DataFrame, model: str, stroke: int, metric: str) -> str:
    """Median over the seeds to three decimals, or nothing where the material has no such stroke."""
    values = metrics.loc[
        (metrics["model"] == model) & (metrics["stroke"] == str(stroke)) & (metrics["metric"] == metric), "value"
    ]
    return "" if values.empty else f"{values.median():.3f}"


def rows(metrics: pd.DataFrame, number: int, titles: dict[str, str]) -> list[Row]:
    """Rows of Table I or II: winding, split `within`; `titles` maps a model's name to its title, in order."""
    shown = metrics[
        (metrics["split"] == "within")
        & (metrics["phase"] == "winding")
        & (metrics["angle_band"] == "all")
        & (metrics["map"] == paper.MAPS[number])
    ]
    return [
        (title, f"n={stroke}", [cell(shown, model, stroke, metric) for metric in paper.METRICS])
        for model, title in titles.items()
        for stroke in paper.STROKES
    ]


def to_csv(number: int, table: list[Row]) -> str:
    """The table as csv; the model's name stands in every row."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(paper.header(number))
    writer.writerows([title, stroke, *cells] for title, stroke, cells in table)
    return text.getvalue()


def _spanned(table: list[Row]) -> list[Row]:
    """The table with each model's name in the first of its rows only."""
    return [(title if stroke == f"n={paper.STROKES[0]}" else "", stroke, cells) for title, stroke, cells in table]


def to_markdown(number: int, table: list[Row]) -> str:
    """The table as Markdown, its columns aligned so that it reads well as plain text too."""
    lines = [paper.header(number), *([title, stroke, *cells] for title, stroke, cells in _spanned(table))]
    widths = [max(len(line[column]) for line in lines) for column in range(5)]
    ruler = ["-" * width for width in widths]
    padded = [
        [
            text.ljust(width) if column < 2 else text.rjust(width)
            for column, (text, width) in enumerate(zip(line, widths, strict=True))
        ]
        for line in (lines[0], ruler, *lines[1:])
    ]
    roman = "I" * number
    return f"TABLE {roman}: {paper.TITLES[number]}\n\n" + "".join(f"| {' | '.join(line)} |\n" for line in padded)


def to_latex(number: int, table: list[Row]) -> str:
    """The table as LaTeX, each model spanning its rows; needs the package multirow."""
    head = [title.replace("θ/2π", r"$\theta/2\pi$") for title in paper.header(number)]
    lines = [
        r"\begin{table}", r"\centering", rf"\caption{{{paper.TITLES[number]}}}", r"\begin{tabular}{lcccc}", r"\hline",
        " & ".join(head) + r" \\",
    ]  # fmt: skip
    for title, stroke, cells in table:
        first = stroke == f"n={paper.STROKES[0]}"
        if first:
            lines.append(r"\hline")
        name = rf"\multirow{{{len(paper.STROKES)}}}{{*}}{{{title.replace('_', chr(92) + '_')}}}" if first else ""
        lines.append(" & ".join([name, f"${stroke}$", *cells]) + r" \\")
    return "\n".join([*lines, r"\hline", r"\end{tabular}", r"\end{table}", ""])


@program
def main() -> None:
    """Write `table_1` and `table_2` of one material in all three forms."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("metrics", type=Path)
    parser.add_argument("--titles", nargs="+", required=True, metavar="MODEL=TITLE")
    parser.add_argument("--out-dir", type=Path, required=True)
    left_out.arguments(parser)
    arguments = parser.parse_args()
    metrics = schemas.read(arguments.metrics, schemas.METRICS)
    for number in paper.TABLES:
        table = rows(metrics, number, titles_of(arguments.titles))
        for suffix, form in {"csv": to_csv, "md": to_markdown, "tex": to_latex}.items():
            text = form(number, table) + left_out.beneath(suffix, arguments)
            write_text(arguments.out_dir / f"table_{number}.{suffix}", text)


if __name__ == "__main__":
    main()
