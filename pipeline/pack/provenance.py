"""Where Snakemake notes how it made a file: by that it knows the file again, in another folder as in its own.

The place is that of Snakemake's `persistence/file.py`: the file's name in base64, cut where it is too long for a name.
"""

import os
from base64 import urlsafe_b64encode
from pathlib import Path

NOTES = Path(".snakemake", "metadata")
LONGEST = 255


def note_of(root: Path, product: str) -> Path:
    """The file, below the project's folder, in which Snakemake notes how it made a file or folder of it."""
    try:
        longest = os.pathconf(root, "PC_NAME_MAX") or LONGEST
    except (OSError, ValueError):
        longest = LONGEST
    name = urlsafe_b64encode(product.encode()).decode()
    parts = [name[at : at + longest - 1] for at in range(0, len(name), longest - 1)]
    return root.joinpath(NOTES, *(f"@{part}" for part in parts[:-1]), parts[-1])
