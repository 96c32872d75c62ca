"""What the words of a verdict stand on: each explanation that was weighed, what it leaves, and where.

Nothing here decides: the verdict is already made.
"""

from collections.abc import Mapping
from typing import Any, TypeVar

import numpy as np

from ..ground.kinematics import Array
from . import aspects, engine, generic, locate, named
from .compare import price
from .outcome import Study, cancels, rms
from .problem import Problem
from .search import Explanation, Search

T = TypeVar("T")
LISTED = 11  # explanations
RULED_OUT = 3  # of the likeliest that are not held
SINGLES, OTHERS = 8, 4  # of one mechanism, and of each larger number
LEAST_VALUE = 1e-8  # of the largest singular value: smaller directions are rounding
FOLLOWS = 0.5  # of a signal's energy: what a driver must carry for the signal to follow it


def listed(found: Study) -> list[Explanation]:
    """What is shown: nothing, what ties, the likeliest others, the best of every size; in order of what they leave."""
    shown = {one.ids: one for one in (found.search.nothing, *found.sets)}
    likeliest = sorted(found.judged.likely, key=lambda ids: -found.judged.likely[ids])
    for ids in likeliest[: len(found.sets) + RULED_OUT]:
        if len(shown) < LISTED and tuple(sorted({*ids, *found.random})) not in shown:
            shown[ids] = found.search.explain(ids)
    for size in range(max((len(one.ids) for one in found.sets), default=1), 0, -1):
        for one in found.search.all_of(size)[: SINGLES if size == 1 else OTHERS]:
            if len(shown) < LISTED:
                shown.setdefault(one.ids, one)
    return sorted(shown.values(), key=lambda one: (-float(f"{one.energy:.6g}"), len(one.ids)))  # no rounding


def explanations(found: Study, ending: str) -> list[dict[str, Any]]:
    """Every explanation that is shown: its ids, its standing, what it leaves (rms), and how it falls short of the best.

    `bent`: what it leaves with a discrepancy of its formulas. `worse`: misfit over that of the first, which is minus
    twice the logarithm of how much likelier the first makes the recording.
    """
    search = found.search
    decided = found.verdict in ("explained", "ambiguous")
    first = found.sets[0] if found.sets else None
    tied = {one.ids for one in found.sets}
    drivers, entries = bases(found.problem), []
    for one in listed(found):
        standing = "beaten"
        if one.ids in tied:
            standing = "tied" if decided and one is not first else "named" if decided else "not enough"
        elif not one.ids:
            standing = "nothing"
        elif not first or len(one.ids) > len(first.ids):
            standing = "not needed"
        entry: dict[str, Any] = {
            "ids": list(one.ids),
            "standing": standing,
            f"left_{ending}": float(np.sqrt(max(one.energy, 0.0))),
        }
        entry["probability"] = probability(found, one.ids)
        entry[f"bent_{ending}"] = float(np.sqrt(max(search.with_discrepancy(one).energy, 0.0)))
        if first and one.ids and one is not first:
            entry["worse"] = price(search, one) - price(search, first)
            entry["because"] = because(found, one.ids, first.ids)
            gap = fitted(search, first) - fitted(search, one)
            entry[f"gap_{ending}"] = float(np.sqrt(np.mean(np.square(gap))))
            entry["location"] = locate.box(gap, found.problem)
            entry["driver"] = follows(drivers, gap)
            likelier = (entry["probability"] or 0.0) > (probability(found, first.ids) or 0.0)
            if standing == "beaten" and (likelier or entry["worse"] <= 0.0):  # nothing but that can disqualify it
                entry["balanced"] = cancels(found.problem, engine.at_work(search, one))
        entries.append(entry)
    return entries


def probability(found: Study, ids: tuple[str, ...]) -> float | None:
    """The judge's probability of an explanation; None where the judge did not weigh it, as on rigs without a string."""
    return _of(found, found.judged.likely, ids) if found.problem.drivers.levered else None


def because(found: Study, ids: tuple[str, ...], best: tuple[str, ...]) -> list[dict[str, Any]] | None:
    """What counts most against an explanation beside the best one; None where the judge did not weigh both."""
    known = {one.ids: one for one in found.judged.weighed}
    one, first = (_of(found, known, each) for each in (ids, best))
    return aspects.chief(found.problem.judge, one, first) if one and first and one is not first else None


