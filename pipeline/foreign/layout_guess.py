"""The form of a text file or a workbook, guessed from its first rows: its delimiter, and the lines above its table."""

import codecs
import gzip
from dataclasses import dataclass, field
from pathlib import Path

from ..formats import format_of, workbook
from ..formats.text_layout import DECIMAL_COMMA, cells
from ..formats.unpacked import GZIP
from ..ground.errors import BadInput
from ..ground.input.text_file import TextFile
from ..ground.stored.regular_file import open_regular
from .number_rows import Rows, names_at, names_told, of_recording, places_of_numbers, share, units_in

LOOK_BYTES, LOOK_ROWS = 1_000_000, 300
DELIMITERS = ("\t", ";", "|", ",", " ")  # the first that parts most rows
REMARKS = ("%", "#", "//", "!", "*", "'")
BY_HAND = "check that it is the recording; if it is, write the mapping by hand (docs/import.md)"


@dataclass(frozen=True)
class Guessed:
    """How a file is written, and the cells of the row of units under its names, where it has one.

    `behind` are names that a mapping cannot point at, since they stand in a remark.
    """

    layout: TextFile
    units: list[str] = field(default_factory=list)
    behind: list[str] = field(default_factory=list)


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


def _above(rows: Rows, places: set[int]) -> tuple[int, bool, int, list[str]]:
    """`skip`, `header`, `skip_below` and the cells of the row of units, from the rows above the numbers."""
    first = next((index for index, (_, row) in enumerate(rows) if of_recording(row, places)), None)
    if first is None:
        return 0, True, 0, []
    top = names_at(rows, first)
    if top is None:
        return (rows[first][0] if first else 0), False, 0, []
    return (rows[top][0] if top else 0), True, first - top - 1, units_in(rows[top + 1 : first])


def _without_ends(parted: Rows, first: int) -> Rows:
    """The rows without empty cells at their ends, where rows of numbers have such cells and the names above do not."""
    over = len(parted[first][1]) - len(parted[first - 1][1]) if first > 0 else 0
    if over <= 0 or any(parted[first][1][-over:]):
        return parted
    rows = ((number, row if any(row[-over:]) else row[:-over]) for number, row in parted[first:])
    return [*parted[:first], *rows]


def _parted(path: Path, numbered: list[tuple[int, str]]) -> tuple[str, Rows, set[int]]:
    """The delimiter that leaves most rows of numbers, the rows, and where their numbers stand; raises BadInput."""
    best: tuple[float, str, Rows, set[int]] = (0.0, ",", [], set())
    for sign in DELIMITERS:
        rows: Rows = [(number, cells(line, sign)) for number, line in numbered]
        places = places_of_numbers(rows)
        score = sum(share(row) for _, row in rows if of_recording(row, places))
        best = (score, sign, rows, places) if score > best[0] else best
    if not best[3]:
        problem = f"has no row of two numbers or more in its first {LOOK_ROWS} lines, whatever parts them"
        raise BadInput(path, "file", problem, BY_HAND)
    return best[1:]


def _refuse_two_commas(path: Path, delimiter: str, rows: Rows, first: int) -> None:
    """Raise BadInput where commas part numbers that have decimal commas."""
    quoted = any(isinstance(cell, str) and DECIMAL_COMMA.fullmatch(cell) for cell in rows[first][1])
    twice = first > 0 and len(rows[first][1]) == 2 * len(rows[first - 1][1])
    if delimiter == "," and (quoted or (twice and names_told(rows[first - 1][1]))):
        mend = "save it again with semicolons or tabs between the numbers, or with decimal points"
        raise BadInput(path, "file.delimiter", "is a comma, and so is the decimal sign", mend)


def _of_text(path: Path) -> Guessed:
    lines, encoding = _decoded(path)
    numbered = [(number, line) for number, line in enumerate(lines[:LOOK_ROWS]) if line.strip()]
    delimiter, parted, places = _parted(path, numbered)
    first = next((index for index, (_, row) in enumerate(parted) if of_recording(row, places)), 0)
    _refuse_two_commas(path, delimiter, parted, first)
    parted = _without_ends(parted, first)
    remarks = [line.lstrip() for _, line in numbered if line.lstrip().startswith(REMARKS)]
    comment = next((sign for sign in REMARKS if remarks and remarks[0].startswith(sign)), None)
    named = first > 0 and len(parted[first - 1][1]) == len(parted[first][1])
    behind = _behind(numbered[first - 1][1], comment, delimiter, len(parted[first][1])) if first > 0 else []
    if comment and named and numbered[first - 1][1].lstrip().startswith(comment):
        comment = None  # the names themselves stand behind that sign
    elif comment:
        parted = [row for row, (_, line) in zip(parted, numbered, strict=True) if not line.lstrip().startswith(comment)]
    skip, header, below, units = _above(parted, places)
    numbers = [cell for _, row in parted if of_recording(row, places) for cell in row]
    comma = delimiter != "," and any(DECIMAL_COMMA.fullmatch(cell) for cell in numbers)
    settings: dict[str, object] = {
        "delimiter": delimiter,
        "decimal": "," if comma else ".",
        "header": header,
        "skip": skip,
    }
    settings |= {"skip_below": below, "comment": comment, "encoding": encoding}
    return Guessed(TextFile.model_validate(settings), units, [] if header else behind)


def _behind(line: str, comment: str | None, delimiter: str, width: int) -> list[str]:
    """The names of that many columns in a line after a remark's sign; else nothing."""
    remark = line.lstrip()
    if not comment or not remark.startswith(comment):
        return []
    names = [name for name in cells(remark.lstrip(comment).strip(), delimiter) if name]
    return names if len(names) == width and len(set(names)) == width and names_told(names) else []


def _of_workbook(path: Path) -> Guessed:
    sheets = workbook.first_rows(path, LOOK_ROWS)
    places = {title: places_of_numbers(rows) for title, rows in sheets.items()}
    title = next((title for title in sheets if places[title]), None)
    skip, header, below, units = _above(sheets[title], places[title]) if title else (0, True, 0, [])
    sheet = title if len(sheets) > 1 else None
    settings: dict[str, object] = {"header": header, "skip": skip, "skip_below": below, "sheet": sheet}
    return Guessed(TextFile.model_validate(settings), units)


def guess_layout(path: Path) -> Guessed:
    """How a file is written, as far as its first rows tell; raises BadInput for what is no file."""
    kind = format_of(path)
    if ".csv" in kind.suffixes:
        return _of_text(path)
    return _of_workbook(path) if "sheet" in kind.keys else Guessed(TextFile.model_validate({}))
