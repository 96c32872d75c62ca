"""How far effects move the reading: from the lowest value to the highest, and in the course of time.

Effects are given by their ids, each of shape (samples,), in the reading's unit.
"""

from itertools import combinations

import numpy as np

from ...ground.kinematics import Array
from ..mechanisms.library import mechanisms
from ..recording.working_samples import Record

LIKE = 0.05  # of a load: loads that differ by less count as the same
CANCEL = 0.5  # of the larger effect's span: two effects whose sum spans less nearly cancel
BOTH = " + "  # between two ids
TOP = 0.02  # of the motion's range: places nearer to the highest one count as the top


def spans(effects: dict[str, Array]) -> dict[str, float]:
    """The difference of the highest and the lowest value of each effect, a few samples left out.

    Each effect has the shape (samples,), in the reading's unit.
    """
    return {id_: float(np.subtract(*np.percentile(effect, [99.9, 0.1]))) for id_, effect in effects.items()}


def sums(effects: dict[str, Array], record: Record) -> dict[str, float]:
    """The span of the sum of each two slow effects that nearly cancel, by their ids with a plus between.

    Such a sum spans less than half of what the larger one does, which it cannot where both move the same way. What
    changes from run to run alone does not count: each run has a zero of its own. Each effect has the shape (samples,),
    in the reading's unit, and so have the spans.
    """
    effects = {id_: _within_runs(effect, record) for id_, effect in effects.items() if mechanisms()[id_].slow}
    slow, alone = list(effects), spans(effects)
    nearly: dict[str, float] = {}
    for first, second in combinations(slow, 2):
        both = f"{first}{BOTH}{second}"
        together = spans({both: effects[first] + effects[second]})
        nearly |= together if together[both] < CANCEL * max(alone[first], alone[second]) else {}
    return nearly


def _within_runs(effect: Array, record: Record) -> Array:
    """An effect less its mean in each run; both of shape (samples,), in the reading's unit."""
    runs = record.run_index
    return np.asarray(effect - (np.bincount(runs, effect) / np.maximum(np.bincount(runs), 1))[runs])


def trends(effects: dict[str, Array]) -> dict[str, float]:
    """The mean of each effect in the last third of the recording less its mean in the first third.

    Each effect has the shape (samples,), in the reading's unit.
    """
    thirds = {id_: max(len(effect) // 3, 1) for id_, effect in effects.items()}
    return {
        id_: float(np.mean(effect[-thirds[id_] :]) - np.mean(effect[: thirds[id_]])) for id_, effect in effects.items()
    }


def tops(effects: dict[str, Array], record: Record) -> dict[str, float]:
    """By how much each slow effect changes at the highest motion, from the first stroke there to the last.

    Only strokes under the load of the first one count. Dimensions cannot make such a change, since they are the same in
    every stroke. Each effect has the shape (samples,), in the reading's unit.
    """
    high = record.motion >= record.motion.max() - TOP * np.ptp(record.motion)
    strokes = [high & (record.stroke == stroke) for stroke in np.unique(record.stroke[high & (record.stroke > 0)])]
    loads = [float(np.median(record.load[stroke])) for stroke in strokes]
    strokes = [
        stroke for stroke, load in zip(strokes, loads, strict=True) if abs(load - loads[0]) <= LIKE * abs(loads[0])
    ]
    return {
        id_: float(np.mean(effect[strokes[-1]]) - np.mean(effect[strokes[0]]))
        for id_, effect in effects.items()
        if mechanisms()[id_].slow and len(strokes) > 1
    }