def _of(found: Study, weighed: Mapping[tuple[str, ...], T], ids: tuple[str, ...]) -> T | None:
    """What is known of an explanation that was weighed; what is random stands in each of them, seen and not weighed."""
    return weighed.get(ids, weighed.get(tuple(id_ for id_ in ids if id_ not in found.random)))


def fitted(search: Search, one: Explanation) -> Array:
    """What an explanation predicts beside the linearised simulator, calibration included, one value a sample.

    In the reading's unit.
    """
    fit = search.linear.plain(search.linear.columns_of(one.keys))
    return np.asarray(search.linear.table[fit.columns].T @ fit.coefficients)


def bases(problem: Problem) -> dict[str, Array]:
    """Orthonormal columns of each driver of the generic dictionary, their means aside, shape (samples, columns).

    Without a unit.
    """
    found = {}
    for name, group in generic.groups(problem.drivers).items():
        columns = group[:, : problem.rows] - group[:, : problem.rows].mean(axis=1, keepdims=True)
        if len(group):
            basis, values, _ = np.linalg.svd(columns.T, full_matrices=False)
            found[name] = basis[:, values > LEAST_VALUE * max(float(values[0]), 1e-300)]
    return found


def follows(drivers: dict[str, Array], signal: Array) -> str | None:
    """The one driver whose columns carry most of a signal; None where none carries half of it.

    Shape (samples,), in any unit.
    """
    signal = signal - signal.mean()
    carried = {name: float(np.sum(np.square(basis.T @ signal))) for name, basis in drivers.items()}
    name = max(carried, key=lambda key: carried[key])
    energy = float(np.sum(np.square(signal)))
    return name if energy > 0.0 and carried[name] >= FOLLOWS * energy else None


def spans(found: Study) -> dict[str, float]:
    """From the lowest to the highest value of what each named mechanism does, a few samples aside; by id."""
    ends = {}
    for act in found.best.acts:
        if act in found.problem.included or act.id in found.random:
            continue
        effect = named.effect_of(found.problem, found.best, act)
        ends[act.id] = float(np.subtract(*np.percentile(effect, [99.9, 0.1])))
    return ends


def moved(found: Study) -> dict[str, float]:
    """By how many sigma calibration moved each dimension from what was measured."""
    problem = found.problem
    return {
        problem.parameters[i].name: float(
            (found.state.values[i] - problem.parameters[i].nominal) / problem.parameters[i].sigma
        )
        for i in problem.movable
    }


def tolerances(found: Study) -> dict[str, float]:
    """The sigma of each dimension that calibration may move, in its own unit."""
    problem = found.problem
    return {problem.parameters[i].name: problem.parameters[i].sigma for i in problem.movable}


def misfits(found: Study, ending: str) -> dict[str, float]:
    """What the simulator leaves of the recording as `run.yaml` has it, and with its dimensions calibrated, rms."""
    problem = found.problem
    return {
        f"{name}_{ending}": rms((problem.measured - problem.simulate(state))[: problem.rows])
        for name, state in (("nominal", found.nominal), ("calibrated", found.base))
    }


def evidence(found: Study) -> dict[str, Any]:
    """All of it, as `diagnosis.json` holds it; `floor` is that of the values that were compared, `step_s` apart."""
    system, drivers = found.problem.system, found.problem.drivers
    ending = system.channel.rpartition("_")[2]
    return {
        f"floor_{ending}": found.floor,
        **misfits(found, ending),
        "explanations": explanations(found, ending),
        "probability_of_none": found.judged.none if found.judged.likely and drivers.levered else None,
        f"spans_{ending}": spans(found),
        "moved_sigma": moved(found),
        "tolerance": tolerances(found),
        "step_s": drivers.step_s,
        system.driver: [float(drivers.motion.min()), float(drivers.motion.max())],
        "strokes": [int(max(drivers.stroke.min(), 1)), int(drivers.stroke.max())],
        "loaded": drivers.loaded,
    }
