"""A recording's file, text, MATLAB or Parquet, as the raw table that it holds."""

import warnings
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import scipy.io

from pipeline import seal
from pipeline.errors import BadInput
from pipeline.regular_file import open_regular
from pipeline.text_file import TextFile
from pipeline.text_table import read_text

MOST_VALUES = 2_000_000_000  # of a Parquet file: some bytes of it can stand for any number of rows


def read_matlab(path: Path) -> pd.DataFrame:
    """Vectors of a MATLAB file, those as long as its longest, one column each under the variable's name.

    Raises BadInput for a file that is not MATLAB's, is of its version 7.3, or holds no vector of numbers.
    """
    try:
        with open_regular(path) as file, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            variables = scipy.io.loadmat(file)
    except NotImplementedError:
        mend = "save it again in MATLAB with save(..., '-v7')"
        raise BadInput(path, "file", "is of MATLAB's version 7.3 (HDF5), which is not read", mend) from None
    except BadInput:
        raise
    except Exception as error:  # scipy's reader raises whatever a damaged byte leads it to
        said = f"{type(error).__name__}: {str(error)[:100]}"
        raise BadInput(path, "file", f"is not a MATLAB file ({said})", "copy it again") from None
    arrays = {name: np.asarray(value) for name, value in variables.items() if not name.startswith("__")}
    vectors = {
        name: value.ravel() for name, value in arrays.items() if value.dtype.kind in "fiu" and value.size in value.shape
    }
    longest = max((value.size for value in vectors.values()), default=0)
    if longest < 2:
        structs = [name for name, value in arrays.items() if value.dtype.names]
        found = f"; {structs[0]!r} is a struct" if structs else ""
        raise BadInput(path, "file", f"holds no vector of numbers{found}", "save each channel as a vector of its own")
    return pd.DataFrame({name: value for name, value in vectors.items() if value.size == longest})


def read_parquet(path: Path) -> pd.DataFrame:
    """Columns of a Parquet file, an index like any other; raises BadInput when it is damaged or too large.

    A file that carries our seal, as an imported run's does, must be what was sealed; a foreign one carries none.
    """
    try:
        with open_regular(path) as file:
            if seal.is_sealed(content := seal.content_of(path)):
                seal.check_parquet(content)
            parquet = pq.ParquetFile(file)
            rows, columns = parquet.metadata.num_rows, parquet.metadata.num_columns
            if not 0 <= rows * columns <= MOST_VALUES:
                problem = f"says that it holds {rows} rows of {columns} columns"
                raise BadInput(path, "file", problem, "cut it into runs of a day or less")
            return parquet.read().to_pandas(ignore_metadata=True)
    except seal.Damaged as error:
        mend = "copy it again from where it was made, or import the recording again"
        raise BadInput(path, "file", f"is damaged: {error}", mend) from None
    except (pa.ArrowException, OSError, ValueError, OverflowError, MemoryError):
        mend = "copy it again; a Parquet file whose writer was killed cannot be read"
        raise BadInput(path, "file", "is not a readable Parquet file", mend) from None


def read_table(path: Path, layout: TextFile) -> pd.DataFrame:
    """Raw table of a recording, text, MATLAB or Parquet, as it stands in the file; raises BadInput."""
    if path.suffix.lower() == ".mat":
        return read_matlab(path)
    return read_parquet(path) if path.suffix.lower() == ".parquet" else read_text(path, layout)
