"""A Parquet file, ours or foreign, as a table."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain
from pathlib import Path

import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from ..ground.errors import BadInput
from ..ground.input.text_file import TextFile
from ..ground.stored import schemas, seal
from ..ground.stored.regular_file import open_regular
from .interface import Format

BUFFER_BYTES = 1 << 20  # of each column that are read at once
MOST_VALUES = 2_000_000_000  # some bytes of a file can stand for any number of rows


@contextmanager
def _opened(path: Path) -> Iterator[pq.ParquetFile]:
    """A Parquet file for reading; raises BadInput when it is damaged or too large, or turns out to be in reading."""
    try:
        with open_regular(path) as file:
            if seal.is_sealed(file):
                seal.check_parquet_file(file)
            file.seek(0)
            parquet = pq.ParquetFile(file, buffer_size=BUFFER_BYTES, pre_buffer=False)
            rows, columns = parquet.metadata.num_rows, parquet.metadata.num_columns
            if not 0 <= rows * columns <= MOST_VALUES:
                problem = f"says that it holds {rows} rows of {columns} columns"
                raise BadInput(path, "file", problem, "cut it into runs of a day or less")
            yield parquet
    except seal.Damaged as error:
        mend = "copy it again from where it was made, or import the recording again"
        raise BadInput(path, "file", f"is damaged: {error}", mend) from None
    except (pa.ArrowException, OSError, ValueError, OverflowError, MemoryError):
        mend = "copy it again; a Parquet file whose writer was killed cannot be read"
        raise BadInput(path, "file", "is not a readable Parquet file", mend) from None


def read_parquet(path: Path, _: TextFile | None = None) -> pd.DataFrame:
    """Columns of a Parquet file, an index like any other; raises BadInput when it is damaged or too large.

    A file that carries our seal, as an imported run's does, must be what was sealed; a foreign one carries none.
    """
    with _opened(path) as parquet:
        table = parquet.read().to_pandas(ignore_metadata=True)
    pa.default_memory_pool().release_unused()  # else the allocator keeps as much as the table holds
    return table


def parquet_pieces(path: Path) -> Iterator[pd.DataFrame]:
    """What `read_parquet` gives, in pieces of some rows, at least one; raises BadInput as it does."""
    with _opened(path) as parquet:
        batches = parquet.iter_batches(schemas.ROW_GROUP)
        empty = pa.RecordBatch.from_pylist([], parquet.schema_arrow)
        for batch in chain([next(batches, empty)], batches):
            yield pa.Table.from_batches([batch]).to_pandas(ignore_metadata=True)


FORMAT = Format("a Parquet file", (".parquet",), (b"PAR1",), frozenset(), read_parquet)
