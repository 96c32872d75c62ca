"""The box of a model's validity: the range of every input among its training points."""

from dataclasses import dataclass
from typing import TypedDict

import numpy as np
import pandas as pd

from ...ground.kinematics import Array

COLUMNS = (
    "motor_turns", "displacement_mm", "stroke", "direction", "load_n", "separator_mm", "length_mm", "radius_mm",
    "torsion_zone_mm", "stiffness_n_per_mm",
)  # fmt: skip
SIZES = ("separator_mm", "length_mm", "radius_mm", "torsion_zone_mm", "stiffness_n_per_mm")
ROUNDED = 5e-4  # of a size that varies: it is told with four digits, and what is told lies in the box
MARGIN = {"motor_turns": 0.01, "displacement_mm": 0.01, "load_n": 0.05}  # of the range, or of the value where constant


def room(name: str, least: float, most: float) -> float:
    """How far beyond the recorded range a column still counts as inside, at either end, in the column's unit."""
    if name in SIZES and most > least:
        return ROUNDED * max(abs(least), abs(most))
    return MARGIN.get(name, 1e-9) * (most - least or abs(most))


class SavedBox(TypedDict):
    """A box in a model's file: the content of `Box` as plain values."""

    low: dict[str, float]
    high: dict[str, float]
    materials: list[str]


@dataclass(frozen=True)
class Box:
    """Least and largest value of each column, in the column's unit; and the known materials."""

    low: dict[str, float]
    high: dict[str, float]
    materials: tuple[str, ...] = ()

    @classmethod
    def of(cls, points: pd.DataFrame) -> "Box":
        """The box of training points, a little wider for measured columns; a column that is NaN is left out."""
        low, high = {}, {}
        for name in COLUMNS:
            values = points[name].to_numpy(float)
            if np.isfinite(values).all():
                least, most = float(values.min()), float(values.max())
                margin = room(name, least, most)
                low[name], high[name] = least - margin, most + margin
        return cls(low, high, tuple(sorted(set(points["material"]))) if "material" in points else ())

    @classmethod
    def from_saved(cls, saved: SavedBox) -> "Box":
        """The box that `saved` wrote; raises ValueError for values that are no box."""
        low, high = dict(saved["low"]), dict(saved["high"])
        if set(low) != set(high) or not set(low) <= set(COLUMNS):
            raise ValueError("the box is of other columns")
        if not all(-np.inf < float(low[name]) <= float(high[name]) < np.inf for name in low):
            raise ValueError("the box holds what is no range")
        return cls(low, high, tuple(saved["materials"]))

    def saved(self) -> SavedBox:
        """Plain values for a file."""
        return {"low": self.low, "high": self.high, "materials": list(self.materials)}

    def clipped(self, column: str, values: Array) -> Array:
        """Values of a column, brought into the box. Shape (points,), in the column's unit."""
        return np.clip(values, self.low[column], self.high[column])

    def outside(self, points: pd.DataFrame, from_column: str) -> dict[str, Array]:
        """Which points lie outside the box, by column; `from_column` says whether twist or contraction is given.

        A value that is not finite lies outside. Only columns in which some point does are there. Each is a mask of
        shape (points,).
        """
        answer = {"motor_turns": "displacement_mm", "displacement_mm": "motor_turns"}[from_column]
        outside = {}
        for name in self.low:
            if name != answer:
                values = points[name].to_numpy(float)
                wrong = ~((values >= self.low[name]) & (values <= self.high[name]))
                if wrong.any():
                    outside[name] = wrong
        if self.materials:
            strange = ~points["material"].isin(self.materials).to_numpy()
            if strange.any():
                outside["material"] = strange
        return outside
