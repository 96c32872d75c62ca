"""A conditional monotone spline over eq. 4: the physics bends the curve, the spline learns what the physics misses.

The contraction by eq. 4 over the torsion zone, u = x₄(θ) / d, is the coordinate; a rational-quadratic spline S of u,
whose knots depend on the direction of motion, the strokes n and whatever else varies (load, dimensions, material),
gives x = d · S(u). Every rise and slope is an exponential of a linear form of these conditions, so x rises with θ
whatever was learnt, and θ follows from x exactly: S backwards, then eq. 5. A pair has its own equation and d = l.

Fitted by Levenberg and Marquardt on the forward error; the law of n is the one that best foresees the last strokes
and follows all of them.

Source: Gregory and Delbourgo, "Piecewise rational quadratic interpolation to monotonic data", IMA Journal of
Numerical Analysis 2, 1982; Durkan et al., "Neural Spline Flows", NeurIPS 2019 (as a model with an inverse).
"""

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import numpy as np
import pandas as pd
from pydantic import Field

from ..ground.kinematics import Array, point_contraction_mm, point_motor_turns
from .about import About
from .parts.box import Box
from .parts.conditions import Conditions
from .parts.growth import Law, chosen
from .parts.marquardt import least_squares
from .parts.networks import rational
from .parts.saved import read_json, write_json
from .parts.settings import checked, values

SHORTEST = 1e-9  # of what the knots span: one twist only is still a spline
CHOICE_POINTS, CHOICE_STEPS = 2000, 2  # with which the law of n is chosen
NOISE_MM = 0.03  # a displacement sensor's, about: what the pull towards no change at all is weighed against
MOST = 3.0  # of the size of a logarithm: no piece is flatter than a twentieth of the physics, nor 20 times as steep
LOOSE, TIGHT = 1.0, 0.2  # spread expected of the logarithms of rises and slopes, and of their change by a condition


@checked
class Settings:
    """The spline's size and what it is told."""

    bins: Annotated[int, Field(ge=1, le=128)] = 16
    steps: Annotated[int, Field(ge=1, le=1000)] = 30
    direction: bool = True  # whether it may know winding from unwinding


