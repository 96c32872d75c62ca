"""The diagnosis, step by step: calibrate, noise, search, refine, judge, decide. It knows no mechanism by name."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ...ground.errors import BadInput
from ...ground.words.counts import counted
from ...systems import System
from ...systems.interface import PORTS
from ..choice import candidates, chance
from ..choice.closest import with_closest
from ..choice.judged import NOTHING, judged
from ..choice.kept import kept
from ..choice.outcome import Study, bare, decide, rms
from ..choice.search import Explanation, Search
from ..fit import calibrate, discrepancy, generic
from ..fit.adopt import acts_from
from ..fit.linear import Linear
from ..fit.problem import Problem, State, placed
from ..mechanisms.library import mechanisms
from ..numerics.judge import Judge, judge
from ..numerics.noise import Noise, estimate, robust, white
from ..recording.drivers import Drivers, drivers_of
from ..recording.recorded_run import RecordedRun
from ..recording.working_samples import DRIVES_SAMPLES, WORKING_SAMPLES, joined
from . import motor_zeros
from .beside import clearer, with_stand_ins

ADOPTED = 0.1  # of the mismatch before effects were adopted: a smaller rest comes from their inexact formulas
SURPRISES = 0.3  # of the blocks of a recording, in which something unnamed may have happened
GUESSED = 0.5  # of a noise, that the columns took: a noise of which more is taken is a guess
TOO_LOUD = 1.2  # times an explanation's residual: a larger noise floor holds structure
LEAST_SAMPLES, LEAST_STROKES = 200, 2  # least number of samples, and of whole strokes, for a diagnosis
Progress = Callable[[str], None]


def make_problem(
    recorded: list[RecordedRun],
    most: int | None = None,
    without: frozenset[str] = frozenset(),
    thin: bool = True,
    by: Judge | None = None,
    to_fit: bool = True,
) -> Problem:
    """The problem of one or more runs of one rig, averaged to `most` samples (the working number); raises BadInput.

    No explanation of it may name the mechanisms in `without`. Unless `thin`, a working rate is no reason to average.
    `by` judges in place of the library's own judge. Unless `to_fit`, it may be too short to be diagnosed.
    """
    runs, where = [each.run for each in recorded], recorded[0].place
    system = runs[0].system
    record = joined(recorded, most or (WORKING_SAMPLES if system.levered else DRIVES_SAMPLES), thin)
    worked = len(np.unique(record.stroke[record.stroke > 0]))
    mend = "record at least three strokes, with a pause between them"
    if to_fit and worked < LEAST_STROKES:
        few = f"holds {worked} stroke{'s' * (worked != 1)}: what comes with time cannot be told from what comes with "
        raise BadInput(where, "recording", f"{few}the motion", mend)
    if to_fit and len(record) < LEAST_SAMPLES:
        raise BadInput(
            where, "recording", f"holds {counted(len(record), 'sample')}, of which {LEAST_SAMPLES} are needed", mend
        )
    drivers = drivers_of(system, record, runs[0])
    zeros = motor_zeros.of_runs(system, runs)
    nowhere = unplaced(system, drivers)
    for number, entry in enumerate(runs[0].simulation):
        if entry.get("id") in nowhere:
            problem = f"{entry['id']} acts where a {system.name} has nothing"
            raise BadInput(where / "run.yaml", f"simulation[{number}].id", problem, "remove it")
    included = acts_from(runs[0].simulation, drivers, str(where / "run.yaml"))  # what the simulator has already
    return Problem(
        system, record, drivers, (*system.parameters(runs[0]), *zeros), record.measured, len(record), included,
        len(zeros), without | nowhere, by or judge(), motor_zeros.one_string(runs),
    )  # fmt: skip


def unplaced(system: System, drivers: Drivers) -> frozenset[str]:
    """Mechanisms whose candidates all act at ports that the system lacks."""
    if set(system.ports) == set(PORTS):
        return frozenset()
    library = [(id_, mechanism, mechanism.candidates(drivers)) for id_, mechanism in mechanisms().items()]
    return frozenset(
        id_
        for id_, mechanism, options in library
        if options and not any(placed(system, mechanism.terms(drivers, nonlinear)) for nonlinear in options)
    )


def fine_floor(fine: Problem, studied: Study) -> float:
    """Noise floor at the recording's own rate: the working floor plus the noise that averaging took off."""
    if len(fine.record) == len(studied.problem.record):
        return studied.noise.floor
    own = robust(fine.measured - fine.simulate(studied.best))
    averaged = robust(studied.problem.measured - studied.problem.simulate(studied.best))
    return float(np.sqrt(max(rms(own) ** 2 - rms(averaged) ** 2, 0.0) + studied.floor**2))


