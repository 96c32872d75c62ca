"""A black box fitted to a simulator's residual, for a reader who wants the prediction alone: it is no physics.

Boosted trees over the drivers of the recording, as in `flexible.py`. They answer only inside the recorded range.
Outside it they add 0.

Source: Friedman, "Greedy function approximation: a gradient boosting machine", Annals of Statistics 29, 2001.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from ...ground.kinematics import Array, Mask
from ..choice.outcome import rms
from ..document.content import Simulated, Verdict
from ..fit.flexible import SEED, inputs
from ..fit.problem import Problem
from ..recording.drivers import LEAST_LOAD, LOAD_MOVES, Drivers
from ..recording.recorded_run import RecordedRun
from ..recording.working_samples import wild
from ..study.engine import make_problem
from ..study.own_rate import to_score
from . import without_last
from .simulation import has_zero, tared

ROOM, NEAR = 0.05, 0.2  # of a driver's recorded range: so far beyond it is inside; so near, in all, a row was recorded
NINE_OF_TEN = 0.9


@dataclass(frozen=True)
class Lesson:
    """A recording at its working rate, and the simulator's residual `left`, of shape (samples,), in its unit."""

    problem: Problem
    left: Array


@dataclass(frozen=True)
class BlackBox:
    """Trees fitted to a residual, and the drivers that they were fitted over, by name."""

    recorded: dict[str, Array]  # each of shape (rows,), in its own unit
    told: tuple[str, ...]  # those that the trees listen to
    span: float  # of the motion, in its unit
    predict: Callable[[Array], Array]
    near: cKDTree

    @classmethod
    def fitted(cls, lessons: Sequence[Lesson], seen: Sequence[Mask], names: Sequence[str]) -> "BlackBox":
        """A black box fitted to the visible rows of some lessons, over the drivers of these names.

        `seen` are masks, each of shape (samples,) of its lesson.
        """
        motion = np.concatenate([lesson.problem.drivers.motion for lesson in lessons])
        span = float(np.subtract(*np.percentile(motion, [99.9, 0.1])))
        rows = [mask & ~wild(lesson.left)[0] for lesson, mask in zip(lessons, seen, strict=True)]
        columns = [told_of(lesson.problem.drivers, span) for lesson in lessons]
        recorded = {name: _stacked([each[name] for each in columns], rows) for name in names}
        load = recorded["load"]
        usual = max(abs(float(np.median(load))), LEAST_LOAD)
        loaded = float(np.subtract(*np.percentile(load, [95, 5]))) > LOAD_MOVES * usual
        listened_to = tuple(name for name in names if name != "load" or loaded)
        from ...ground.numbers.regression import boosted_trees  # seconds to import

        residuals = _stacked([lesson.left for lesson in lessons], rows)
        predict = boosted_trees(np.column_stack([recorded[name] for name in listened_to]), residuals, SEED)
        near = cKDTree(_in_ranges(recorded, recorded, listened_to))
        return cls(recorded, listened_to, span, predict, near)

    def added(self, drivers: Drivers) -> tuple[Array, Mask]:
        """What the trees add to a simulator, in the reading's unit, and the rows inside the recorded range.

        In other rows they add 0. Both of shape (samples,).
        """
        columns = told_of(drivers, self.span)
        inside = np.ones(len(drivers.motion), bool)
        for name, recorded_driver in self.recorded.items():
            low, high = float(recorded_driver.min()), float(recorded_driver.max())
            room = ROOM * max(high - low, abs(high) * ROOM)
            inside &= (columns[name] >= low - room) & (columns[name] <= high + room)
        apart = self.near.query(_in_ranges(columns, self.recorded, self.told), p=np.inf, distance_upper_bound=NEAR)[0]
        inside &= np.isfinite(apart)
        answer = self.predict(np.column_stack([columns[name] for name in self.told]))
        return np.where(inside, answer, 0.0), inside


def told_of(drivers: Drivers, span: float) -> dict[str, Array]:
    """The drivers that the trees may use, by name; corners of a drawn motion are rounded like recorded ones.

    Temperature is left out: it drifts with time, so that it would mark each stroke. `span` is in the motion's unit.
    Each driver has the shape (samples,), in its own unit.
    """
    return inputs(replace(drivers, drawn=False, temperature_c=None), span)


