"""Tables named on a command line: read, or refused in one line that says what to do."""

from pathlib import Path

import pandas as pd
import pyarrow as pa

from ..errors import BadInput
from . import schemas, seal


def opened(path: Path, schema: pa.Schema, mend: str) -> pd.DataFrame:
    """A Parquet table under its schema; raises BadInput for no Parquet file, another table, or one without rows."""
    try:
        if not bytes(seal.content_of(path)[:4]) == b"PAR1":
            raise BadInput(path, "file", "is no Parquet table", mend)
        table = schemas.read(path, schema)
    except OSError as error:
        reason = "is missing" if not path.exists() else f"cannot be read ({error})"
        raise BadInput(path, "file", reason, mend) from None
    if table.empty:
        raise BadInput(path, "file", "has no rows", mend)
    return table
