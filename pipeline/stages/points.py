"""Strokes → points: the samples of a run in which it winds or unwinds, tared, with the string's dimensions."""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ..ground.kinematics import TOLERANCE
from ..ground.numbers.spans import blocks
from ..ground.stored import schemas
from ..run.lossy import MOVING, all_lossy
from ..string.history import Recorded
from .splits import Numbers, block_of

CHANNELS = ["time_s", "motor_turns", "displacement_mm", "load_n"]


@dataclass(frozen=True)
class Piece:
    """Samples `first` until `stop` of one phase of a stroke in a run; `before` samples of that phase come earlier.

    The phase has `samples` in all; `number` is the stroke's number in the string's life.
    """

    recorded: Recorded
    offset_mm: float
    number: int
    phase: str
    first: int
    stop: int
    before: int
    samples: int

    @property
    def block(self) -> Numbers:
        """Block of each sample, counted from the top of its winding or unwinding; shape (samples,), a count."""
        place = np.arange(self.before, self.before + self.stop - self.first)
        return block_of(self.samples - 1 - place if self.phase == "winding" else place, self.samples)

    def points(self) -> pd.DataFrame:
        """The moving points, with stroke number, phase, block and the string's dimensions."""
        run = self.recorded.run
        assert run.string is not None
        points = self.recorded.rows.frame(self.first, self.stop, CHANNELS)
        points["displacement_mm"] = points["displacement_mm"] + self.offset_mm
        points["stroke"] = self.number
        points["phase"] = self.phase
        points["direction"] = 1 if self.phase == "winding" else -1
        points["block"] = self.block
        points["run"], points["string"], points["actuator"] = run.run, run.string_id, run.actuator
        points["radius_mm"] = run.string.radius_mm
        points["length_mm"] = run.string.length_mm
        points["stiffness_n_per_mm"] = run.string.nominal_stiffness_n_per_mm
        points["torsion_zone_mm"] = run.rig.get("torsion_zone_mm", np.nan)
        points["separator_mm"] = run.rig.get("separator_mm", np.nan)
        tolerance = {**TOLERANCE, **run.tolerance}
        points["radius_tolerance"] = tolerance["radius"]
        for name in ("length", "torsion_zone", "separator"):
            points[f"{name}_tolerance_mm"] = tolerance[f"{name}_mm"]
        return points


def moving(
    recorded: Recorded, strokes_before: int, offset_mm: float, left_out: frozenset[int] = frozenset()
) -> list[Piece]:
    """The moving pieces of a run, in order, without the strokes `left_out`; raises BadInput if none are left."""
    strokes = recorded.strokes
    stretches = strokes[strokes["phase"].isin(MOVING) & (strokes["stroke"] > 0) & ~strokes["stroke"].isin(left_out)]
    if stretches.empty:
        raise all_lossy(recorded.run.run)
    lengths = stretches["last_sample"] - stretches["first_sample"] + 1
    by_phase = lengths.groupby([stretches["stroke"], stretches["phase"]])
    before, samples = by_phase.cumsum() - lengths, by_phase.transform("sum")
    columns = (stretches["stroke"], stretches["phase"], stretches["first_sample"], lengths, before, samples)
    moving_pieces = []
    for stroke, phase, begin, length, earlier, every in zip(*columns, strict=True):
        for first, stop in blocks(int(begin), int(begin + length), schemas.ROW_GROUP):
            number, place = int(stroke) + strokes_before, int(earlier) + first - int(begin)
            moving_pieces.append(Piece(recorded, offset_mm, number, str(phase), first, stop, place, int(every)))
    return moving_pieces


def points_of(
    recorded: Recorded, strokes_before: int, offset_mm: float, left_out: frozenset[int] = frozenset()
) -> pd.DataFrame:
    """The moving points of a run, as `moving` finds them."""
    pieces = moving(recorded, strokes_before, offset_mm, left_out)
    return pd.concat([piece.points() for piece in pieces], ignore_index=True)
