"""The diagnosis' problem of training points: it sees their readings, and what moved between them."""

from dataclasses import dataclass, replace

import numpy as np
import pandas as pd

from ...diagnosis import engine
from ...diagnosis.drivers import Drivers, drivers_of
from ...diagnosis.interface import Mechanism, Nonlinear, Term
from ...diagnosis.problem import Problem
from ...diagnosis.record import joined
from ...ground.kinematics import Array
from ...run.description import Run
from .motion import Motion

SAMPLES = ["time_s", "motor_turns", "displacement_mm", "load_n"]
FOLLOWED = ("rate", "moved", "path")  # what drivers find in neighbouring samples, and would find wrong at a hole


@dataclass(frozen=True)
class Holed(Problem):
    """A problem whose mechanisms act along the whole motion, of which only some instants have a reading."""

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


def plain(run: Run, samples: pd.DataFrame, started_s: float) -> Problem:
    """A simulator's problem for samples of any number, whose events are timed from `started_s`."""
    record = joined([run], [samples], len(samples))
    drivers = drivers_of(run.system, record, run)
    # A point that is asked from before the training must not shift what was timed from its start.
    drivers.__dict__["elapsed_s"] = samples["time_s"].to_numpy() - started_s
    parameters = tuple(run.system.parameters(run))
    return Problem(run.system, record, drivers, parameters, record.measured, len(record))


def along(run: Run, motion: Motion, started_s: float) -> Problem:
    """A simulator's problem along a motion, without readings."""
    columns = {"time_s": motion.time_s, "motor_turns": motion.motor_turns, "load_n": motion.load_n}
    return plain(run, pd.DataFrame({**columns, "displacement_mm": 0.0}), started_s)


def holed(run: Run, samples: pd.DataFrame, without: frozenset[str]) -> Problem:
    """The problem that the diagnosis is given, with every sample as it is; raises BadInput where they show too little.

    The motion between the samples goes straight, as it does when the simulator is asked afterwards: what a mechanism
    listens to, such as a rate, must not differ between the two.
    """
    problem = engine.make_problem([run], [samples], most=len(samples), without=without)
    motion = Motion.of(samples)
    whole = along(run, motion.evenly(motion.step_s), float(motion.time_s[0])).drivers
    for name in FOLLOWED:
        problem.drivers.__dict__[name] = np.interp(problem.drivers.elapsed_s, whole.elapsed_s, getattr(whole, name))
    fields = {name: getattr(problem, name) for name in Problem.__dataclass_fields__}
    return Holed(**fields, whole=whole)
