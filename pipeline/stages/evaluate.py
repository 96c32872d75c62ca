"""Predictions → metrics: errors of every model, split and seed on points that it has not seen."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pandas as pd

from ..ground.errors import BadInput, program
from ..ground.input.outputs import file_to_write
from ..ground.input.parser import Parser
from ..ground.kinematics import Array
from ..ground.stored import schemas

COLUMNS = ["map", "stroke", "phase", "angle_band", "metric", "unit", "value"]
BANDS = 4  # of the material's twist range, for errors by angle
MAPS = {"forward": ("displacement_mm", "mm"), "inverse": ("motor_turns", "turns")}
METRICS = {
    "average": lambda error: float(np.mean(np.abs(error))),
    "maximum": lambda error: float(np.max(np.abs(error))),
    "rmse": lambda error: float(np.sqrt(np.mean(np.square(error)))),
}


def angle_bands(motor_turns: Array) -> Array:
    """Band of the twist range that each point lies in, as text such as 0-25%.

    Twist in turns; both of shape (points,).
    """
    low, high = motor_turns.min(), motor_turns.max()
    index = np.clip(((motor_turns - low) / (high - low) * BANDS).astype(int), 0, BANDS - 1)
    names = np.array([f"{100 * band // BANDS}-{100 * (band + 1) // BANDS}%" for band in range(BANDS)])
    return names[index]


def groups(points: pd.DataFrame) -> Iterator[tuple[str, str, str, pd.DataFrame]]:
    """Stroke, phase, angle band and the points of every group whose errors are reported."""
    by_phase = [("all", points), *points.groupby("phase", sort=True)]
    for phase, of_phase in by_phase:
        yield "all", str(phase), "all", of_phase
        for stroke, group in of_phase.groupby("stroke", sort=True):
            yield str(stroke), str(phase), "all", group
        for band, group in of_phase.groupby("angle_band", sort=True):
            yield "all", str(phase), str(band), group


def metrics_of(dataset: pd.DataFrame, predictions: pd.DataFrame) -> pd.DataFrame:
    """Errors of one fitted model; columns map, stroke, phase, angle_band, metric, unit and value.

    Forward errors are in mm at the measured twist, inverse errors in turns at the measured displacement.
    """
    points = dataset.iloc[predictions["point"]].reset_index(drop=True)
    points["angle_band"] = angle_bands(dataset["motor_turns"].to_numpy())[predictions["point"]]
    rows: list[tuple[str, str, str, str, str, str, float]] = []
    if points.empty:  # a split that the dataset leaves out
        return pd.DataFrame(rows, columns=COLUMNS)
    for direction, (column, unit) in MAPS.items():
        points["error"] = predictions[column] - points[column]
        for stroke, phase, band, group in groups(points):
            for metric, measure in METRICS.items():
                rows.append((direction, stroke, phase, band, metric, unit, measure(group["error"].to_numpy())))
    return pd.DataFrame(rows, columns=COLUMNS)


def evaluate(dataset: pd.DataFrame, predictions: Path, material: str) -> pd.DataFrame:
    """Metrics of a predictions file `<model>/<split>-<seed>.predictions.parquet`; columns of `schemas.METRICS`.

    Raises BadInput when the file predicts other points than the split holds out.
    """
    split, seed = predictions.name.split(".")[0].rsplit("-", 1)
    predicted = schemas.read(predictions, schemas.PREDICTIONS)
    if not np.array_equal(np.flatnonzero(dataset[split] == "test"), predicted["point"]):
        raise BadInput(
            predictions, "point", f"these are not the points that {split} holds out", "delete it and run again"
        )
    metrics = metrics_of(dataset, predicted)
    metrics["material"], metrics["model"] = material, predictions.parent.name
    metrics["split"], metrics["seed"] = split, int(seed)
    return metrics[schemas.METRICS.names]


@program
def main() -> None:
    """Write `metrics.parquet` of one material."""
    parser = Parser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("predictions", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True, help="the file of the errors, Parquet; required")
    arguments = parser.parse_args()
    file_to_write(arguments.out, reads=[arguments.dataset, *arguments.predictions])
    dataset = schemas.read(arguments.dataset, schemas.DATASET)
    material = arguments.dataset.parent.name
    parts = [evaluate(dataset, path, material) for path in arguments.predictions]
    schemas.write(pd.concat(parts, ignore_index=True), schemas.METRICS, arguments.out)


if __name__ == "__main__":
    main()
