"""The inputs of the learned models: twist or contraction, then the conditions b, l, r and n."""

import numpy as np
import pandas as pd

from ...ground.kinematics import Array

CONDITIONS = ("separator_mm", "length_mm", "radius_mm", "stroke")


def conditions(points: pd.DataFrame, log_stroke: bool) -> Array:
    """Separator b, length l, radius r in mm and stroke times n, shape (points, 4).

    A twisted pair has no separator: where `separator_mm` is NaN or not a column, b is the constant 0. With
    `log_stroke` n stands on a log(1 + n) axis: a string's wear-in slows down from stroke to stroke, so strokes
    beyond the training ones lie closer to them there.
    """
    columns = points.reindex(columns=list(CONDITIONS)).astype(float).fillna({"separator_mm": 0.0})
    return (columns.assign(stroke=np.log1p(columns["stroke"])) if log_stroke else columns).to_numpy(np.float64)


def twist_and_conditions(points: pd.DataFrame, log_stroke: bool = True) -> Array:
    """The INN's input (θ in turns, b, l, r, n), shape (points, 5)."""
    return np.column_stack([points["motor_turns"], conditions(points, log_stroke)])


def contraction_and_conditions(points: pd.DataFrame, log_stroke: bool = True) -> Array:
    """The INN's output (x in mm, b, l, r, n), shape (points, 5)."""
    return np.column_stack([points["displacement_mm"], conditions(points, log_stroke)])
