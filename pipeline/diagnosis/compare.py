"""Compare by Cox's idea: an explanation beats another if the gap between them is as large as its truth implies."""

from pipeline.diagnosis.search import Explanation, Search

CONTENDER = 0.75  # of the best one's gain: less is no contender
LEAST_GAP = 10.0
SHARE = 0.4  # of the expected gap that must be seen


def price(search: Search, one: Explanation) -> float:
    """Misfit, and two numbers (when, how much) for every sudden event after the first of its kind."""
    return one.fit.misfit + 2.0 * search.penalty * (len(one.keys) - len(one.ids))


def beats(search: Search, one: Explanation, other: Explanation) -> bool:
    """Whether the recording tells `one` from `other`."""
    seen = price(search, other) - price(search, one)
    if seen <= LEAST_GAP:
        return False
    expected = search.linear.gap(one.fit, other.fit.columns)
    return expected > LEAST_GAP and seen > SHARE * expected


def unbeaten(search: Search, chosen: Explanation, floor: float) -> list[Explanation]:
    """Every explanation as small as the chosen one that no other beats, the best first."""
    if not chosen.ids:
        return []
    nothing = search.nothing.fit.misfit
    rivals = search.all_of(len(chosen.ids))
    whole = nothing - min(rival.fit.misfit for rival in rivals)
    close = [rival for rival in rivals if nothing - rival.fit.misfit >= CONTENDER * whole]
    left = [rival for rival in close if not any(beats(search, other, rival) for other in close if other is not rival)]
    return sorted(left or [chosen], key=lambda one: one.cost)
