"""A recording in memory: the samples of one run, what was measured of its rig, and what may be asked of it."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import pandas as pd

from ..diagnosis.planned_columns import planned_columns
from ..diagnosis.planned_words import of_outside
from ..diagnosis.recording.recorded_run import RecordedRun
from ..diagnosis.simulated_plan import simulated_plan
from ..diagnosis.simulated_recording import SimulatedRecording
from ..diagnosis.simulator import Simulator
from ..ground.input.index_labels import by_index
from ..ground.input.strict_yaml import write_yaml
from ..ground.stored import schemas
from ..ground.stored.whole_folder import whole_folder
from ..run.description import Run, parse_run
from ..run.run_yaml import RunYaml
from ..run.samples import check
from ..run.strokes import segment
from ..run.table.recorded_table import to_samples
from ..string import from_raw
from ..string.history import Recorded, tare_mm
from .as_parts import as_parts
from .explained import Explained, beside, doubts

NAME = "recording"  # of a run that its description gives none


@dataclass(frozen=True, repr=False)
class Recording:
    """One run: `run`, what its description says of string and rig; `samples`, one row a sample in our units.

    `samples` has `time_s` in s and the rig's channels; for a string `motor_turns` (0 untwisted, winding positive),
    `displacement_mm` (contraction positive) and `load_n`. Make one by `Recording.read` or `Recording.of`.
    """

    run: Run
    samples: pd.DataFrame
    folder: Path
    started_utc: str = field(default="", compare=False)
    _strokes: pd.DataFrame | None = field(default=None, compare=False)  # as cut at the door

    @classmethod
    def read(cls, folder: Path | str) -> Recording:
        """The recording in a run folder, `run.yaml` and all, checked as the pipeline checks it; raises BadInput."""
        read = from_raw.read(Path(folder))
        return cls(read.run, read.table, read.folder, read.started_utc, read.strokes)

    @classmethod
    def of(cls, samples: pd.DataFrame, description: RunYaml) -> Recording:
        """A recording of a table, one row a sample, and of what `run.yaml` would say of it.

        `description` has the keys of `run.yaml`: `string`, `rig`, `channels` where columns or units differ, and so on;
        `run`, its name, may be left out. Raises BadInput naming the argument, and the key or the column in it.
        """
        content: RunYaml = {"run": NAME, **description}
        folder = Path(str(content["run"]))
        with as_parts(folder):
            run = parse_run(content, folder / "run.yaml")
            table = samples.reset_index(drop=True)
            where = by_index(samples.index[slice(*(run.file.rows or (None, None)))])
            own_samples = to_samples(run, table, folder / "samples", folder / "run.yaml", where=where)
            checked, strokes = check(run, own_samples, folder / "samples", where)
        return cls(run, checked, folder, _strokes=strokes)

    @cached_property
    def strokes(self) -> pd.DataFrame:
        """Its strokes: one row for each stretch of one phase of one stroke.

        Columns: `stroke` (from 1), `phase` (winding, hold, unwinding or rest), `first_sample`, `last_sample` (rows of
        `samples`), `start_s` and `end_s` (s), `start_turns` and `end_turns` (the motion there, in turns for a
        string), `missing_samples` (a count), `complete` (whether the stroke was wound and unwound).
        """
        if self._strokes is not None:
            return self._strokes
        return segment(self.samples, self.run.system.driver, self.folder)

    @property
    def tare_mm(self) -> float:
        """What `points` add to the displacement of this recording of a string, in mm.

        The zero of points, models and answers is the string's by the model, `x = L - d`; that of `samples` and of
        `simulate` is the sensor's. So a reading of the sensor is an answer less this. Of several runs of one string
        the first one's holds.
        """
        return tare_mm(as_recorded(self))

    def simulate(
        self, diagnosis: Explained | None = None, motion: pd.DataFrame | None = None, after_recording: bool = False
    ) -> pd.DataFrame:
        """What the simulator reads along this recording's motion: `time_s` in s and the predicted channel.

        With a diagnosis its mechanisms and dimensions act; without one those that the description has adopted. The
        measured channel serves for the zero alone; a recording that the diagnosis was made of has its zero there. A
        later run of a diagnosis of several goes on after those before it, which the diagnosis holds; one that was read
        from a file holds none, and they must lie beside the recording's folder. Warns where they are not at hand, of a
        recording of another rig, and of a motion that leaves what was recorded.

        `motion` is one that nobody has recorded, in place of the recording's: `time_s`, the rig's motion (`motor_turns`
        of a string) and its load, one row a sample; corners of a string's motion will do. The answer has more columns
        then, each in the unit that its name ends in: the motion itself, the reading without the effects
        (`without_effects_mm`), the band in which nine of ten readings lie (`low_mm`, `high_mm`), whether a row lies
        outside what was recorded (`outside`), and a reading for each explanation that ties (`if_…`). The rig is as it
        was before its first stroke, or with `after_recording` as the recording left it: crept, warm, worn.

        Raises BadInput where a diagnosis gives no number, for a motion that is none, and where the diagnosis was made
        of another recording of this one's name.
        """
        with as_parts(self.folder, is_read=(self.folder / "run.yaml").is_file()):
            return self._simulated(diagnosis, motion, after_recording)

    def _simulated(
        self, diagnosis: Explained | None, motion: pd.DataFrame | None, after_recording: bool
    ) -> pd.DataFrame:
        source = self.folder / "run.yaml" if diagnosis is None else self.folder / "diagnosis.json"
        simulator = Simulator.of(self.run, source, diagnosis.content if diagnosis else None)
        recorded = RecordedRun(self.run, self.samples, self.strokes, self.folder)
        at_hand = beside(recorded, diagnosis)
        leaves: list[str] = []
        if motion is None:
            simulated = SimulatedRecording(recorded, simulator, beside=at_hand)
            columns, before = {self.run.system.channel: simulated.predicted}, simulated.before
            table = pd.DataFrame({"time_s": self.samples["time_s"].to_numpy(), **columns})
        else:
            path = self.folder / "motion"
            more = after_recording, at_hand, by_index(motion.index)
            plan = simulated_plan(self.run, self.folder, recorded, simulator, motion, path, *more)
            table, before = plan.table(planned_columns(plan, simulator).columns), plan.before
            leaves = of_outside(plan, Path("motion"))
        for words in [*doubts(recorded, before, simulator, diagnosis), *leaves]:
            warnings.warn(words, stacklevel=3)  # said of the line that called simulate
        return table

    def save(self, raw: Path | str) -> Path:
        """Write it as the run folder `raw/<run>`, whole or not at all; raises BadInput where that is there already."""
        folder = Path(raw) / self.run.run
        content = self.run.model_dump(exclude_unset=True, exclude_none=True, exclude={"channels", "file"})
        with whole_folder(folder, "run", "choose another name; runs are never overwritten") as temporary:
            (temporary / "run.yaml").write_text(write_yaml(content), encoding="utf-8")
            schemas.write(self.samples, schemas.samples(list(self.samples.columns)), temporary / "recording.parquet")
        return folder

    def __repr__(self) -> str:
        span_s = self.samples["time_s"].iloc[-1] - self.samples["time_s"].iloc[0]
        channels = ", ".join(self.samples.columns[1:])
        return (
            f"<Recording {self.run.run}: {self.strokes['stroke'].max()} strokes, {len(self.samples)} samples over "
            f"{span_s:.1f} s of {channels}>"
        )


def as_recorded(recording: Recording) -> Recorded:
    """A recording as the stages know a run, for a dataset and a diagnosis."""
    return Recorded(recording.run, recording.started_utc, recording.samples, recording.strokes, recording.folder)
