"""Changes of a sensor's zero between runs of a string, and the tare of each run's displacement.

A displacement's zero is arbitrary, and is thought to stay the same over all runs of a string. Between two runs nothing
winds the string, so the rest before a run's first stroke should read what the last rest of the run before read, but for
noise and for what a string does by itself. Where it does not, a clamp or the sensor was moved: a jump. Only a person
can say that neither was: by `tare: checked` the change is the string's own.
"""

from dataclasses import replace
from itertools import pairwise

import numpy as np

from .history import Recorded, in_order, tare_mm
from .jump import Jump
from .recovered import alike, recovered
from .rests import Rests

FLOORS = 6.0  # noise floors that a jump is larger than
STROKES = 3.0  # times the usual change of the rest from stroke to stroke, that it is larger than too
LEAST_FLOOR_MM = 1e-4  # no sensor's is smaller


def jumps_among(runs: list[Rests]) -> list[Jump]:
    """The jumps of the zero among runs of one string with known rests, in their order."""
    return [jump for jump in changes_among(runs) if not jump.is_own]


def changes_among(runs: list[Rests]) -> list[Jump]:
    """The jumps of the zero among runs of one string, and the changes that are the string's own, in their order."""
    runs, changes, done = in_order(runs), [], 0
    anew: tuple[str, str] | None = None
    for number, rests in enumerate(runs):
        assert rests.run.string is not None
        unrecorded = max(rests.run.string.strokes_before - done, 0) if number else 0
        done = max(done, rests.run.string.strokes_before) + rests.strokes
        jump = _jump(runs[number - 1], rests, unrecorded) if number else None
        if jump is not None:
            changes.append(replace(jump, anew=anew))
        if number and rests.run.tare == "run":
            anew = rests.run.run, runs[number - 1].run.run
    return changes


def offsets_mm(runs: list[Recorded], moved: frozenset[str] = frozenset()) -> list[float]:
    """The offset to the displacement of each run of one string, in the order of the runs.

    The first run's own tare holds for the others. A run whose run.yaml says `tare: run`, and one of those `moved`, is
    set by its own rest to what the string read at the end of the run before and what it took back since, and those
    after it go with it. Where that rest does not compare, it is set to the model's value. One that says
    `tare: checked` keeps the zero of the run before.
    """
    offsets = [tare_mm(runs[0])]
    for before, after in pairwise(runs):
        offset = offsets[-1]
        if after.run.tare == "run" or after.run.run in moved:
            rests = Rests.of(before), Rests.of(after)
            change = change_mm(*rests)
            offset = tare_mm(after) if change is None else offset - change + recovered(*rests).mm
        offsets.append(offset)
    return offsets


def _jump(before: Rests, after: Rests, unrecorded: int) -> Jump | None:
    """The change of the rest between two runs, None where it is no more than usual or the rests do not compare."""
    change = change_mm(before, after)
    if change is None:
        return None
    floor_mm = max(before.noise_mm, after.noise_mm, LEAST_FLOOR_MM)
    if abs(change) <= max(FLOORS * floor_mm, STROKES * _usual_mm(before, after)):
        return None
    names = before.run.run, after.run.run
    tare, own = after.run.tare, recovered(before, after)
    return Jump(*names, change, floor_mm, unrecorded, tare == "run", own, tare == "checked", after.folder)


def change_mm(before: Rests, after: Rests) -> float | None:
    """By how much a run's first rest exceeds the last rest of the run before, both relative to the model."""
    turns, load_n = [before.turns[-1], after.turns[0]], [before.load_n[-1], after.load_n[0]]
    if not alike(turns, load_n, before.range_turns):
        return None
    return after.levels_mm[0] - before.levels_mm[-1]


def _usual_mm(*runs: Rests) -> float:
    """The usual change of the rest per stroke, the median over runs; 0 where no run has two strokes."""
    every = np.abs(np.concatenate([np.diff(rests.levels_mm) for rests in runs]))
    return float(np.median(every)) if len(every) else 0.0
