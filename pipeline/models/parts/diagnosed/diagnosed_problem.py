"""The diagnosis' problem for training points: it has their readings, and the motion between them."""

from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any

import numpy as np
import pandas as pd

from ....diagnosis.fit.problem import Problem
from ....diagnosis.mechanisms.interface import Mechanism, Nonlinear, Term
from ....diagnosis.recording.drivers import Drivers, drivers_of
from ....diagnosis.recording.recorded_run import RecordedRun
from ....diagnosis.recording.working_samples import joined
from ....diagnosis.study import engine
from ....ground.kinematics import Array
from ....run.description import Run
from ....run.strokes import stretches
from .filled_motion import Motion

CHANNELS, CUT = ["time_s", "motor_turns", "displacement_mm", "load_n"], ["stroke", "phase"]
SAMPLES = [*CHANNELS, *CUT]  # columns of a dataset that a problem is made of


@dataclass(frozen=True)
class HoledDrivers(Drivers):
    """Drivers at instants with gaps between; values that depend on neighbours come from the whole motion."""

    whole: Drivers | None = None  # of the motion without holes, from the same start

    @cached_property
    def rate(self) -> Array:
        """Rate of the motion. In the motion's unit a second, shape (samples,)."""
        return self._of_whole("rate")

    @cached_property
    def moved(self) -> Array:
        """The motion without encoder noise. In the motion's unit, shape (samples,)."""
        return self._of_whole("moved")

    @cached_property
    def path(self) -> Array:
        """Travel of the motion since the start. In the motion's unit, shape (samples,)."""
        return self._of_whole("path")

    def _of_whole(self, name: str) -> Array:
        assert self.whole is not None
        return np.interp(self.elapsed_s, self.whole.elapsed_s, getattr(self.whole, name))


@dataclass(frozen=True)
class Holed(Problem):
    """A problem whose mechanisms act along the whole motion, with readings only at some instants."""

    whole: Drivers | None = None  # of the motion without holes, from the same start

    def terms(self, mechanism: Mechanism, nonlinear: Nonlinear) -> list[Term]:
        """Terms of a mechanism at the instants that have a reading, remembered."""
        assert self.whole is not None
        key = (mechanism.id, tuple(nonlinear.items()))
        if key not in self._terms:
            self._terms[key] = [self._seen(term, self.whole) for term in mechanism.terms(self.whole, nonlinear)]
        return self._terms[key]

    def _seen(self, term: Term, whole: Drivers) -> Term:
        signal, own_s, whole_s = term.signal, self.drivers.elapsed_s, whole.elapsed_s
        if not callable(signal):
            return replace(term, signal=np.interp(own_s, whole_s, signal))

        def operator(reading: Array) -> Array:
            return np.interp(own_s, whole_s, signal(np.interp(whole_s, own_s, reading)))

        return replace(term, signal=operator)


def recorded_of(run: Run, samples: pd.DataFrame) -> RecordedRun:
    """Points of a dataset, columns `SAMPLES`, as a run, in the strokes of its recording."""
    cut = stretches(samples["stroke"].to_numpy(np.intp), samples["phase"].to_numpy(object))
    return RecordedRun(run, samples[CHANNELS], cut)


def plain(run: Run, samples: pd.DataFrame, started_s: float) -> Problem:
    """A simulator's problem for any number of samples, whose events are timed from `started_s`."""
    record = joined([recorded_of(run, samples)], len(samples))
    # A point that is asked from before the training must not shift what was timed from its start.
    counted_s = samples["time_s"].to_numpy() - started_s
    drivers = replace(drivers_of(run.system, record, run), counted_s=counted_s)
    parameters = tuple(run.system.parameters(run))
    return Problem(run.system, record, drivers, parameters, record.measured, len(record))


def along(run: Run, motion: Motion, started_s: float) -> Problem:
    """A simulator's problem along a motion, without readings."""
    columns = {each.name: getattr(motion, each.name) for each in fields(motion)}
    return plain(run, pd.DataFrame({**columns, "displacement_mm": 0.0}), started_s)


def holed(run: Run, samples: pd.DataFrame, without: frozenset[str]) -> Problem:
    """The problem for the diagnosis, with every sample as it is; raises BadInput where they show too little.

    The motion between the samples goes straight, as it does when the simulator is asked afterwards: what a mechanism
    listens to, such as a rate, must not differ between the two.
    """
    problem = engine.make_problem([recorded_of(run, samples)], most=len(samples), without=without)
    motion = Motion.of(samples)
    whole = along(run, motion.evenly(motion.step_s), float(motion.time_s[0])).drivers
    drivers = HoledDrivers(**_held(problem.drivers), whole=whole)
    return Holed(**{**_held(problem), "drivers": drivers}, whole=whole)


def _held(of: Problem | Drivers) -> dict[str, Any]:
    return {each.name: getattr(of, each.name) for each in fields(of)}
