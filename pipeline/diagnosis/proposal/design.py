"""A run built for a tie: parts of motion, one after the other, each the one that parts the rivals most for its cost.

Source: Atkinson and Fedorov, "The design of experiments for discriminating between two rival models", Biometrika 62,
1975.
"""

import math
from collections.abc import Callable
from itertools import groupby, pairwise

from .legs import CANDIDATES, Leg, Rig

MOST_PARTS = 4
KEPT = 8  # parts, the best alone, that are tried in every later place
STROKE_MIN, PART_MIN = 0.5, 0.2  # minutes that the wear of a stroke and the trouble of a part count as; by hand
PLAIN = 5.0  # standard deviations, from which chance alone makes no tie
LITTLE = 2.0  # times further apart, expected: less may not decide
RAISED, FAINT = 1.05, 1.0  # times further apart, and standard deviations: less is no difference; by hand
HELD_S = 20.0
SPEEDS = {0.5: " at twice the speed", 1.0: "", 2.0: " at half the speed", 4.0: " at a quarter of the speed"}
LOADS = {0.5: " under half the load", 1.0: "", 2.0: " under twice the load"}
HOLDS = {0.2: "", HELD_S: " with a hold"}
REST = "a rest of {:.0f} s"
RESTS = {REST.format(seconds): seconds for seconds in (30.0, 120.0)}
AS_BEFORE = "one stroke as before"
LEAST_STROKE = 0.1  # of the range: what winds less is no stroke

Parts = dict[str, list[Leg]]
Gap = Callable[[list[Leg]], float]  # of legs after the recording: the closest rivals' expected misfit


def deviations(gap: float) -> float:
    """An expected misfit in standard deviations."""
    return math.sqrt(max(gap, 0.0))


def decides(now: float, then: float) -> bool:
    """Whether a run is expected to part two explanations by so much more, and so far, that it can decide."""
    return deviations(then) >= max(LITTLE * deviations(now), PLAIN)


def raises(now: float, then: float) -> bool:
    """Whether a run is expected to part two explanations further, so far that it can be seen at all."""
    return decides(now, then) or deviations(then) >= max(RAISED * deviations(now), FAINT)


def parts(rig: Rig, loads: bool, faster: bool) -> Parts:
    """Parts by their words: strokes by speed, load and hold, rests, partial strokes.

    `loads` and `faster`: whether other loads and a higher speed than before are asked.
    """
    legs_by_part = {
        f"one stroke{speed}{load}{hold}": rig.stroke(slower=slower, load=times, dwell_s=dwell_s)
        for slower, speed in SPEEDS.items()
        for times, load in LOADS.items()
        for dwell_s, hold in HOLDS.items()
        if (faster or slower >= 1.0) and (loads or times == 1.0)
    }
    legs_by_part |= {name: rig.rest(seconds) for name, seconds in RESTS.items()}
    partial = (name for name in CANDIDATES if name.startswith(("two", "four")))
    return legs_by_part | {name: CANDIDATES[name](rig) for name in partial}


def cost_min(legs: list[Leg], at: float) -> float:
    """Minutes that a part costs from a motion on: its time, its strokes' wear, and its trouble."""
    ups, seconds = 0, 0.0
    for lasts_s, to, _ in legs:
        ups, seconds, at = ups + (to > at), seconds + lasts_s, to
    return seconds / 60.0 + STROKE_MIN * ups + PART_MIN


def with_stroke(title: str, legs: list[Leg], rig: Rig) -> tuple[str, list[Leg]]:
    """A run's words and legs, with one stroke as before at its end where it has none: such a recording is refused."""
    ends = [rig.at, *(to for _, to, _ in legs)]
    if max(to - at for at, to in pairwise(ends)) >= LEAST_STROKE * (rig.high - rig.low):
        return title, legs
    return f"{title}, then {AS_BEFORE}" if title else AS_BEFORE, [*legs, *rig.stroke()]


def designed(rig: Rig, gap: Gap, now: float, loads: bool, faster: bool) -> tuple[str, list[Leg]]:
    """The words and the legs of a run that is built part by part, until it decides or has MOST_PARTS.

    `now` is the gap without a run.
    """
    legs_by_part, names, whole = parts(rig, loads, faster), list[str](), [rig.home()]
    reached = gap(whole)
    while len(names) < MOST_PARTS and not decides(now, reached):
        gained = {name: gap([*whole, *legs]) - reached for name, legs in legs_by_part.items()}
        worth = {name: gained[name] / cost_min(legs_by_part[name], whole[-1][1]) for name in legs_by_part}
        best = max(worth, key=lambda name: worth[name])
        whole, reached = [*whole, *legs_by_part[best]], reached + gained[best]
        names.append(best)
        # each part once: rivals differ in more than one way
        likely = sorted(set(worth) - {best}, key=lambda name: -worth[name])
        legs_by_part = {name: legs_by_part[name] for name in likely[:KEPT]}
    return with_stroke("; ".join(_in_one(names)), whole, rig)


def _in_one(names: list[str]) -> list[str]:
    """The parts of a run by their names, rests that follow each other as one."""
    called = list[str]()
    for resting, group in groupby(names, key=RESTS.__contains__):
        together = list(group)
        called += [REST.format(sum(RESTS[name] for name in together))] if resting else together
    return called
