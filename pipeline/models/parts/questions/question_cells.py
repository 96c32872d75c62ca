"""The cells of a file of questions as text: a csv, one with another sign between its columns, or a workbook.

A decimal comma is read where another sign than a comma parts the columns. Where it may part thousands the file is
refused: nothing is guessed.
"""

import re
import shlex
from collections.abc import Collection
from pathlib import Path
from typing import Any

from ....formats import format_of, read_foreign
from ....formats.text import first_names
from ....formats.text_layout import LOOK, cells, with_point
from ....formats.text_lines import table_lines
from ....ground.errors import BadInput
from ....ground.input.text_file import TextFile

COMMA = ","
MARKS = {";": ";", "\t": r"\t", "|": "|"}  # that part columns elsewhere, each as `tr` writes it
THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}")  # 1,234: a decimal comma, or one between thousands
POINT = re.compile(r"[+-]?\d[\d,]*\.\d*")
LAYOUT = TextFile.model_validate({})
Cells = list[list[str]]


def question_cells(path: Path, columns: Collection[str], words: Collection[str]) -> tuple[Cells, str]:
    """The header's cells, then those of each row, and the sign that parts them; raises BadInput for no table.

    `columns` are those that questions may have; of `words` the cells are no numbers.
    """
    if "sheet" in format_of(path).keys:
        table = read_foreign(path, LAYOUT)
        return [list(map(str, table.columns)), *([_text(cell) for cell in row] for row in table.to_numpy(object))], ""
    lines = [line for _, line in table_lines(path, LAYOUT)]
    header = cells(lines[0], COMMA) if lines else []
    mark = next((mark for mark in MARKS if mark in header[0]), COMMA) if len(header) == 1 else COMMA
    header = cells(lines[0], mark) if lines else []
    if not lines or not set(header) <= set(columns):  # else it is a table of questions, whatever its rows are
        layout = LAYOUT.model_copy(update={"delimiter": mark})
        first_names(path, layout, list(enumerate(lines[:LOOK])), len(lines))
    rows = [cells(line, mark) for line in lines[1:]]
    return [header, *(rows if mark == COMMA else _with_points(path, mark, header, rows, words))], mark


def _text(cell: Any) -> str:
    """A cell of a workbook as a csv has it: nothing where it is empty, and 3 for 3.0."""
    if cell is None or cell != cell:
        return ""
    return f"{cell:.0f}" if isinstance(cell, float) and cell.is_integer() else str(cell).strip()


def _with_points(path: Path, mark: str, header: list[str], rows: Cells, words: Collection[str]) -> Cells:
    """Rows with points for decimal commas; raises BadInput where a comma may be none, with the mend as a command."""
    is_word = [name in words for name in header]
    numbers = [cell for row in rows for cell, word in zip(row, is_word, strict=False) if not word]
    commas = [cell for cell in numbers if with_point(cell) != cell]
    pointed = [cell for cell in numbers if POINT.fullmatch(cell)]
    are_thousands = mark != ";" and all(THOUSANDS.fullmatch(cell) for cell in commas)
    if commas and (pointed or are_thousands):
        hold = f"hold {commas[0]}" + (f" and {pointed[0]}" if pointed else "")
        problem = f"{hold}: the comma may stand before decimals or part thousands"
        target = path.with_name(f"{path.stem}-points.csv")
        command = f"tr ',{MARKS[mark]}' '.,' < {shlex.quote(str(path))} > {shlex.quote(str(target))}"
        mend = f"if it stands before decimals, ask the file that the command below makes; else take it out\n  {command}"
        raise BadInput(path, "columns", problem, mend)
    places = range(len(header))
    return [
        [with_point(cell) if place in places and not is_word[place] else cell for place, cell in enumerate(row)]
        for row in rows
    ]
