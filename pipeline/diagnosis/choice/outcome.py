"""What a study found, and the verdict on it."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

import numpy as np

from ..document.content import VerdictWord
from ..fit import discrepancy
from ..fit.calibrate import calibrate
from ..fit.problem import Problem, State
from ..mechanisms.interface import Nonlinear, physics
from ..mechanisms.library import mechanisms
from ..numerics.noise import Noise
from . import chance
from .excursions import Excursion, excursions
from .judged import UNKNOWN, Judged
from .search import EXPLAINED, LEAST_EFFECT, Explanation, Search

UNKNOWN_FROM = 0.35  # noise floors of mismatch that no noise makes
SWALLOWED = 0.1  # of the noise, that the dictionary may take without making its floor doubtful
PARAMETERS_FROM = 0.15  # noise floors of improvement that make moved parameters worth a verdict
HELPED = 0.7  # of the mismatch (half of its energy): a helper that takes more counts as the explanation
CANCELS = 8.0  # times the joint effect: a single effect that is larger is balanced by another one


@dataclass(frozen=True)
class Study:
    """Everything that one pass over a recording found."""

    problem: Problem
    nominal: State
    base: State
    noise: Noise
    verdict: VerdictWord
    state: State  # with what was named, or the base
    best: State  # the best that the library offers, whatever the verdict
    sets: list[Explanation]
    search: Search
    share: float  # of the mismatch's energy that the best explanation takes
    mismatch: float  # rms after calibration, noise taken off
    floor: float  # of the noise: at rest, where something random is at work in motion
    random: dict[str, Nonlinear]  # what was seen of mechanisms whose every move is chance
    random_rms: float
    judged: Judged  # how likely each explanation is
    closest: State | None = None  # of an unknown mismatch, what foretells it better by far than dimensions alone
    gone_off: tuple[Excursion, ...] = ()  # of a reading that nothing explains
    spreads: dict[str, float] = field(default_factory=dict)  # least sigma of dimensions, where not all left is noise

    @property
    def simulator(self) -> State:
        """The state that predicts the rig: with the named effects, else with the closest ones, else calibration."""
        return self.closest or self.state

    def beside_chance(self, ids: tuple[str, ...]) -> tuple[str, ...]:
        """An explanation with the random effects that were seen: unweighed, they belong to each explanation."""
        return with_random(ids, self.random)

    def without_chance(self, ids: tuple[str, ...]) -> tuple[str, ...]:
        """The part of an explanation that was weighed: its ids without random effects."""
        return tuple(id_ for id_ in ids if id_ not in self.random)

    def explanation(self, ids: tuple[str, ...]) -> Explanation:
        """The best explanation by these mechanisms; a random effect in it has no curve that could be fitted."""
        return replace(self.search.explain(self.without_chance(ids) or ids), ids=ids)

    @property
    def best_ids(self) -> tuple[str, ...]:
        """Ids that the best explanation names."""
        return tuple(act.id for act in self.best.acts if act not in self.problem.included)


def rms(values: np.ndarray) -> float:
    """Root of the mean square. Values of any shape, in their unit."""
    return float(np.sqrt(np.mean(np.square(values))))


def decide(
    problem: Problem,
    nominal: State,
    base: State,
    noise: Noise,
    best: State,
    judged: Judged,
    search: Search,
    random: dict[str, Nonlinear],
) -> Study:
    """The verdict, from what is left after calibration and after the best explanation, and from the judge."""
    sets = judged.sets
    seen = slice(0, problem.rows)
    rms_by_state = {
        name: rms((problem.measured - problem.simulate(state))[seen])
        for name, state in (("nominal", nominal), ("base", base), ("best", best))
    }
    floor, jerks = noise.floor, 0.0
    if random:
        quiet = chance.floor_at_rest(problem, best, noise.floor)
        jerks = float(np.sqrt(max(rms_by_state["best"] ** 2 - quiet**2, 0.0)))
        floor, random = (quiet, random) if LEAST_EFFECT * quiet <= jerks <= chance.most(random) else (floor, {})
    mismatch = float(np.sqrt(max(rms_by_state["base"] ** 2 - floor**2, 0.0)))
    remainder = float(np.sqrt(max(rms_by_state["best"] ** 2 - noise.floor**2, 0.0)))
    share = 1.0 - remainder**2 / max(mismatch**2, 1e-300)
    better = rms_by_state["nominal"] ** 2 - rms_by_state["base"] ** 2
    new = {id_: nonlinear for id_, nonlinear in random.items() if id_ not in {act.id for act in problem.included}}
    if new:
        together: dict[tuple[str, ...], Explanation] = {}
        for explanation in sets or [search.nothing]:  # with and without the random effect is one explanation then
            ids = with_random(explanation.ids, new)
            together.setdefault(ids, replace(explanation, ids=ids))
        sets, judged = list(together.values()), replace(judged, likely=_likely_beside(judged.likely, new))
        acting = {act.id for act in best.acts}  # an explanation that holds it needs no second, silent one
        silent = [chance.act(problem, id_, nonlinear) for id_, nonlinear in new.items() if id_ not in acting]
        best = replace(best, acts=(*best.acts, *silent))
    gone_off = () if sets or random else tuple(excursions(problem, base))
    verdict: VerdictWord
    if not sets:
        verdict = "unknown" if gone_off or (not random and mismatch > surely(noise) * floor) else "consistent"
        if verdict == "consistent" and better > (PARAMETERS_FROM * floor) ** 2:
            verdict = "parameters"
    elif (
        not physics(sets[0].ids)
        or cancels(problem, best)
        or helped(problem, best, mismatch)
        or (judged.sets and judged.none >= UNKNOWN)  # of jerks alone the judge weighed nothing
        or (not new and share < EXPLAINED and remainder > LEAST_EFFECT * floor)
    ):
        verdict = "unknown"
    else:
        verdict = "explained" if len(sets) == 1 else "ambiguous"
    explained = (1.0 - EXPLAINED) * bare(problem, noise) ** 2 if problem.adopted and verdict == "unknown" else 0.0
    # noise, or what an adopted explanation may leave, is nothing unknown
    if verdict == "unknown" and not gone_off and mismatch**2 <= max((UNKNOWN_FROM * floor) ** 2, explained):
        verdict = "parameters" if better > (PARAMETERS_FROM * floor) ** 2 else "consistent"
    state = best if verdict in ("explained", "ambiguous") else base
    jerks *= bool(new)
    return Study(
        problem, nominal, base, noise, verdict, state, best, sets, search, share, mismatch, floor, new, jerks,
        judged, gone_off=gone_off,
    )  # fmt: skip


def with_random(ids: tuple[str, ...], random: Iterable[str]) -> tuple[str, ...]:
    """Ids of an explanation and of random effects, sorted; the same ids where no random effect was seen."""
    return tuple(sorted({*ids, *random})) if random else ids


def _likely_beside(likely: dict[tuple[str, ...], float], random: Iterable[str]) -> dict[tuple[str, ...], float]:
    """Probabilities of explanations, in shares of 1, with random effects added; stand-ins alone stay unchanged."""
    together: dict[tuple[str, ...], float] = {}
    for ids, share in likely.items():
        beside = with_random(ids, random) if physics(ids) else ids
        together[beside] = together.get(beside, 0.0) + share
    return together


def bare(problem: Problem, noise: Noise) -> float:
    """The rms that calibration would leave without the effects that `run.yaml` adopted, noise taken off."""
    without = replace(problem, included=problem.beside)
    bare_rms = rms((problem.measured - without.simulate(calibrate(without, noise)))[: problem.rows])
    return float(np.sqrt(max(bare_rms**2 - noise.floor**2, 0.0)))


def surely(noise: Noise) -> float:
    """The mismatch in noise floors that no noise makes; it is larger where the floor itself is known badly.

    In a short recording of slow noise the dictionary swallows much of the noise. Its loudness is then an estimate.
    """
    doubt = 0.5 * max(noise.swallowed - SWALLOWED, 0.0)
    return float(np.sqrt((np.hypot(1.0, UNKNOWN_FROM) + doubt) ** 2 - 1.0))


def cancels(problem: Problem, state: State) -> bool:
    """Whether the named effects are far larger than what they do together: such a balance is no explanation."""
    effects = [discrepancy.effect(problem, state, act.id) for act in state.acts if act not in problem.included]
    together = float(np.std(np.sum(effects, axis=0))) if len(effects) > 1 else np.inf
    return max((float(np.std(effect)) for effect in effects), default=0.0) > CANCELS * together


def helped(problem: Problem, state: State, mismatch: float) -> bool:
    """Whether a helper, which is no physics, takes most of a mismatch."""
    helpers = [act.id for act in state.acts if act not in problem.included and mechanisms()[act.id].helper]
    sizes = [float(np.std(discrepancy.effect(problem, state, id_)[: problem.rows])) for id_ in helpers]
    return max(sizes, default=0.0) > HELPED * mismatch