def noise_of(problem: Problem, state: State, smooth: np.ndarray | None = None, trim: float = 0.0) -> Noise:
    """The noise of a state's residual, beside all that calibration, its acts and the generic dictionary can do.

    `smooth` is the dictionary, shape (columns, samples), in any unit, if it is made already: one made here is let go.
    """
    acts = tuple(act for act in state.acts if act not in problem.included)
    catalogue = {act.id: list(act.nonlinear) for act in acts}
    more = generic.dictionary(problem.drivers) if smooth is None else smooth
    linear = Linear(problem, state, white(1.0), catalogue, more)
    del more
    columns = linear.table[:-1]
    target = (problem.measured - problem.simulate(state))[: problem.rows]
    return estimate(target, columns, problem.drivers.first[: problem.rows], problem.drivers.step_s, trim)


def study(problem: Problem, say: Progress = lambda _: None) -> Study:
    """The whole procedure on the rows that the problem shows; again if stand-ins take up what named effects leave.

    What is named then counts if it is clearer.
    """
    first = with_homes(problem, say)
    taken = with_stand_ins(first)
    if taken is None:
        return first
    again = with_homes(taken, say)
    return replace(again, nominal=first.nominal) if clearer(again, first) else first


def with_homes(problem: Problem, say: Progress) -> Study:
    """The procedure with one simulator; twice where a break between runs may mislead it."""
    if not (problem.homed and problem.stays):
        return studied_once(problem, say)
    with_held_zeros = studied_once(motor_zeros.held(problem), say)
    return studied_once(problem, say) if motor_zeros.moved(problem, with_held_zeros) else with_held_zeros


def studied_once(problem: Problem, say: Progress) -> Study:
    """The whole procedure, with the motor's zeros of later runs as free as the problem has them."""
    say("calibrating")
    nominal = problem.nominal()
    base = calibrate.base(problem)
    problem, _ = calibrate.without_outliers(problem, base)
    base = calibrate.base(problem)
    more = candidates.suggested(problem, base)
    smooth = candidates.without_physics(problem, more)
    say("noise floor and colour")
    noise = noise_of(problem, base, smooth, SURPRISES)
    catalogue = candidates.catalogue(problem, more)
    random = chance.seen(problem, base)
    least = chance.LEAST_BESIDE * chance.size(problem, base, random)
    if problem.adopted:  # what was adopted is as inexact as any formula
        least = max(least, ADOPTED * bare(problem, noise))
    say("searching explanations")
    search = Search(Linear(problem, base, noise, catalogue), least)
    chosen, best = search.select(noise.floor, largest=1), base
    if chosen.ids:
        for step in ("one mechanism", "several mechanisms", "several mechanisms again"):
            say(f"refining {step}")
            states = [search.linear.state_of(leader.fit, leader.keys) for leader in search.leaders(chosen)]
            refined = [calibrate.refine(problem, noise, state) for state in states]
            own = [noise_of(problem, state, smooth) for state in refined]
            place = clearest(problem, own, refined)
            best, noise = refined[place], own[place]
            catalogue = candidates.with_refined(problem, catalogue, refined)
            deviations = discrepancy.columns(problem, [best, *(state for state in refined if state is not best)])
            del search  # it is large, and the next one is as large
            search = Search(Linear(problem, best, noise, catalogue, deviations=deviations), least)
            before, chosen = chosen, search.select(noise.floor)
            is_settled = len(chosen.ids) == len(before.ids) or step == "several mechanisms"
            if not chosen.ids or (is_settled and not too_loud(noise, chosen)):
                break
    say("judging")
    judgement = judged(search, base, chosen, noise.floor) if chosen.ids else NOTHING
    best, judgement = kept(search, judgement, base)
    still = chance.seen(problem, best) if random else {}  # what an explanation takes away was not chance
    random = {id_: nonlinear for id_, nonlinear in random.items() if id_ in still}
    return with_closest(decide(problem, nominal, base, noise, best, judgement, search, random))


def too_loud(noise: Noise, chosen: Explanation) -> bool:
    """Whether a noise is larger than the residual of the explanation: it was estimated with a state that fits worse."""
    return noise.floor > TOO_LOUD * float(np.sqrt(chosen.energy))


def clearest(problem: Problem, own: list[Noise], refined: list[State]) -> int:
    """Place of the likeliest of several states, each beside the noise that it leaves, in the reading's unit.

    A state whose noise is a guess comes after those whose noise is seen: a slow misfit that the columns take in part
    passes for noise with a long memory, which looks likelier than it is.
    """
    return min(
        range(len(own)), key=lambda place: (own[place].swallowed > GUESSED, bic(problem, own[place], refined[place]))
    )


def bic(problem: Problem, noise: Noise, state: State) -> float:
    """Bayesian information criterion of a state: minus twice its log-likelihood, and ln n for each number that acts.

    The likelihood is under the noise that the state itself leaves (Schwarz, 1978).
    """
    active = sum(value != 0.0 for act in state.acts for value in act.coefficients)
    return 2.0 * problem.rows * float(np.log(noise.innovation)) + active * float(np.log(problem.rows))
