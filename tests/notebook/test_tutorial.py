"""docs/tutorial was stored as it ran. That it runs, and says the same again, is tested on the wheel (tests/package)."""

import pytest
from tutorial_run import PICTURE, code_cells, like, said_by, unlike


def printed(cells) -> str:
    """What a program prints that says all that is stored."""
    return "".join(f"\n== {number}\n{said_by(cell)}\n" for number, cell in enumerate(cells))


def test_every_cell_was_run_in_order_and_failed_nowhere() -> None:
    cells = code_cells()
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [output for cell in cells for output in cell.outputs if output.output_type == "error"]
    pictures = [output for cell in cells for output in cell.outputs if "image/png" in output.get("data", {})]
    pages = [output for cell in cells for output in cell.outputs if PICTURE.search(str(output.get("data")))]
    assert len(pictures) == 1 and len(pages) == 1


@pytest.mark.parametrize(
    ("stored", "today"),
    [
        ("tsa.h: 23199 bytes of text", "tsa.h: 23092 bytes of text"),  # the size that was stale
        ("8 strokes, 4181 samples", "9 strokes, 4181 samples"),
        ("sure by 98%", "sure by 96%"),
        ("0.136 mm rms", "0.139 mm rms"),
        ("<td>12.382814</td>", "<td>12.482814</td>"),  # a cell of a table
        ("Its zero, its runs, and", "Its zero and"),
        ("'simulation.yaml',\n", ""),  # a line that is no longer printed
    ],
)
def test_a_stale_word_line_or_number_is_found_in_the_stored_output(stored: str, today: str) -> None:
    """The same cells, but for one place in one of them."""
    cells = code_cells()
    now = printed(cells)
    assert not unlike(cells, now) and stored in now
    assert len(unlike(cells, now.replace(stored, today, 1))) == 1


def test_numbers_may_differ_by_what_processors_round_otherwise() -> None:
    assert like("12.382814", "12.382826") and like("98%", "98%") and like("(0.115", "(0.116")
    assert like("23199", "23180", bytes_follow=True) and not like("23199", "23180")
    assert not like("98%", "97%") and not like("0.115", "0.117") and not like("creep:", "wear:")
