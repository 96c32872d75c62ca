"""What the dataset's stage noted of jumps of the zero that nobody confirmed, for all that use its points."""

import json
from collections.abc import Sequence
from pathlib import Path

from pipeline.errors import BadInput


def read_jumps(files: Sequence[Path]) -> list[str]:
    """What such files say, one sentence a jump; a file that is not there says nothing. Raises BadInput."""
    found: list[str] = []
    for path in files:
        try:
            said = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else []
        except (ValueError, RecursionError):
            said = None
        if not isinstance(said, list) or not all(isinstance(one, str) for one in said):
            raise BadInput(path, "JSON", "is not what the dataset's stage writes", "delete it and run snakemake again")
        found += said
    return found
