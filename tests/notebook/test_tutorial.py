"""docs/tutorial was stored as it ran. That it runs, and says the same again, is tested on the wheel (tests/package)."""

from tutorial_run import code_cells


def test_every_cell_was_run_in_order_and_failed_nowhere() -> None:
    cells = code_cells()
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [one for cell in cells for one in cell.outputs if one.output_type == "error"]
    pictures = [one for cell in cells for one in cell.outputs if "image/png" in one.get("data", {})]
    pages = [
        one for cell in cells for one in cell.outputs if "data:image/png" in one.get("data", {}).get("text/html", "")
    ]
    assert len(pictures) == 1 and len(pages) == 1
