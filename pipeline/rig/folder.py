"""Folders of synthetic runs that are either whole or not there."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pandas as pd
import yaml

from pipeline import schemas
from pipeline.errors import BadInput
from pipeline.files import write_text
from pipeline.run_yaml import parse_run


@contextmanager
def whole_folder(folder: Path) -> Iterator[Path]:
    """Yield a folder beside `folder`; on success rename it to `folder`, on failure remove it.

    Raises BadInput when `folder` is there already or cannot be made.
    """
    folder = folder.resolve()
    if folder.exists():
        raise BadInput(folder, "--out", "is there already", "choose another; recordings are never overwritten")
    temporary = folder.with_name(f".{folder.name}.{os.getpid()}")
    try:
        try:
            temporary.mkdir(parents=True)
        except OSError as error:
            raise BadInput(folder.parent, "--out", f"cannot be written ({error})", "choose another folder") from None
        yield temporary
        os.rename(temporary, folder)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def write_run(content: dict[str, Any], samples: pd.DataFrame, folder: Path) -> None:
    """Write run.yaml and recording.parquet; raises BadInput when run.yaml could not be read again."""
    parse_run(content, (folder / "run.yaml").resolve())
    schemas.write(samples, schemas.samples(list(samples.columns)), folder / "recording.parquet")
    write_text(folder / "run.yaml", yaml.safe_dump(content, sort_keys=False))
