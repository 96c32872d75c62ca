"""Conditions that make strings differ beside twist, stroke and direction: dimensions, load and material."""

from dataclasses import asdict, dataclass

import numpy as np
import pandas as pd

from ...ground.kinematics import Array

MEASURED = ("separator_mm", "length_mm", "radius_mm", "torsion_zone_mm", "load_n", "stiffness_n_per_mm")
VARIES = 0.02  # spread over mean above which a condition is one; below, it is a load cell's noise


@dataclass(frozen=True)
class Conditions:
    """Measured columns that vary, standardised, then one column for each material but the first; all without unit."""

    names: tuple[str, ...] = ()
    mean: tuple[float, ...] = ()
    std: tuple[float, ...] = ()
    materials: tuple[str, ...] = ()

    @classmethod
    def of(cls, points: pd.DataFrame, columns: tuple[str, ...] = MEASURED) -> "Conditions":
        """The conditions that vary among training points, of these columns, and the material."""
        table = _measured(points, columns)
        mean, std = table.mean(axis=0), table.std(axis=0)
        kept = [i for i in range(len(columns)) if std[i] > VARIES * abs(mean[i])]
        materials = sorted(set(points["material"])) if "material" in points else []
        return cls(
            tuple(columns[i] for i in kept),
            tuple(float(mean[i]) for i in kept),
            tuple(float(std[i]) for i in kept),
            tuple(materials if len(materials) > 1 else ()),
        )

    @classmethod
    def from_saved(cls, saved: dict[str, list[object]]) -> "Conditions":
        """The conditions that `saved` wrote."""
        return cls(**{name: tuple(values) for name, values in saved.items()})  # type: ignore[arg-type]

    def saved(self) -> dict[str, list[object]]:
        """Plain values for a file."""
        return {name: list(values) for name, values in asdict(self).items()}

    @property
    def size(self) -> int:
        """Columns of the table."""
        return len(self.names) + max(len(self.materials) - 1, 0)

    def table(self, points: pd.DataFrame) -> Array:
        """The conditions of points, shape (points, size); an unknown material counts as the first one."""
        scaled = (_measured(points, self.names) - np.array(self.mean)) / np.array(self.std)
        if not self.materials:
            return scaled
        material = points["material"].to_numpy() if "material" in points else np.full(len(points), self.materials[0])
        return np.column_stack([scaled, *((material == name).astype(float) for name in self.materials[1:])])


def _measured(points: pd.DataFrame, names: tuple[str, ...]) -> Array:
    """Columns of points as numbers, shape (points, names); a column that a twisted pair lacks is 0."""
    return points.reindex(columns=list(names)).astype(float).fillna(0.0).to_numpy()
