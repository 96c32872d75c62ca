"""A table of numbers that may be longer than memory: held, or stored as Parquet and read by row groups."""

import weakref
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np
import pandas as pd

from ..kinematics import Array, Places
from ..numbers import quantiles
from . import schemas


class Rows(ABC):
    """Columns of numbers of one length, each of shape (rows,) and in the unit that its name ends in.

    What is asked of a whole column is told from piece after piece.
    """

    columns: list[str]
    borders: list[int]  # of the pieces in which it is read, from 0 to its length

    def __len__(self) -> int:
        """How many rows there are."""
        return self.borders[-1]

    @abstractmethod
    def read(self, name: str, first: int, stop: int) -> Array:
        """A column in its unit from row `first` until row `stop`, which is left out; shape (stop - first,)."""

    @property
    def spans(self) -> list[tuple[int, int]]:
        """First row of each piece, and the first after it."""
        return list(pairwise(self.borders))

    def pieces(self, name: str) -> Iterator[Array]:
        """A column in its unit, piece by piece, each of shape (rows of the piece,)."""
        return (self.read(name, *span) for span in self.spans)

    def frame(self, first: int, stop: int, names: Sequence[str] | None = None) -> pd.DataFrame:
        """Some rows and columns as a table; its index counts from 0."""
        return pd.DataFrame({name: self.read(name, first, stop) for name in names or self.columns})

    def percentiles(self, name: str, q: Sequence[float]) -> Array:
        """Percentiles `q` of a column of finite numbers; shape (q,), in the column's unit."""
        return quantiles.percentiles(partial(self.pieces, name), len(self), q)

    def median(self, name: str) -> float:
        """Median of a column of finite numbers."""
        return quantiles.median(partial(self.pieces, name), len(self))

    def extremes(self, name: str) -> tuple[float, float]:
        """Least and greatest number of a column."""
        ends = np.array([(piece.min(), piece.max()) for piece in self.pieces(name)])
        return float(ends[:, 0].min()), float(ends[:, 1].max())

    def correlation(self, *names: str) -> float:
        """Coefficient of correlation of two columns of finite numbers."""
        means = [sum(float(piece.sum()) for piece in self.pieces(name)) / len(self) for name in names]
        products = np.zeros((2, 2))
        for span in self.spans:
            off = np.array([self.read(name, *span) - mean for name, mean in zip(names, means, strict=True)])
            products += off @ off.T
        with np.errstate(invalid="ignore"):
            return float(products[0, 1] / np.sqrt(products[0, 0] * products[1, 1]))

    def at(self, name: str, places: Places) -> Array:
        """Values of a column in some rows, in any order; shape (places,)."""
        values = np.empty(len(places))
        by_piece = np.searchsorted(self.borders, places, side="right") - 1
        for piece in np.unique(by_piece).tolist():
            in_piece = by_piece == piece
            values[in_piece] = self.read(name, *self.spans[piece])[places[in_piece] - self.borders[piece]]
        return values


class Held(Rows):
    """Rows of a table in memory."""

    def __init__(self, table: pd.DataFrame) -> None:
        self._values = {str(name): table[name].to_numpy() for name in table.columns}
        self.columns = list(self._values)
        self.borders = [*range(0, len(table), schemas.ROW_GROUP), len(table)]

    def read(self, name: str, first: int, stop: int) -> Array:
        """A column in its unit from row `first` until row `stop`, which is left out; shape (stop - first,)."""
        return self._values[name][first:stop]


class Stored(Rows):
    """Rows of a file that `schemas.write` made; the last two row groups of each column stay in memory.

    Raises BadInput or Refused as `schemas.read` does.
    """

    def __init__(self, path: Path | str) -> None:
        self._file = schemas.opened(path)
        weakref.finalize(self, self._file.close, True)
        data = self._file.metadata
        self.columns = list(self._file.schema_arrow.names)
        lengths = [data.row_group(group).num_rows for group in range(data.num_row_groups)]
        self.borders = [0, *np.cumsum([length for length in lengths if length]).tolist()]
        self._groups = [group for group, length in enumerate(lengths) if length]
        self._kept: dict[str, dict[int, Array]] = {name: {} for name in self.columns}

    def _piece(self, name: str, piece: int) -> Array:
        kept = self._kept[name]
        if piece not in kept:
            if len(kept) > 1:
                del kept[next(iter(kept))]
            kept[piece] = self._file.read_row_group(self._groups[piece], [name]).column(0).to_numpy()
        return kept[piece]

    def read(self, name: str, first: int, stop: int) -> Array:
        """A column in its unit from row `first` until row `stop`, which is left out; shape (stop - first,)."""
        if first >= stop:
            return np.zeros(0)
        first_piece, last_piece = (
            int(np.searchsorted(self.borders, row, side="right")) - 1 for row in (first, stop - 1)
        )
        parts = []
        for piece in range(first_piece, last_piece + 1):
            begin = self.borders[piece]
            parts.append(self._piece(name, piece)[max(first - begin, 0) : stop - begin])
        return parts[0] if len(parts) == 1 else np.concatenate(parts)


def rows_of(table: pd.DataFrame | Rows) -> Rows:
    """A table in memory, or one on disk, as rows."""
    return Held(table) if isinstance(table, pd.DataFrame) else table


def opened(path: Path | str) -> pd.DataFrame | Rows:
    """The table of a file that `schemas.write` made: held if short, else read by row groups; raises like it."""
    rows = Stored(path)
    return rows if len(rows) > schemas.ROW_GROUP else rows.frame(0, len(rows))
