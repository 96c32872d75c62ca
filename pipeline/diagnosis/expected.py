"""What each explanation foretells of strokes that nobody made: numbers that show at the rig which of them is right."""

import re
from dataclasses import dataclass

import numpy as np

from ..ground.kinematics import Array
from ..run.description import Run
from .content import Part, time_constants_s
from .interface import physics
from .legs import Leg, Rig
from .library import mechanisms
from .nextrun import appended, counts, lengthened
from .outcome import Study
from .problem import State
from .rivals import refitted
from .search import Explanation

STROKES = {"as_before": (1.0, 1.0), "half_speed": (2.0, 1.0), "half_load": (1.0, 0.5)}  # times as slow, of the load
MOST, REPEATED = 3, 10  # explanations that are compared; strokes that are made once more, at most
WEIGHED, SEEN = 4, 2.0  # of the likeliest that are compared; noise floors, from which a person sees a difference
STAND_S = 60.0  # where no time constant is known
UP, DWELL, DOWN = 2, 3, 4  # of the legs of a way home and a stroke


def of_explanations(study: Study, run: Run, named: list[Part], ending: str) -> Part:
    """What the explanations foretell of strokes after the recording; `named` are the entries of `mechanisms`.

    `explanations`: those that tie, or the one and the likeliest others of which a number differs from it by what a
    person sees, each with its `ids`. `loop_…`: by how much winding and unwinding part at most at one motion, as before,
    at half the speed and, where one load was recorded, under half of it. What swings or drifts has no loop that could
    be foretold, and how a slow effect follows a load that was not recorded is not known. `top_…`: by how much the
    reading at the highest motion changes in `strokes` more strokes as before. `hold_…` and `rest_…`: by how much it
    changes while the rig stands wound, and then unwound, for `stand_s` each: twice the longest time constant. All in
    the unit of the reading, whose channel has this `ending`. `load` and `speed_per_s` are the usual ones, in the units
    of the load and of the motion per second. Empty where nothing is named, and where chance acts: it foretells
    nothing.
    """
    if study.random or not named:
        return {}
    rig, record, tied = Rig(study.problem.record), study.problem.record, study.sets[:MOST]
    others = [] if len(tied) > 1 else [study.search.explain(ids) for ids in _alike(study)]
    acting = [mechanisms()[id_] for explanation in (*tied, *others) for id_ in explanation.ids]
    known: Part = {"load": rig.load, "speed_per_s": rig.speed}
    if any(mechanism.slow for mechanism in acting):
        known["strokes"] = int(min(REPEATED, len(np.unique(record.stroke[record.stroke > 0]))))
    if any(mechanism.acts_at_rest for mechanism in acting):
        longest_s = max((seconds for entry in named for seconds in time_constants_s(entry)), default=0.0)
        known["stand_s"] = 2.0 * longest_s or STAND_S

    def foretold(explanation: Explanation) -> Part:
        state = study.best if explanation is tied[0] else refitted(study, explanation)
        return {"ids": list(explanation.ids), **_foretold(_Ahead(study, run, state), rig, known, ending)}

    rows = [foretold(explanation) for explanation in tied]
    for other in others:
        if len(rows) == MOST:
            break
        row = foretold(other)
        if _differ(row, rows[0]) >= SEEN * study.floor:
            rows.append(row)
    return known | {"explanations": rows}


def _differ(row: Part, other: Part) -> float:
    """The largest difference between the numbers of two explanations, in their unit."""
    return max((abs(row[key] - other[key]) for key in row.keys() & other.keys() if key != "ids"), default=0.0)


def _alike(study: Study) -> list[tuple[str, ...]]:
    """Explanations that could stand in the place of the best one, the likeliest first, then those of its look-alikes.

    A look-alike takes the place of the mechanism that may be taken for it (`confused_with`).
    """
    best, likely = study.sets[0].ids, study.judged.likely
    ranked = sorted(likely, key=lambda ids: -likely[ids])[:WEIGHED]
    lacking = [ids for ids in ranked if physics(ids) and not set(best) <= set(ids)]
    for id_ in best:
        alike = [other for other in mechanisms() if re.search(rf"\b{other}\b", mechanisms()[id_].confused_with)]
        swaps = [tuple(sorted({*best, other} - {id_})) for other in alike if study.search.linear.catalogue.get(other)]
        lacking += [ids for ids in swaps if physics(ids) and len(ids) == len(best)]
    return list(dict.fromkeys(lacking))


@dataclass(frozen=True)
class _Ahead:
    """A simulator that goes on after the recording."""

    study: Study
    run: Run
    state: State

    def along(self, legs: list[Leg]) -> tuple[list[Array], list[Array]]:
        """Its reading over each leg, and the motion; each of shape (samples of the leg,)."""
        before = self.study.problem.record
        record, ends = appended(before, legs), np.cumsum([len(before), *counts(before, legs)])[:-1]
        reading = lengthened(self.study.problem, self.run, record).simulate(self.state)
        return np.split(reading, ends)[1:], np.split(record.motion, ends)[1:]


def _foretold(ahead: _Ahead, rig: Rig, known: Part, ending: str) -> Part:
    """The numbers of one explanation."""
    numbers: Part = {}
    acting = [mechanisms()[act.id] for act in ahead.state.acts if any(act.coefficients)]
    opens = not any(mechanism.swings or mechanism.drifts for mechanism in acting)
    lighter = rig.load and not ahead.study.problem.drivers.loaded and not any(mechanism.slow for mechanism in acting)
    for kind, (slower, load) in STROKES.items():
        if opens and (load == 1.0 or lighter):
            reading, motion = ahead.along([rig.home(), *rig.stroke(slower=slower, load=load)])
            numbers[f"loop_{kind}_{ending}"] = _width(reading, motion)
    if "strokes" in known:
        reading, _ = ahead.along([rig.home(), *(rig.stroke() * known["strokes"])])
        numbers[f"top_{ending}"] = float(reading[-2][-1] - reading[DWELL][-1])  # the dwell before the last way down
    if "stand_s" in known:
        reading, _ = ahead.along([rig.home(), *rig.stroke(dwell_s=known["stand_s"]), *rig.rest(known["stand_s"])])
        numbers[f"hold_{ending}"] = float(reading[DWELL][-1] - reading[DWELL][0])
        numbers[f"rest_{ending}"] = float(reading[-1][-1] - reading[-1][0])
    return numbers


def _width(reading: list[Array], motion: list[Array]) -> float:
    """By how much the reading differs at most between both ways of a stroke at one motion, in its unit; leg by leg."""
    places, values = (np.concatenate([signal[DWELL][-1:], signal[DOWN]])[::-1] for signal in (motion, reading))
    return float(np.abs(reading[UP] - np.interp(motion[UP], places, values)).max())
