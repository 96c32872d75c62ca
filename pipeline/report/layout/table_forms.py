"""Tables I and II as csv, Markdown and LaTeX; the Markdown can be read back, for other pages."""

import csv
import io
import re
from itertools import pairwise

from . import paper
from .plain_markdown import plain

OF_WHAT = "Material"  # begins the note on what a table's numbers are of
Row = tuple[str, str, list[str]]  # model's title, stroke, cells
TEX = {
    "\\": r"\textbackslash{}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_", "{": r"\{", "}": r"\}",
    "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}",
    "×": r"$\times$", "θ": r"$\theta$",
}  # fmt: skip


def tex(text: str) -> str:
    """Text that LaTeX shows as it is."""
    return "".join(TEX.get(character, character) for character in text)


def to_csv(number: int, table: list[Row]) -> str:
    """The table as csv; the model's name stands in every row."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(paper.header(number))
    writer.writerows([title, stroke, *cells] for title, stroke, cells in table)
    return text.getvalue()


def _spans(table: list[Row]) -> list[int]:
    """For each row the number of its model's rows if it is the first of them, else 0."""
    titles = [title for title, _, _ in table]
    return [titles.count(title) if titles.index(title) == row else 0 for row, title in enumerate(titles)]


def caption_of(number: int, warning: str) -> str:
    """Caption of the paper, and that the table is no result where it is none."""
    return f"{paper.TITLES[number]}{f' ({warning})' if warning else ''}"


def to_markdown(number: int, table: list[Row], warning: str = "", notes: tuple[str, ...] = ()) -> str:
    """The table as Markdown, its columns aligned so that it reads well as plain text too; notes stand beneath."""
    spanned = [
        [plain(title) if span else "", stroke, *cells]
        for (title, stroke, cells), span in zip(table, _spans(table), strict=True)
    ]
    lines = [paper.header(number), *spanned]
    widths = [max(len(line[column]) for line in lines) for column in range(5)]
    ruler = ["-" * width for width in widths]
    padded = [
        [
            text.ljust(width) if column < 2 else text.rjust(width)
            for column, (text, width) in enumerate(zip(line, widths, strict=True))
        ]
        for line in (lines[0], ruler, *lines[1:])
    ]
    rows = "".join(f"| {' | '.join(line)} |\n" for line in padded)
    beneath = "".join(f"\n{words}\n" for words in notes if words)
    return f"TABLE {'I' * number}: {caption_of(number, warning)}\n\n{rows}{beneath}"


def from_markdown(text: str) -> tuple[str, list[str], list[list[str]], list[str]]:
    """Caption, head, rows and notes from the text of `to_markdown`, the model's name in every row."""
    caption, _, rest = text.partition("\n")
    cells = [
        [re.sub(r"\\(.)", r"\1", cell.strip()) for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        for line in rest.splitlines()
        if line.startswith("|")
    ]
    rows = cells[2:]
    for above, row in pairwise(rows):
        row[0] = row[0] or above[0]
    notes = [line for line in rest.splitlines() if line and not line.startswith("|")]
    return caption, cells[0] if cells else [], rows, notes


def to_latex(number: int, table: list[Row], label: str, warning: str = "", notes: tuple[str, ...] = ()) -> str:
    """The table as LaTeX with a label, each model spanning its rows, notes beneath; needs the package multirow."""
    head = [title.replace("θ/2π", r"$\theta/2\pi$") for title in paper.header(number)]
    lines = [
        r"% needs \usepackage{multirow} before \begin{document}",
        r"\begin{table}", r"\centering", rf"\caption{{{tex(caption_of(number, warning))}}}", rf"\label{{{label}}}",
        r"\begin{tabular}{lcccc}", r"\hline", " & ".join(head) + r" \\",
    ]  # fmt: skip
    for (title, stroke, cells), span in zip(table, _spans(table), strict=True):
        if span:
            lines.append(r"\hline")
        name = rf"\multirow{{{span}}}{{*}}{{{tex(title)}}}" if span else ""
        lines.append(" & ".join([name, f"${stroke}$", *cells]) + r" \\")
    lines += [r"\hline", r"\end{tabular}"]
    lines += [rf"\par\smallskip{{\footnotesize {tex(words)}}}" for words in notes if words]
    return "\n".join([*lines, r"\end{table}", ""])
