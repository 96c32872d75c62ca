"""The table of a run folder's own recording, which is Parquet or text; what else there is, `import_run` reads."""

from pathlib import Path

import pandas as pd

from ..ground.text_file import TextFile
from .parquet import read_parquet
from .text import read_text


def read_table(path: Path, layout: TextFile) -> pd.DataFrame:
    """Raw table of a recording, Parquet or text by its name, as it stands in the file; raises BadInput."""
    return read_parquet(path) if path.suffix.lower() == ".parquet" else read_text(path, layout)
