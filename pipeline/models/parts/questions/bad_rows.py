"""Rows of a file of questions that cannot be answered: all are named at once, and the others are answered."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ....ground.errors import BadInput, bounded
from ....ground.input.index_labels import by_index, row_label
from ....ground.words.counts import are, consecutive, counted

SHOWN = 10  # stretches of rows that are named; of the others it is said how many they are
PRINTED = 5  # reasons that are printed; the file has all
NO_QUESTION = "no question: "  # how the reason of a row begins that asks nothing that can be answered


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
    return f"{NO_QUESTION}{entry.column} {entry.what}{entry.instead}; {entry.mend}".replace(":  ", ": ")


class BadRows(BadInput):
    """Rows that cannot be answered: the text has a line for each, after the first line."""

    def __init__(self, path: Path, problem: str, mend: str, lines: Sequence[str]) -> None:
        super().__init__(path, "rows", problem, mend)
        self.args = ("\n".join([str(self), *(bounded(f"  {line}") for line in lines)]),)


def refusal(
    path: Path, bad: Sequence[BadRow], answered: int, answers: Path | None = None, index: pd.Index | None = None
) -> BadInput:  # fmt: skip
    """The complaint that names the bad rows, each once, and says that the others are `answered`, in a file.

    Of several rows each reason has a line. Rows of a table in memory are named by its `index`.
    """
    others = f". The other {counted(answered, 'row')} {are(answered)} answered" if answered else ""
    if len(bad) == 1:
        row, column, what, instead, mend = bad[0]
        where = f"row {row}" if index is None else by_index(index)(row - 1)
        if column:
            return BadInput(path, column, f"{what} in {where}{instead}", f"{mend}{others}")
        return BadInput(path, where, what + instead, f"{mend}{others}")
    sentence_by_row = {entry.row: reason(entry).removeprefix(NO_QUESTION) for entry in bad}
    sentences = [sentence_by_row.get(row, "") for row in range(1, bad[-1].row + 1)]
    where = f", each with its reason in the column `why` of {answers}" if answers else ""
    first = " (row 1 is the first question)" if index is None else ""
    problem = f"{len(bad)} cannot be answered{first}"
    mend = f"each as its line says{others or '. Until then no row is answered'}"
    return BadRows(path, problem, mend, first_of(sentences, where, index))


def first_of(sentences: Sequence[str], where: str, index: pd.Index | None = None) -> list[str]:
    """The first reasons, each once with the numbers of its rows, and `where` the others are; empty ones are left out.

    The sentences are those of all rows in their order; `index` has the labels of rows in memory.
    """
    rows_by_reason: dict[str, list[int]] = {}
    for number, sentence in enumerate(sentences, start=1):
        if sentence:
            rows_by_reason.setdefault(sentence, []).append(number)
    lines = [f"{numbered(rows, index)}: {sentence}" for sentence, rows in list(rows_by_reason.items())[:PRINTED]]
    unshown = sum(map(len, list(rows_by_reason.values())[PRINTED:]))
    return lines + ([f"and {unshown} more{where}"] if unshown else [])


def numbered(rows: Sequence[int], index: pd.Index | None = None) -> str:
    """Rows by number, in rising order: row 3; rows 2, 5; rows 1 to 96; of many stretches the first.

    Rows in memory are named by the labels of their `index`: the rows of index 2, 5.
    """
    stretches = consecutive(rows)
    texts = [
        f"{_label(stretch[0], index)} to {_label(stretch[-1], index)}"
        if len(stretch) > 2
        else ", ".join(_label(row, index) for row in stretch)
        for stretch in stretches
    ]
    unshown = sum(map(len, stretches[SHOWN:]))
    more = f" and {unshown} more" if unshown else ""
    noun = f"row{'s' * (len(rows) > 1)}"
    if index is not None:
        noun = f"the {noun} of{' index' * index.is_unique}"
    return f"{noun} {', '.join(texts[:SHOWN])}{more}"


def _label(row: int, index: pd.Index | None) -> str:
    return str(row) if index is None else row_label(index, row - 1)
