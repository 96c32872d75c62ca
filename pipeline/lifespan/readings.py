"""Samples and strokes → the readings of each complete stroke, as their difference from the nominal model.

Strokes whose twist differs a little then compare; the model's own errors are the same in every stroke and drop out of
every change.
"""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ..ground.kinematics import Array
from ..run.samples import geometry
from ..string.history import Recorded

Readings = tuple[Array, Array]  # twist in turns, what the nominal model leaves in mm


@dataclass(frozen=True)
class Stroke:
    """One complete stroke: its readings by phase, `rest` those of the rest before it, `hold` those of its own holds.

    `moving` has a row a sample of winding and unwinding: motor_turns, left_mm, load_n and direction (1, -1).
    """

    run: str
    number: int
    winding: Readings
    unwinding: Readings
    rest: Readings
    hold: Readings
    moving: pd.DataFrame

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest twist of the winding, in turns."""
        return float(self.winding[0].min()), float(self.winding[0].max())


def readings(recorded: Recorded, before: int, offset_mm: float) -> list[Stroke]:
    """The complete strokes of a run; `before` strokes came earlier, `offset_mm` is the string's tare."""
    samples = recorded.samples
    turns, load_n = samples["motor_turns"].to_numpy(), samples["load_n"].to_numpy()
    nominal_mm = geometry(recorded.run).contraction_mm(turns, float(np.median(load_n)))
    nominal_mm = np.where(np.isfinite(nominal_mm), nominal_mm, np.nanmax(nominal_mm))  # a pair wound beyond its length
    left_mm = samples["displacement_mm"].to_numpy() + offset_mm - nominal_mm
    rows: dict[tuple[int, str], list[np.ndarray]] = {}
    strokes = recorded.strokes
    for stroke, phase, first, last in zip(
        strokes["stroke"], strokes["phase"], strokes["first_sample"], strokes["last_sample"], strict=True
    ):
        rows.setdefault((int(stroke), str(phase)), []).append(np.arange(first, last + 1))

    def of(stroke: int, phase: str) -> np.ndarray:
        return np.concatenate(rows.get((stroke, phase), [np.zeros(0, int)]))

    found = []
    for number in sorted(set(strokes.loc[strokes["complete"] & (strokes["stroke"] > 0), "stroke"].astype(int))):
        wound, unwound = of(number, "winding"), of(number, "unwinding")
        if not len(wound) or not len(unwound):
            continue
        moved = np.concatenate([wound, unwound])
        direction = np.repeat([1.0, -1.0], [len(wound), len(unwound)])
        moving = pd.DataFrame({"motor_turns": turns[moved], "left_mm": left_mm[moved], "load_n": load_n[moved]})
        here = (wound, unwound, of(number - 1, "rest"), of(number, "hold"))
        one, two, rest, hold = ((turns[at], left_mm[at]) for at in here)
        moving["direction"] = direction
        found.append(Stroke(recorded.run.run, number + before, one, two, rest, hold, moving))
    return found
