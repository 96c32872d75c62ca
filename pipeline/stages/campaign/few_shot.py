"""Which model knows a new string from how many of its strokes: errors on strokes that nothing has learnt from."""

import json
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import pandas as pd

from ...ground.errors import BadInput, program
from ...ground.stored import schemas
from ...ground.words.progress import steps
from ...models.interface import Model, about, make_model
from ...models.parts.configured import fitting
from .adapt import Adaptation
from .arguments import parser, points_of
from .campaign_tables import FEW_SHOT

SHOTS = (0, 1, 2, 3, 5)  # strokes of the new string that are shown
ASKED_AFTER = 5  # so the same strokes are asked about whatever was shown
TRAINING_POINTS = 12000
LEAST_STRINGS = {"train": 1, "tune": 2, "test": 1}
PROBED = (
    "direction", "stroke", "separator_mm", "length_mm", "radius_mm", "torsion_zone_mm", "stiffness_n_per_mm", "load_n",
    "material",
)  # fmt: skip
PROBES = 200  # points on which a model is asked what it reads


def errors(model: Any, points: pd.DataFrame) -> tuple[float, float]:
    """Forward RMSE in mm and inverse RMSE in turns, each map without the answer it is to give."""
    forward = model.forward(points.assign(displacement_mm=np.nan)) - points["displacement_mm"]
    inverse = model.inverse(points.assign(motor_turns=np.nan)) - points["motor_turns"]
    return float(np.sqrt(np.mean(forward**2))), float(np.sqrt(np.mean(inverse**2)))


def fitted(name: str, settings: Mapping[str, object], points: pd.DataFrame, seed: int) -> Model:
    """A model of the strings to learn from, on at most so many points, evenly thinned."""
    train = points[points["strings"] == "train"]
    model = make_model(name, **settings)
    model.fit(train.iloc[:: max(1, -(-len(train) // TRAINING_POINTS))].reset_index(drop=True), seed)
    return model


def reads(model: Model, points: pd.DataFrame) -> str:
    """Names of the columns, beside twist and contraction, that change a model's answers, joined by spaces.

    Found by asking: each column in turn gets the values of the points in reverse order, so those of other strings.
    """
    probes = points.iloc[:: max(1, len(points) // PROBES)].reset_index(drop=True)

    def moved(name: str) -> bool:
        other = probes.assign(**{name: probes[name].to_numpy()[::-1]})
        by = (getattr(model, map_)(other) - getattr(model, map_)(probes) for map_ in ("forward", "inverse"))
        return any(float(np.abs(change).max()) > 1e-6 for change in by)

    return " ".join(name for name in PROBED if moved(name))


def asked_and_shown(points: pd.DataFrame) -> Iterator[tuple[pd.DataFrame, dict[int, pd.DataFrame]]]:
    """For each string to ask about: the points asked, and by number of strokes the points shown.

    Strokes are counted from the first recorded one. Raises BadInput for a string with none left to ask about.
    """
    for string, rows in points[points["strings"] == "test"].groupby("string", sort=True):
        count = rows["stroke"].rank(method="dense")
        rows_asked = rows[count > ASKED_AFTER].reset_index(drop=True)
        if rows_asked.empty:
            problem = f"has {int(count.max())} strokes, and {ASKED_AFTER} are shown before any is asked about"
            raise BadInput("string", str(string), problem, "record more of it, or leave it out of the campaign")
        yield rows_asked, {shots: rows[count <= shots].reset_index(drop=True) for shots in SHOTS}


def curves(name: str, settings: Mapping[str, object], points: pd.DataFrame, seed: int) -> pd.DataFrame:
    """Errors of a model by string, strokes shown, and how it learnt: "transfer" or "alone"; columns of `FEW_SHOT`."""
    rows = []
    model_about = about(name)
    learns, alone_from = not model_about.each_string_apart, model_about.least_strokes_alone
    model = fitted(name, settings, points, seed) if learns else make_model(name, **settings)
    columns_read = reads(model, points[points["strings"] == "test"])
    if learns:
        adaptation = Adaptation(model, points[points["strings"] == "tune"])
    for points_asked, shown in steps(asked_and_shown(points), "string"):
        which = (str(points_asked["string"].iloc[0]), str(points_asked["material"].iloc[0]))
        for shots, few in shown.items():
            if learns:
                rows.append((name, *which, "transfer", columns_read, shots, *errors(adaptation.to(few), points_asked)))
            if alone_from is not None and shots >= alone_from:
                alone = make_model(name, **settings)
                if shots:
                    alone.fit(few, seed)
                rows.append((name, *which, "alone", columns_read, shots, *errors(alone, points_asked)))
    return pd.DataFrame(rows, columns=FEW_SHOT.names)


@program
def main() -> None:
    """Write the few-shot errors of one model."""
    arguments = parser(__doc__).parse_args()
    points = points_of(arguments)
    strings = points.groupby("strings")["string"].nunique()
    if any(strings.get(part, 0) < least for part, least in LEAST_STRINGS.items()):
        problem = "has too few strings to learn from, to tune on or to ask about"
        raise BadInput(arguments.points, "strings", problem, "record at least 20 strings, 4 of each material")
    with fitting(arguments.model):
        table = curves(arguments.model, json.loads(arguments.settings), points, arguments.seed)
    schemas.write(table, FEW_SHOT, arguments.out)
    middle = table.groupby(["how", "shots"])[["forward_mm", "inverse_turns"]].median()
    print(middle.to_string(float_format="%.3f"))


if __name__ == "__main__":
    main()
