"""A model of many strings, adapted to a new one from a few of its strokes.

What a model of many strings gets wrong about one string is smooth: an offset, a slope, a bend, a loop a little wider, a
growth a little faster. How large each of these is from string to string is learnt on strings that the model has not
learnt from; a new string's own are then the likeliest given that and the strokes at hand (Bayesian linear regression).

Source: Lindley and Smith, "Bayes estimates for the linear model", Journal of the Royal Statistical Society B 34, 1972.
"""

import numpy as np
import pandas as pd

from ...ground.kinematics import Array, point_contraction_mm
from ...models.interface import Model

TOP = 0.15  # contraction over torsion zone of a string wound far, so that terms are of size 1
INDEPENDENT = 12  # points of a winding whose errors count as independent: neighbours err alike
LOOSE = 0.1  # share of the spread between strings that is taken as independent from term to term
ROUNDS = 4  # of the inverse: correct the contraction, invert, correct again


def terms(points: pd.DataFrame) -> Array:
    """The possible forms of an error over twist, direction and strokes, shape (points, terms).

    Each without a unit.
    """
    zone_mm = points["torsion_zone_mm"].fillna(points["length_mm"]).to_numpy()  # a pair's is its whole length
    wound = point_contraction_mm(points) / zone_mm / TOP
    way, ones = points["direction"].to_numpy(float), np.ones(len(points))
    grown = np.log1p(points["stroke"].to_numpy(float)) - np.log(5.0)
    first = (points["stroke"] == 1).to_numpy(float)
    return np.column_stack([ones, wound, wound**2, wound**3, way, way * wound, grown, grown * wound, first])


class Adaptation:
    """The expected errors on a new string, learnt from a fitted model's errors on unseen strings."""

    def __init__(self, model: Model, tune: pd.DataFrame) -> None:
        self.model = model
        each, noise = [], []
        for _, rows in tune.groupby("string", sort=True):
            table, error_mm = terms(rows), self._error_mm(rows)
            weights = np.linalg.lstsq(table, error_mm, rcond=None)[0]
            each.append(weights)
            noise.append(np.mean(np.square(error_mm - table @ weights)))
        self.mean = np.mean(each, axis=0)
        spread = np.cov(np.array(each).T)
        self.spread = (1.0 - LOOSE) * spread + LOOSE * np.diag(np.diag(spread))
        self.noise = float(np.mean(noise))  # mm²

    def _error_mm(self, points: pd.DataFrame) -> Array:
        """Measured minus predicted contraction, shape (points,)."""
        return points["displacement_mm"].to_numpy() - self.model.forward(points)

    def to(self, few: pd.DataFrame) -> "Adapted":
        """The model adapted to the string of a few points; without points, to the average string."""
        if few.empty:
            return Adapted(self.model, self.mean)
        table = terms(few)
        passages = few.groupby(["stroke", "phase"]).ngroups
        noise = self.noise * max(len(few) / (INDEPENDENT * passages), 1.0)
        gain = self.spread @ table.T @ np.linalg.inv(table @ self.spread @ table.T + noise * np.eye(len(few)))
        return Adapted(self.model, self.mean + gain @ (self._error_mm(few) - table @ self.mean))


class Adapted:
    """A model with a string's own correction."""

    def __init__(self, model: Model, weights: Array) -> None:
        self.model, self.weights = model, weights

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm, shape (points,)."""
        return np.asarray(self.model.forward(points) + terms(points) @ self.weights)

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns, shape (points,): the model's for the contraction without the string's own correction."""
        turns = self.model.inverse(points)
        for _ in range(ROUNDS):
            corrected_mm = points["displacement_mm"] - terms(points.assign(motor_turns=turns)) @ self.weights
            turns = self.model.inverse(points.assign(displacement_mm=corrected_mm))
        return turns
