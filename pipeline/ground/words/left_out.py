"""A run that was left out, and why: noted by the stage that refuses it, and told by the pages that go on without it."""

import json
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ..command import REMAKE
from ..errors import BadInput
from ..stored import schemas
from ..stored.notes import read_note, write_note

LARGEST = 100_000_000  # bytes of a file of runs that were left out


@dataclass(frozen=True)
class LeftOut:
    """A run, and the fault of one field of a file, with the mend."""

    run: str
    material: str  # empty where nobody can tell
    file: str
    field: str
    problem: str
    mend: str

    @classmethod
    def of(cls, run: str, error: BadInput, material: str = "") -> "LeftOut":
        """The run that an error is about."""
        return cls(run, material, error.file, error.field, error.problem, error.mend)

    @property
    def why(self) -> str:
        """File, field, problem and mend, as every program words them, with printable characters only."""
        sentence = str(BadInput(self.file, self.field, self.problem, self.mend))
        return "".join(sign if sign.isprintable() else repr(sign)[1:-1] for sign in sentence)


def to_json(runs: list[LeftOut]) -> str:
    """Runs as JSON, for a command line."""
    return json.dumps(_values(runs))


def from_json(text: str) -> list[LeftOut]:
    """Runs from such JSON; raises BadInput for anything else."""
    try:
        return _runs(json.loads(text))
    except (ValueError, TypeError, RecursionError):
        raise BadInput("the runs left out", "JSON", "is not what the pipeline writes", REMAKE) from None


def write_left_out(path: Path, runs: list[LeftOut]) -> None:
    """Write runs with a check sum."""
    write_note(path, _values(runs))


def read_left_out(path: Path) -> list[LeftOut]:
    """Runs in such a file; raises BadInput for one that is not what was written."""
    try:
        return _runs(read_note(path, LARGEST))
    except TypeError:
        raise BadInput(path, "content", "is not what this version writes", schemas.MEND) from None


def _values(runs: list[LeftOut]) -> list[dict[str, str]]:
    return [asdict(left_out) for left_out in runs]


def _runs(content: Any) -> list[LeftOut]:
    """Runs from plain values; raises TypeError for others."""
    runs = [LeftOut(**entry) for entry in content]
    if isinstance(content, list) and all(isinstance(value, str) for entry in content for value in entry.values()):
        return runs
    raise TypeError(content)


@contextmanager
def noted(run_dir: Path, tables: list[Path], note: bool) -> Iterator[None]:
    """Where ingest refuses its run, write the refusal in place of its tables if `note` says so; else raise it.

    A fault of ours in one run costs that run, and is shown in full.
    """
    try:
        yield
    except Exception as error:
        if not note or isinstance(error, schemas.Damaged):
            raise
        if not isinstance(error, BadInput):
            traceback.print_exc()
            problem = f"could not be read: {type(error).__name__}: {error}"
            error = BadInput(run_dir, "recording", problem, "please report it, with its log")
        for table in tables:
            schemas.write_refusal(error, table)
        print(f"left out: {error}")
