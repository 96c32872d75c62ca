"""Probabilities of explanations → the sets that a verdict holds, the likeliest first."""

from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ..fit.problem import State
from ..mechanisms.interface import physics
from ..numerics.judge import Weighed
from . import compare, cross_validation
from .search import Explanation, Search
from .three_instead import far_better, three_instead
from .weigh import weighed

HELD = 0.8  # of the probability of all explanations: the sets of a verdict hold at least this together
TAUGHT = 2  # effects in a lesson at most
POOR = 2.5  # noise floors: the likeliest explanation that leaves more stands behind three effects as likely
UNKNOWN = 0.4  # probability of "none of them" from which on the verdict is `unknown`


@dataclass(frozen=True)
class LeftOut:
    """A likely explanation that is no name: `because` is the reason (`recalibration.py`), `of` the effects."""

    ids: tuple[str, ...]
    because: str
    of: tuple[str, ...]


@dataclass(frozen=True)
class Judged:
    """The held explanations, the likeliest first; the probability of each weighed set and of "none of them"."""

    sets: list[Explanation]
    likely: dict[tuple[str, ...], float]
    none: float
    weighed: tuple[Weighed, ...] = ()  # with their signs
    left_out: tuple[LeftOut, ...] = ()  # likely enough to be held, and no names

    def confidence(self, id_: str) -> float:
        """How likely a mechanism is at work, whatever is beside it; what is left out says nothing of it."""
        out = {each.ids for each in self.left_out}
        shares = {ids: share for ids, share in self.likely.items() if ids not in out}
        with_it = sum(share for ids, share in shares.items() if id_ in ids)
        return float(with_it * sum(self.likely.values()) / max(sum(shares.values()), 1e-300))


NOTHING = Judged([], {}, 1.0)


def held(named: Array) -> list[int]:
    """Places of the held explanations, the likeliest first, from the probability of each.

    `named` has the shape (explanations,), in shares of 1.
    """
    likeliest = np.argsort(-named, kind="stable")
    reached = np.cumsum(named[likeliest]) / max(float(named.sum()), 1e-300)
    return [int(place) for place in likeliest[: int(np.argmax(reached >= HELD)) + 1]]


def as_likely(
    likely: dict[tuple[str, ...], float], sets: set[tuple[str, ...]], as_ids: tuple[str, ...]
) -> dict[tuple[str, ...], float]:
    """Probabilities in which some explanations together are as likely as another one, and whose sum is as before."""
    each = likely[as_ids] / max(len(sets), 1)
    raised = likely | {ids: max(each, likely.get(ids, 0.0)) for ids in sorted(sets)}
    scale = sum(likely.values()) / max(sum(raised.values()), 1e-300)
    return {ids: share * scale for ids, share in raised.items()}


def helpers_share(candidates: list[Weighed], named: Array) -> float:
    """Probability of explanations without physics of the library; it is added to that of "none of them".

    `named` has the shape (explanations,), in shares of 1.
    """
    return float(sum(share for candidate, share in zip(candidates, named, strict=True) if not physics(candidate.ids)))


def _more_is_needed(search: Search, likeliest: Explanation, chosen: Explanation, floor: float) -> bool:
    """Whether chosen effects have a further one than the likeliest explanation, or are far better than that."""
    if set(likeliest.ids) <= set(chosen.ids):
        return likeliest.ids != chosen.ids
    return far_better(chosen, likeliest, floor) and search.more(likeliest, chosen, floor)


def judged(search: Search, base: State, chosen: Explanation, floor: float) -> Judged:
    """The judgement on what a search found; `base` is the calibrated simulator, `floor` the noise floor.

    The judge was taught on strings. Where nothing is wound, `compare` does it.
    """
    if not search.linear.problem.drivers.levered:
        sets = cross_validation.by_prediction(search.linear, compare.unbeaten(search, chosen, floor))
        return Judged(sets, {explanation.ids: 1.0 / len(sets) for explanation in sets}, 0.0)
    candidates = weighed(search, base, floor)
    *shares, none = search.linear.problem.judge.probabilities(candidates).tolist()
    named = np.array(shares)
    untaught = np.array([len(candidate.ids) > TAUGHT for candidate in candidates])
    likeliest = search.explain(candidates[int(np.argmax(named))].ids)
    if len(chosen.ids) > TAUGHT and untaught.any() and _more_is_needed(search, likeliest, chosen, floor):
        # no lesson has three effects: where a third is worth much more than a discrepancy of formulas, it is taken
        named = np.where(untaught, named, 0.0)
        named *= (1.0 - none) / max(float(named.sum()), 1e-300)
    none += helpers_share(candidates, named)
    likely = {candidate.ids: float(share) for candidate, share in zip(candidates, named, strict=True)}
    named_sets = [candidates[place].ids for place in held(named)]
    first = named_sets[0]
    if instead := {three.ids for three in three_instead(search, search.explain(first), floor)}:
        unweighed = instead - set(likely)
        anew = weighed(search, base, floor) if unweighed else []
        candidates += [candidate for candidate in anew if candidate.ids in unweighed]
        instead &= {candidate.ids for candidate in candidates}  # the others lack a mark in the recording
        likely = as_likely(likely, instead, first)
        before = instead if search.explain(first).energy > (POOR * floor) ** 2 else {first}
        named_sets = sorted({*named_sets, *instead}, key=lambda ids: (-likely[ids], ids not in before, ids))
    return Judged([search.explain(ids) for ids in named_sets], likely, none, tuple(candidates))
