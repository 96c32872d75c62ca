"""The paper's traditional model: eqs 4 and 5 with the dimensions as measured, nothing fitted.

Source: Liu, Wei, Gao and Gong, "Kinematic Modeling of Twisted String Actuator Based on Invertible Neural Networks".
"""

from pathlib import Path

import pandas as pd

from ..ground.kinematics import Array, point_contraction_mm, point_motor_turns
from .about import About
from .parts.saved import read_json, write_json


class Traditional:
    """The nominal analytic model; it has no settings and learns nothing."""

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Learn nothing: the dimensions stand in the points that are predicted."""

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm by eq. 4 (or the pair), shape (points,); x(0) = √(d² + b²) − d is not 0."""
        return point_contraction_mm(points)

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns by eq. 5 (or the pair), shape (points,); below x = 0 the radicand is clipped at 0."""
        return point_motor_turns(points)

    def save(self, path: Path) -> None:
        """Write an empty JSON object: there is nothing to keep."""
        write_json(path, {})

    def load(self, path: Path) -> None:
        """Take over nothing; the file must be there all the same."""
        read_json(path)


MODEL = Traditional
ABOUT = About(least_strokes_alone=0, by_equations=True)
