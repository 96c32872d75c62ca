"""What a sensor's zero did from one run of a string to the next, and what each run's displacement is tared by.

A displacement's zero is arbitrary, and is thought to stay the same over all runs of a string. Between two runs nothing
winds the string, so the rest before a run's first stroke should read what the last rest of the run before read, but for
noise and for what a string does by itself. Where it does not, a clamp or the sensor was moved: a jump.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np
import pandas as pd

from ..ground import order, schemas
from ..ground.kinematics import Array
from ..ground.spans import blocks
from .history import Recorded, in_order, tare_mm

FLOORS = 6.0  # noise floors that a jump is larger than
STROKES = 3.0  # times the usual change of the rest from stroke to stroke, that it is larger than too
SAME_TWIST, SAME_LOAD = 0.05, 0.05  # of the range of twist, and of the load, within which two rests compare
LEAST_FLOOR_MM = 1e-4  # no sensor's is smaller
Rest = tuple[int, int]  # its first sample, and the first after it


@dataclass(frozen=True)
class Jump:
    """A run's rest that reads otherwise than the one before it: `jump_mm` more, with a noise floor of `floor_mm`.

    `unrecorded` strokes were done in between by what run.yaml says: the change may be theirs.
    """

    before: str
    run: str
    jump_mm: float
    floor_mm: float
    unrecorded: int = 0
    taken_off: bool = False  # by `tare: run` in the run's run.yaml

    @property
    def may_be_wear(self) -> bool:
        """Whether strokes that nobody recorded may have made the change."""
        return self.unrecorded > 0 and not self.taken_off

    @property
    def sentence(self) -> str:
        """What is seen, in words."""
        more = f"{abs(self.jump_mm):.2g} mm {'more' if self.jump_mm > 0 else 'less'}"
        floors = f"{abs(self.jump_mm) / self.floor_mm:.0f} times the noise ({self.floor_mm:.2g} mm)"
        between = f"{self.unrecorded} strokes that were not recorded" if self.unrecorded else "no stroke"
        return (
            f"The zero jumps between two runs of one string: at rest {self.run} reads {more} than {self.before} at its "
            f"end, {floors}, with {between} in between."
        )

    @property
    def advice(self) -> str:
        """What is seen, and what to do if the zero was moved, or that it was done."""
        if self.taken_off:
            return (
                f"{self.sentence} run.yaml of {self.run} says `tare: run`: so this jump is taken off the displacement "
                "before the tables and models are made."
            )
        return (
            f"{self.sentence} If the sensor or a clamp was moved or set to zero, write `tare: run` in run.yaml of "
            f"{self.run}: it is then tared on its own rest, from where {self.before} ended."
        )


def jumps(runs: list[Recorded]) -> list[Jump]:
    """The jumps of the zero among runs of one string, in their order."""
    runs, jumps_found, done = in_order(runs), [], 0
    for number, recorded in enumerate(runs):
        assert recorded.run.string is not None
        unrecorded = max(recorded.run.string.strokes_before - done, 0) if number else 0
        done = max(done, recorded.run.string.strokes_before) + int(recorded.strokes["stroke"].max())
        jump = _jump(runs[number - 1], recorded, unrecorded) if number else None
        if jump is not None:
            jumps_found.append(jump)
    return jumps_found


def offsets_mm(runs: list[Recorded], moved: frozenset[str] = frozenset()) -> list[float]:
    """What to add to the displacement of each run of one string, which are in order.

    The first run's own tare holds for the others. A run whose run.yaml says `tare: run`, and one of those `moved`, is
    set by its own rest to what the string read at the end of the run before, and those after it go with it. Where that
    rest does not compare, it is set to the model's value.
    """
    offsets = [tare_mm(runs[0])]
    for before, after in pairwise(runs):
        offset = offsets[-1]
        if after.run.tare == "run" or after.run.run in moved:
            change = _change_mm(before, after)
            offset = tare_mm(after) if change is None else offset - change
        offsets.append(offset)
    return offsets


def _jump(before: Recorded, after: Recorded, unrecorded: int) -> Jump | None:
    """The jump of the zero between two runs, None where there is none or the rests do not compare."""
    change = _change_mm(before, after)
    if change is None:
        return None
    floor_mm = max(noise_mm(before), noise_mm(after), LEAST_FLOOR_MM)
    if abs(change) <= max(FLOORS * floor_mm, STROKES * _usual_mm(before, after)):
        return None
    return Jump(before.run.run, after.run.run, change, floor_mm, unrecorded, after.run.tare == "run")


def _change_mm(before: Recorded, after: Recorded) -> float | None:
    """By how much a run's first rest reads more than the last rest of the run before, both against the model."""
    rests = [_rests(before)[-1:], _rests(after)[:1]]
    if not all(rests):
        return None
    (one,), (two,) = rests
    turns, load_n = ([_middle(run, name, rest) for run, rest in ((before, one), (after, two))]
                     for name in ("motor_turns", "load_n"))  # fmt: skip
    span = float(np.ptp(before.rows.extremes("motor_turns")))
    if abs(turns[1] - turns[0]) > SAME_TWIST * span or abs(load_n[1] - load_n[0]) > SAME_LOAD * max(map(abs, load_n)):
        return None
    return after.level_mm(*two) - before.level_mm(*one)


def _rests(recorded: Recorded) -> list[Rest]:
    """The rest before the first stroke, without one the first sample, and each rest after a stroke."""
    table = recorded.strokes[recorded.strokes["phase"] == "rest"]
    first, later = table[table["stroke"] == 0][-1:], table[table["stroke"] > 0]
    both = pd.concat([first, later])
    found = [(int(a), int(b) + 1) for a, b in zip(both["first_sample"], both["last_sample"], strict=True)]
    return found if len(first) else [(0, 1), *found]


def _read(recorded: Recorded, name: str, rest: Rest) -> Iterator[Array]:
    """A channel in a rest, piece by piece."""
    return (recorded.rows.read(name, *part) for part in blocks(*rest, schemas.ROW_GROUP))


def _middle(recorded: Recorded, name: str, rest: Rest) -> float:
    """Median of a channel in a rest."""
    return order.median(partial(_read, recorded, name, rest), rest[1] - rest[0])


def _usual_mm(*runs: Recorded) -> float:
    """How much the rest changes from one stroke to the next, the median over runs; 0 where none has two strokes."""
    changes = [np.diff([one.level_mm(*rest) for rest in _rests(one)]) for one in runs]
    every = np.abs(np.concatenate(changes))
    return float(np.median(every)) if len(every) else 0.0


def noise_mm(recorded: Recorded) -> float:
    """Noise floor of a run's displacement in mm: the spread of what is not smooth, and of its rests if that is more."""
    rows, name = recorded.rows, "displacement_mm"
    last = len(rows) - 2
    spans = [(first, min(stop, last)) for first, stop in rows.spans if first < last]
    rough = order.median(lambda: (np.abs(np.diff(rows.read(name, first, stop + 2), 2)) for first, stop in spans), last)
    spreads = [_spread_mm(recorded, rest) for rest in _rests(recorded) if rest[1] - rest[0] > 2]
    return max(1.4826 * rough / np.sqrt(6.0), float(np.median(spreads)) if spreads else 0.0)


def _spread_mm(recorded: Recorded, rest: Rest) -> float:
    """How far the displacement of a rest scatters about its median, robustly."""
    name = "displacement_mm"
    middle = _middle(recorded, name, rest)
    off = order.median(lambda: (np.abs(part - middle) for part in _read(recorded, name, rest)), rest[1] - rest[0])
    return 1.4826 * off
