"""Two ridge regressions on products of polynomials, one for each way: the plain baseline that any spreadsheet can fit.

Terms are powers of θ (or x) to the seventh, times 1, L and L² with L = log(1 + n), times 1 and the direction; what else
varies (dimensions, load, material) multiplies the powers to the third. Inputs beyond the training range are taken as
its edge, where a polynomial would run away.

Source: Hoerl and Kennard, "Ridge Regression", Technometrics 12, 1970.
"""

from pathlib import Path
from typing import Annotated

import numpy as np
import pandas as pd
from numpy.polynomial.legendre import legvander
from pydantic import Field

from ..ground.kinematics import Array
from .parts.box import Box
from .parts.conditions import Conditions
from .parts.saved import read_json, write_json
from .parts.settings import checked, values

GIVEN = ("motor_turns", "displacement_mm")  # of the forward and of the inverse map; each gives the other


@checked
class Settings:
    """Degrees of the polynomials and the ridge's weight."""

    degree: Annotated[int, Field(ge=1, le=30)] = 7
    stroke_degree: Annotated[int, Field(ge=0, le=10)] = 2
    other_degree: Annotated[int, Field(ge=0, le=30)] = 3
    ridge: Annotated[float, Field(ge=1e-15, le=1e6)] = 1e-6  # of the points' number, terms being of size 1


class Polynomial:
    """The pair of ridge regressions; `weights` has one row of terms for each map."""

    def __init__(self, **settings: object) -> None:
        self.settings = Settings(**settings)  # type: ignore[arg-type]

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Solve both regressions; nothing is drawn by the seed."""
        self.box, self.conditions = Box.of(points), Conditions.of(points)
        self.weights = {}
        for from_column, wanted in (GIVEN, GIVEN[::-1]):
            terms = self._terms(points, from_column)
            square = terms.T @ terms + self.settings.ridge * len(points) * np.eye(terms.shape[1])
            self.weights[from_column] = np.linalg.solve(square, terms.T @ points[wanted].to_numpy(float))

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm, shape (points,)."""
        return self._terms(points, GIVEN[0]) @ self.weights[GIVEN[0]]

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns, shape (points,)."""
        return self._terms(points, GIVEN[1]) @ self.weights[GIVEN[1]]

    def save(self, path: Path) -> None:
        """Write all of it as JSON."""
        content = {
            "settings": values(self.settings), "box": self.box.saved(), "conditions": self.conditions.saved(),
            "weights": {from_column: weights.tolist() for from_column, weights in self.weights.items()},
        }  # fmt: skip
        write_json(path, content)

    def load(self, path: Path) -> None:
        """Take over what a JSON file holds."""
        content = read_json(path)
        self.settings = Settings(**content["settings"])
        self.box, self.conditions = Box.from_saved(content["box"]), Conditions.from_saved(content["conditions"])
        self.weights = {from_column: np.array(weights) for from_column, weights in content["weights"].items()}

    def _terms(self, points: pd.DataFrame, from_column: str) -> Array:
        """The products in the sum of a map, shape (points, terms)."""
        s = self.settings
        powers = legvander(self._within(from_column, points[from_column].to_numpy(float)), s.degree)
        grown = legvander(self._grown(points["stroke"].to_numpy(float)), s.stroke_degree)
        way = np.column_stack([np.ones(len(points)), points["direction"].to_numpy(float)])
        others = self.conditions.table(points)
        main = powers[:, :, None, None] * grown[:, None, :, None] * way[:, None, None, :]
        beside = powers[:, : s.other_degree + 1, None] * others[:, None, :]
        return np.column_stack([main.reshape(len(points), -1), beside.reshape(len(points), -1)])

    def _within(self, column: str, values: Array) -> Array:
        """Values of a column as −1 to 1 over its training range."""
        low, high = self.box.low[column], self.box.high[column]
        return np.clip(2.0 * (values - low) / ((high - low) or 1.0) - 1.0, -1.0, 1.0)

    def _grown(self, stroke: Array) -> Array:
        """log(1 + n) scaled to −1…1 over the training strokes, continued with the same scale beyond them."""
        low, high = np.log1p(self.box.low["stroke"]), np.log1p(self.box.high["stroke"])
        return 2.0 * (np.log1p(stroke) - low) / max(high - low, np.log(2.0)) - 1.0


MODEL = Polynomial
