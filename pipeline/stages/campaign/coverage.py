"""How often prediction intervals hold what came: each string's last strokes, foreseen from its first ones."""

import json

import numpy as np
import pandas as pd

from ...ground.errors import BadInput, program
from ...ground.stored import schemas
from ...ground.words.progress import steps
from ...models.interface import make_model
from ...models.parts.configured import fitting
from ...models.parts.questions.prediction_intervals import Intervals, TooFew
from .arguments import parser, points_of
from .campaign_tables import COVERAGE

LEFT_OUT = 2  # strokes of each string, its last
LEVELS = (0.5, 0.8, 0.9, 0.95)
MAPS = {"forward": "displacement_mm", "inverse": "motor_turns"}


def of_string(rows: pd.DataFrame, model: str, settings: dict[str, object], seed: int) -> pd.DataFrame:
    """Share of held points, median width and points by map, strokes ahead and level; columns of `COVERAGE`.

    Raises BadInput for a string of which too little is left to fit.
    """
    last = int(rows["stroke"].max()) - LEFT_OUT
    early_rows, ahead = rows[rows["stroke"] <= last].reset_index(drop=True), rows[rows["stroke"] > last]
    intervals = Intervals(lambda: make_model(model, **settings))
    try:
        intervals.fit(early_rows, seed)
    except TooFew as error:
        problem = f"its points but for the last {LEFT_OUT} strokes {error}"
        raise BadInput("string", str(rows["string"].iloc[0]), problem, "record more of it, or leave it out") from None
    results = []
    for map_, column in MAPS.items():
        for stroke, stroke_points in ahead.groupby("stroke", sort=True):
            for level in LEVELS:
                interval = getattr(intervals, map_)(stroke_points.assign(**{column: np.nan}), level)
                truth, wide = stroke_points[column].to_numpy(), (interval["high"] - interval["low"]).to_numpy()
                inside = interval["inside"].to_numpy() & np.isfinite(wide)  # what has no end holds anything
                is_held = (interval["low"].to_numpy() <= truth) & (truth <= interval["high"].to_numpy())
                width = float(np.median(wide[inside])) if inside.any() else np.nan
                about = (str(rows["string"].iloc[0]), str(rows["material"].iloc[0]), map_, int(stroke) - last, level)
                share = float(is_held[inside].mean()) if inside.any() else np.nan
                results.append((*about, share, width, float(inside.sum()), float((~inside).sum())))
    return pd.DataFrame(results, columns=COVERAGE.names)


@program
def main() -> None:
    """Write the coverage of one model's intervals on the strings of a campaign."""
    words = parser(__doc__)
    words.add_argument("--strings", type=int, help="the first so many of them (all)")
    arguments = words.parse_args()
    if arguments.strings is not None and arguments.strings < 1:
        raise BadInput("--strings", str(arguments.strings), "is none", "give a number from 1, or leave it out for all")
    points = points_of(arguments)
    by_string = [rows for _, rows in points.groupby("string", sort=True)]
    settings = json.loads(arguments.settings)
    with fitting(arguments.model):
        shown = steps(by_string[: arguments.strings], "string")
        parts = [of_string(rows, arguments.model, settings, arguments.seed) for rows in shown]
    table = pd.concat(parts, ignore_index=True)
    schemas.write(table, COVERAGE, arguments.out)
    weighted = table.assign(held=table["held"] * table["points"]).groupby(["map", "level"])[["held", "points"]].sum()
    print((weighted["held"] / weighted["points"]).to_string(float_format="%.3f"))


if __name__ == "__main__":
    main()
