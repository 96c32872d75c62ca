"""Dataset → the errors that no model can beat: an oracle that sees the held-out answers, with and without direction.

For each string and stroke it knows the mean contraction at a twist, and the mean twist at a contraction: smooth
curves through all measured points, `floor` one for each direction of motion, `floor_blind` one for both. What is left
is noise, and for the blind oracle the loop too. It bounds the RMSE of models that see the twist (or contraction), the
string, the stroke and (`floor`) the direction; one that sees more, the load or the past, may get below it.

Source: Craven and Wahba, "Smoothing noisy data with spline functions", Numerische Mathematik 31, 1979 (generalised
cross-validation); de Boor, A Practical Guide to Splines, 1978.
"""

from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from ..ground.errors import program
from ..ground.input.parser import Parser
from ..ground.kinematics import Array
from ..ground.stored import schemas

FLOORS = {"floor": ["string", "stroke", "direction"], "floor_blind": ["string", "stroke"]}  # points of one curve
SPLITS = ("within", "later")
DEGREE = 3
PIECES = (1, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64)  # of a curve; which, cross-validation says
POINTS_A_COEFFICIENT = 5  # at least: a curve through fewer follows the noise
LEAST_LEFT = 1e-6  # share of a point's noise that its residual keeps, at least: a lone point is its own curve


def knots(at: Array, pieces: int, degree: int) -> Array:
    """Knots of a spline through points, so that its pieces hold fewer points towards both ends.

    There the motor turns back: the loop opens within a small part of a turn, and noise is cut off by the range. In the
    unit of `at`, which has the shape (points,); the knots have the shape (pieces + 2·degree + 1,) or fewer.
    """
    inner = (1.0 - np.cos(np.pi * np.arange(1, pieces) / pieces)) / 2.0
    low, high = float(at.min()), float(at.max())
    inside = np.unique(np.quantile(at, inner))
    inside = inside[(inside > low) & (inside < high)]
    return np.concatenate([[low] * (degree + 1), inside, [high] * (degree + 1)])


def smooth(at: Array, values: Array, pieces: int) -> tuple[Array, Array]:
    """Least-squares spline of values over `at`: its residual, and the leverage of each point, both shape (points,).

    The leverages sum to the coefficients that the data has determined. What is left is in the unit of the values.
    """
    degree = min(DEGREE, max(len(at) // POINTS_A_COEFFICIENT - 1, 0))
    if np.ptp(at) == 0.0:  # one place: the mean of what was measured there
        return values - values.mean(), np.full(len(at), 1.0 / len(at))
    sparse = BSpline.design_matrix(at, knots(at, pieces, degree), degree)
    inverse = np.linalg.pinv((sparse.T @ sparse).toarray(), rcond=1e-10, hermitian=True)
    residual = values - sparse @ (inverse @ (sparse.T @ values))
    columns, weights = (part.reshape(len(at), degree + 1) for part in (sparse.indices, sparse.data))
    leverage = np.einsum("pi,pij,pj->p", weights, inverse[columns[:, :, None], columns[:, None, :]], weights)
    return residual, leverage


def noise(at: Array, values: Array) -> Array:
    """The residual of each value from a smooth curve that was not fitted to it, shape (points,).

    The number of pieces has the least generalised cross-validation error. A fitted point's residual has lost the share
    of its variance that its leverage says, over all points as many as there are coefficients: it gets it back. In the
    unit of the values.
    """
    best, least = np.zeros(len(at)), np.inf
    for pieces in PIECES:
        if pieces > 1 and (pieces + DEGREE) * POINTS_A_COEFFICIENT > len(at):
            break
        residual, leverage = smooth(at, values, pieces)
        score = float(np.mean(np.square(residual)) / max(1.0 - leverage.mean(), LEAST_LEFT) ** 2)
        if score < least:
            best, least = residual / np.sqrt(np.maximum(1.0 - leverage, LEAST_LEFT)), score
    return best


def residuals(dataset: pd.DataFrame, together: list[str]) -> tuple[Array, Array]:
    """The oracle's errors at every point, in mm forward and in turns inverse, each of shape (points,).

    `together` names the columns whose values the points of one curve share.
    """
    twist, contraction = dataset["motor_turns"].to_numpy(), dataset["displacement_mm"].to_numpy()
    missed_mm, missed_turns = np.empty(len(dataset)), np.empty(len(dataset))
    for rows in _rows(dataset, together):
        missed_mm[rows] = noise(twist[rows], contraction[rows])
        missed_turns[rows] = noise(contraction[rows], twist[rows])
    return missed_mm, missed_turns


def _rows(dataset: pd.DataFrame, together: list[str]) -> Iterable[NDArray[np.intp]]:
    """Row numbers of the points of each curve."""
    return dataset.groupby(together, sort=True).indices.values()


def predictions(dataset: pd.DataFrame, split: str, missed_mm: Array, missed_turns: Array) -> pd.DataFrame:
    """The oracle's answers at the points that a split holds out, as a model's (`schemas.PREDICTIONS`).

    What is missed in mm and in turns, of shape (points,).
    """
    held_out = np.flatnonzero(dataset[split] == "test")
    points = dataset.iloc[held_out]
    return pd.DataFrame(
        {
            "point": held_out,
            "displacement_mm": points["displacement_mm"].to_numpy() - missed_mm[held_out],
            "motor_turns": points["motor_turns"].to_numpy() - missed_turns[held_out],
        }
    )


@program
def main() -> None:
    """Write both oracles' predictions for both splits of one material, beside those of its models."""
    parser = Parser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--out-dir", type=Path, required=True, help="the folder of the models' predictions")
    arguments = parser.parse_args()
    dataset = schemas.read(arguments.dataset, schemas.DATASET)
    for name, together in FLOORS.items():
        missed = residuals(dataset, together)
        for split in SPLITS:
            path = arguments.out_dir / name / f"{split}-0.predictions.parquet"
            schemas.write(predictions(dataset, split, *missed), schemas.PREDICTIONS, path)


if __name__ == "__main__":
    main()
