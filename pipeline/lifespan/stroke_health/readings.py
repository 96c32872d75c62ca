"""Samples and strokes → the readings of each complete stroke, as their difference from the nominal model.

Strokes whose twist differs a little then compare; the model's own errors are the same in every stroke and drop out of
every change.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from ...run.dimensions import geometry
from ...string.history import Recorded

Spans = list[tuple[int, int]]  # first samples, and the first after each
Readings = tuple[Array, Array]  # twist in turns, what the nominal model leaves in mm


@dataclass(frozen=True)
class Stroke:
    """One complete stroke: its readings by phase, `rest` those of the rest before it, `hold` those of its own holds.

    `moving` has a row a sample of winding and unwinding: motor_turns, left_mm, load_n and direction (1, -1).
    """

    winding: Readings
    unwinding: Readings
    rest: Readings
    hold: Readings
    moving: pd.DataFrame


class Nominal:
    """A run's readings beyond its nominal model under one load, for any part; the load is its median unless given."""

    def __init__(self, recorded: Recorded, offset_mm: float, load_n: float | None = None) -> None:
        self.recorded, self.rows, self.offset_mm = recorded, recorded.rows, offset_mm
        self.geometry = geometry(recorded.run)
        self.load_n = recorded.rows.median("load_n") if load_n is None else load_n

    @cached_property
    def most_mm(self) -> float:
        """The largest contraction of the model in the run."""
        nominal = (self.geometry.contraction_mm(turns, self.load_n) for turns in self.rows.pieces("motor_turns"))
        return float(np.nanmax([np.nanmax(piece) for piece in nominal if not np.isnan(piece).all()]))

    def readings(self, first: int, stop: int) -> Readings:
        """Twist and residual of the model from sample `first` until `stop`; shape (stop - first,)."""
        turns = self.rows.read("motor_turns", first, stop)
        nominal_mm = self.geometry.contraction_mm(turns, self.load_n)
        is_finite = np.isfinite(nominal_mm)
        if not is_finite.all():  # a pair wound beyond its length
            nominal_mm = np.where(is_finite, nominal_mm, self.most_mm)
        return turns, self.rows.read("displacement_mm", first, stop) + self.offset_mm - nominal_mm


@dataclass(frozen=True)
class Found:
    """One complete stroke in its run: spans of samples by phase; `rest` is that of the rest before it."""

    run: str
    number: int
    of: Nominal
    winding: Spans
    unwinding: Spans
    rest: Spans
    hold: Spans

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest twist of the winding, in turns."""
        turns = [self.of.rows.read("motor_turns", *span) for span in self.winding]
        return float(min(part.min() for part in turns)), float(max(part.max() for part in turns))

    @cached_property
    def load_n(self) -> tuple[float, float]:
        """Median of the load while it moves, and how far apart its quartiles are, in N."""
        loads = [self.of.rows.read("load_n", *span) for span in (*self.winding, *self.unwinding)]
        low, middle, high = np.percentile(np.concatenate(loads), (25.0, 50.0, 75.0))
        return float(middle), float(high - low)

    def under(self, load_n: float) -> "Found":
        """The stroke with the nominal model under a load in N."""
        return replace(self, of=Nominal(self.of.recorded, self.of.offset_mm, load_n))

    def _phase(self, spans: Spans) -> Readings:
        parts = [self.of.readings(*span) for span in spans]
        turns, left_mm = (np.concatenate([np.zeros(0), *(part[side] for part in parts)]) for side in (0, 1))
        return turns, left_mm

    def read(self) -> Stroke:
        """The stroke with its readings, which are held."""
        winding, unwinding, rest, hold = (
            self._phase(at) for at in (self.winding, self.unwinding, self.rest, self.hold)
        )
        load_n = [self.of.rows.read("load_n", *span) for span in (*self.winding, *self.unwinding)]
        moving = pd.DataFrame(
            {
                "motor_turns": np.concatenate([winding[0], unwinding[0]]),
                "left_mm": np.concatenate([winding[1], unwinding[1]]),
                "load_n": np.concatenate(load_n),
                "direction": np.repeat([1.0, -1.0], [len(winding[0]), len(unwinding[0])]),
            }
        )
        return Stroke(winding, unwinding, rest, hold, moving)


def found(recorded: Recorded, before: int, offset_mm: float) -> list[Found]:
    """The complete strokes of a run; `before` strokes came earlier, `offset_mm` is the string's tare."""
    nominal, strokes = Nominal(recorded, offset_mm), recorded.strokes
    places: dict[tuple[int, str], Spans] = {}
    for stroke, phase, first, last in zip(
        strokes["stroke"], strokes["phase"], strokes["first_sample"], strokes["last_sample"], strict=True
    ):
        places.setdefault((int(stroke), str(phase)), []).append((int(first), int(last) + 1))
    complete = sorted(set(strokes.loc[strokes["complete"] & (strokes["stroke"] > 0), "stroke"].astype(int)))
    every = []
    for number in complete:
        phases = (number, "winding"), (number, "unwinding"), (number - 1, "rest"), (number, "hold")
        wound, unwound, rest, hold = (places.get(phase, []) for phase in phases)
        if wound and unwound:
            every.append(Found(recorded.run.run, number + before, nominal, wound, unwound, rest, hold))
    return every
