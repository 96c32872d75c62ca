"""Reports → index.html, one page with every material's tables and figures and every run's diagnosis."""

import argparse
import csv
import html
from pathlib import Path

from pipeline.errors import program
from pipeline.files import write_text
from pipeline.report import left_out, paper
from pipeline.report.diagnoses import section

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #222 }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums }
caption { text-align: left; font-weight: 600 } th, td { padding: .15rem .8rem; border-bottom: 1px solid #ddd }
th, td:nth-child(-n+2) { text-align: left } td { text-align: right } img { max-width: 100%; margin: .5rem 0 }
pre { white-space: pre-wrap; font: 14px/1.5 system-ui, sans-serif } .verdicts td:nth-child(3) { text-align: left }
"""
LEAK = """\
What training on the forward error alone does to the INN's inverse, by chance of its permutations, and two cures: the
error of both ways, or permutations that undo each other. A constant input comes out of the network with a small error,
and where θ had to pass through that output, the inverse magnifies it."""


def html_table(path: Path, caption: str) -> str:
    """A csv table as HTML."""
    with open(path, encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    cells = "".join(f"<th>{html.escape(name)}</th>" for name in head)
    lines = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>\n" for row in rows)
    return f"<table><caption>{html.escape(caption)}</caption>\n<tr>{cells}</tr>\n{lines}</table>\n"


def figure(material: str, stem: str, words: str) -> str:
    """A figure as HTML, a link to its pdf."""
    return f'<a href={material}/{stem}.pdf><img src={material}/{stem}.png alt="{words}"></a>'


def page(reports: Path, materials: list[str], runs: list[str]) -> str:
    """The page's HTML; links are relative to the reports' folder, so that it can be moved as a whole."""
    text = [f"<!doctype html>\n<html lang=en><meta charset=utf-8><title>twistbench</title><style>{STYLE}</style>"]
    text.append("<h1>twistbench reports</h1><p>All numbers: <a href=metrics.csv>metrics.csv</a></p>")
    for material in materials:
        text.append(f"<h2 id={material}>{material}</h2>")
        text += [
            html_table(reports / material / f"table_{number}.csv", f"Table {'I' * number}: {title.lower()}")
            for number, title in paper.TITLES.items()
        ]
        text.append(f"<p><a href={material}/comparison.md>Beside the paper's numbers</a></p>")
        every = "Every model by stroke, direction and angle, beside the floor of the data"
        text.append(f"<p><a href={material}/models.md>{every}</a> (<a href={material}/models.csv>csv</a>)</p>")
        text += [figure(material, f"figure_{number}", f"Figure {number}") for number in (4, 5)]
        if (reports / material / "figure_leak.png").is_file():
            text.append(f"<p>{LEAK}</p>")
            text.append(figure(material, "figure_leak", "The INN's inverse error and its parts"))
    if runs:
        text.append(section(reports, runs))
    return "\n".join(text) + "\n"


@program
def main() -> None:
    """Write `index.html`."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("materials", nargs="*")
    parser.add_argument("--runs", nargs="*", default=[], help="runs that are diagnosed")
    parser.add_argument("--reports", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    left_out.arguments(parser)
    arguments = parser.parse_args()
    text = page(arguments.reports, arguments.materials, arguments.runs)
    write_text(arguments.out, text + left_out.section(left_out.told(arguments)))


if __name__ == "__main__":
    main()
