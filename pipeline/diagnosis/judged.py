"""Probabilities of explanations → the sets that a verdict holds, the likeliest first."""

from dataclasses import dataclass

import numpy as np

from pipeline.diagnosis.problem import State
from pipeline.diagnosis.search import Explanation, Search
from pipeline.diagnosis.weigh import weighed
from pipeline.kinematics import Array

HELD = 0.8  # of the probability of all explanations, that the sets of a verdict have together at least
UNKNOWN = 0.5  # of the probability: "none of them" with more makes the verdict


@dataclass(frozen=True)
class Judged:
    """Explanations that are held, the likeliest first; how likely each weighed set is, and "none of them"."""

    sets: list[Explanation]
    likely: dict[tuple[str, ...], float]
    none: float

    def confidence(self, id_: str) -> float:
        """How likely a mechanism is at work, whatever is beside it."""
        return float(sum(share for ids, share in self.likely.items() if id_ in ids))


NOTHING = Judged([], {}, 1.0)


def held(named: Array) -> list[int]:
    """Places of the explanations that are held, the likeliest first, from the probability of each."""
    order = np.argsort(-named, kind="stable")
    reached = np.cumsum(named[order]) / max(float(named.sum()), 1e-300)
    return [int(place) for place in order[: int(np.argmax(reached >= HELD)) + 1]]


def judged(search: Search, base: State, floor: float) -> Judged:
    """What a search found, judged; `base` is the calibrated simulator, `floor` that of the noise."""
    some = weighed(search, base, floor)
    *named, none = search.linear.problem.judge.probabilities(some).tolist()
    places = held(np.array(named))
    likely = {one.ids: share for one, share in zip(some, named, strict=True)}
    return Judged([search.explain(some[place].ids) for place in places], likely, none)
