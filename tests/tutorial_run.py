"""docs/tutorial as one program, and whether it says again what it said when it was written."""

import ast
from pathlib import Path

import nbformat

TUTORIAL = Path(__file__).parents[1] / "docs" / "tutorial" / "tutorial.ipynb"
WITHOUT_A_SCREEN = "import matplotlib; matplotlib.use('Agg')\n"
SAME = ("explained", "sure by", "strokes", "looks like", "diagnosis.json")  # lines with these words say no rounding


def code_cells():
    """The cells that are run, as they were stored."""
    return [cell for cell in nbformat.read(TUTORIAL, 4).cells if cell.cell_type == "code"]


def said_by(cell) -> str:
    """What a cell's stored output is, as text."""
    return "".join(output.get("text", "") or output.get("data", {}).get("text/plain", "") for output in cell.outputs)


def as_program(cells) -> str:
    """The cells as one program that shows the last expression of each, as a notebook does."""
    lines = [WITHOUT_A_SCREEN]
    for number, cell in enumerate(cells):
        tree = ast.parse(cell.source)
        if isinstance(tree.body[-1], ast.Expr) and "show()" not in ast.unparse(tree.body[-1]):
            tree.body[-1] = ast.parse(f"print(repr({ast.unparse(tree.body[-1])}))").body[0]
        lines += [f"print('\\n== {number}')", ast.unparse(tree)]
    return "\n".join(lines)


def unlike(cells, printed: str) -> list[tuple[int, str]]:
    """Lines of the stored output that a run did not say, each with its cell's number."""
    missing = []
    for number, cell in enumerate(cells):
        cell_output = printed.partition(f"\n== {number}\n")[2].partition("\n== ")[0]
        lines = [line for line in said_by(cell).splitlines() if any(word in line for word in SAME)]
        missing += [(number, line) for line in lines if line.strip() not in cell_output]
    return missing
