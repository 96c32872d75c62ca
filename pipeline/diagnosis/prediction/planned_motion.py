"""A motion that nobody recorded, and its simulation: alone, or after the recorded motion of its run."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, cast

import numpy as np
import pandas as pd

from ...ground.errors import BadInput
from ...ground.kinematics import Array
from ...run.description import Run
from ...run.planned_motion.continued import continued
from ...run.planned_motion.motion_course import Mask, Recorded
from ...run.planned_motion.outside import Outside, outside
from ...run.samples import read_strokes
from ..choice.outcome import rms
from ..document.content import Simulated, Verdict
from ..fit.problem import Problem
from ..mechanisms.library import mechanisms
from ..recording.recorded_run import RecordedRun
from ..study.own_rate import at_own_rate
from .fallen_load import with_fallen_load
from .harder_acceleration import with_harder
from .later_run import places_beside
from .planned_zero import beginning, own_zero, set_by, set_where_it_begins
from .prediction_band import Foretold, band, curves
from .simulation import simulated, tared, value_of

SHARE = 0.01  # of the reading's range: where no error is expected, a smaller difference is not worth a word


@dataclass(frozen=True)
class Plan:
    """A planned motion of a run: its samples, whether corners drew it, what was recorded, and what to simulate it by.

    `content`, from the file `source`, is the simulator. `after`: whether the recorded motion goes before the plan.
    `tied`: the explanations that are as likely as what acts, by their mechanisms. `beside`: the other recordings that
    were diagnosed together with the run's own; `before`: those of them that go before it, and so before the plan.
    """

    run: Run
    samples: pd.DataFrame
    drawn: bool
    recorded: RecordedRun | None
    content: Simulated
    source: Path
    after: bool = False
    tied: Sequence[Sequence[str]] = ()
    beside: Sequence[RecordedRun] = ()
    before: Sequence[RecordedRun] = ()

    @cached_property
    def outside(self) -> Outside | None:
        """The part of the plan that leaves the recorded range; None where nothing was recorded."""
        if self.recorded is None:
            return None
        library, acting = mechanisms(), [entry["id"] for entry in self.content["simulation"]]
        remembers = any(library[id_].remembers_turns for id_ in acting if id_ in library)
        likely = dict.fromkeys([*acting, *(id_ for ids in self.tied for id_ in ids)])
        paced = [id_ for id_ in likely if id_ in library and library[id_].paced]
        all_recorded = [*self.before, self.recorded, *(each for each in self.beside if each not in self.before)]
        tables, strokes = [each.samples for each in all_recorded], [each.strokes for each in all_recorded]
        recorded = Recorded(tables, strokes, self.run.system.driver)
        beyond = outside(self.run, self.samples, recorded, remembers, paced)
        beyond = with_harder(beyond, self.run.system, self.samples, tables)
        goes_before = [*self.before, *([self.recorded] if self.after else [])]
        return with_fallen_load(beyond, self.run.system, self.samples, tables, [each.samples for each in goes_before])

    @cached_property
    def problem(self) -> Problem:
        """The problem to simulate: the plan's samples are its last ones."""
        samples = self.samples
        if self.after and self.recorded is not None:
            samples = continued(self.run.system, samples, self.recorded.samples, self.drawn)
        problem = at_own_rate([*self.before, RecordedRun.cut(self.run, samples)], thin=False, to_fit=False)
        if self.drawn:
            problem = replace(problem, drivers=replace(problem.drivers, drawn=True), _terms={})
        return problem

    def own(self, values: Array) -> Array:
        """The plan's rows of a simulated signal: shape (samples,), in the channel's unit."""
        return values[-len(self.samples) :]

    @cached_property
    def begun(self) -> Problem | None:
        """The beginning of the recording, which sets the zero. None where the zero is known, or nothing sets it."""
        zero_known = self.zero or not self.run.system.free_zero
        return None if zero_known else beginning(self.recorded)

    @property
    def zero(self) -> str:
        """The name of the zero of the run's reading in the simulator; empty where it has none."""
        return own_zero(self.content, self.run.system, self.run.run)

    def zeroed(self, content: Simulated, path: Path) -> Array:
        """The simulated reading in the plan's rows, with the zero found as for `content`; raises BadInput.

        The zero is the recording's, where that is known or its first second sets it. Else the plan begins at 0. Shape
        (samples,), in the channel's unit.
        """
        run = self.run.run
        if self.after:
            return self.own(tared(self.problem, content, path, run))
        reading = self.own(simulated(self.problem, content, path, run))
        name = own_zero(content, self.run.system, run) if self.zero else ""
        if name:
            return reading + value_of(content, name, path, 0.0)
        if not self.run.system.free_zero:
            return reading
        return reading + set_by(self.begun, content, path, run) if self.begun else set_where_it_begins(reading)

    @cached_property
    def predicted(self) -> Array:
        """The reading, of shape (samples,) in the channel's unit; raises BadInput as `zeroed` does."""
        return self.zeroed(self.content, self.source)

    @cached_property
    def without_effects(self) -> Array:
        """The reading with the same dimensions and the same zero, if no effect acted.

        Shape (samples,), in the channel's unit.
        """
        bare: Simulated = {**self.content, "simulation": []}
        whole, alone = (simulated(self.problem, content, self.source, self.run.run) for content in (self.content, bare))
        return self.predicted - self.own(whole) + self.own(alone)

    def band(self, diagnosis: Verdict, path: Path) -> Foretold | None:
        """The error band of the plan by `diagnosis`; None where that does not hold one."""
        return band(self.problem, diagnosis, path, self.run.run, lambda content: self.zeroed(content, path))

    def curves(self, diagnosis: Verdict, path: Path) -> dict[str, Array]:
        """The reading by each tied explanation, keyed by its mechanisms: of shape (samples,), in the channel's unit."""
        return curves(self.problem, diagnosis, path, self.run.run, lambda content: self.zeroed(content, path))

    @property
    def inputs(self) -> dict[str, Array]:
        """Motion and load of the plan by their columns, the load only where one hangs.

        Each of shape (samples,), in the unit that its name ends in.
        """
        driver, load = self.run.system.driver, self.run.system.load
        hung = load in self.samples and (self.run.system.needs_string or bool(self.samples[load].any()))
        return {name: self.samples[name].to_numpy() for name in (driver, *([load] if load and hung else []))}

    def table(self, columns: Mapping[str, Array]) -> pd.DataFrame:
        """The answer, one row a sample: time in s, the reading, columns beside it, and what was planned.

        Each of `columns` has the shape (samples,), and the unit that its name ends in.
        """
        answer = {"time_s": self.samples["time_s"].to_numpy(), self.run.system.channel: self.predicted}
        return pd.DataFrame({**answer, **columns, **self.inputs})

    def inside(self) -> Mask:
        """The rows within what was recorded, all where nothing was. Shape (samples,)."""
        return np.ones(len(self.samples), bool) if self.outside is None else ~self.outside.rows

    def changed_by_recording(self, expected: float | None) -> Array | None:
        """By how much the reading differs after the recorded motion, of shape (samples,) in the channel's unit.

        None where that is not more than the error that is `expected`, or where nothing was recorded or acts.
        """
        if self.after or self.recorded is None or not self.content["simulation"]:
            return None
        try:
            gap = replace(self, after=True).predicted - self.predicted
        except BadInput:  # what cannot be simulated after the recording is no reason to refuse the plan alone
            return None
        limit = SHARE * float(np.ptp(self.predicted)) if expected is None else expected
        return gap if rms(gap) > limit else None


def expected_error(width: Foretold | None, rows: Mask) -> float | None:
    """The error that is expected in some rows, rms in the channel's unit; None without a band, or without rows."""
    return None if width is None or not rows.any() else width.expected(rows)


def tied_with(run: Run, content: Simulated, adopted: bool) -> list[list[str]]:
    """The explanations that tie with the simulator: those of a diagnosis, or those a run `adopted` last."""
    tied: Any = run.adopted[-1].tied if adopted and run.adopted else cast(Verdict, content).get("alternatives", [])
    return (
        [[id_ for id_ in ids if isinstance(id_, str)] for ids in tied if isinstance(ids, list)]
        if isinstance(tied, list)
        else []
    )


def recorded_beside(folder: Path, run: Run, content: Simulated, adopted: bool) -> list[RecordedRun]:
    """The other recordings of the diagnosis beside `folder`, as far as they are there.

    `adopted`: those of what the run has adopted last. Raises BadInput for a recording that cannot be read.
    """
    runs: Any = (run.adopted[-1].runs if run.adopted else None) if adopted else content.get("run")
    others = [name for name in runs if name != run.run] if isinstance(runs, list) and run.run in runs else []
    return [RecordedRun(*read_strokes(place), place) for place in places_beside(folder, others)]
