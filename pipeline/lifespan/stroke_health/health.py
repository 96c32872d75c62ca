"""Samples and strokes → the indicators of a string's health, stroke by stroke, each with its standard error."""

from dataclasses import dataclass, field
from itertools import combinations

import numpy as np
import pandas as pd

from ...ground.command import command
from ...ground.errors import BadInput
from ...ground.stored.rows import Rows
from ...run.description import STRING_ACTUATORS
from ...string.history import Recorded, in_order
from ...string.jump import Jump
from ...string.not_compared import not_compared
from ...string.rests import Rests
from ...string.tare_notes import tare_notes
from ...string.zero import jumps_among, offsets_mm
from .changed_string import runs_anew
from .indicators import REFERENCE, curves, ends_mm, loop, model_errors
from .one_load import Loads, of_one_load
from .readings import Found, found
from .stiffness import stiffness

SAME_RANGE = 0.05  # of the reference's range by which a stroke's ends may differ from the reference's
INDICATORS = ("stroke_mm", "rest_mm", "loop_mm", "stiffness_n_per_mm", "model_error_mm")


@dataclass(frozen=True)
class Health:
    """A string's `strokes`, one row each: run, stroke, each of INDICATORS with its `_error`, NaN where not measured.

    `string` is its name, `left_out` the complete strokes that wind over another range than the first three in the
    median, `range_turns`,
    `loads` under which load they are, and which strokes of other loads are left out. `jumps` is what the rest did from
    run to run: one between which no stroke went unrecorded, and whose zero was not checked, is taken off, as it is no
    wear. `anew` are the runs that begin as the string began, and may be of another one. `tares` says what a person
    should know of `tare: run` where no jump is seen, `uncompared` between which runs the zero was not compared. The
    longest run took `longest_min` minutes.
    """

    string: str
    runs: list[str]
    strokes: pd.DataFrame
    left_out: list[int]
    jumps: list[Jump] = field(default_factory=list)
    anew: list[str] = field(default_factory=list)
    tares: list[str] = field(default_factory=list)
    material: str = ""
    loads: Loads = field(default_factory=Loads)
    uncompared: list[str] = field(default_factory=list)
    range_turns: tuple[float, float] = (0.0, 0.0)
    longest_min: float = 0.0

    @property
    def done(self) -> int:
        """The last complete stroke of the string in the given runs, under whatever load and over whatever range."""
        of_other_loads = [number for _, numbers in self.loads.others for number in numbers]
        return max([int(self.strokes["stroke"].max()), *self.left_out, *of_other_loads])


def numbered(runs: list[Recorded], seen: list[Jump]) -> list[Found]:
    """Complete strokes of one string's runs, in order and numbered on, with the known jumps subtracted."""
    moved = frozenset(jump.run for jump in seen if not jump.may_be_wear)
    done, every = 0, list[Found]()
    for recorded, offset_mm in zip(runs, offsets_mm(runs, moved), strict=True):
        assert recorded.run.string is not None
        done = max(done, recorded.run.string.strokes_before)
        every += found(recorded, done, offset_mm)
        done += int(recorded.strokes["stroke"].max())
    return every


def refuse_copies(runs: list[Recorded]) -> None:
    """Raise BadInput where two runs hold the same recording, whose strokes would count twice."""
    for earlier, later in combinations(runs, 2):
        if len(earlier.rows) == len(later.rows) and _alike(earlier.rows, later.rows):
            mend = (
                f"name one of the two; if one is wrong, bring the right file in under its name ({command('new_run')})"
            )
            raise BadInput(later.run.run, "recording", f"has the same samples as {earlier.run.run}", mend)


def _alike(rows: Rows, others: Rows) -> bool:
    names = ("time_s", "motor_turns", "displacement_mm")
    return all(
        np.array_equal(rows.read(name, *span), others.read(name, *span)) for span in rows.spans for name in names
    )


def health(runs: list[Recorded]) -> Health:
    """Indicators of one string from all its runs; raises BadInput where these are not of a string."""
    for recorded in runs:
        if recorded.run.actuator not in STRING_ACTUATORS:
            mend = f"ask about runs of a {' or a '.join(STRING_ACTUATORS)}"
            problem = f"is {recorded.run.actuator}, which has no string to wear out"
            raise BadInput(recorded.run.run, "actuator", problem, mend)
    runs = in_order(runs)
    refuse_copies(runs)
    rests = [Rests.of(recorded) for recorded in runs] if len(runs) > 1 else []
    seen, tares = jumps_among(rests), [note for _, note in tare_notes(rests)]
    strokes = numbered(runs, seen)
    if not strokes:
        mend = "record whole strokes: a winding and the unwinding after it"
        raise BadInput(runs[0].run.run, "motor_turns", "there is no complete stroke in it", mend)
    strokes, loads = of_one_load(strokes)
    low, high = (float(np.median(ends)) for ends in zip(*(place.ends for place in strokes[:REFERENCE]), strict=True))
    near = SAME_RANGE * (high - low)
    same = [place for place in strokes if abs(place.ends[0] - low) <= near and abs(place.ends[1] - high) <= near]
    if not same:
        problem = f"no stroke winds over the usual {low:.3g} to {high:.3g} turns of the first ones"
        raise BadInput(runs[0].run.run, "motor_turns", problem, "record strokes that all wind over the same range")
    left_out = sorted({place.number for place in strokes} - {place.number for place in same})
    first, model = runs[0], same[0].of
    nominal = np.nan_to_num(model.geometry.contraction_mm(np.array([low, high]), model.load_n))
    rows, tables = [], []
    for place in same:
        stroke = place.read()  # no other stroke's readings are held
        ends_and_loop = ends_mm(stroke, low, high, float(nominal[1] - nominal[0])) | loop(stroke, low, high)
        rows.append({"run": place.run, "stroke": place.number, **ends_and_loop, **stiffness(stroke.moving)})
        tables.append(curves(stroke, low, high))
    table = pd.DataFrame([row | error for row, error in zip(rows, model_errors(tables), strict=True)])
    names = [recorded.run.run for recorded in runs]
    material = first.run.string.material if first.run.string else ""
    return Health(
        first.run.string_id, names, table, left_out, seen, runs_anew(table), tares, material, loads,
        not_compared(rests), (low, high), max(float(np.ptp(recorded.span_s)) for recorded in runs) / 60.0,
    )  # fmt: skip
