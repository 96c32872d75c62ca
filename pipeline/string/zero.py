"""Changes of a sensor's zero between runs of a string, and the tare of each run's displacement.

A displacement's zero is arbitrary, and is thought to stay the same over all runs of a string. Between two runs nothing
winds the string, so the rest before a run's first stroke should read what the last rest of the run before read, but for
noise and for what a string does by itself. Where it does not, a clamp or the sensor was moved: a jump. Only a person
can say that neither was: by `tare: checked` the change is the string's own.
"""

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from ..ground.words.counts import counted
from ..ground.words.jump_notes import OFF
from ..run.mend_command import tare_command
from .history import Recorded, in_order, tare_mm
from .recovered import NOTHING, Recovered, alike, recovered
from .rests import Rests

FLOORS = 6.0  # noise floors that a jump is larger than
STROKES = 3.0  # times the usual change of the rest from stroke to stroke, that it is larger than too
LEAST_FLOOR_MM = 1e-4  # no sensor's is smaller
# How far off the zero is, in the median, where a string took something back: less than that is no move.
KNOWN_MM = 0.05


@dataclass(frozen=True)
class Jump:
    """A run's rest that differs from the one before it: by `jump_mm`, with a noise floor of `floor_mm`.

    `unrecorded` strokes were done in between by what run.yaml says: the change may be theirs. What the string took back
    in the break is `own`: the zero was moved by the rest. Of a zero that was `checked` it is no jump: all is the
    string's.
    """

    before: str
    run: str
    jump_mm: float
    floor_mm: float
    unrecorded: int = 0
    taken_off: bool = False  # by `tare: run` in the run's run.yaml
    own: Recovered = NOTHING
    checked: bool = False  # by `tare: checked` in the run's run.yaml
    folder: Path = Path()  # of the run

    @property
    def entry(self) -> dict[str, str | float]:
        """The entry in a diagnosis' `zero_jumps`."""
        return {"before": self.before, "run": self.run, "jump_mm": self.jump_mm, "floor_mm": self.floor_mm}

    @property
    def may_be_wear(self) -> bool:
        """Whether the string may have changed so: its zero was checked, or strokes were not recorded."""
        return self.checked or (self.unrecorded > 0 and not self.taken_off)

    @property
    def is_unconfirmed(self) -> bool:
        """Whether no run.yaml says what the zero did."""
        return not (self.taken_off or self.checked)

    @property
    def moved_mm(self) -> float:
        """By how much the zero was moved."""
        return self.jump_mm - self.own.mm

    @property
    def sentence(self) -> str:
        """The observed change, in words."""
        more = f"{_two_digits(abs(self.jump_mm))} mm {'more' if self.jump_mm > 0 else 'less'}"
        floors = f"{_two_digits(abs(self.jump_mm) / self.floor_mm)} times the noise ({self.floor_mm:.2g} mm)"
        were = "was" if self.unrecorded == 1 else "were"
        between = f"{counted(self.unrecorded, 'stroke')} that {were} not recorded" if self.unrecorded else "no stroke"
        jumps = "At rest" if self.checked else "The zero jumps between two runs of one string: at rest"
        return f"{jumps} {self.run} reads {more} than {self.before} at its end, {floors}, with {between} in between."

    @property
    def advice(self) -> str:
        """The observed change, and what to do if the zero was moved, or was not, or that it was done."""
        if self.taken_off:
            return f"{self.sentence} run.yaml of {self.run} says `tare: run`. {taken_off(self.jump_mm, self.own)}"
        if self.checked:
            return f"{self.sentence} run.yaml of {self.run} says `tare: checked`: so the change is the string's own."
        own, and_own = "", ""
        if self.own.mm:
            moved_so = (
                f"So the zero was moved by {self.moved_mm:+.2g} mm, if at all: on simulated strings that was {OFF}."
            )
            own = f" {self.own.sentence} {moved_so}"
            and_own = " and what the string took back"
        moved, stayed = (tare_command(self.folder, tare) for tare in ("run", "checked"))
        return (
            f"{self.sentence}{own} If the sensor or a clamp was moved or set to zero, write `tare: run` in run.yaml of "
            f"{self.run} ({moved}): it is then tared on its own rest, from where {self.before} ended{and_own}. If they "
            f"were checked and did not move, write `tare: checked` ({stayed}): the change is then the string's own."
        )


def taken_off(change_mm: float, own: Recovered) -> str:
    """What is taken off for the `tare: run` of a run: the change of its rest, less what the string did itself."""
    where = "taken off the displacement before the tables and models are made."
    if not own.mm:
        return f"So this change is {where}"
    return f"{own.sentence} So the zero was moved by {change_mm - own.mm:+.2g} mm, and that is {where}"


def _two_digits(value: float) -> str:
    """A number with two digits and no exponent: 150, 5100, 0.28."""
    return f"{float(f'{value:.2g}'):,.10g}"


def jumps_among(runs: list[Rests]) -> list[Jump]:
    """The jumps of the zero among runs of one string with known rests, in their order."""
    runs, jumps_found, done = in_order(runs), [], 0
    for number, rests in enumerate(runs):
        assert rests.run.string is not None
        unrecorded = max(rests.run.string.strokes_before - done, 0) if number else 0
        done = max(done, rests.run.string.strokes_before) + rests.strokes
        jump = _jump(runs[number - 1], rests, unrecorded) if number else None
        if jump is not None:
            jumps_found.append(jump)
    return jumps_found


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
    """The jump of the zero between two runs, None where there is none or the rests do not compare."""
    change = change_mm(before, after)
    if change is None:
        return None
    floor_mm = max(before.noise_mm, after.noise_mm, LEAST_FLOOR_MM)
    if abs(change) <= max(FLOORS * floor_mm, STROKES * _usual_mm(before, after)):
        return None
    names = before.run.run, after.run.run
    tare, own = after.run.tare, recovered(before, after)
    if own.mm and abs(change - own.mm) <= KNOWN_MM:
        return None  # all of it, as far as is known, is what the string took back
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
