"""What each explanation foretells of strokes that nobody made: numbers that show at the rig which of them is right."""

import re
from dataclasses import dataclass, field, replace

import numpy as np

from ...ground.kinematics import Array
from ...run.description import Run
from ..choice.outcome import Study
from ..choice.search import Explanation
from ..document.effects_named import MechanismEntry
from ..document.expected import Expected, ExpectedExplanation
from ..document.made_keys import amount, with_made
from ..document.time_constants import time_constants_s
from ..facts.recorded_loop import recorded_loop
from ..fit.problem import Problem, State
from ..mechanisms.interface import physics
from ..mechanisms.library import mechanisms
from ..study.rivals import refitted
from .foretold_spread import plus_minus
from .legs import Leg, Rig, as_left
from .next_runs import appended, counts, lengthened

STROKES = {  # times as slow, of the load
    "as_before": (1.0, 1.0), "half_speed": (2.0, 1.0), "half_load": (1.0, 0.5), "twice_load": (1.0, 2.0),
}  # fmt: skip
MOST, REPEATED = 3, 10  # explanations that are compared; strokes that are made once more, at most
LIKELY, SEEN = 0.01, 2.0  # of a probability: rivals before all look-alikes; noise floors that a person sees
NO_NUMBERS = {"ids", "plus_minus", "recorded"}  # of an explanation's keys
UNKNOWN_LOAD = {0.5: 0.21, 2.0: 0.61}  # by the share of the only load that was recorded, of a loop that follows it
STAND_S = 60.0  # where no time constant is known
UP, DWELL, DOWN = 2, 3, 4  # of the legs of a way home and a stroke


def of_explanations(study: Study, run: Run, named: list[MechanismEntry], ending: str, missed: float) -> Expected:
    """What the explanations foretell of strokes after the recording; `named` are the entries of `mechanisms`.

    `missed`: by how much the simulator misses strokes that no fit had seen, the noise of averages in it.

    `explanations`: those that tie, or the one and the likeliest others of which a number differs from it by what a
    person sees, each with its `ids`. `loop_…`: by how much winding and unwinding part at most at one motion, as before,
    at half the speed and, where one load was recorded, under half and twice of it. What swings or drifts has no loop
    that could be foretold, and how a slow effect follows a load that was not recorded is not known. How a drift goes
    on is known for no longer than the recording lasted: where both stands are longer, it has no `hold_…` and `rest_…`.
    `top_…`: by how much the reading at the highest motion changes in `strokes` more strokes as before. `hold_…` and
    `rest_…`: by how much it changes while the rig stands wound, and then unwound, for `stand_s` each: twice the longest
    time constant. All in the unit of the reading, whose channel has this `ending`. `plus_minus` has of each number, by
    its key, half of the interval that holds nine of ten true values if the explanation is right. `recorded`: the loop
    that the recording itself shows, under one load, and that each explanation has in it. Empty where nothing is named,
    and where chance acts: it foretells nothing.
    """
    if study.random or not named:
        return {}
    rig, record, tied = as_left(study.problem.record), study.problem.record, study.sets[:MOST]
    others = [] if len(tied) > 1 else [study.search.explain(ids) for ids in _alike(study)]
    acting = [mechanisms()[id_] for explanation in (*tied, *others) for id_ in explanation.ids]
    expected: Expected = {"load": rig.load, "speed_per_s": rig.speed}
    if any(mechanism.slow for mechanism in acting):
        expected["strokes"] = int(min(REPEATED, len(np.unique(record.stroke[record.stroke > 0]))))
    if any(mechanism.acts_at_rest for mechanism in acting):
        longest_s = max((seconds for entry in named for seconds in time_constants_s(entry)), default=0.0)
        expected["stand_s"] = 2.0 * longest_s or STAND_S

    ahead, shown = _Ahead(study, run, rig, expected, ending), recorded_loop(study.problem, study.base)
    expected["recorded"] = {f"loop_{ending}": shown} if shown else {}

    def foretold(explanation: Explanation) -> ExpectedExplanation:
        state = study.best if explanation is tied[0] else refitted(study, explanation)
        which = _which(study, rig, expected, state)

        def numbers(near: State) -> dict[str, float]:
            return _foretold(ahead, which, near)

        spread = plus_minus(study.problem, state, study.noise, numbers, missed)
        spread = _with_load(spread, numbers(state), explanation, ending)
        ids: ExpectedExplanation = {"ids": list(explanation.ids)}
        row = with_made(ids, numbers(state))
        if shown:
            row["recorded"] = {f"loop_{ending}": recorded_loop(study.problem, study.base, state)}
        return row | {"plus_minus": spread} if spread else row

    rows = [foretold(explanation) for explanation in tied]
    for other in others:
        if len(rows) == MOST:
            break
        row = foretold(other)
        if _differ(row, rows[0]) >= SEEN * study.floor:
            rows.append(row)
    return expected | {"explanations": rows}


def _differ(row: ExpectedExplanation, other: ExpectedExplanation) -> float:
    """The largest difference between the numbers of two explanations, in their unit."""
    both = row.keys() & other.keys() - NO_NUMBERS
    return max((abs(amount(row, key) - amount(other, key)) for key in both), default=0.0)


