"""The place of a job's files on a machine without a shared file system: a copy of a part of the storage."""

from pathlib import Path
from typing import Any
from urllib.parse import urlparse


def copy_of_storage(settings: Any) -> str:
    """The local folder for the root of Snakemake's default storage; empty where there is none.

    Rules name `raw/`, `processed/` and `reports/`, so commands start there. Raises ValueError for a relative folder.
    """
    if not settings.default_storage_provider:
        return ""
    place = Path(settings.local_storage_prefix)
    if not place.is_absolute():
        raise ValueError(
            f"--local-storage-prefix: {place} is relative; name a folder by its whole path, as in env/slurm-unshared"
        )
    parsed = urlparse(str(settings.default_storage_prefix))
    return str(place / settings.default_storage_provider / f"{parsed.netloc}{parsed.path}".strip("/"))
