"""A run as a diagnosis takes it: what run.yaml says, its checked samples, and the strokes that these were cut into."""

from dataclasses import dataclass, replace
from pathlib import Path

import pandas as pd

from ...run.description import Run


@dataclass(frozen=True, eq=False)
class RecordedRun:
    """One run of a diagnosis.

    `samples` has one row a sample, in our units. `strokes` is what these were cut into at the door (`schemas.STROKES`);
    samples that nobody cut, as a planned motion's, are cut where they are joined. `folder` is where the run lies or
    would lie, for what is said of it.
    """

    run: Run
    samples: pd.DataFrame
    strokes: pd.DataFrame | None = None
    folder: Path | None = None

    @property
    def place(self) -> Path:
        """Where it lies or would lie: its folder, or its name where there is none."""
        return self.folder or Path(self.run.run)

    def each(self, step: int) -> "RecordedRun":
        """The run with each `step`-th of its samples, which nobody has cut."""
        return replace(self, samples=self.samples.iloc[::step].reset_index(drop=True), strokes=None)
