"""Which contractions no twist of a range gives by a model, at each question's stroke, direction and load."""

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ..interface import Model


def reached_mm(model: Model, points: pd.DataFrame, turns: tuple[float, float]) -> tuple[Array, Array]:
    """The least and the largest contraction that a model gives between two twists, in mm.

    Each has the shape (points,); twists in turns. Contraction rises with twist but for a flat beginning, so the ends
    of the range tell.
    """
    ends = [model.forward(points.assign(motor_turns=end, displacement_mm=np.nan)) for end in turns]
    return np.minimum(*ends), np.maximum(*ends)


def unreached(
    model: Model, points: pd.DataFrame, turns: tuple[float, float], room_mm: float = 0.0
) -> NDArray[np.bool_]:
    """Whether each question's contraction lies more than `room_mm` beyond what the model gives between two twists.

    `points` tell the contraction in mm, `turns` the two twists in turns. The mask has the shape (points,).
    """
    least_mm, most_mm = reached_mm(model, points, turns)
    asked_mm = points["displacement_mm"].to_numpy(float)
    return np.asarray((asked_mm < least_mm - room_mm) | (asked_mm > most_mm + room_mm), bool)
