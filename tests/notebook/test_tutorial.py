"""docs/tutorial runs from its first cell to its last, and says what it said when it was written."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

TUTORIAL = Path(__file__).parents[2] / "docs" / "tutorial" / "tutorial.ipynb"
RUNNER = "import sys, pipeline; sys.modules['twistbench'] = pipeline\nimport matplotlib; matplotlib.use('Agg')\n"


def said_by(cell) -> str:
    """What a cell's stored output is, as text."""
    return "".join(one.get("text", "") or one.get("data", {}).get("text/plain", "") for one in cell.outputs)


def as_program(cells) -> str:
    """The cells as one program that shows the last expression of each, as a notebook does."""
    lines = [RUNNER]
    for number, cell in enumerate(cells):
        tree = ast.parse(cell.source)
        if isinstance(tree.body[-1], ast.Expr) and "show()" not in ast.unparse(tree.body[-1]):
            tree.body[-1] = ast.parse(f"print(repr({ast.unparse(tree.body[-1])}))").body[0]
        lines += [f"print('\\n== {number}')", ast.unparse(tree)]
    return "\n".join(lines)


@pytest.fixture(scope="module")
def cells():
    return [cell for cell in nbformat.read(TUTORIAL, 4).cells if cell.cell_type == "code"]


def test_every_cell_was_run_in_order_and_failed_nowhere(cells) -> None:
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [one for cell in cells for one in cell.outputs if one.output_type == "error"]
    pictures = [one for cell in cells for one in cell.outputs if "image/png" in one.get("data", {})]
    pages = [
        one for cell in cells for one in cell.outputs if "data:image/png" in one.get("data", {}).get("text/html", "")
    ]
    assert len(pictures) == 1 and len(pages) == 1


def test_the_tutorial_runs_and_says_again_what_it_says(cells) -> None:
    environment = {**os.environ, "PYTHONPATH": str(TUTORIAL.parents[2])}
    command = [sys.executable, "-c", as_program(cells)]
    done = subprocess.run(command, cwd=TUTORIAL.parent, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for number, cell in enumerate(cells):
        made = done.stdout.partition(f"\n== {number}\n")[2].partition("\n== ")[0]
        for line in said_by(cell).splitlines():
            if any(word in line for word in ("explained", "sure by", "strokes", "looks like", "diagnosis.json")):
                assert line.strip() in made, (number, line)
