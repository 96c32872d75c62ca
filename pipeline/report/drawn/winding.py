"""The points of the figures: one stroke's winding, measured and predicted."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pandas as pd

from ...ground.kinematics import point_contraction_mm, point_motor_turns
from ...ground.stored import schemas

PAUSE_STEPS = 5  # times the usual step: more is a pause
SHOWN = ["motor_turns", "displacement_mm", "forward_mm", "inverse_turns"]


def with_nominal(points: pd.DataFrame) -> pd.DataFrame:
    """The points with the traditional model's predictions, `forward_mm` and `inverse_turns`."""
    return points.assign(forward_mm=point_contraction_mm(points), inverse_turns=point_motor_turns(points))


def with_median(dataset: pd.DataFrame, predictions: list[Path]) -> pd.DataFrame:
    """The held-out points with the median over the seeds of a model's predictions, as `forward_mm`, `inverse_turns`."""
    middle = pd.concat(schemas.read(path, schemas.PREDICTIONS) for path in predictions).groupby("point").median()
    points = dataset.iloc[middle.index].reset_index(drop=True)
    return points.assign(
        forward_mm=middle["displacement_mm"].to_numpy(), inverse_turns=middle["motor_turns"].to_numpy()
    )


def winding(points: pd.DataFrame, stroke: int, string: str) -> pd.DataFrame:
    """Points of one stroke's winding of a string, in order of time, with an empty row wherever the winding pauses.

    A line through them then breaks where the motor held or turned back, instead of jumping.
    """
    chosen = points[(points["stroke"] == stroke) & (points["phase"] == "winding") & (points["string"] == string)]
    chosen = chosen.sort_values("time_s", ignore_index=True)
    step_s = chosen["time_s"].diff()
    pauses = np.flatnonzero(step_s > PAUSE_STEPS * step_s.median())
    chosen.index = chosen.index.astype(float)
    breaks = pd.DataFrame(np.nan, index=pauses - 0.5, columns=SHOWN)
    return pd.concat([chosen[SHOWN], breaks]).sort_index() if len(pauses) else chosen[SHOWN]


def windings(points: pd.DataFrame, of_stroke: Mapping[int, Sequence[str]]) -> list[pd.DataFrame]:
    """The winding of each stroke, of its one string."""
    return [winding(points, stroke, string) for stroke, (string,) in of_stroke.items()]


def strokes_of(points: pd.DataFrame) -> list[int]:
    """Strokes with a winding, in order."""
    return sorted({int(stroke) for stroke in points.loc[points["phase"] == "winding", "stroke"]})
