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

    `floor` is the noise's, in the reading's unit.
    """
    if len(likeliest.ids) >= COUNT or leaves_noise(likeliest, floor):
        return []
    _exchange(search)
    better = [
        three
        for three in search.known
        if len(three.ids) == COUNT and far_better(three, likeliest, floor) and not set(likeliest.ids) <= set(three.ids)
    ]
    return sorted(better, key=lambda three: three.cost)[:MOST]


def leaves_noise(explanation: Explanation, floor: float) -> bool:
    """Whether an explanation leaves nothing to explain but the noise; `floor` is that, in the reading's unit."""
    return amplitude(explanation.energy, floor) < SEEN * floor


def far_better(three: Explanation, likeliest: Explanation, floor: float) -> bool:
    """Whether three mechanisms leave far less than the likeliest explanation, which leaves more than the noise.

    A stand-in is none of them: it fits what it is no physics of. `floor` is the noise's, in the reading's unit.
    """
    is_less = amplitude(three.energy, floor) <= LESS * amplitude(likeliest.energy, floor)
    is_worth_it = is_less and three.cost <= likeliest.cost - CHEAPER
    return is_worth_it and not leaves_noise(likeliest, floor) and not any(map(is_outside, three.ids))


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
