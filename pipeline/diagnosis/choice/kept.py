"""Which likely explanations are names, why the others are left out, and the simulator with the best name in it."""

from dataclasses import replace

from ..fit import calibrate
from ..fit.linear import Linear
from ..fit.problem import State
from ..numerics.noise import white
from .judged import Judged, LeftOut
from .outcome import cancels, rms
from .recalibration import in_disguise, no_name
from .search import Explanation, Search

INEXACT_FROM = 0.2  # noise floors between two ways to weigh the samples: more shows that no formula is exact


def kept(search: Search, judgement: Judged, base: State) -> tuple[State, Judged]:
    """The simulator with the best explanation that is a name, and the judgement with the explanations left out.

    `base` is the calibrated simulator. An effect that dimensions could imitate is no name. Effects that cancel each
    other are not a rival explanation.
    """
    problem = search.linear.problem
    dimensions = Linear(problem, base, white(1.0), {})
    sets, out = [], list(judgement.left_out)
    for explanation in judgement.sets:
        if why := in_disguise(search.linear, explanation, dimensions):
            out.append(LeftOut(explanation.ids, *why))
        else:
            sets.append(explanation)
    best = at_work(search, sets[0]) if sets else base
    while sets and (why := _why_not(search, best, dimensions, len(sets))):
        out.append(LeftOut(sets[0].ids, *why))
        sets = sets[1:]
        best = at_work(search, sets[0]) if sets else base
    return best, replace(judgement, sets=sets, left_out=tuple(out))


def _why_not(search: Search, best: State, dimensions: Linear, sets: int) -> tuple[str, tuple[str, ...]] | None:
    """Why the best of so many sets is no name once refined, and by which of its effects; None where it is one."""
    why = no_name(search.linear.problem, best, dimensions)
    return why or (("cancels", ()) if sets > 1 and cancels(search.linear.problem, best) else None)


def at_work(search: Search, explanation: Explanation) -> State:
    """The simulator with an explanation in it, fitted again through the simulator itself, without linearisation.

    Where the formula is right, weighing samples alike gives what weighing them by their noise gives, but for chance.
    Where the two part, what is left is misfit and no noise, and plain least squares is what a person would want; so it
    is where the reading follows derivatives, as those who identify inverse dynamics have found.
    """
    problem, noise = search.linear.problem, search.linear.noise
    best = calibrate.refine(problem, noise, search.linear.state_of(explanation.fit, explanation.keys))
    acts = tuple(act for act in best.acts if act not in problem.included)
    alike = calibrate.calibrate(problem, white(noise.floor), best, acts)
    apart = rms((problem.simulate(best) - problem.simulate(alike))[: problem.rows])
    return alike if problem.system.differentiates or apart > INEXACT_FROM * noise.floor else best
