"""The history of one string: its runs from earlier stages, in order, and their common tare."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import Protocol, TypeVar

import numpy as np
import pandas as pd

from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..ground.numbers import quantiles
from ..ground.numbers.spans import blocks
from ..ground.stored import schemas
from ..ground.stored.rows import Rows, opened, rows_of
from ..ground.words.left_out import LeftOut
from ..run.description import Run
from ..run.dimensions import geometry
from ..run.folder import read_run, started_utc

LEVEL = ("motor_turns", "load_n", "displacement_mm")


@dataclass(frozen=True)
class Recorded:
    """One run at this stage: its description, its start, its samples, its strokes, and its folder."""

    run: Run
    started_utc: str
    samples: pd.DataFrame | Rows
    strokes: pd.DataFrame
    folder: Path = Path()

    @cached_property
    def rows(self) -> Rows:
        """Its samples, however many."""
        return rows_of(self.samples)

    @property
    def table(self) -> pd.DataFrame:
        """Its samples as a table in memory."""
        return self.samples if isinstance(self.samples, pd.DataFrame) else self.samples.frame(0, len(self.samples))

    @property
    def span_s(self) -> tuple[float, float]:
        """Time stamps of its first and last sample."""
        first, last = self.rows.at("time_s", np.array([0, len(self.rows) - 1])).tolist()
        return first, last

    def level_mm(self, first: int, stop: int) -> float:
        """The median of the displacement less the nominal model, from one sample to another."""
        nominal = geometry(self.run)

        def pieces() -> Iterator[Array]:
            for part in blocks(first, stop, schemas.ROW_GROUP):
                turns, load_n, displacement_mm = (self.rows.read(name, *part) for name in LEVEL)
                yield displacement_mm - nominal.contraction_mm(turns, load_n)

        return quantiles.median(pieces, stop - first)


class Dated(Protocol):
    """A run with the facts that tell when it was recorded."""

    @property
    def run(self) -> Run: ...

    @property
    def started_utc(self) -> str: ...

    @property
    def span_s(self) -> tuple[float, float]: ...


OneRun = TypeVar("OneRun", bound=Dated)


def _strokes_before(recorded: Dated) -> int | None:
    """Strokes that run.yaml says the string had done, or None where it does not say."""
    string = recorded.run.string
    return string.strokes_before if string and "strokes_before" in string.model_fields_set else None


def natural(name: str) -> list[tuple[int, str]]:
    """A name as its numbers and its words, so that run 10 comes after run 2."""
    return [(int(part), "") if part.isdigit() else (-1, part) for part in re.split(r"(\d+)", name)]


def in_order(runs: list[OneRun]) -> list[OneRun]:
    """Runs of one string in the order in which they were recorded.

    The capture program notes when it began. Where it did not record every run, the strokes that the string had done
    tell if every run says another number; failing that, their own time stamps as long as no two overlap, for a logger
    may count from its own start; failing that too, their names, 2 before 10.
    """
    by_name = sorted(runs, key=lambda recorded: natural(recorded.run.run))
    if all(recorded.started_utc for recorded in runs):
        return sorted(by_name, key=lambda recorded: recorded.started_utc)
    strokes_before = {recorded.run.run: _strokes_before(recorded) for recorded in by_name}
    if None not in strokes_before.values() and len(set(strokes_before.values())) == len(by_name):
        return sorted(by_name, key=lambda recorded: strokes_before[recorded.run.run] or 0)
    spans = sorted(recorded.span_s for recorded in runs)
    if all(before[1] <= after[0] for before, after in pairwise(spans)):
        return sorted(by_name, key=lambda recorded: recorded.span_s[0])
    return by_name


def tare_mm(first: Recorded) -> float:
    """The offset to a string's displacement that makes it equal the model on the rest before the first stroke.

    Without a rest there, its first sample serves. The median keeps outliers out.
    """
    before = first.strokes[(first.strokes["stroke"] == 0) & (first.strokes["phase"] == "rest")]
    if before.empty:
        return -first.level_mm(0, 1)
    return -first.level_mm(int(before["first_sample"].iloc[-1]), int(before["last_sample"].iloc[-1]) + 1)


def read_recorded(run_dir: Path, processed: Path) -> Recorded:
    """One run from its folder and from the files of earlier stages; raises BadInput or Refused."""
    run = read_run(run_dir)
    samples = opened(processed / run.run / "samples.parquet")
    strokes = schemas.read(processed / run.run / "strokes.parquet", schemas.STROKES)
    return Recorded(run, started_utc(run_dir), samples, strokes, run_dir)


def by_string(recorded: list[Recorded]) -> list[list[Recorded]]:
    """Runs of each string in the order in which they were recorded; the strings in the order of their runs' names."""
    strings: dict[str, list[Recorded]] = {}
    for recorded_run in sorted(recorded, key=lambda recorded_run: recorded_run.run.run):
        strings.setdefault(recorded_run.run.string_id, []).append(recorded_run)
    return [in_order(runs) for runs in strings.values()]


def read_usable(folders: list[Path], processed: Path) -> tuple[list[Recorded], list[LeftOut]]:
    """Runs from the earlier stages, and those that these refused; raises BadInput when all are refused."""
    recorded, refused = [], []
    for folder in folders:
        try:
            recorded.append(read_recorded(folder, processed))
        except schemas.Refused as error:
            print(f"left out: {error}")
            refused.append(LeftOut.of(folder.name, error))
            last = error
    if not recorded:
        raise BadInput(last.file, last.field, last.problem, last.mend)
    return recorded, refused
