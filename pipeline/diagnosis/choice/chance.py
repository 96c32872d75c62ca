"""Effects that move at random: a recording shows that they are there and how large they are; nothing predicts them.

Source: our own; what it can and cannot do is in docs/diagnosis.md, "Random events".
"""

import numpy as np
from scipy.ndimage import uniform_filter1d

from ...ground.kinematics import Array
from ...ground.numbers import spans
from ..fit.problem import Act, Problem, State
from ..mechanisms.interface import Nonlinear
from ..mechanisms.library import mechanisms

LEAST_BESIDE = 0.7  # of the random effect's size: a mechanism that takes away less only follows a trend of chance
MOST = 10.0  # of a random effect's largest move: a larger residual is not its own (0.2 to 2.6 on jerking rigs)
STILL = 0.01  # of the highest rate: slower is a rest
LEAST_REST_S = 1.0  # shorter is no rest


def left(problem: Problem, state: State) -> Array:
    """The residual of the samples that a fit sees. Shape (rows,), in the reading's unit."""
    return (problem.measured - problem.simulate(state))[: problem.rows]


def seen(problem: Problem, state: State) -> dict[str, Nonlinear]:
    """By mechanism, the nonlinear parameters of the random effect that a residual shows."""
    residual, predicted = left(problem, state), problem.simulate(state)[: problem.rows]
    random_by_id = {
        id_: mechanism.random(problem.drivers, residual, predicted) for id_, mechanism in problem.library.items()
    }
    return {id_: nonlinear for id_, nonlinear in random_by_id.items() if nonlinear is not None}


def act(problem: Problem, id_: str, nonlinear: Nonlinear) -> Act:
    """A random effect as it enters the simulator: it is named and adds nothing."""
    return Act(id_, (nonlinear,), (0.0,) * len(problem.terms(mechanisms()[id_], nonlinear)))


def floor_at_rest(problem: Problem, state: State, otherwise: float) -> float:
    """Standard deviation of the residual within rests, each about its mean; `otherwise` where there are too few."""
    residual, drivers = left(problem, state), problem.drivers
    rate = np.abs(drivers.rate[: problem.rows])
    still = rate < STILL * rate.max()
    squares, count = 0.0, 0
    for start, end in spans.of_mask(still):
        if (end - start) * drivers.step_s >= LEAST_REST_S and end - start > 10:
            part = residual[start + 2 : end - 2]
            squares += float(np.sum(np.square(part - part.mean())))
            count += len(part) - 1
    return min(float(np.sqrt(squares / count)), otherwise) if count > 50 else otherwise


def size(problem: Problem, state: State, random: dict[str, Nonlinear]) -> float:
    """The rms of a residual beyond its floor at rest, as far as these random effects can make it; 0 without any."""
    if not random:
        return 0.0
    whole = float(np.std(left(problem, state)))
    beyond = float(np.sqrt(max(whole**2 - floor_at_rest(problem, state, whole) ** 2, 0.0)))
    return min(beyond, most(random))


def most(random: dict[str, Nonlinear]) -> float:
    """The rms that random effects can leave at most, by the largest move of each, in the reading's unit."""
    return MOST * max(nonlinear[mechanisms()[id_].largest_move] for id_, nonlinear in random.items())


def trace(problem: Problem, state: State, floor: float) -> Array:
    """How large the residual is from second to second, its noise taken off: where a random effect was at work.

    Shape (samples,), in the reading's unit.
    """
    width = max(int(1.0 / problem.drivers.step_s), 5)
    power = uniform_filter1d(np.square(problem.measured - problem.simulate(state)), width)
    return np.asarray(np.sqrt(np.maximum(power - floor**2, 0.0)))
