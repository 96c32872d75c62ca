"""docs/tutorial as one program, and whether a run of it says all that is stored in the notebook."""

import ast
import re
from itertools import zip_longest
from pathlib import Path

import nbformat

TUTORIAL = Path(__file__).parents[1] / "docs" / "tutorial" / "tutorial.ipynb"
PICTURE = re.compile(r"<img [^>]*>")
NUMBER = re.compile(r"\d+(?:\.(\d+))?")
APART = 1e-3  # share of a decimal number: processors round differently, and a fit carries that into its last digits
BYTES_APART = 3e-3  # share of a file's size: constants that are rounded differently have more or fewer digits
# a notebook shows the last expression of a cell, as HTML where the object has some
BEGIN = f"""
import re, sys
import matplotlib; matplotlib.use('Agg')
sys.stdout.reconfigure(line_buffering=True)  # so that what a cell's own program prints stands in its place

def show_as_a_notebook(value):
    print(re.sub({PICTURE.pattern!r}, '', value._repr_html_()) if hasattr(value, '_repr_html_') else repr(value))
"""


def code_cells():
    """The cells that are run, as they were stored."""
    return [cell for cell in nbformat.read(TUTORIAL, 4).cells if cell.cell_type == "code"]


def said_by(cell) -> str:
    """All words of a cell's stored output: what it printed and what it shows, without pictures."""
    words = []
    for output in cell.outputs:
        data = output.get("data", {})
        if "image/png" not in data:  # beside a picture stands only its size
            words.append(output.get("text") or PICTURE.sub("", data.get("text/html") or data["text/plain"]))
    return "\n".join(words)


def as_program(cells) -> str:
    """The cells as one program that shows the last expression of each, as a notebook does."""
    lines = [BEGIN]
    for number, cell in enumerate(cells):
        tree = ast.parse(cell.source)
        if isinstance(tree.body[-1], ast.Expr) and not re.search(r"\b(show|print)\(", ast.unparse(tree.body[-1])):
            tree.body[-1] = ast.parse(f"show_as_a_notebook({ast.unparse(tree.body[-1])})").body[0]
        lines += [f"print('\\n== {number}')", ast.unparse(tree)]
    return "\n".join(lines)


def like(stored: str, printed: str, bytes_follow: bool = False) -> bool:
    """Whether two words are equal, but for what processors round differently in decimal numbers and a file's size."""
    if NUMBER.sub("0", stored) != NUMBER.sub("0", printed):
        return False
    for old, new in zip(NUMBER.finditer(stored), NUMBER.finditer(printed), strict=True):
        last_digit = 1.01 * 10.0 ** -len(old[1]) if old[1] else 0.0
        share = BYTES_APART if bytes_follow else APART if old[1] else 0.0
        if abs(float(old[0]) - float(new[0])) > max(share * float(old[0]), last_digit):
            return False
    return True


def unlike(cells, printed: str) -> list[tuple[int, str, str]]:
    """For each cell whose output differs from its stored one: its number, and both from the first difference on."""
    different = []
    for number, cell in enumerate(cells):
        cell_output = printed.partition(f"\n== {number}\n")[2].partition("\n== ")[0]
        old, new = said_by(cell).split(), cell_output.split()
        for place, (stored_word, printed_word) in enumerate(zip_longest(old, new, fillvalue="")):
            if not like(stored_word, printed_word, old[place + 1 : place + 2] == ["bytes"]):
                different.append((number, " ".join(old[place : place + 9]), " ".join(new[place : place + 9])))
                break
    return different
