"""Modules of a folder that are found by being there."""

import re
from pathlib import Path


def holding(folder: Path, line: str) -> tuple[str, ...]:
    """Names, sorted, of the modules of a folder that have a line which begins so, a regular expression.

    Their text is read and they are not imported: some of them take seconds.
    """
    files = (path for path in folder.glob("*.py") if path.stem.isidentifier())
    return tuple(sorted(path.stem for path in files if re.search(f"^{line}", path.read_text("utf-8"), re.M)))
