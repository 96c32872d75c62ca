"""The remark on cells of a foreign file that are no numbers: how the import will treat them."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from ..ground.input.complaint import key_name
from ..ground.input.text_file import TextFile
from ..ground.kinematics import Array
from ..ground.words.counts import counted
from ..run.table.file_lines import line_or_row, named
from ..run.table.no_number import are_few


def damaged_rows(path: Path, layout: TextFile, by_column: Mapping[str | int, Array]) -> list[str]:
    """Sentences on rows without a number in a column of numbers, or on a column with too many such rows.

    `by_column` has the columns, each of shape (rows,) and in its own unit.
    """
    wrong = {column: ~np.isfinite(values) for column, values in by_column.items()}
    if len({len(rows) for rows in wrong.values()}) != 1:  # of several lengths: they are not rows of one table
        return []
    what, first = line_or_row(path), (layout.rows or (0, 0))[0]
    few = [rows for rows in wrong.values() if are_few(int(rows.sum()), len(rows))]
    damaged = np.flatnonzero(np.logical_or.reduce(few)) if few else np.zeros(0, np.intp)
    sentences = []
    if len(damaged):
        which = named(path, layout, [first + int(row) for row in damaged])
        sentences.append(f"{counted(len(damaged), f'damaged {what}')}, which the import leaves out: {which}")
    for column, rows in wrong.items():
        count = int(rows.sum())
        if count and not are_few(count, len(rows)):
            which = named(path, layout, [first + int(np.argmax(rows))])
            cells = f"{key_name(column)} has no number in {count} of {counted(len(rows), what)}, first in {which}"
            sentences.append(f"{cells}. The import refuses it so: remove these {what}s first; missing ones are no harm")
    return sentences
