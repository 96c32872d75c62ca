"""What the import will do about cells of a foreign file that are no numbers, said when its mapping is drafted."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from ..ground.complaint import key_name
from ..ground.counts import counted
from ..ground.kinematics import Array
from ..ground.text_file import TextFile
from ..run.no_number import are_few, named


def damaged_rows(path: Path, layout: TextFile, by_column: Mapping[str | int, Array], even: bool) -> list[str]:
    """Sentences on the rows that lack a number in a column of numbers, or in one that has too many of them.

    `by_column` has the columns, each of shape (rows,) and in its own unit. `even`: lines with more fields than the
    first are no rows.
    """
    wrong = {column: ~np.isfinite(values) for column, values in by_column.items()}
    if len({len(rows) for rows in wrong.values()}) != 1:  # of several lengths: they are not rows of one table
        return []
    first = (layout.rows or (0, 0))[0]
    few = [rows for rows in wrong.values() if are_few(int(rows.sum()), len(rows))]
    damaged = np.flatnonzero(np.logical_or.reduce(few)) if few else np.zeros(0, np.intp)
    sentences = []
    if len(damaged):
        which = named(path, layout, [first + int(row) for row in damaged], even)
        sentences.append(f"{counted(len(damaged), 'damaged row')}, which the import leaves out: {which}")
    for column, rows in wrong.items():
        count = int(rows.sum())
        if count and not are_few(count, len(rows)):
            which = named(path, layout, [first + int(np.argmax(rows))], even)
            cells = f"{key_name(column)} has no number in {count} of {counted(len(rows), 'row')}, first in {which}"
            sentences.append(f"{cells}. As a channel it will be refused: correct or remove these rows")
    return sentences
