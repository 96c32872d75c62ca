"""What speaks against each library effect that no kept explanation has, for the words.

Nothing here decides: the verdict is already made.
"""

import numpy as np

from ...ground.kinematics import Array
from ..choice.candidates import apart
from ..choice.outcome import Study
from ..choice.search import Explanation
from ..document.explanations import Change, NotKept, Stood
from ..document.made_keys import with_made
from ..mechanisms.interface import physics
from ..recording.working_samples import PHASES
from .explanations import fitted

LEAST_S, LEAST_SAMPLES, LEAST_STANDS = 1.0, 9, 3  # shorter, coarser and fewer stands say nothing
PART = 3  # of a stand: its last third is held against its first


def not_kept(study: Study, ending: str) -> list[NotKept]:
    """For each effect: `id`, how `likely` it is at work, and the rms that the best explanation with it leaves.

    `instead`: an explanation of as many effects as the best one; `beside`: the best one with this effect added.
    `stands`: the mean change of the residual of `instead` while the motor stands, by `hold` and `rest`. A value is None
    where nothing tells it. The first entry is the best explanation's own, with the `tied` ones. Empty where nothing is
    named.
    """
    if study.verdict not in ("explained", "ambiguous") or not study.sets or not study.sets[0].ids:
        return []
    search, best = study.search, study.sets[0]
    kept = {id_ for explanation in study.sets for id_ in explanation.ids}
    possible = {id_ for id_, options in search.linear.catalogue.items() if options}
    same = search.all_of(len(best.ids))
    tied: list[Stood] = [{"ids": list(other.ids), "stands": _stands(study, other)} for other in study.sets[1:]]
    own: NotKept = {"id": None, "stands": _stands(study, best), "tied": tied}
    entries = [with_made(own, {f"left_{ending}": _left(best)}, "stands")]
    for id_ in study.problem.library:
        if id_ in kept or not physics((id_,)):
            continue
        instead = min((other for other in same if id_ in other.ids), key=lambda other: other.energy, default=None)
        more = tuple(sorted({*best.ids, id_}))
        beside = search.explain(more) if id_ in possible and apart(more) else None
        entry: NotKept = {
            "id": id_,
            "likely": study.judged.confidence(id_),
            "possible": id_ in possible,
            "instead": list(instead.ids) if instead else None,
            "stands": _stands(study, instead) if instead else None,
        }
        left_by_key = {
            f"left_{ending}": _left(instead) if instead else None,
            f"beside_{ending}": _left(beside) if beside else None,
        }
        entries.append(with_made(entry, left_by_key, "stands"))
    return entries


def _left(explanation: Explanation) -> float:
    return float(np.sqrt(max(explanation.energy, 0.0)))


def _stands(study: Study, explanation: Explanation) -> dict[str, Change]:
    """The residual's mean `change` in holds and in rests, its standard `error`, and their `count`.

    Changes are in the reading's unit, from the first third of a stand to its last.
    """
    search = study.search
    return going_on(study, search.linear.table[-1] - fitted(search, explanation))


def going_on(study: Study, signal: Array) -> dict[str, Change]:
    """By how much a signal of shape (samples,) changes while the motor stands, by phase; in the signal's unit."""
    record, change_by_phase = study.problem.record, dict[str, Change]()
    for phase in ("hold", "rest"):
        inside = record.phase[: len(signal)] == PHASES.index(phase)
        edges = np.flatnonzero(np.diff(inside.astype(int)) | (np.diff(record.run_index[: len(signal)]) != 0)) + 1
        changes = []
        for part in np.split(np.arange(len(signal)), edges):
            if len(part) < LEAST_SAMPLES or not inside[part[0]] or np.ptp(record.time_s[part]) < LEAST_S:
                continue
            third = len(part) // PART
            changes.append(float(signal[part[-third:]].mean() - signal[part[:third]].mean()))
        if len(changes) >= LEAST_STANDS:
            error = float(np.std(changes, ddof=1) / np.sqrt(len(changes)))
            change_by_phase[phase] = {"change": float(np.mean(changes)), "error": error, "count": len(changes)}
    return change_by_phase
