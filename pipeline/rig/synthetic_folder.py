"""Folders of synthetic runs that are either whole or not there."""

from contextlib import AbstractContextManager
from pathlib import Path

import pandas as pd
import yaml

from ..ground.stored import schemas
from ..ground.stored.files import write_text
from ..ground.stored.whole_folder import whole_folder
from ..run.description import parse_run
from ..run.run_yaml import RunYaml


def whole_recordings(folder: Path) -> AbstractContextManager[Path]:
    """A folder of recordings, whole or not at all; raises BadInput as `whole_folder` does."""
    return whole_folder(folder.resolve(), "--out", "choose another; recordings are never overwritten")


def write_run(content: RunYaml, samples: pd.DataFrame, folder: Path) -> None:
    """Write run.yaml and recording.parquet; raises BadInput when run.yaml could not be read again."""
    parse_run(content, (folder / "run.yaml").resolve())
    schemas.write(samples, schemas.samples(list(samples.columns)), folder / "recording.parquet")
    write_text(folder / "run.yaml", yaml.safe_dump(content, sort_keys=False))
