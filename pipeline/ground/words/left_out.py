"""A run that was left out, and why: noted by the stage that refuses it, and told by the pages that go on without it."""

import json
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path

from ..command import REMAKE
from ..errors import BadInput
from ..stored import schemas
from ..stored.regular_file import read_regular

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
    """Runs as JSON, for a file or a command line."""
    return json.dumps([asdict(left_out) for left_out in runs])


def from_json(text: str | bytes, source: Path | str = "the runs left out") -> list[LeftOut]:
    """Runs from such JSON, which is read from `source`; raises BadInput for anything else."""
    try:
        content = json.loads(text if isinstance(text, str) else text.decode("utf-8"))
        runs = [LeftOut(**entry) for entry in content]
        if isinstance(content, list) and all(isinstance(value, str) for entry in content for value in entry.values()):
            return runs
    except (ValueError, TypeError, RecursionError):
        pass
    raise BadInput(source, "JSON", "is not what the pipeline writes", REMAKE)


def read_left_out(path: Path) -> list[LeftOut]:
    """Runs in a file of such JSON; raises BadInput for one that is damaged."""
    return from_json(read_regular(path, LARGEST), path)


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
