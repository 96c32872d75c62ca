"""Three mechanisms that explain without one of the likeliest explanation's, and leave far less than that does.

The judge was taught on two mechanisms at most. It prices a third one by what it adds to two others. Where two take the
place of one, that price says nothing: under loads that only rise, stretch and creep look like a plastic elongation.
"""

from ...ground.outside_library import is_outside
from .candidates import apart
from .search import Explanation, Search
from .weigh import amplitude

COUNT = 3  # mechanisms
MOST = 2  # such explanations, the cheapest
SEEN = 0.3  # noise floors beyond the noise: the likeliest explanation that leaves less leaves nothing to explain
LESS = 0.4  # of what the likeliest leaves beyond the noise: what leaves more may fit a wrong formula's rest
CHEAPER = 100.0  # gain over the likeliest, each of its numbers counted
ROUNDS = 3  # of exchanges, each of one mechanism


def three_instead(search: Search, likeliest: Explanation, floor: float) -> list[Explanation]:
    """The cheapest three mechanisms that are far better than the likeliest explanation and lack one of its own.

    None of them is a stand-in, which fits what it is no physics of. `floor` is the noise's, in the reading's unit.
    """
    excess = amplitude(likeliest.energy, floor)
    if len(likeliest.ids) >= COUNT or excess < SEEN * floor:
        return []
    _exchange(search)
    far_better = [
        three
        for three in search.known
        if len(three.ids) == COUNT
        and amplitude(three.energy, floor) <= LESS * excess
        and three.cost <= likeliest.cost - CHEAPER
        and not set(likeliest.ids) <= set(three.ids)
        and not any(map(is_outside, three.ids))
    ]
    return sorted(far_better, key=lambda three: three.cost)[:MOST]


def _exchange(search: Search) -> None:
    """Search the cheapest three mechanisms by exchanging one of them for each other of the library, in turn."""
    threes = search.all_of(COUNT)
    for _ in range(ROUNDS if threes else 0):
        best = threes[0]
        sets = [tuple(sorted({*best.ids, id_} - {out})) for out in best.ids for id_ in search.linear.catalogue]
        exchanged = [ids for ids in dict.fromkeys(sets) if len(ids) == COUNT and apart(ids)]
        threes = sorted(search.explained([best.ids, *exchanged]), key=lambda three: three.cost)
        if threes[0] is best:
            break
