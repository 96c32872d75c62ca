"""What each explanation foretells of strokes that nobody made: numbers that show at the rig which of them is right."""

import re
from dataclasses import dataclass, field

import numpy as np

from ..ground.kinematics import Array
from ..run.description import Run
from .content import Part
from .foretold_spread import plus_minus
from .interface import physics
from .legs import Leg, Rig
from .library import mechanisms
from .nextrun import appended, counts, lengthened
from .outcome import Study
from .problem import Problem, State
from .rivals import refitted
from .search import Explanation
from .time_constants import time_constants_s

STROKES = {"as_before": (1.0, 1.0), "half_speed": (2.0, 1.0), "half_load": (1.0, 0.5)}  # times as slow, of the load
MOST, REPEATED = 3, 10  # explanations that are compared; strokes that are made once more, at most
WEIGHED, SEEN = 4, 2.0  # of the likeliest that are compared; noise floors, from which a person sees a difference
NO_NUMBERS = {"ids", "plus_minus"}  # of an explanation's keys
UNKNOWN_LOAD = 0.5  # of a loop that follows the load: what half of a load that alone was recorded may change of it
STAND_S = 60.0  # where no time constant is known
UP, DWELL, DOWN = 2, 3, 4  # of the legs of a way home and a stroke


def of_explanations(study: Study, run: Run, named: list[Part], ending: str, missed: float) -> Part:
    """What the explanations foretell of strokes after the recording; `named` are the entries of `mechanisms`.

    `missed`: by how much the simulator misses strokes that no fit had seen, the noise of averages in it.

    `explanations`: those that tie, or the one and the likeliest others of which a number differs from it by what a
    person sees, each with its `ids`. `loop_…`: by how much winding and unwinding part at most at one motion, as before,
    at half the speed and, where one load was recorded, under half of it. What swings or drifts has no loop that could
    be foretold, and how a slow effect follows a load that was not recorded is not known. `top_…`: by how much the
    reading at the highest motion changes in `strokes` more strokes as before. `hold_…` and `rest_…`: by how much it
    changes while the rig stands wound, and then unwound, for `stand_s` each: twice the longest time constant. All in
    the unit of the reading, whose channel has this `ending`. `plus_minus` has of each number, by its key, half of the
    interval that holds nine of ten true values if the explanation is right. `load` and `speed_per_s` are the usual
    ones, in the units of the load and of the motion per second. Empty where nothing is named, and where chance acts:
    it foretells nothing.
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

    ahead = _Ahead(study, run, rig, known, ending)

    def foretold(explanation: Explanation) -> Part:
        state = study.best if explanation is tied[0] else refitted(study, explanation)
        which = _which(study, rig, known, state)

        def numbers(near: State) -> dict[str, float]:
            return _foretold(ahead, which, near)

        spread = plus_minus(study.problem, state, study.noise, numbers, missed)
        spread = _with_load(spread, numbers(state), explanation, ending)
        return {"ids": list(explanation.ids), **numbers(state), **({"plus_minus": spread} if spread else {})}

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
    return max((abs(row[key] - other[key]) for key in row.keys() & other.keys() - NO_NUMBERS), default=0.0)


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
    """Simulators that go on after the recording, along legs that are asked again and again."""

    study: Study
    run: Run
    rig: Rig
    known: Part
    ending: str
    _longer: dict[tuple[Leg, ...], Problem] = field(default_factory=dict)

    def along(self, state: State, legs: list[Leg]) -> tuple[list[Array], list[Array]]:
        """The reading of a simulator over each leg, and the motion; each of shape (samples of the leg,)."""
        before, key = self.study.problem.record, tuple(legs)
        if key not in self._longer:
            self._longer[key] = lengthened(self.study.problem, self.run, appended(before, legs))
        longer, ends = self._longer[key], np.cumsum([len(before), *counts(before, legs)])[:-1]
        return np.split(longer.simulate(state), ends)[1:], np.split(longer.record.motion, ends)[1:]


def _with_load(spread: Part, numbers: dict[str, float], explanation: Explanation, ending: str) -> Part:
    """The half-widths with the doubt how a loop that follows the load follows one that was not recorded.

    It may stay as wide as before or be half as wide.
    """
    key = f"loop_half_load_{ending}"
    if key not in spread or not any("load" in mechanisms()[id_].driver for id_ in explanation.ids):
        return spread
    return spread | {key: float(np.hypot(spread[key], UNKNOWN_LOAD * numbers[f"loop_as_before_{ending}"]))}


def _which(study: Study, rig: Rig, known: Part, state: State) -> list[str]:
    """Which numbers an explanation foretells, by their names without the unit."""
    acting = [mechanisms()[act.id] for act in state.acts if any(act.coefficients)]
    opens = not any(mechanism.swings or mechanism.drifts for mechanism in acting)
    lighter = rig.load and not study.problem.drivers.loaded and not any(mechanism.slow for mechanism in acting)
    loops = [f"loop_{kind}" for kind, (_, load) in STROKES.items() if opens and (load == 1.0 or lighter)]
    return [*loops, *(["top"] if "strokes" in known else []), *(["hold", "rest"] if "stand_s" in known else [])]


def _foretold(ahead: _Ahead, which: list[str], state: State) -> dict[str, float]:
    """The numbers of one simulator, by their keys, in the unit of the reading."""
    rig, known, numbers = ahead.rig, ahead.known, dict[str, float]()
    for kind, (slower, load) in STROKES.items():
        if f"loop_{kind}" in which:
            reading, motion = ahead.along(state, [rig.home(), *rig.stroke(slower=slower, load=load)])
            numbers[f"loop_{kind}_{ahead.ending}"] = _width(reading, motion)
    if "top" in which:
        reading, _ = ahead.along(state, [rig.home(), *(rig.stroke() * known["strokes"])])
        numbers[f"top_{ahead.ending}"] = float(reading[-2][-1] - reading[DWELL][-1])  # before the last way down
    if "hold" in which:
        stand_s = known["stand_s"]
        reading, _ = ahead.along(state, [rig.home(), *rig.stroke(dwell_s=stand_s), *rig.rest(stand_s)])
        numbers[f"hold_{ahead.ending}"] = float(reading[DWELL][-1] - reading[DWELL][0])
        numbers[f"rest_{ahead.ending}"] = float(reading[-1][-1] - reading[-1][0])
    return numbers


def _width(reading: list[Array], motion: list[Array]) -> float:
    """By how much the reading differs at most between both ways of a stroke at one motion, in its unit; leg by leg."""
    places, values = (np.concatenate([signal[DWELL][-1:], signal[DOWN]])[::-1] for signal in (motion, reading))
    return float(np.abs(reading[UP] - np.interp(motion[UP], places, values)).max())
