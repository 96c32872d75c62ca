"""How a text file or a workbook is written, guessed from its first rows: what parts them, what stands above them."""

import codecs
import gzip
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..formats import format_of, workbook
from ..formats.text_layout import DECIMAL_COMMA, NUMBER, cells
from ..formats.time_stamps import is_stamp
from ..formats.unpacked import GZIP
from ..ground.regular_file import open_regular
from ..ground.text_file import TextFile

LOOK_BYTES, LOOK_ROWS, MOST_ABOVE = 1_000_000, 300, 5
DELIMITERS = ("\t", ";", "|", ",", " ")  # the first that parts most rows
REMARKS = ("%", "#", "//", "!", "*", "'")
Rows = list[tuple[int, list[Any]]]  # the cells of each row that has some, after its number in the file


@dataclass(frozen=True)
class Guessed:
    """How a file is written, and the cells of the row of units under its names, where it has one."""

    layout: TextFile
    units: list[str] = field(default_factory=list)


def _decoded(path: Path) -> tuple[list[str], str]:
    """The first lines of a text, and its encoding; raises BadInput for what is no file."""
    with open_regular(path) as file:
        zipped = file.read(2) == GZIP
        file.seek(0)
        start = (gzip.GzipFile(fileobj=file) if zipped else file).read(LOOK_BYTES)
    if start.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return start.decode("utf-16", "replace").splitlines(), "utf-16"
    whole = start if len(start) < LOOK_BYTES else start[: start.rfind(b"\n") + 1]
    for encoding in ("utf-8", "cp1252"):
        try:
            return whole.decode(encoding).removeprefix("\ufeff").splitlines(), encoding
        except UnicodeDecodeError:
            continue
    return whole.decode("latin1").splitlines(), "latin1"


def _is_number(cell: Any) -> bool:
    return bool(NUMBER.fullmatch(cell)) or is_stamp(cell) if isinstance(cell, str) else cell is not None


def _of_numbers(row: list[Any]) -> bool:
    """Whether a row has two cells or more, most of them numbers and the others empty."""
    full = [cell for cell in row if cell not in ("", None)]
    return len(full) > 1 and all(map(_is_number, full)) and 2 * len(full) > len(row)


def _above(rows: Rows) -> tuple[int, bool, int, list[str]]:
    """`skip`, `header`, `skip_below` and the cells of the last row above the numbers, which may be units."""
    first = next((index for index, (_, row) in enumerate(rows) if _of_numbers(row)), None)
    if first is None:
        return 0, True, 0, []
    width, top = len(rows[first][1]), first
    while top > 0 and first - top < MOST_ABOVE and len(rows[top - 1][1]) == width:
        top -= 1
    if top == first:
        return (rows[first][0] if first else 0), False, 0, []
    last = [str(cell) for cell in rows[first - 1][1]] if first - top > 1 else []
    return (rows[top][0] if top else 0), True, first - top - 1, last


def _without_ends(parted: Rows, first: int) -> Rows:
    """The rows without the empty cells at their ends where the rows of numbers have those, and the names above not."""
    over = len(parted[first][1]) - len(parted[first - 1][1]) if first > 0 else 0
    if over <= 0 or any(parted[first][1][-over:]):
        return parted
    rows = ((number, row if any(row[-over:]) else row[:-over]) for number, row in parted[first:])
    return [*parted[:first], *rows]


def _of_text(path: Path) -> Guessed:
    lines, encoding = _decoded(path)
    numbered = [(number, line) for number, line in enumerate(lines[:LOOK_ROWS]) if line.strip()]
    scores = {sign: sum(_of_numbers(cells(line, sign)) for _, line in numbered) for sign in DELIMITERS}
    delimiter = max(DELIMITERS, key=lambda sign: (scores[sign], -DELIMITERS.index(sign)))
    parted = [(number, cells(line, delimiter)) for number, line in numbered]
    first = next((index for index, (_, row) in enumerate(parted) if _of_numbers(row)), 0)
    parted = _without_ends(parted, first)
    remarks = [line.lstrip() for _, line in numbered if line.lstrip().startswith(REMARKS)]
    comment = next((sign for sign in REMARKS if remarks and remarks[0].startswith(sign)), None)
    named = first > 0 and len(parted[first - 1][1]) == len(parted[first][1])
    if comment and named and numbered[first - 1][1].lstrip().startswith(comment):
        comment = None  # the names themselves stand behind that sign
    elif comment:
        parted = [row for row, (_, line) in zip(parted, numbered, strict=True) if not line.lstrip().startswith(comment)]
    skip, header, below, units = _above(parted)
    numbers = [cell for _, row in parted if _of_numbers(row) for cell in row]
    comma = delimiter != "," and any(DECIMAL_COMMA.fullmatch(cell) for cell in numbers)
    settings: dict[str, object] = {
        "delimiter": delimiter,
        "decimal": "," if comma else ".",
        "header": header,
        "skip": skip,
    }
    settings |= {"skip_below": below, "comment": comment, "encoding": encoding}
    return Guessed(TextFile.model_validate(settings), units)


def _of_workbook(path: Path) -> Guessed:
    sheets = workbook.first_rows(path, LOOK_ROWS)
    title = next((title for title, rows in sheets.items() if any(_of_numbers(row) for _, row in rows)), None)
    skip, header, below, units = _above(sheets[title]) if title else (0, True, 0, [])
    sheet = title if len(sheets) > 1 else None
    settings: dict[str, object] = {"header": header, "skip": skip, "skip_below": below, "sheet": sheet}
    return Guessed(TextFile.model_validate(settings), units)


def guess_layout(path: Path) -> Guessed:
    """How a file is written, as far as its first rows tell; raises BadInput for what is no file."""
    kind = format_of(path)
    if ".csv" in kind.suffixes:
        return _of_text(path)
    return _of_workbook(path) if "sheet" in kind.keys else Guessed(TextFile.model_validate({}))
