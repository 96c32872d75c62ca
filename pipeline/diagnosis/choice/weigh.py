"""What is weighed of each explanation: what it leaves, what each part is worth, what others would do in its place.

Every sign is a number that a person can check in `diagnosis.json`; the judge weighs nothing else but the names.
"""

import numpy as np

from ..fit.problem import Problem, State
from ..numerics.judge import SIZES, Weighed
from ..numerics.recogniser import signs as signature_signs
from ..signature.signature import signature_of
from .search import Explanation, Search

SINGLES, PAIRS, TRIPLES = 10, 12, 6  # explanations of each size that are weighed, the cheapest
BY_ENERGY = 4  # more of each size, by what they leave
NO_MORE = {"more_gain": 0.0, "more_completes": 0.0}  # signs of a further mechanism where none is weighed
LEAST_LEFT = 1e-4  # of the noise's energy: less is left to the noise's own chance
MOST_CANCELLED = 5.0  # logarithm of the ratio of single effects to their joint effect: a larger one counts as this


def candidates(search: Search) -> list[Explanation]:
    """The explanations that are weighed: the best of every size that was searched."""
    by_ids: dict[tuple[str, ...], Explanation] = {}
    for size, most in zip(SIZES, (SINGLES, PAIRS, TRIPLES), strict=True):
        of_this_size = sorted(
            (explanation for explanation in search.known if len(explanation.ids) == size),
            key=lambda explanation: explanation.cost,
        )
        for explanation in [
            *of_this_size[:most],
            *sorted(of_this_size, key=lambda explanation: explanation.energy)[:BY_ENERGY],
        ]:
            by_ids[explanation.ids] = explanation
    return list(by_ids.values())


def weighed(search: Search, base: State, floor: float) -> list[Weighed]:
    """Every explanation that is weighed, with its signs; `base` is the calibrated simulator, `floor` the noise's.

    A mechanism whose mark the recording lacks is in none of them.
    """
    problem = search.linear.problem
    explanations, marks, library = candidates(search), marked(problem, base), problem.library
    recogniser = problem.judge.recogniser if problem.runs == 1 else None  # it was taught on single recordings
    alike = recogniser.likenesses(signature_of(problem, base)) if recogniser else {}
    return [
        Weighed(
            explanation.ids,
            {
                **signs(search, explanation, explanations, floor),
                **own(marks, explanation.ids),
                **signature_signs(alike, explanation.ids),
            },
        )
        for explanation in explanations
        if all(marks.get(id_, 0.0) >= library[id_].least_mark for id_ in explanation.ids)
    ]


def marked(problem: Problem, base: State) -> dict[str, float]:
    """How clearly the residual after calibration shows the mark of each mechanism that has one, by id."""
    predicted = problem.simulate(base)[: problem.rows]
    residual = problem.measured[: problem.rows] - predicted
    library = problem.library.items()
    return {id_: mechanism.mark(problem.drivers, residual, predicted) for id_, mechanism in library if mechanism.mark}


def own(marks: dict[str, float], ids: tuple[str, ...]) -> dict[str, float]:
    """Each mark twice: for a set that names its mechanism, and for a set that does not."""
    mark_by_sign = {f"with_{id_}": mark if id_ in ids else 0.0 for id_, mark in marks.items()}
    return mark_by_sign | {f"without_{id_}": 0.0 if id_ in ids else mark for id_, mark in marks.items()}


def amplitude(energy: float, floor: float) -> float:
    """Root mean square beyond the noise."""
    return float(np.sqrt(max(energy - floor**2, 0.0)))


def worth(smaller: Explanation, larger: Explanation) -> float:
    """The rms that the larger explanation takes away beyond the smaller one."""
    return float(np.sqrt(max(smaller.energy - larger.energy, 0.0)))


def completes(smaller: Explanation, larger: Explanation, floor: float) -> float:
    """The share of the smaller explanation's excess over the noise that the larger one takes away."""
    excess_energy = max(smaller.energy - floor**2, LEAST_LEFT * floor**2)
    return float(np.clip((smaller.energy - larger.energy) / excess_energy, -1.0, 2.0))


def cost(difference: float) -> float:
    """A difference of costs on a scale that compresses large ones."""
    return float(np.arcsinh(difference / 10.0))


