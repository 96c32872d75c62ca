"""A recording of a real rig as a simulator's problem, for questions and for learning."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import pandas as pd

from ..diagnosis.document.content import Simulated
from ..diagnosis.fit.problem import Problem
from ..diagnosis.prediction.carried_over import carried_over
from ..diagnosis.prediction.simulation import state_of
from ..diagnosis.recording.recorded_run import RecordedRun
from ..diagnosis.study.motor_zeros import one_string
from ..diagnosis.study.own_rate import at_own_rate
from ..ground.kinematics import Array
from ..run.description import Run
from ..string.history import Recorded


@dataclass(frozen=True, eq=False)
class About:
    """A recording for questions and for learning: read and cut once, and one problem for all diagnoses."""

    recorded: Recorded

    @property
    def run(self) -> Run:
        """What its run.yaml says."""
        return self.recorded.run

    @property
    def samples(self) -> pd.DataFrame:
        """Its samples, one row each."""
        return self.recorded.table

    @cached_property
    def problem(self) -> Problem:
        """The simulator's problem at the recording's own rate."""
        return at_own_rate([RecordedRun(self.run, self.samples, self.recorded.strokes, self.recorded.folder)])

    @property
    def another(self) -> bool:
        """Whether no file says that it is of the same string as others, so that its motor counts turns anew."""
        return not one_string([self.run])

    def simulated(self, content: Simulated, path: Path) -> tuple[Array, Array, Array]:
        """Prediction of a diagnosis, the measured values, and their time; the zero is left open.

        Of the diagnosis that part is taken which holds on the first stroke, the motor homed there where it may count
        its turns from elsewhere. Of the same string all of it is taken.

        Each of shape (samples,), in the reading's unit and s.
        """
        if self.another:
            content = carried_over(self.problem, content, path, self.run.run).content
        state = state_of(content, self.problem, path, self.run.run)
        return self.problem.simulate(state), self.problem.measured, self.problem.record.time_s
