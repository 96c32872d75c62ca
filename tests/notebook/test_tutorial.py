"""docs/tutorial runs from its first cell to its last, and says what it said when it was written."""

import os
import subprocess
import sys

import pytest
from tutorial_run import IN_A_CHECKOUT, TUTORIAL, as_program, code_cells, unlike


def test_every_cell_was_run_in_order_and_failed_nowhere() -> None:
    cells = code_cells()
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [one for cell in cells for one in cell.outputs if one.output_type == "error"]
    pictures = [one for cell in cells for one in cell.outputs if "image/png" in one.get("data", {})]
    pages = [
        one for cell in cells for one in cell.outputs if "data:image/png" in one.get("data", {}).get("text/html", "")
    ]
    assert len(pictures) == 1 and len(pages) == 1


@pytest.mark.long
def test_the_tutorial_runs_and_says_again_what_it_says() -> None:
    cells, environment = code_cells(), {**os.environ, "PYTHONPATH": str(TUTORIAL.parents[2])}
    command = [sys.executable, "-c", as_program(cells, IN_A_CHECKOUT)]
    done = subprocess.run(command, cwd=TUTORIAL.parent, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert not unlike(cells, done.stdout)