def signs(search: Search, explanation: Explanation, rivals: list[Explanation], floor: float) -> dict[str, float]:
    """The signs of one explanation beside the others; costs compressed, shares and sizes as logarithms."""
    whole = max(amplitude(search.nothing.energy, floor), 1e-12)
    remainder = amplitude(explanation.energy, floor)
    sign_by_name = {
        "mismatch_floors": float(np.log(whole / floor + 0.01)),
        "left_share": float(np.log(remainder / whole + 0.003)),
        "left_floors": float(np.log(remainder / floor + 0.02)),
        "numbers": float(explanation.fit.active),
        "gain": cost(search.nothing.cost - explanation.cost),
    }
    for size in SIZES:
        group = [other for other in rivals if len(other.ids) == size] or [search.nothing]
        sign_by_name[f"behind_{size}"] = cost(explanation.cost - min(other.cost for other in group))
        least = amplitude(min(other.energy for other in group), floor)
        sign_by_name[f"left_behind_{size}"] = float(np.arcsinh(30.0 * (remainder - least) / whole))
    sign_by_name |= _parts(search, explanation, rivals, floor, whole)
    sign_by_name |= _more(explanation, rivals, floor, whole)
    own, together = sizes(search, explanation)
    sign_by_name["left_of_own"] = float(np.log(remainder / own + 0.003)) if own > 0.0 else 0.0
    return sign_by_name | {"cancels": cancelled(own, together)}


def _parts(
    search: Search, explanation: Explanation, rivals: list[Explanation], floor: float, whole: float
) -> dict[str, float]:
    """The worth of an explanation's weakest mechanism, and how much of it another mechanism would give instead."""
    smaller = (
        [search.explain(tuple(id_ for id_ in explanation.ids if id_ != out)) for out in explanation.ids]
        if len(explanation.ids) > 1
        else []
    )
    without = min(smaller or [search.nothing], key=lambda other: other.energy)
    others = [other for other in rivals if len(other.ids) == len(explanation.ids) and set(other.ids) > set(without.ids)]
    instead = max((without.cost - other.cost for other in others if other is not explanation), default=0.0)
    return {
        "weakest_share": float(np.log(worth(without, explanation) / whole + 0.003)),
        "weakest_floors": float(np.log(worth(without, explanation) / floor + 0.01)),
        "weakest_gain": cost(min(other.cost for other in smaller or [search.nothing]) - explanation.cost),
        "weakest_completes": completes(without, explanation, floor),
        "instead": float(np.clip(instead / max(without.cost - explanation.cost, 1.0), -3.0, 3.0)),
    }


def _more(explanation: Explanation, rivals: list[Explanation], floor: float, whole: float) -> dict[str, float]:
    """The gain that the best further mechanism would add."""
    larger = [
        other
        for other in rivals
        if len(other.ids) == len(explanation.ids) + 1 and set(other.ids) > set(explanation.ids)
    ]
    if not larger:
        return {**NO_MORE, "more_share": float(np.log(0.003)), "more_floors": float(np.log(0.01))}
    best = min(larger, key=lambda other: other.cost)
    return {
        "more_gain": cost(explanation.cost - best.cost),
        "more_share": float(np.log(worth(explanation, best) / whole + 0.003)),
        "more_floors": float(np.log(worth(explanation, best) / floor + 0.01)),
        "more_completes": completes(explanation, best, floor),
    }


def cancelled(own: float, together: float) -> float:
    """The logarithm of the ratio of an explanation's effects, added one by one, to their joint effect, both in mm."""
    return float(np.clip(np.log(own / together), 0.0, MOST_CANCELLED)) if together > 0.0 and own > 0.0 else 0.0


def sizes(search: Search, explanation: Explanation) -> tuple[float, float]:
    """The sizes of an explanation's effects, taken one by one and added, and the size of their joint effect, in mm."""
    linear = search.linear
    fit = linear.plain(linear.columns_of(explanation.keys))
    at, own, together = len(linear.calibration), 0.0, np.zeros(linear.rows)
    for id_ in explanation.ids:
        count = sum(len(linear.index[key]) for key in explanation.keys if key[0] == id_)
        columns = slice(at, at + count)
        effect = linear.table[fit.columns[columns]].T @ fit.coefficients[columns]
        at, own, together = at + count, own + float(np.std(effect)), together + effect
    return own, float(np.std(together))
