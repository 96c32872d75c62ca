"""Each mechanism of the library, fitted to the residual of a frozen calibration: the best by BIC, if clearly better.

Source: BIC: Schwarz, "Estimating the dimension of a model", Annals of Statistics 6, 1978.
"""

from ...diagnosis.choice import candidates
from ...diagnosis.choice.search import LEAST_GAIN, Search
from ...diagnosis.fit import calibrate
from ...diagnosis.fit.linear import Linear
from ...diagnosis.fit.problem import Problem, State
from ...diagnosis.mechanisms.interface import physics
from ...diagnosis.numerics.noise import white
from ...diagnosis.study import engine
from ...ground.kinematics import Array
from .frozen import frozen
from .learnt import Calibrated, Learnt


def learn(seen: Calibrated) -> Learnt:
    """One mechanism or none, its nonlinear parameters refined; the zero stays free, dimensions are frozen."""
    problem = frozen(seen.problem, seen.state)
    catalogue = candidates.catalogue(problem, candidates.suggested(problem, seen.state))
    physical = {id_: options for id_, options in catalogue.items() if physics((id_,))}
    floor = engine.noise_of(problem, seen.state).floor
    noise = white(floor)
    search = Search(Linear(problem, seen.state, noise, physical))
    best = search.all_of(1)[0]
    named: list[str] = []
    state = seen.state
    if best.cost <= search.nothing.cost - LEAST_GAIN:
        named = list(best.ids)
        state = calibrate.refine(problem, noise, search.linear.state_of(best.fit, best.keys))

    def adds_mm(other: Problem) -> Array:
        return change_mm(other, seen.state, state)

    return Learnt(named, adds_mm)


def change_mm(problem: Problem, before: State, after: State) -> Array:
    """The difference of two simulators' readings, shape (samples,)."""
    return problem.simulate(after) - problem.simulate(before)
