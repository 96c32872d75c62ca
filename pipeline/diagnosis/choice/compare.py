"""Compare two explanations: the first wins if the second fits worse by about as much as expected if the first is true.

Source: Cox, Tests of separate families of hypotheses, 4th Berkeley Symposium, 1961.
"""

from ...ground.outside_library import is_outside
from .search import EXPLAINED, INEXACT, LEAST_EFFECT, LEAST_MORE, TRIED, Explanation, Search

CONTENDER = 0.75  # of the best one's gain: an explanation with less is no contender
LEAST_GAP = 10.0  # of the price, in log-likelihood: explanations with a smaller difference count as alike
SHARE, CLEAR = 0.4, 0.85  # of the expected gap: what must be seen at least, and what leaves no doubt
FLAW = 0.15  # of the whole mismatch: what a formula that is only nearly right may leave
COMPLETED = 0.8  # of an explanation's residual: a larger one that takes away this share explains to the noise
IDLE = 0.1  # of the energy that the best one takes away: an explanation that takes away less does nothing
REPLACED = 0.7  # of a further mechanism's gain: if another one in its place gains so much, it is not needed


def price(search: Search, explanation: Explanation) -> float:
    """Misfit, and a cost of two numbers (when, how much) for every sudden event after the first of its kind."""
    return explanation.fit.misfit + 2.0 * search.penalty * (len(explanation.keys) - len(explanation.ids))


def beats(search: Search, explanation: Explanation, other: Explanation) -> bool:
    """Whether the recording tells `explanation` from `other`.

    `other` must fit worse by about as much as it would if `explanation` were true. Where the gap is smaller, it must
    remain with a discrepancy of both formulas.
    """
    for first, second in ((explanation, other), (search.with_discrepancy(explanation), search.with_discrepancy(other))):
        seen = price(search, second) - price(search, first)
        if seen <= LEAST_GAP:
            return False
        expected = search.linear.gap(first.fit, second.fit.columns)
        if expected <= LEAST_GAP or seen <= SHARE * expected:
            return False
        if seen >= CLEAR * expected:
            return True
    return True


def explains(search: Search, explanation: Explanation, floor: float) -> bool:
    """Whether an explanation takes away enough of the mismatch to count as one."""
    return explanation.energy - floor**2 <= (1.0 - EXPLAINED) * (search.nothing.energy - floor**2)


def unbeaten(search: Search, chosen: Explanation, floor: float) -> list[Explanation]:
    """Every explanation of the chosen one's size that the best one does not beat, the best first."""
    if not chosen.ids:
        return []
    larger = search.forward(floor)
    if len(larger.ids) > len(chosen.ids):
        holds = explains(search, chosen, floor)  # only with a discrepancy of its formula
        return [chosen, larger] if holds else [larger]
    nothing = search.nothing.fit.misfit
    rivals = search.all_of(len(chosen.ids))
    whole = nothing - min(rival.fit.misfit for rival in rivals)
    close = [rival for rival in rivals if nothing - rival.fit.misfit >= CONTENDER * whole]
    best = min(close, key=lambda explanation: price(search, explanation), default=chosen)
    sets = sorted(
        (explanation for explanation in close if not beats(search, best, explanation)),
        key=lambda explanation: explanation.cost,
    ) or [chosen]
    simpler = without_flaw(search, sets[0], rivals, floor)
    unbeaten_sets = [*to_the_noise(search, chosen, floor), *([simpler] if simpler else []), *sets]
    core = search.explain(tuple(set.intersection(*(set(explanation.ids) for explanation in sets))))
    bare = (
        core.ids
        and core.ids not in [explanation.ids for explanation in unbeaten_sets]
        and explains(search, core, floor)
    )
    # if many different partners fit equally well, the shared part alone may suffice
    return that_take_away(search, [*unbeaten_sets, core] if bare else unbeaten_sets)


def that_take_away(search: Search, sets: list[Explanation]) -> list[Explanation]:
    """The sets that take away at least a share `IDLE` of what the best of them takes away from the mismatch."""
    most = max(search.nothing.energy - explanation.energy for explanation in sets)
    return [explanation for explanation in sets if search.nothing.energy - explanation.energy >= IDLE * most]


def to_the_noise(search: Search, chosen: Explanation, floor: float) -> list[Explanation]:
    """Larger explanations, by one mechanism, that leave about the noise floor where the chosen one leaves clearly more.

    They are kept beside the chosen one: the recording cannot tell whether a formula of the chosen one is slightly wrong
    or a weak mechanism is missing. `floor` is the noise floor in the reading's unit. Empty where the chosen one has an
    id outside the library.
    """
    if any(map(is_outside, chosen.ids)):
        return []  # what has no physics may leave something
    excess_energy = chosen.energy - floor**2
    least = max(LEAST_EFFECT * floor, INEXACT * search.mismatch(floor)) ** 2
    complete = [
        explanation
        for explanation in search.all_of(len(chosen.ids) + 1)[:TRIED]
        if chosen.energy - explanation.energy >= max(COMPLETED * excess_energy, least)
        and explanation.cost <= chosen.cost - LEAST_MORE
    ]
    return [
        explanation
        for explanation in complete
        if explanation is complete[0] or not beats(search, complete[0], explanation)
    ]


def without_flaw(
    search: Search, explanation: Explanation, rivals: list[Explanation], floor: float
) -> Explanation | None:
    """The explanation less its weakest mechanism, or None where that mechanism is needed.

    It is not needed where it takes away little and another mechanism in its place takes away nearly as much: then it
    may only make up for an error of another mechanism's formula. `floor` is the noise floor in the reading's unit.
    """
    if len(explanation.ids) < 2:
        return None
    smaller = [search.explain(tuple(other for other in explanation.ids if other != id_)) for id_ in explanation.ids]
    small = min(smaller, key=lambda other: other.cost)
    without, whole = search.with_discrepancy(small), search.with_discrepancy(explanation)
    if without.energy - whole.energy > (FLAW * search.mismatch(floor)) ** 2 or not explains(search, small, floor):
        return None
    needed = REPLACED * (without.cost - whole.cost)
    others = [rival for rival in rivals if set(small.ids) < set(rival.ids) and rival.ids != explanation.ids]
    return small if any(without.cost - search.with_discrepancy(rival).cost >= needed for rival in others) else None