def _alike(study: Study) -> list[tuple[str, ...]]:
    """Explanations that could stand in the place of the best one: likely ones, then look-alikes, the likeliest first.

    A look-alike takes the place of the mechanism that may be taken for it (`confused_with`).
    """
    best, likely = study.sets[0].ids, study.judged.likely
    ranked = [ids for ids in sorted(likely, key=lambda ids: -likely[ids]) if likely[ids] >= LIKELY]
    ranked = [ids for ids in ranked if physics(ids) and not set(best) <= set(ids)]
    swapped: list[tuple[str, ...]] = []
    for id_ in best:
        alike = [other for other in mechanisms() if re.search(rf"\b{other}\b", mechanisms()[id_].confused_with)]
        swaps = [tuple(sorted({*best, other} - {id_})) for other in alike if study.search.linear.catalogue.get(other)]
        swapped += [ids for ids in swaps if physics(ids) and len(ids) == len(best)]
    return list(dict.fromkeys([*ranked, *sorted(swapped, key=lambda ids: -likely.get(ids, 0.0))]))


@dataclass(frozen=True)
class _Ahead:
    """Simulators that go on after the recording, along legs that are asked again and again."""

    study: Study
    run: Run
    rig: Rig
    known: Expected
    ending: str
    _longer: dict[tuple[Leg, ...], Problem] = field(default_factory=dict)

    def along(self, state: State, legs: list[Leg]) -> tuple[list[Array], list[Array]]:
        """The reading of a simulator over each leg, and the motion; each of shape (samples of the leg,)."""
        before, key = self.study.problem.record, tuple(legs)
        if key not in self._longer:
            self._longer[key] = lengthened(self.study.problem, self.run, appended(before, legs))
        longer, ends = self._longer[key], np.cumsum([len(before), *counts(before, legs)])[:-1]
        return np.split(longer.simulate(state), ends)[1:], np.split(longer.record.motion, ends)[1:]

    def loop(self, state: State, legs: list[Leg]) -> float:
        """By how much both ways of a stroke, the last three of some legs, part at most at one motion, in its unit.

        Where the reading follows derivatives of the motion it is that of the effects alone: what accelerates a mass
        opens no loop that anybody means.
        """
        reading, motion = self.along(state, legs)
        if self.study.problem.system.differentiates:
            bare, _ = self.along(replace(state, acts=()), legs)
            reading = [whole - alone for whole, alone in zip(reading, bare, strict=True)]
        return _width(reading, motion)


def _with_load(
    spread: dict[str, float], numbers: dict[str, float], explanation: Explanation, ending: str
) -> dict[str, float]:
    """The half-widths with the doubt how a loop that follows the load follows one that was not recorded.

    `UNKNOWN_LOAD` held nine of ten loops of 40 laws of friction by four authors, who let it grow with the load to a
    power of 0.4 to 1.2.
    """
    if not any("load" in mechanisms()[id_].driver for id_ in explanation.ids):
        return spread
    doubts = {
        f"loop_{kind}_{ending}": UNKNOWN_LOAD[load] for kind, (_, load) in STROKES.items() if load in UNKNOWN_LOAD
    }
    before = numbers.get(f"loop_as_before_{ending}", 0.0)
    return spread | {
        key: float(np.hypot(spread[key], share * before)) for key, share in doubts.items() if key in spread
    }


def _which(study: Study, rig: Rig, expected: Expected, state: State) -> list[str]:
    """Which numbers an explanation foretells, by their names without the unit."""
    acting = [mechanisms()[act.id] for act in state.acts if any(act.coefficients)]
    opens = not any(mechanism.swings or mechanism.drifts for mechanism in acting)
    other = rig.load and not study.problem.drivers.loaded and not any(mechanism.slow for mechanism in acting)
    loops = [f"loop_{kind}" for kind, (_, load) in STROKES.items() if opens and (load == 1.0 or other)]
    time_s = study.problem.record.time_s
    far = 2.0 * expected.get("stand_s", 0.0) > time_s[-1] - time_s[0] and any(mechanism.drifts for mechanism in acting)
    stands = ["hold", "rest"] if "stand_s" in expected and not far else []
    return [*loops, *(["top"] if "strokes" in expected else []), *stands]


def _foretold(ahead: _Ahead, which: list[str], state: State) -> dict[str, float]:
    """The numbers of one simulator, by their keys, in the unit of the reading."""
    rig, expected, numbers = ahead.rig, ahead.known, dict[str, float]()
    for kind, (slower, load) in STROKES.items():
        if f"loop_{kind}" in which:
            numbers[f"loop_{kind}_{ahead.ending}"] = ahead.loop(
                state, [rig.home(), *rig.stroke(slower=slower, load=load)]
            )
    if "top" in which:
        reading, _ = ahead.along(state, [rig.home(), *(rig.stroke() * expected["strokes"])])
        numbers[f"top_{ahead.ending}"] = float(reading[-2][-1] - reading[DWELL][-1])  # before the last way down
    if "hold" in which:
        stand_s = expected["stand_s"]
        reading, _ = ahead.along(state, [rig.home(), *rig.stroke(dwell_s=stand_s), *rig.rest(stand_s)])
        numbers[f"hold_{ahead.ending}"] = float(reading[DWELL][-1] - reading[DWELL][0])
        numbers[f"rest_{ahead.ending}"] = float(reading[-1][-1] - reading[-1][0])
    return numbers


def _width(reading: list[Array], motion: list[Array]) -> float:
    """By how much the reading differs at most between both ways of a stroke at one motion, in its unit; leg by leg."""
    places, values = (np.concatenate([signal[DWELL][-1:], signal[DOWN]])[::-1] for signal in (motion, reading))
    return float(np.abs(reading[UP] - np.interp(motion[UP], places, values)).max())
