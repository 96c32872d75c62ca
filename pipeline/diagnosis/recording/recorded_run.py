"""A run as a diagnosis takes it: what run.yaml says, its checked samples, and the strokes that these were cut into."""

from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from ...run.description import Run
from ...run.strokes import label, of_samples, stretches


@dataclass(frozen=True, eq=False)
class RecordedRun:
    """One run of a diagnosis.

    `samples` has one row a sample, in our units. `strokes` is what these were cut into at the door: `stroke`, `phase`,
    `first_sample` and `last_sample` of `schemas.STROKES`. `folder` is where the run lies or would lie, for what is said
    of it.
    """

    run: Run
    samples: pd.DataFrame
    strokes: pd.DataFrame
    folder: Path | None = None

    @property
    def place(self) -> Path:
        """Where it lies or would lie: its folder, or its name where there is none."""
        return self.folder or Path(self.run.run)

    @classmethod
    def cut(cls, run: Run, samples: pd.DataFrame, folder: Path | None = None) -> "RecordedRun":
        """A motion that came through no door, as a planned one: it is cut into strokes, also where it holds none."""
        time_s, motion = (samples[name].to_numpy() for name in ("time_s", run.system.driver))
        return cls(run, samples, stretches(*label(time_s, motion)), folder)

    def each(self, step: int) -> "RecordedRun":
        """The run with each `step`-th of its samples, in the strokes that it was cut into."""
        return self._taken(slice(None, None, step))

    def begun(self, count: int) -> "RecordedRun":
        """The run with its first `count` samples, in the strokes that it was cut into."""
        return self._taken(slice(count))

    def _taken(self, rows: slice) -> "RecordedRun":
        stroke, phase = of_samples(self.strokes)
        samples = self.samples.iloc[rows].reset_index(drop=True)
        return RecordedRun(self.run, samples, stretches(stroke[rows], phase[rows]), self.folder)
