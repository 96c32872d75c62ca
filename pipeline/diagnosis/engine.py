"""The diagnosis, step by step: calibrate, noise, search, refine, compare, decide. It knows no mechanism and no system."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from pipeline.diagnosis import calibrate, compare, generic
from pipeline.diagnosis.adopt import acts_from
from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Shape
from pipeline.diagnosis.library import mechanisms, systems
from pipeline.diagnosis.linear import Linear
from pipeline.diagnosis.noise import Noise, estimate, robust, white
from pipeline.diagnosis.problem import Act, Problem, State
from pipeline.diagnosis.record import WORKING_SAMPLES, joined
from pipeline.diagnosis.search import LEAST_EFFECT, Explanation, Search
from pipeline.errors import BadInput
from pipeline.runs import Run

EXPLAINED = 0.8  # of the mismatch's energy: less is no explanation
PARAMETERS_FROM = 0.15  # noise floors of improvement that make moved parameters worth a verdict
LEAST_SAMPLES = 200
Progress = Callable[[str], None]


@dataclass(frozen=True)
class Study:
    """Everything that one pass over a recording found."""

    problem: Problem
    nominal: State
    base: State
    noise: Noise
    verdict: str
    state: State  # with what was named, or the base
    best: State  # the best that the library offers, whatever the verdict
    sets: list[Explanation]
    search: Search
    share: float  # of the mismatch's energy that the best explanation takes
    mismatch: float  # rms after calibration, noise taken off

    @property
    def best_ids(self) -> tuple[str, ...]:
        """Ids of what the best explanation names."""
        return tuple(act.id for act in self.best.acts if act not in self.problem.included)


def make_problem(
    runs: list[Run], tables: list[pd.DataFrame], folders: list[Path] | None = None, most: int = WORKING_SAMPLES
) -> Problem:
    """The problem of one or more runs of one rig, averaged to at most `most` samples; raises BadInput."""
    record = joined(runs, tables, most)
    worked = len(np.unique(record.stroke[record.stroke > 0]))
    if len(record) < LEAST_SAMPLES or worked < 1:
        where = (folders or [Path(runs[0].run)])[0]
        problem = f"{len(record)} samples with {worked} strokes decide nothing"
        raise BadInput(where, "recording", problem, "record at least three strokes, with a pause, at 10 Hz or more")
    system = systems()[runs[0].actuator]
    drivers = system.drivers(record, runs[0])
    parameters = tuple(system.parameters(runs[0]))
    return Problem(system, record, drivers, parameters, record.measured, len(record), adopted(runs[0], drivers))


def adopted(run: Run, drivers: Drivers) -> tuple[Act, ...]:
    """What `simulation:` of run.yaml says that the simulator already includes."""

    return acts_from(run.simulation, drivers)


def fine_problem(run: Run, table: pd.DataFrame) -> Problem:
    """The problem of a run at its own rate."""
    return make_problem([run], [table], most=len(table))


def fine_floor(runs: list[Run], tables: list[pd.DataFrame], found: Study) -> float:
    """Noise floor at the recording's own rate: the working floor and what averaging took off it."""
    problem = make_problem(runs, tables, most=sum(map(len, tables)))
    if len(problem.record) == len(found.problem.record):
        return found.noise.floor
    fine = robust(problem.measured - problem.simulate(found.best), 0.0)
    coarse = robust(found.problem.measured - found.problem.simulate(found.best), 0.0)
    return float(np.sqrt(max(np.mean(fine**2) - np.mean(coarse**2), 0.0) + found.noise.floor**2))


def catalogue(problem: Problem) -> dict[str, list[Shape]]:
    """All shapes of all mechanisms that the recording could show."""
    found = {id_: mechanism.shapes(problem.drivers) for id_, mechanism in mechanisms().items()}
    return {id_: shapes for id_, shapes in found.items() if shapes}


def noise_of(problem: Problem, state: State, smooth: np.ndarray) -> Noise:
    """Noise of what a state leaves, beside everything that calibration, its acts and the generic dictionary can do."""
    acts = tuple(act for act in state.acts if act not in problem.included)
    linear = Linear(problem, state, white(1.0), {act.id: list(act.shapes) for act in acts}, smooth)
    columns = linear.table[:-1]
    target = (problem.measured - problem.simulate(state))[: problem.rows]
    noise, _ = estimate(target, columns, problem.drivers.first[: problem.rows], problem.drivers.step_s)
    return noise


def rms(values: np.ndarray) -> float:
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def study(problem: Problem, say: Progress = lambda _: None) -> Study:
    """The whole procedure on the rows that the problem lets it see."""
    say("calibrating")
    nominal = problem.nominal()
    base = calibrate.base(problem)
    problem, _ = calibrate.without_outliers(problem, base)
    base = calibrate.base(problem)
    smooth = generic.dictionary(problem.drivers)
    say("noise floor and colour")
    noise = noise_of(problem, base, smooth)
    shapes = catalogue(problem)
    say("searching explanations")
    search = Search(Linear(problem, base, noise, shapes))
    chosen = search.select(noise.floor)
    best = search.linear.state_of(chosen.fit, chosen.keys)
    if chosen.ids:
        say("refining " + " + ".join(chosen.ids))
        best = calibrate.refine(problem, noise, best)
        noise = noise_of(problem, best, smooth)
        near = {id_: list(options) for id_, options in shapes.items()}
        for act in best.acts:
            if act not in problem.included:
                near[act.id] += [shape for shape in act.shapes if shape not in near[act.id]]
        search = Search(Linear(problem, best, noise, near))
        chosen = search.select(noise.floor)
        best = calibrate.refine(problem, noise, search.linear.state_of(chosen.fit, chosen.keys))
    say("comparing")
    sets = compare.unbeaten(search, chosen, noise.floor)
    return decide(problem, nominal, base, noise, best, sets, search)


def decide(
    problem: Problem, nominal: State, base: State, noise: Noise, best: State, sets: list[Explanation], search: Search
) -> Study:
    """The verdict, from what is left after calibration and after the best explanation."""
    seen = slice(0, problem.rows)
    left = {
        name: rms((problem.measured - problem.simulate(state))[seen])
        for name, state in (("nominal", nominal), ("base", base), ("best", best))
    }
    floor = noise.floor
    mismatch = float(np.sqrt(max(left["base"] ** 2 - floor**2, 0.0)))
    share = 1.0 - max(left["best"] ** 2 - floor**2, 0.0) / max(mismatch**2, 1e-300)
    if not sets:
        verdict = "unknown" if mismatch > unknown_from(search, floor) else "consistent"
        if verdict == "consistent" and left["nominal"] ** 2 - left["base"] ** 2 > (PARAMETERS_FROM * floor) ** 2:
            verdict = "parameters"
    elif share < EXPLAINED and np.sqrt(max(left["best"] ** 2 - floor**2, 0.0)) > LEAST_EFFECT * floor:
        verdict = "unknown"
    else:
        verdict = "explained" if len(sets) == 1 else "ambiguous"
    state = best if verdict in ("explained", "ambiguous") else base
    return Study(problem, nominal, base, noise, verdict, state, best, sets, search, share, mismatch)


def unknown_from(search: Search, floor: float) -> float:
    """Mismatch that no noise makes: what the generic dictionary must see before it counts without a name."""
    return 0.35 * floor
