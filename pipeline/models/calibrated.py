"""The analytic model with its dimensions refitted per string, within the tolerance of their measurement.

First-order physics only: eqs 4 and 5 with better numbers, no direction and no stroke times. It is the honest
baseline of a learned model, where the nominal one is the paper's.

Source: eqs 4 and 5 of Liu et al., "Kinematic Modeling of Twisted String Actuator Based on Invertible Neural
Networks"; least squares with priors: Tarantola, Inverse Problem Theory, 2005.
"""

from pathlib import Path

import numpy as np
import pandas as pd
from scipy.optimize import least_squares

from ..ground.kinematics import DIMENSIONS as EVERY_DIMENSION
from ..ground.kinematics import Array, point_contraction_mm, point_motor_turns
from .about import About
from .parts.saved import read_json, write_json

LARGEST_MOVE = 3.0  # sigmas; a diagnosis moves a dimension by no more either (docs/diagnosis.md, step 1)
ROUNDS = 5  # of fit and re-estimate of the error's size; it settles in two or three
SMALLEST_ERROR_MM = 1e-3  # below any sensor's; keeps the weights finite on noise-free data
DIMENSIONS = {
    "separator": ("radius_mm", "separator_mm", "torsion_zone_mm", "length_mm"),
    "twisted_pair": ("radius_mm", "length_mm"),
}


def sigma_mm(points: pd.DataFrame, dimension: str) -> pd.Series:
    """One sigma of how well a dimension was measured at each point, in mm."""
    if dimension == "radius_mm":
        return points["radius_tolerance"] * points["radius_mm"]
    return points[f"{dimension.removesuffix('_mm')}_tolerance_mm"]


class Calibrated:
    """Eqs 4 and 5 with the radius, separator, torsion zone, length and sensor zero of each string refitted."""

    def __init__(self) -> None:
        self.moves: dict[str, dict[str, float]] = {}  # by string: each dimension's move and zero_mm, all in mm

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Refit every string in the points by least squares of the contraction; nothing is drawn by the seed."""
        self.moves = {str(string): self._fitted(rows) for string, rows in points.groupby("string", sort=True)}

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm by eq. 4 (or the pair), shape (points,); an unknown string keeps nominal dimensions."""
        moved, zero_mm = self._moved_strings(points)
        return point_contraction_mm(moved) + zero_mm

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns by eq. 5 (or the pair), shape (points,); an unknown string keeps nominal dimensions."""
        moved, zero_mm = self._moved_strings(points)
        return point_motor_turns(moved.assign(displacement_mm=moved["displacement_mm"] - zero_mm))

    def save(self, path: Path) -> None:
        """Write the moves as JSON."""
        write_json(path, self.moves)

    def load(self, path: Path) -> None:
        """Take over the moves of a JSON file."""
        self.moves = read_json(path)

    def _fitted(self, rows: pd.DataFrame) -> dict[str, float]:
        """The most probable changes of one string's dimensions: Gaussian errors of the contraction, Gaussian priors.

        The error's size is not known beforehand: it is re-estimated from what the fit leaves, because a size
        too small would let missing physics push a dimension to its bound.
        """
        names = sorted({name for actuator in rows["actuator"].unique() for name in DIMENSIONS[actuator]})
        measured_mm = rows["displacement_mm"].to_numpy()
        sigmas_mm = np.array([float(sigma_mm(rows, name).iloc[0]) for name in names])
        bounds = np.array([LARGEST_MOVE] * len(names) + [np.inf])  # the sensor's zero is arbitrary: no prior
        # arrays, for a table of which some columns are moved takes as long as all the rest, thousands of times
        columns = {name: rows[name].to_numpy() for name in ("motor_turns", "load_n", *EVERY_DIMENSION)}
        columns["actuator"] = rows["actuator"].to_numpy().astype(str)

        def errors_mm(state: Array) -> Array:
            moved = columns | {name: columns[name] + by for name, by in zip(names, state[:-1] * sigmas_mm, strict=True)}
            return np.asarray(point_contraction_mm(moved) + state[-1] - measured_mm)

        state = np.zeros(len(names) + 1)
        state[-1] = -np.mean(errors_mm(state))
        for _ in range(ROUNDS):
            size_mm = max(float(np.sqrt(np.mean(np.square(errors_mm(state))))), SMALLEST_ERROR_MM)
            state = least_squares(
                lambda s, size_mm=size_mm: np.concatenate([errors_mm(s) / size_mm, s[:-1]]),
                state,
                bounds=(-bounds, bounds),
            ).x
        return {**dict(zip(names, map(float, state[:-1] * sigmas_mm), strict=True)), "zero_mm": float(state[-1])}

    def _moved(self, points: pd.DataFrame, move: dict[str, float]) -> pd.DataFrame:
        """Points of one string with its changed dimensions, in mm."""
        return points.assign(**{name: points[name] + by for name, by in move.items() if name in points.columns})

    def _moved_strings(self, points: pd.DataFrame) -> tuple[pd.DataFrame, Array]:
        """Points with the changed dimensions of every known string, and the sensor's zero of each, in mm."""
        moved, zero_mm = points.copy(), np.zeros(len(points))
        strings = points["string"].astype(str).to_numpy()
        for string in np.unique(strings):
            move = self.moves.get(string, {})
            of_string = strings == string
            names = [name for name in move if name in points.columns]
            moved.loc[of_string, names] = self._moved(points[of_string], move)[names]
            zero_mm[of_string] = move.get("zero_mm", 0.0)
        return moved, zero_mm


MODEL = Calibrated
ABOUT = About(each_string_apart=True, least_strokes_alone=0, by_equations=True)