def _stacked(parts: Sequence[Array], rows: Sequence[Mask]) -> Array:
    return np.concatenate([part[mask] for part, mask in zip(parts, rows, strict=True)])


def _in_ranges(columns: dict[str, Array], recorded: dict[str, Array], names: Sequence[str]) -> Array:
    """Columns as shares of their recorded ranges, shape (rows, columns)."""
    ranges = {name: float(np.ptp(recorded[name])) or 1.0 for name in names}
    return np.column_stack([(columns[name] - recorded[name].min()) / ranges[name] for name in names])


@dataclass(frozen=True)
class Residual:
    """What a black box adds to a simulator's motion, its interval, and its error on unseen strokes.

    Sizes and errors (rms) are in the reading's unit; `runs` are those that it was fitted to.
    """

    added: Array  # (samples,)
    inside: Mask  # (samples,)
    half_width: float
    error_with: float
    error_without: float
    runs: tuple[str, ...]

    def within(self, rows: Mask) -> "Residual":
        """The last rows, with 0 where a mask is False; `rows` has the shape (last samples,)."""
        inside = self.inside[-len(rows) :] & rows
        return replace(self, inside=inside, added=np.where(inside, self.added[-len(rows) :], 0.0))

    @property
    def low(self) -> Array:
        """Lower end of the interval, of shape (samples,) in the reading's unit; no number where it says nothing."""
        return np.where(self.inside, self.added - self.half_width, np.nan)

    @property
    def high(self) -> Array:
        """Upper end of it, of shape (samples,) in the reading's unit; no number where it says nothing."""
        return np.where(self.inside, self.added + self.half_width, np.nan)


def residual(problem: Problem, content: Verdict, path: Path, recorded: list[RecordedRun], mend: str) -> Residual:
    """What a black box adds to the motion of `problem`, fitted to a diagnosis' residual on its own runs.

    Its error and its interval are those of a black box that, like its simulator, had not seen the last strokes. Raises
    BadInput for a diagnosis that does not hold that simulator, with `mend`.
    """
    runs = [each.run.run for each in recorded]
    before, seen_s = without_last.read(content, runs, path, mend)
    working = [make_problem([each], to_fit=False) for each in recorded]
    lessons, earlier = ([_lesson(*pair, simulator, path) for pair in zip(working, recorded, strict=True)]
                        for simulator in (content, before))  # fmt: skip
    driver_names = [set(told_of(each.drivers, 1.0)) for each in (*working, problem)]
    names = [name for name in told_of(problem.drivers, 1.0) if all(name in each for each in driver_names)]
    seen = [each.record.time_s < seen_s[run] for each, run in zip(working, runs, strict=True)]
    whole = BlackBox.fitted(lessons, [np.ones_like(mask) for mask in seen], names)
    part = BlackBox.fitted(earlier, seen, names)
    unseen_residuals = [_left_of_unseen(each, part, before, path, seen_s[each.run.run]) for each in recorded]
    alone, with_it = (np.concatenate([each[place] for each in unseen_residuals]) for place in (0, 1))
    half_width = float(np.quantile(np.abs(with_it), NINE_OF_TEN))
    added, inside = whole.added(problem.drivers)
    return Residual(added, inside, half_width, rms(with_it), rms(alone), tuple(runs))


def _lesson(problem: Problem, recorded: RecordedRun, simulator: Simulated, path: Path) -> Lesson:
    """The residual of a simulator on a run at its working rate, about its median where the zero was unknown."""
    run = recorded.run.run
    residual_of_run = problem.measured - tared(problem, simulator, path, run)
    unknown = problem.system.free_zero and not has_zero(simulator, problem.system, run)
    return Lesson(problem, residual_of_run - np.median(residual_of_run) if unknown else residual_of_run)


def _left_of_unseen(
    recorded: RecordedRun, box: BlackBox, simulator: Simulated, path: Path, seen_s: float
) -> tuple[Array, Array]:
    """The residual on unseen strokes, of the simulator alone and with a black box, scored as in `held_out`.

    Each of shape (unseen samples,), in the reading's unit, lonely wild readings left out.
    """
    problem = to_score([recorded])
    alone = problem.measured - tared(problem, simulator, path, recorded.run.run)
    with_it = alone - box.added(problem.drivers)[0]
    unseen = problem.record.time_s >= seen_s
    return alone[unseen & ~wild(alone)[0]], with_it[unseen & ~wild(with_it)[0]]