class Spline:
    """The conditional monotone spline; `weights` has shape (2 · bins + 2, features)."""

    def __init__(self, **settings: object) -> None:
        self.settings = Settings(**settings)  # type: ignore[arg-type]

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Choose the law of n, then fit all weights; nothing is drawn by the seed."""
        self.box, self.conditions = Box.of(points), Conditions.of(points)
        u = self._coordinate(points)
        self.knots_at = np.linspace(u.min(), max(u.max(), u.min() + SHORTEST), self.settings.bins + 1)
        thin = points.iloc[:: max(1, len(points) // CHOICE_POINTS)]
        weights = np.zeros((2 * self.settings.bins + 2, self._features(thin, Law()).shape[1]))

        def error_of(law: Law, earlier: pd.DataFrame, later: pd.DataFrame) -> float:
            fitted = self._fitted(earlier, law, weights, CHOICE_STEPS)
            error = self._contraction_mm(later, law, fitted) - later["displacement_mm"].to_numpy()
            return float(np.sqrt(np.mean(error**2)))

        self.law = Law().standardised(thin["stroke"].to_numpy())
        weights = self._fitted(thin, self.law, weights, 3 * CHOICE_STEPS)
        self.law = chosen(thin, error_of)
        self.weights = self._fitted(points, self.law, weights, self.settings.steps)

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm, shape (points,)."""
        return self._contraction_mm(points, self.law, self.weights)

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns, shape (points,), within the twists that were seen."""
        zone_mm = _zone_mm(points)
        y = points["displacement_mm"].to_numpy(float) / zone_mm
        u = rational.inverse(self._knots(points, self.law, self.weights), y)
        return self.box.clipped("motor_turns", point_motor_turns(points.assign(displacement_mm=u * zone_mm)))

    def save(self, path: Path) -> None:
        """Write all of it as JSON."""
        content = {
            "settings": values(self.settings), "box": self.box.saved(), "conditions": self.conditions.saved(),
            "law": asdict(self.law), "knots": self.knots_at.tolist(), "weights": self.weights.tolist(),
        }  # fmt: skip
        write_json(path, content)

    def load(self, path: Path) -> None:
        """Take over what a JSON file holds."""
        content = read_json(path)
        self.settings, self.law = Settings(**content["settings"]), Law(**content["law"])
        self.box, self.conditions = Box.from_saved(content["box"]), Conditions.from_saved(content["conditions"])
        self.knots_at, self.weights = np.array(content["knots"]), np.array(content["weights"])

    def _coordinate(self, points: pd.DataFrame) -> Array:
        """u = x₄(θ) / d of points, shape (points,)."""
        return point_contraction_mm(points) / _zone_mm(points)

    def _features(self, points: pd.DataFrame, law: Law) -> Array:
        """The inputs of the knots, shape (points, features); the first is 1."""
        ones, grown = np.ones(len(points)), law.of(points["stroke"].to_numpy())
        first = points["stroke"].to_numpy() == 1  # a new string beds in while it is wound for the first time
        base = np.column_stack([ones, grown, first])
        others = self.conditions.table(points)
        columns = np.column_stack([base, others, others * grown[:, None]])
        if not self.settings.direction:
            return columns
        way = points["direction"].to_numpy(float)[:, None]
        return np.column_stack([columns, way * base, way * others])

    def _knots(self, points: pd.DataFrame, law: Law, weights: Array) -> rational.Knots:
        """Every point's own knots."""
        return self._knots_of(self._features(points, law), _zone_mm(points), weights)

    def _knots_of(self, features: Array, zone_mm: Array, weights: Array) -> rational.Knots:
        """Knots of points from their features."""
        bins, linear = self.settings.bins, features @ weights.T
        linear[:, 1:] = np.clip(linear[:, 1:], -MOST, MOST)
        rise = np.diff(self.knots_at) * np.exp(linear[:, 1 : bins + 1])
        start = self.knots_at[0] + linear[:, 0] / zone_mm
        return rational.Knots(self.knots_at, start, rise, np.exp(linear[:, bins + 1 :]))

    def _contraction_mm(self, points: pd.DataFrame, law: Law, weights: Array) -> Array:
        """Every point's contraction."""
        return rational.value(self._knots(points, law, weights), self._coordinate(points)) * _zone_mm(points)

    def _fitted(self, points: pd.DataFrame, law: Law, start: Array, steps: int) -> Array:
        """Weights that fit the points, of the shape of `start`."""
        features, measured_mm = self._features(points, law), points["displacement_mm"].to_numpy()
        u, zone_mm = self._coordinate(points), _zone_mm(points)

        def problem(flat: Array) -> tuple[Array, Array]:
            knots = self._knots_of(features, zone_mm, flat.reshape(start.shape))
            predicted_mm = rational.value(knots, u) * zone_mm
            rises, slopes = rational.by_logarithms(knots, u)
            free = np.abs(features @ flat.reshape(start.shape)[1:].T) < MOST
            by_logarithm = np.column_stack([rises, slopes]) * zone_mm[:, None] * free
            by_linear = np.column_stack([np.ones(len(points)), by_logarithm])
            jacobian = by_linear[:, :, None] * features[:, None, :]
            return predicted_mm - measured_mm, jacobian.reshape(len(points), -1)

        ridge = np.full(start.shape, (NOISE_MM / TIGHT) ** 2)
        ridge[:, 0] = (NOISE_MM / LOOSE) ** 2
        ridge[0] *= 1e-6  # the offset: any
        return least_squares(problem, start.ravel(), ridge.ravel(), steps).reshape(start.shape)


def _zone_mm(points: pd.DataFrame) -> Array:
    """The length that contractions are relative to: the torsion zone, or a pair's whole length."""
    return points["torsion_zone_mm"].fillna(points["length_mm"]).to_numpy(np.float64)


MODEL = Spline
ABOUT = About(least_strokes_alone=1)
