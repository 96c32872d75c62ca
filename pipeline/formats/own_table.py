"""The table of a run folder's own recording, Parquet or text; `import_run` reads all other formats."""

from collections.abc import Iterator
from pathlib import Path

import pandas as pd

from ..ground.input.text_file import TextFile
from .parquet import parquet_pieces, read_parquet
from .text import read_text, text_pieces


def read_table(path: Path, layout: TextFile) -> pd.DataFrame:
    """Raw table of a recording, Parquet or text by its name, as it stands in the file; raises BadInput."""
    return read_parquet(path) if path.suffix.lower() == ".parquet" else read_text(path, layout)


def table_pieces(path: Path, layout: TextFile) -> Iterator[pd.DataFrame]:
    """The table of `read_table` in pieces of some rows, at least one; raises BadInput as it does."""
    return parquet_pieces(path) if path.suffix.lower() == ".parquet" else text_pieces(path, layout)
