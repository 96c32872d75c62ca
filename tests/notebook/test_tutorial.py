"""docs/tutorial was stored as it ran. That it runs, and says the same again, is tested on the wheel (tests/package)."""

from tutorial_run import code_cells


def test_every_cell_was_run_in_order_and_failed_nowhere() -> None:
    cells = code_cells()
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [output for cell in cells for output in cell.outputs if output.output_type == "error"]
    pictures = [output for cell in cells for output in cell.outputs if "image/png" in output.get("data", {})]
    pages = [
        output
        for cell in cells
        for output in cell.outputs
        if "data:image/png" in output.get("data", {}).get("text/html", "")
    ]
    assert len(pictures) == 1 and len(pages) == 1
