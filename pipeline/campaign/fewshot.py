"""Which model knows a new string from how many of its strokes: errors on strokes that nothing has learnt from."""

import argparse
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa

from pipeline import schemas
from pipeline.campaign.adapt import Adaptation
from pipeline.campaign.points import SCHEMA
from pipeline.errors import program
from pipeline.models.interface import Model, make_model

SHOTS = (0, 1, 2, 3, 5)  # strokes of the new string that are shown
ASKED_AFTER = 5  # so the same strokes are asked about whatever was shown
TRAINING_POINTS = 12000
ALONE = ("calibrated", "spline")  # models that may also learn from the new string's strokes alone
RESULTS = pa.schema(
    [pa.field(name, pa.string()) for name in ("model", "string", "material", "how")]
    + [pa.field("shots", pa.int32())]
    + [pa.field(name, pa.float64()) for name in ("forward_mm", "inverse_turns")]
)


def errors(model: Any, asked: pd.DataFrame) -> tuple[float, float]:
    """Forward RMSE in mm and inverse RMSE in turns, each map without the answer it is to give."""
    forward = model.forward(asked.assign(displacement_mm=np.nan)) - asked["displacement_mm"]
    inverse = model.inverse(asked.assign(motor_turns=np.nan)) - asked["motor_turns"]
    return float(np.sqrt(np.mean(forward**2))), float(np.sqrt(np.mean(inverse**2)))


def fitted(name: str, settings: dict[str, Any], points: pd.DataFrame, seed: int) -> Model:
    """A model of the strings to learn from, on at most so many points, evenly thinned."""
    train = points[points["strings"] == "train"]
    model = make_model(name, **settings)
    model.fit(train.iloc[:: max(1, len(train) // TRAINING_POINTS)].reset_index(drop=True), seed)
    return model


def asked_and_shown(points: pd.DataFrame) -> Iterator[tuple[pd.DataFrame, dict[int, pd.DataFrame]]]:
    """Of each string to ask about: the points asked, and by number of strokes the points shown."""
    for _, rows in points[points["strings"] == "test"].groupby("string", sort=True):
        shown = {shots: rows[rows["stroke"] <= shots].reset_index(drop=True) for shots in SHOTS}
        yield rows[rows["stroke"] > ASKED_AFTER].reset_index(drop=True), shown


def curves(name: str, settings: dict[str, Any], points: pd.DataFrame, seed: int) -> pd.DataFrame:
    """Errors of a model by string, strokes shown, and how it learnt: "transfer" or "alone"; columns of `RESULTS`."""
    rows = []
    learns = name not in ("traditional", "calibrated")
    if learns:
        adaptation = Adaptation(fitted(name, settings, points, seed), points[points["strings"] == "tune"])
    for asked, shown in asked_and_shown(points):
        about = (str(asked["string"].iloc[0]), str(asked["material"].iloc[0]))
        for shots, few in shown.items():
            if learns:
                rows.append((name, *about, "transfer", shots, *errors(adaptation.to(few), asked)))
            if name in ALONE and (shots or not learns):
                model = make_model(name, **settings)
                if shots:
                    model.fit(few, seed)
                rows.append((name, *about, "alone", shots, *errors(model, asked)))
    return pd.DataFrame(rows, columns=RESULTS.names)


@program
def main() -> None:
    """Write the few-shot errors of one model."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("points", type=Path)
    parser.add_argument("--model", required=True)
    parser.add_argument("--settings", default="{}", metavar="JSON")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, required=True)
    asked = parser.parse_args()
    table = curves(asked.model, json.loads(asked.settings), schemas.read(asked.points, SCHEMA), asked.seed)
    schemas.write(table, RESULTS, asked.out)
    middle = table.groupby(["how", "shots"])[["forward_mm", "inverse_turns"]].median()
    print(middle.to_string(float_format="%.3f"))


if __name__ == "__main__":
    main()
