"""Each explanation that was weighed: its residual, where it differs from the best one, and what counts against it.

Nothing here decides: the verdict is already made.
"""

import math
from dataclasses import replace

import numpy as np

from ...ground.kinematics import Array
from ..choice.compare import price
from ..choice.kept import at_work
from ..choice.outcome import Study, cancels
from ..choice.search import Explanation, Search
from ..document.explanations import Cause, ExplanationEntry, LeftOut, share_of
from ..document.made_keys import put
from ..fit import generic, locate
from ..fit.problem import Problem
from . import aspects

LISTED = 11  # explanations
RULED_OUT = 3  # of the likeliest that are not held
SINGLES, OTHERS = 8, 4  # of one mechanism, and of each larger number
LEAST_VALUE = 1e-8  # of the largest singular value: smaller directions are rounding
FOLLOWS = 0.5  # of a signal's energy: what a driver must carry for the signal to follow it


def listed(study: Study) -> list[Explanation]:
    """The explanations to show, by residual: none, the tied, the likeliest others, and the best of every size."""
    shown = {explanation.ids: explanation for explanation in (study.search.nothing, *study.sets)}
    likeliest = sorted(study.judged.likely, key=lambda ids: -study.judged.likely[ids])
    for ids in likeliest[: len(study.sets) + RULED_OUT]:
        if len(shown) < LISTED and ids not in shown:
            shown[ids] = study.explanation(ids)
    for size in range(max((len(explanation.ids) for explanation in study.sets), default=1), 0, -1):
        for explanation in study.search.all_of(size)[: SINGLES if size == 1 else OTHERS]:
            ids = study.beside_chance(explanation.ids)
            if len(shown) < LISTED and ids not in shown:
                shown[ids] = replace(explanation, ids=ids)
    return sorted(
        shown.values(), key=lambda explanation: (-float(f"{explanation.energy:.6g}"), len(explanation.ids))
    )  # no rounding


def explanations(study: Study, ending: str, calibrated: float) -> list[ExplanationEntry]:
    """Every shown explanation: its ids, its standing, the rms that it leaves, and how it differs from the best.

    `with_discrepancy_…`: the rms that it leaves with a discrepancy of its formulas. `worse`: its misfit minus that of
    the first, which is twice the logarithm of the ratio of their likelihoods. `calibrated` is the rms that calibration
    alone leaves, by the simulator itself. The search's approximation of it is `approximated_…`.
    """
    search = study.search
    decided = study.verdict in ("explained", "ambiguous")
    first = study.sets[0] if study.sets else None
    tied = {explanation.ids for explanation in study.sets}
    drivers, entries = bases(study.problem), []
    for explanation in listed(study):
        standing = "beaten"
        if explanation.ids in tied:
            standing = "tied" if decided and explanation is not first else "named" if decided else "not enough"
        elif not explanation.ids:
            standing = "nothing"
        elif not first or len(explanation.ids) > len(first.ids):
            standing = "not needed"
        entry: ExplanationEntry = {"ids": list(explanation.ids), "standing": standing}
        searched_rms, allowed = (
            math.sqrt(max(each.energy, 0.0)) for each in (explanation, search.with_discrepancy(explanation))
        )
        put(entry, f"left_{ending}", searched_rms if explanation.ids else calibrated)
        if not explanation.ids:
            put(entry, f"approximated_{ending}", searched_rms)
        entry["probability"] = probability(study, explanation.ids)
        put(entry, f"with_discrepancy_{ending}", allowed)
        if first and explanation.ids and explanation is not first:
            entry["worse"] = price(search, explanation) - price(search, first)
            entry["because"] = because(study, explanation.ids, first.ids)
            gap = fitted(search, first) - fitted(search, explanation)
            put(entry, f"gap_{ending}", float(np.sqrt(np.mean(np.square(gap)))))
            entry["location"] = locate.box(gap, study.problem)
            entry["driver"] = follows(drivers, gap)
            likelier = share_of(entry) > (probability(study, first.ids) or 0.0)
            if standing == "beaten" and (likelier or entry["worse"] <= 0.0):  # nothing but that can disqualify it
                entry["balanced"] = cancels(study.problem, at_work(search, explanation))
        entries.append(entry)
    return entries


def probability(study: Study, ids: tuple[str, ...]) -> float | None:
    """The judge's probability of an explanation; None where the judge did not weigh it, as on rigs without a string."""
    likely = study.judged.likely
    return likely.get(study.beside_chance(ids), likely.get(ids)) if study.problem.drivers.levered else None


def left_out(study: Study) -> list[LeftOut]:
    """The likely explanations that are no names: ids, probability, the reason `because`, and the effects `of`."""
    return [
        {"ids": [*out.ids], "because": out.because, "of": [*out.of], "probability": probability(study, out.ids)}
        for out in study.judged.left_out
    ]


def because(study: Study, ids: tuple[str, ...], best: tuple[str, ...]) -> list[Cause] | None:
    """What counts most against an explanation beside the best one; None where the judge did not weigh both."""
    weighed_by_ids = {weighed.ids: weighed for weighed in study.judged.weighed}
    rival, first = (weighed_by_ids.get(study.without_chance(each)) or weighed_by_ids.get(each) for each in (ids, best))
    return aspects.chief(study.problem.judge, rival, first) if rival and first and rival is not first else None


def fitted(search: Search, explanation: Explanation) -> Array:
    """The prediction of an explanation less that of the linearised simulator, calibration included, one value a sample.

    In the reading's unit.
    """
    fit = search.linear.plain(search.linear.columns_of(explanation.keys))
    return np.asarray(search.linear.table[fit.columns].T @ fit.coefficients)


def bases(problem: Problem) -> dict[str, Array]:
    """Orthonormal columns of each driver of the generic dictionary, their means aside, shape (samples, columns).

    Without a unit.
    """
    basis_by_driver = {}
    for name, group in generic.groups(problem.drivers).items():
        columns = group[:, : problem.rows] - group[:, : problem.rows].mean(axis=1, keepdims=True)
        if len(group):
            basis, values, _ = np.linalg.svd(columns.T, full_matrices=False)
            basis_by_driver[name] = basis[:, values > LEAST_VALUE * max(float(values[0]), 1e-300)]
    return basis_by_driver


def follows(drivers: dict[str, Array], signal: Array) -> str | None:
    """The one driver whose columns carry most of a signal; None where none carries half of it.

    Shape (samples,), in any unit.
    """
    signal = signal - signal.mean()
    carried = {name: float(np.sum(np.square(basis.T @ signal))) for name, basis in drivers.items()}
    name = max(carried, key=lambda key: carried[key])
    energy = float(np.sum(np.square(signal)))
    return name if energy > 0.0 and carried[name] >= FOLLOWS * energy else None
