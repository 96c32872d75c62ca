"""Calibration: the joint bounded fit of dimensions, zero and acts, iterated through the simulator itself.

Source: Björck, Numerical Methods for Least Squares Problems, 1996 (Gauss-Newton between bounds).
"""

from dataclasses import replace

import numpy as np

from ..mechanisms.interface import Nonlinear
from ..mechanisms.library import mechanisms
from ..numerics.noise import Noise, white
from ..recording.working_samples import wild
from .gauss_newton import Steps
from .linear import Key, Linear
from .problem import Act, Problem, State

ITERATIONS = 4  # linearised steps of full reach in a calibration, at most
MOST_STEPS = 25  # steps in all, where whole ones lead astray
REFINEMENTS = 3  # rounds of a search between the candidates of a nonlinear parameter, with ever smaller steps
FEW = 5  # values among the candidates: fewer are kinds, more are samples of a continuous parameter
EVENT_REFINEMENTS = 8  # the same for an event: when something happened suddenly must be known to a sample
FIRST_STEP, NEARER = 0.6, 0.55  # first step, as a share of the way to the next candidate; factor on each further step
MOST_WILD = 0.03  # of the samples: if more are wild, they are no lonely readings


def calibrate(problem: Problem, noise: Noise, state: State | None = None, acts: tuple[Act, ...] = ()) -> State:
    """Gauss-Newton from a state (the nominal one by default); the acts' coefficients are refitted, nonlinear ones kept.

    No step is taken that raises the misfit: it is made again within less of what the dimensions may move (`step`).
    """
    state = state or problem.nominal()
    catalogue = {act.id: list(act.nonlinear) for act in acts}
    keys: tuple[Key, ...] = tuple((act.id, number) for act in acts for number in range(len(act.nonlinear)))
    steps, whole = Steps(problem, noise, state, acts), 0
    for _ in range(MOST_STEPS):
        before, linear = steps.state, Linear(problem, steps.state, noise, catalogue)
        whole += steps.reach == 1.0
        if not steps.take(linear, keys):
            break
        moved = max(
            (abs(steps.state.values - before.values)[i] / problem.parameters[i].sigma for i in problem.movable),
            default=0.0,
        )
        if whole == ITERATIONS or (steps.reach == 1.0 and moved < 1e-3):
            break
    return steps.state


def _between(candidates: list[Nonlinear], nonlinear: Nonlinear, width: float, kinds: bool) -> list[Nonlinear]:
    """Values near one set, part of the way to its neighbouring candidates, along each parameter.

    With `kinds` a parameter of a few values takes each of them.
    """
    neighbours = []
    for name in nonlinear:
        others = sorted({other[name] for other in candidates if set(other) == set(nonlinear)})
        if len(others) < FEW:
            neighbours += [{**nonlinear, name: other} for other in others if kinds and other != nonlinear[name]]
            continue
        place = int(np.searchsorted(others, nonlinear[name]))
        lower, upper = others[max(place - 1, 0)], others[min(place + 1, len(others) - 1)]
        reach = max(upper - lower, 1e-9) / 2.0
        for side in (-1.0, 1.0):
            value = float(f"{nonlinear[name] + side * width * reach:.8g}")
            if others[0] <= value <= others[-1]:
                neighbours.append({**nonlinear, name: value})
    return neighbours


def refine(problem: Problem, noise: Noise, state: State) -> State:
    """Refine the nonlinear parameters of the acts between the grid's candidates, one mechanism after the other."""
    kinds = problem.drivers.levered  # the loop of a drive would be bent to anything by mixing its kinds
    price = float(np.log(problem.rows))  # of a coefficient, as the search has it: a kind may need fewer
    for level in range(EVENT_REFINEMENTS):
        for place, act in enumerate(state.acts):
            if act in problem.included or (level >= REFINEMENTS and mechanisms()[act.id].steps == 1):
                continue
            mechanism = mechanisms()[act.id]
            candidates = mechanism.candidates(problem.drivers)
            for number in range(len(act.nonlinear)):
                act = state.acts[place]
                beside = _between(candidates, act.nonlinear[number], FIRST_STEP * NEARER**level, kinds)
                others = [*act.nonlinear[:number], *act.nonlinear[number + 1 :]]
                beside = [
                    each
                    for each in beside
                    if mechanism.tells(problem.drivers, each)
                    and not any(mechanism.at_once(problem.drivers, each, other) for other in others)
                ]
                near = [act.nonlinear[number], *beside]
                if len(near) == 1:
                    continue
                own = [other for other in state.acts if other not in problem.included]
                catalogue = {other.id: list(other.nonlinear) for other in own}
                fixed = [
                    (other.id, i)
                    for other in own
                    for i in range(len(other.nonlinear))
                    if (other.id, i) != (act.id, number)
                ]
                catalogue[act.id] = catalogue[act.id] + near[1:]
                count = len(act.nonlinear)
                linear = Linear(problem, state, noise, catalogue)
                tries = []
                for option in [number, *range(count, count + len(near) - 1)]:
                    keys = tuple(sorted([*fixed, (act.id, option)], key=lambda key: list(catalogue).index(key[0])))
                    tries.append((linear.fit(linear.columns_of(keys)), keys))
                best, keys = min(tries, key=lambda item: item[0].misfit + price * item[0].active)
                state = linear.state_of(best, keys)
        if level >= REFINEMENTS and all(mechanisms()[act.id].steps == 1 for act in state.acts):
            break
        acting = tuple(act for act in state.acts if act not in problem.included)
        state = calibrate(problem, noise, state, acting)
    return state


def without_outliers(problem: Problem, state: State) -> tuple[Problem, int]:
    """The problem with lonely wild readings moved to their neighbours' residual, and how many they were."""
    far, gap = wild(problem.measured - problem.simulate(state))
    if not 0 < far.sum() <= MOST_WILD * len(far):
        return problem, 0
    return replace(problem, measured=np.where(far, problem.measured - gap, problem.measured)), int(far.sum())


def base(problem: Problem) -> State:
    """The simulator with only its dimensions calibrated, all samples weighed alike."""
    nominal = problem.nominal()
    floor = float(np.std((problem.measured - problem.simulate(nominal))[: problem.rows]))
    first = calibrate(problem, white(max(floor, 1e-9)))
    residual = (problem.measured - problem.simulate(first))[: problem.rows]
    return calibrate(problem, white(max(float(np.std(np.diff(residual))) / np.sqrt(2.0), 1e-9)), first)
