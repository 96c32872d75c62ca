"""A recording that is read before its run is planned: samples and strokes are kept until ingest takes them over.

So a new recording is decoded once. What is kept is bound to the recording's content and to the code that read it.
"""

import contextlib
import io
import shutil
import sys
from pathlib import Path

import pandas as pd

from ..ground.errors import BadInput
from ..ground.stored import schemas
from ..ground.stored.files import whole, write_text
from ..ground.stored.rows import Stored
from .description import Run
from .folder import read_run
from .samples import stored_strokes

SAMPLES, STROKES, WARNINGS, READ_OF = "samples.parquet", "strokes.parquet", "warnings.txt", "read_of.txt"


def keep(run_dir: Path, place: Path, bound_to: str) -> None:
    """Read a run as ingest does and keep what it gives in a folder of its name in `place`; raises BadInput.

    `bound_to` has a digest of the run's files and one of the code that reads them.
    """
    kept = place / run_dir.name
    forget(run_dir, place)
    try:
        with whole(kept / SAMPLES) as temporary, contextlib.redirect_stderr(io.StringIO()) as warnings:
            _, _, strokes = stored_strokes(run_dir, temporary)
        schemas.write(strokes, schemas.STROKES, kept / STROKES)
        write_text(kept / WARNINGS, warnings.getvalue())
        write_text(kept / READ_OF, bound_to)  # the last: without it nothing is kept
    except BaseException:
        forget(run_dir, place)
        raise


def taken_over(run_dir: Path, place: Path, bound_to: str, temporary: Path) -> tuple[Run, Stored, pd.DataFrame] | None:
    """The kept result of `stored_strokes`, if it is complete and of this reading; else None."""
    kept = place / run_dir.name
    try:
        if (kept / READ_OF).read_text(encoding="utf-8") != bound_to:
            return None
        shutil.copyfile(kept / SAMPLES, temporary)
        samples, strokes = Stored(temporary), schemas.read(kept / STROKES, schemas.STROKES)
        warnings = (kept / WARNINGS).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError, BadInput):
        return None
    sys.stderr.write(warnings)
    return read_run(run_dir), samples, strokes


def forget(run_dir: Path, place: Path) -> None:
    """Remove the kept reading of a run that ingest has taken over or a newer reading replaces."""
    shutil.rmtree(place / run_dir.name, ignore_errors=True)
