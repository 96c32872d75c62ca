"""Compare by Cox's idea: an explanation beats another if the gap between them is about as large as its truth implies."""

from pipeline.diagnosis.search import Explanation, Search

CONTENDER = 0.75  # of the best one's gain: less is no contender
LEAST_GAP = 10.0
SHARE = 0.4  # of the expected gap that must be seen


def beats(search: Search, one: Explanation, other: Explanation) -> bool:
    """Whether the recording tells `one` from `other`."""
    seen = other.fit.misfit - one.fit.misfit
    if seen <= LEAST_GAP:
        return False
    expected = search.linear.gap(one.fit, other.fit.columns)
    return expected > LEAST_GAP and seen > SHARE * expected


def unbeaten(search: Search, chosen: Explanation, floor: float) -> list[Explanation]:
    """Every explanation as small as the chosen one that the recording cannot rule out, the chosen one first."""
    if not chosen.ids:
        return []
    whole = search.nothing.fit.misfit - chosen.fit.misfit
    contenders = [
        rival
        for rival in search.all_of(len(chosen.ids))
        if rival.ids != chosen.ids and search.nothing.fit.misfit - rival.fit.misfit >= CONTENDER * whole
    ]
    return [chosen, *(rival for rival in contenders if not beats(search, chosen, rival))]
