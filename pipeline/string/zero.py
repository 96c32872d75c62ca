"""Changes of a sensor's zero between runs of a string, and the tare of each run's displacement.

A displacement's zero is arbitrary, and is thought to stay the same over all runs of a string. Between two runs nothing
winds the string, so the rest before a run's first stroke should read what the last rest of the run before read, but for
noise and for what a string does by itself. Where it does not, a clamp or the sensor was moved: a jump. Only a person
can say that neither was: by `tare: checked` the change is the string's own.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..ground.words.jump_notes import KNOWN_IN_PART, MODEL_VALUE
from .history import Recorded, in_order, tare_mm
from .jump import Jump
from .other_rest import other_rest
from .recovered import alike, recovered
from .rests import LEAST_FLOOR_MM, Rests

FLOORS = 6.0  # noise floors that a jump is larger than
STROKES = 3.0  # times the usual change of the rest from stroke to stroke, that it is larger than too


@dataclass(frozen=True)
class Zero:
    """The zero of one run of a string: `offset_mm` is added to its displacement.

    It was moved by `moved_mm` since the run before, None where it is set to the model's value: then, and in the runs
    that go on from there, the zero is not `is_known`. `told_by` names the rest that tells a zero that was set anew,
    where it is not the last one of the run before. `doubt` says what is unknown of it, empty where it was not set anew.
    """

    offset_mm: float
    moved_mm: float | None = 0.0
    is_known: bool = True
    told_by: str = ""
    doubt: str = ""


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
    """The offset to the displacement of each run of one string, in the order of the runs; as `zeros` are."""
    if not any(recorded.run.tare == "run" or recorded.run.run in moved for recorded in runs[1:]):
        return [tare_mm(runs[0])] * len(runs)
    return [zero.offset_mm for zero in zeros([Rests.of(recorded) for recorded in runs], moved)]


def zeros(runs: list[Rests], moved: frozenset[str] = frozenset()) -> list[Zero]:
    """The zero of each run of one string, in the order of the runs.

    The first run's own tare holds for the others. A run whose run.yaml says `tare: run`, and one of those `moved`, is
    set by its own rest to what the string read at the end of the run before and what it took back since, and those
    after it go with it. Where that rest does not compare, it is set by an earlier one that does (`other_rest`), and
    without such a rest to the model's value. One that says `tare: checked` keeps the zero of the run before.
    """
    every = [Zero(-rests.levels_mm[0]) for rests in runs[:1]]
    for number, after in enumerate(runs[1:], 1):
        if after.run.tare == "run" or after.run.run in moved:
            every.append(_set_anew(runs[:number], every, after))
        else:
            every.append(Zero(every[-1].offset_mm, is_known=every[-1].is_known))
    return every


def _set_anew(before: list[Rests], zeros_before: list[Zero], after: Rests) -> Zero:
    """The zero of a run that was set anew, after others of its string."""
    last = zeros_before[-1]
    change = change_mm(before[-1], after)
    if change is not None:
        moved_mm = change - recovered(before[-1], after).mm
        return Zero(last.offset_mm - moved_mm, moved_mm, last.is_known, doubt=KNOWN_IN_PART)
    for earlier, zero in zip(reversed(before), reversed(zeros_before), strict=True):
        other = other_rest(earlier, after) if zero.is_known else None
        if other:
            offset_mm = zero.offset_mm + other.level_mm - after.levels_mm[0]
            return Zero(offset_mm, last.offset_mm - offset_mm, True, other.which, other.doubt)
    return Zero(-after.levels_mm[0], None, False, doubt=MODEL_VALUE)


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
