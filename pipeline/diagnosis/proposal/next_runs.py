"""Which run to add: what is built for a tie, and candidates, scored by how far they part what ties.

Source: Atkinson and Fedorov, "The design of experiments for discriminating between two rival models", Biometrika 62,
1975.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from ...ground.kinematics import Array
from ...run.description import Run
from ..choice.search import Explanation, Search
from ..document.expected import NextRun
from ..fit.linear import Fit, Key, Linear
from ..fit.problem import Problem
from ..numerics.noise import Noise
from ..recording.drivers import drivers_of
from ..recording.working_samples import PHASES, Record
from . import design
from .legs import AFTER_UNKNOWN, CANDIDATES, Leg, Rig, as_legs
from .tie_gaps import Gap, closest, pairs

MOST_STEPS = 4000


@dataclass(frozen=True)
class Proposal:
    """A run to add: what it is called, its legs from where the recording ended, and what it is expected to tell.

    `all_now` and `all_then` are the gaps between each two explanations that tie, without the run and with it. `follows`
    is the driver that it tries, where there are no explanations to part.
    """

    title: str
    legs: list[Leg]
    rig: Rig
    all_now: tuple[Gap, ...] = ()
    all_then: tuple[Gap, ...] = ()
    follows: str | None = None

    @property
    def now(self) -> Gap | None:
        """The smallest gap without the run, and which two explanations it is between; None where none are parted."""
        return closest(self.all_now) if self.all_now else None

    @property
    def then(self) -> Gap | None:
        """The smallest gap with the run, as `now` gives it."""
        return closest(self.all_then) if self.all_then else None

    def entry(self, run: Run, fixed_load: bool) -> NextRun:
        """It as `diagnosis.json` holds it; `fixed_load`: whether the load stood still in what was recorded."""
        content: NextRun = {"title": self.title, "legs": as_legs(self.legs, run), "from": self.rig.at}
        content |= {"load": self.rig.under, "fixed_load": fixed_load}
        if self.now and self.then:
            content["parts"] = [list(ids) for ids in self.then[1:]]
            content |= {"gap_now": self.now[0], "gap_then": self.then[0]}
            content["pairs"] = pairs(self.all_now, self.all_then)
        return content | ({"follows": self.follows} if self.follows else {})


def counts(record: Record, legs: list[Leg]) -> list[int]:
    """How many samples each leg gets after the record."""
    return [max(2, round(leg[0] / _step_s(record, legs))) for leg in legs]


def _step_s(record: Record, legs: list[Leg]) -> float:
    return max(float(np.median(np.diff(record.time_s))), sum(leg[0] for leg in legs) / MOST_STEPS)


def appended(record: Record, legs: list[Leg]) -> Record:
    """The record with legs of straight motion after it; the measured channel is carried on, and means nothing."""
    step_s = _step_s(record, legs)
    motion, load, moving = [], [], []
    at = float(record.motion[-1])
    for (_, to, weight), count in zip(legs, counts(record, legs), strict=True):
        motion.append(np.linspace(at, to, count + 1)[1:])
        load.append(np.full(count, weight))
        moving.append(np.full(count, 0 if to > at else 2 if to < at else 1))
        at = to
    turns = np.concatenate(motion)
    phase = np.concatenate(moving)
    starts = np.concatenate([[False], (np.diff(phase) != 0) & (phase[1:] == PHASES.index("winding"))])
    count = len(turns)
    velocity = np.gradient(turns, step_s)

    def longer(column: Array | None, new: Array | None = None) -> Array | None:
        if column is None:
            return None
        return np.concatenate([column, np.full(count, column[-1]) if new is None else new.astype(column.dtype)])

    new = {
        "time_s": record.time_s[-1] + step_s * np.arange(1, count + 1), "motion": turns, "velocity": velocity,
        "acceleration": np.gradient(velocity, step_s), "load": np.concatenate(load),
        "stroke": record.stroke[-1] + np.cumsum(starts), "phase": phase,
    }  # fmt: skip
    return Record(**{name: longer(getattr(record, name), new.get(name)) for name in Record.__dataclass_fields__})  # type: ignore[arg-type]


def lengthened(problem: Problem, run: Run, record: Record) -> Problem:
    """The problem as if the recording had gone on like `record`."""
    drivers = drivers_of(problem.system, record, run)
    return replace(problem, record=record, drivers=drivers, measured=record.measured, rows=len(record), _terms={})


def separations(
    problem: Problem, run: Run, noise: Noise, search: Search, sets: list[Explanation], record: Record
) -> tuple[Gap, ...]:
    """Expected gaps between each two explanations that tie, if the recording went on like `record`.

    Each is the misfit that the second would leave of a recording that the first made.
    """
    longer = lengthened(problem, run, record)
    catalogue: dict[str, list] = {}
    chosen: list[tuple[Key, ...]] = []
    for explanation in sets:
        keys = []
        for id_, number in explanation.keys:
            nonlinear = search.linear.catalogue[id_][number]
            candidates = catalogue.setdefault(id_, [])
            if nonlinear not in candidates:
                candidates.append(nonlinear)
            keys.append((id_, candidates.index(nonlinear)))
        chosen.append(tuple(keys))
    linear = Linear(longer, search.linear.state, noise, catalogue)
    gaps = []
    for i, explanation in enumerate(sets):
        columns = linear.columns_of(chosen[i])
        truth = Fit(columns, explanation.fit.coefficients, 0.0, 0.0, 0)
        for rival, other in zip(chosen, sets, strict=True):
            if not set(explanation.ids) <= set(other.ids):  # a larger one can always copy it
                gaps.append((linear.gap(truth, linear.columns_of(rival)), explanation.ids, other.ids))
    return tuple(gaps)


class Runs:
    """Runs that could be made to part what ties, each scored once, whoever asks for it again."""

    def __init__(self, problem: Problem, run: Run, noise: Noise, search: Search, sets: list[Explanation]) -> None:
        self.rig, self.changes = Rig(problem.record), bool(problem.record.load.any())
        tied = (problem, run, noise, search, sets[:4])
        self.now = separations(*tied, problem.record)
        self.parted: Callable[[tuple[Leg, ...]], tuple[Gap, ...]] = cache(
            lambda legs: separations(*tied, appended(problem.record, list(legs)))
        )

    def proposal(self, title: str, legs: list[Leg]) -> Proposal:
        """A run by its words and legs, with what it is expected to tell."""
        return Proposal(title, legs, self.rig, self.now, self.parted(tuple(legs)))

    def built(self, loads: bool, faster: bool) -> Proposal:
        """The run that is built for this tie; `loads` and `faster`: whether it may ask other loads, a higher speed."""
        now = closest(self.now)[0]
        return self.proposal(
            *design.designed(self.rig, lambda legs: closest(self.parted(tuple(legs)))[0], now, loads, faster)
        )


def options(problem: Problem, run: Run, noise: Noise, search: Search, sets: list[Explanation]) -> list[Proposal]:
    """Runs that could be made, best first: those that are built for this tie, then every candidate by its gap.

    The first may use every load and speed; it is followed by what is built without other loads, and without a higher
    speed as well, for rigs that cannot have them.
    """
    runs = Runs(problem, run, noise, search, sets)
    built: dict[str, Proposal] = {}
    for loads, faster in ((runs.changes, True), (False, True), (False, False)):
        proposal = runs.built(loads, faster)
        built.setdefault(proposal.title, proposal)
    candidates = [
        runs.proposal(name, [runs.rig.home(), *legs(runs.rig)])
        for name, legs in CANDIDATES.items()
        if runs.changes or "load" not in name
    ]
    return [*built.values(), *sorted(candidates, key=lambda proposal: -proposal.then[0] if proposal.then else 0.0)]


def best(problem: Problem, run: Run, noise: Noise, search: Search, sets: list[Explanation]) -> Proposal:
    """The run that is built for this tie: the first of the options, without what the others cost."""
    runs = Runs(problem, run, noise, search, sets)
    return runs.built(runs.changes, True)


def after_unknown(problem: Problem, run: Run, driver: str) -> Proposal:
    """What to record when nothing in the library explains a mismatch that follows a driver most."""
    rig = Rig(problem.record)
    name, legs = AFTER_UNKNOWN.get(driver, AFTER_UNKNOWN["twist"])
    if "load" in name and not problem.record.load.any():
        name, legs = AFTER_UNKNOWN["speed"]
    return Proposal(name, [rig.home(), *legs(rig)], rig, follows=driver)
