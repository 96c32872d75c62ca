"""Rows of a file of questions that cannot be answered: all are named at once, and the others are answered."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....ground.errors import BadInput
from ....ground.words.counts import are, consecutive, counted

SHOWN = 10  # rows, or stretches of rows, that are named; of the others it is said how many they are


class BadRow(NamedTuple):
    """A fault of a row, and the mend: its `column` (or none) is `what`, and not `instead`."""

    row: int  # 1 stands below the header
    column: str
    what: str
    instead: str
    mend: str


def of_mask(mask: NDArray[np.bool_], column: str, what: Sequence[str] | str, instead: str, mend: str) -> list[BadRow]:
    """A bad row for each True of a mask, of the shape (rows,), without unit; `what` is one for all or one for each."""
    rows = np.flatnonzero(mask)
    texts = [what] * len(rows) if isinstance(what, str) else what
    return [BadRow(int(row) + 1, column, text, instead, mend) for row, text in zip(rows, texts, strict=True)]


def first_of_each(wrong: Sequence[BadRow]) -> list[BadRow]:
    """Each bad row once, with its first fault, in the order of the rows."""
    by_row: dict[int, BadRow] = {}
    for entry in wrong:
        by_row.setdefault(entry.row, entry)
    return [by_row[row] for row in sorted(by_row)]


def reason(entry: BadRow) -> str:
    """The fault of a row, and the mend, in the words of its answer."""
    return f"no question: {entry.column} {entry.what}{entry.instead}; {entry.mend}".replace(":  ", ": ")


def refusal(path: Path, bad: Sequence[BadRow], answered: int) -> BadInput:
    """The complaint that names the bad rows, each once, and says that the others are `answered`."""
    others = f". The other {counted(answered, 'row')} {are(answered)} answered" if answered else ""
    if len(bad) == 1:
        row, column, what, instead, mend = bad[0]
        if column:
            return BadInput(path, column, f"{what} in row {row}{instead}", f"{mend}{others}")
        return BadInput(path, f"row {row}", what + instead, f"{mend}{others}")
    each = [f"row {entry.row}: {entry.column} {entry.what}{entry.instead}".replace(":  ", ": ") for entry in bad]
    more = [f"and {len(bad) - SHOWN} more rows"] if len(bad) > SHOWN + 1 else each[SHOWN:]
    problem = f"{len(bad)} cannot be answered (row 1 is the first question): {'; '.join([*each[:SHOWN], *more])}"
    return BadInput(path, "rows", problem, f"{_mends(bad[:SHOWN])}{others or '. Until then no row is answered'}")


def _mends(bad: Sequence[BadRow]) -> str:
    """Each mend with its rows; without rows where all have the same mend."""
    rows_by_mend: dict[str, list[int]] = {}
    for entry in bad:
        rows_by_mend.setdefault(entry.mend, []).append(entry.row)
    if len(rows_by_mend) == 1:
        return next(iter(rows_by_mend))
    return "; ".join(f"{numbered(rows)}: {mend}" for mend, rows in rows_by_mend.items())


def numbered(rows: Sequence[int]) -> str:
    """Rows by number, in rising order: row 3; rows 2, 5; rows 1 to 96; of many stretches the first."""
    stretches = consecutive(rows)
    texts = [f"{rows[0]} to {rows[-1]}" if len(rows) > 2 else ", ".join(map(str, rows)) for rows in stretches]
    unshown = sum(map(len, stretches[SHOWN:]))
    more = f" and {unshown} more" if unshown else ""
    return f"row{'s' * (len(rows) > 1)} {', '.join(texts[:SHOWN])}{more}"
