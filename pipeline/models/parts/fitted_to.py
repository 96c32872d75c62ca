"""The points that a saved model was fitted to, as a note in its file, and whether a dataset has the same ones.

The note has the number of points of each run and the means of their columns: a dataset that is made again has the
same, whatever the order of its rows and columns and the last digits of its numbers.
"""

import os
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import TypedDict

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from ...ground.command import INSTALLED, command, make_command
from ...ground.errors import BadInput
from .divided import SPLITS
from .saved import read_note, write_note
from .saved_files import FIRST, fit_command, material_of

ALL = "all"  # in place of a split: no point was left out
MEANS = (
    "stroke", "direction", "motor_turns", "displacement_mm", "load_n", "radius_mm", "length_mm", "stiffness_n_per_mm",
    "torsion_zone_mm", "separator_mm", "radius_tolerance", "length_tolerance_mm", "torsion_zone_tolerance_mm",
    "separator_tolerance_mm",
)  # fmt: skip
SQUARES = ("motor_turns", "displacement_mm", "load_n")  # whose mean squares are compared as well
SAME = 1e-9  # relative, and in the column's unit, within which means are the same: one point of 5000 off by 5e-6 mm
NAMED = 3  # runs that are named


class SavedRun(TypedDict):
    """What a model's file says of the training points of one run."""

    string: str
    points: int
    means: list[float | None]  # of MEANS, then of the squares; None: not a number


class SavedPoints(TypedDict):
    """What a model's file says of its training points: the split, the one string that they are of if any, the runs."""

    split: str
    string: str
    runs: dict[str, SavedRun]


@dataclass(frozen=True)
class Apart:
    """How the training points of a dataset differ from those that a model was fitted to, by run.

    `same` are the runs with the same points, `new` those that the model has not seen, `changed` those with other
    points, `gone` those that the dataset lacks.
    """

    file: Path
    dataset: Path
    split: str
    string: str
    same: tuple[str, ...]
    new: tuple[str, ...]
    changed: tuple[str, ...]
    gone: tuple[str, ...]

    @property
    def has_grown(self) -> bool:
        """Whether all points that the model was fitted to are in the dataset as they were."""
        return not self.changed and not self.gone

    @property
    def fitted_runs(self) -> tuple[str, ...]:
        """The runs that the model was fitted to, sorted."""
        return tuple(sorted({*self.same, *self.changed, *self.gone}))

    @property
    def problem(self) -> str:
        """What is wrong, behind the name of the model's file."""
        parts = (
            (self.new, "new to it"),
            (self.changed, "there with other points to train on"),
            (self.gone, "no longer there"),
        )
        words = [f"{_runs(runs)} {'is' if len(runs) == 1 else 'are'} {what}" for runs, what in parts if runs]
        return f"was fitted to other points than those of {_from_here(self.dataset)}: {'; '.join(words)}"

    @property
    def mend(self) -> str:
        """The command that fits the model anew, with the fit beside it that errs on later strokes."""
        later = self.file.with_name(f"later-{self.file.stem.partition('-')[2]}{self.file.suffix}")
        files = [self.file] if later == self.file or not later.is_file() else [self.file, later]
        if self.split == ALL:
            first = self.file.with_name(FIRST)
            words = f" --string {shlex.quote(self.string)}" if self.string else ""
            anew = f"{command('export')} {shlex.quote(str(first))} --format c --all-points{words}"
            return f"fit it anew: {anew}" if first.is_file() else "fit it anew"
        at_its_place = self.file.stem.partition("-")[0] == self.split and self.dataset.name == "dataset.parquet"
        at_its_place &= self.file.resolve().parent.parent == self.dataset.resolve().parent
        targets = [make_command(_from_here(file)) for file in files]
        if at_its_place and (INSTALLED or not material_of(self.dataset)):
            seed = self.file.stem.partition("-")[2]
            by_seed = f" --seed {shlex.quote(seed)}" if seed not in ("", "0") else ""
            return f"fit it anew: {fit_command(self.file.resolve().parent.name, _from_here(self.dataset))}{by_seed}"
        if not (at_its_place and targets[0] and material_of(self.dataset)):
            return "fit it anew"
        return f"fit it anew: {' '.join([targets[0], *(target.partition(' -- ')[2] for target in targets[1:])])}"

    @property
    def sentence(self) -> str:
        """What is wrong, with the mend."""
        return f"{self.file} {self.problem}; {self.mend}"


def note_points(file: Path, points: pd.DataFrame, split: str, string: str = "") -> None:
    """Note in a saved model's file the points of a dataset that it was fitted to, a `split`'s or ALL.

    `string` is the one that alone they are of.
    """
    note: SavedPoints = {"split": split, "string": string, "runs": _by_run(points)}
    write_note(file, note)


def apart(file: Path, dataset: Path) -> Apart | None:
    """How a dataset's training points differ from those in the note of a model's file; None where they do not.

    None as well where the file has no note, or no such dataset is there.
    """
    try:
        note: SavedPoints | None = read_note(file)
        if note is None:
            return None
        split, string, fitted_runs = note["split"], note["string"], note["runs"]
        train = [(split, "==", "train")] if split in SPLITS else None
        points = pq.read_table(dataset, columns=["run", "string", *MEANS], filters=train).to_pandas()
    except (BadInput, OSError, pa.ArrowException, LookupError, ValueError, TypeError):
        return None  # whoever reads the file or the dataset next says what is wrong with it
    now = _by_run(points[points["string"].astype(str) == string] if string else points)
    both = sorted(set(fitted_runs) & set(now))
    same = tuple(run for run in both if _alike(fitted_runs[run], now[run]))
    new, gone = tuple(sorted(set(now) - set(fitted_runs))), tuple(sorted(set(fitted_runs) - set(now)))
    if len(same) == len(fitted_runs) and not new:
        return None
    return Apart(file, dataset, split, string, same, new, tuple(run for run in both if run not in same), gone)


def _by_run(points: pd.DataFrame) -> dict[str, SavedRun]:
    """The number and the means of the points of each run."""
    numbers = points[list(MEANS)].astype(float)
    numbers = numbers.assign(**{f"{name}^2": numbers[name] ** 2 for name in SQUARES})
    numbers["turns*mm"] = numbers["motor_turns"] * numbers["displacement_mm"]
    runs = points["run"].astype(str)
    by_run, strings = numbers.groupby(runs, sort=True), points["string"].astype(str).groupby(runs).first()
    counts = by_run.size()
    return {
        str(run): {
            "string": str(strings[run]),
            "points": int(counts[run]),
            "means": [float(mean) if np.isfinite(mean) else None for mean in means],
        }
        for run, means in zip(counts.index, by_run.mean().to_numpy(), strict=True)
    }


def _alike(fitted: SavedRun, now: SavedRun) -> bool:
    """Whether two runs are of one string and have the same points."""
    means = [np.array(saved["means"], float) for saved in (fitted, now)]
    counts = [(saved["string"], saved["points"], len(saved["means"])) for saved in (fitted, now)]
    return counts[0] == counts[1] and np.allclose(means[0], means[1], rtol=SAME, atol=SAME, equal_nan=True)


def _from_here(path: Path) -> Path:
    """A path as it is from the folder that the program was started in, if it lies in it."""
    return Path(os.path.relpath(path)) if path.resolve().is_relative_to(Path.cwd()) else path


def _runs(runs: tuple[str, ...]) -> str:
    """Some runs by name, and how many more."""
    more = f" and {len(runs) - NAMED} more" if len(runs) > NAMED else ""
    return f"run{'s' * (len(runs) > 1)} {', '.join(runs[:NAMED])}{more}"
