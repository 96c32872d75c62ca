"""Which contractions no twist of a range gives by a model, at each question's stroke, direction and load."""

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..interface import Model


def unreached(
    model: Model, points: pd.DataFrame, turns: tuple[float, float], room_mm: float = 0.0
) -> NDArray[np.bool_]:
    """Whether each question's contraction lies more than `room_mm` beyond what the model gives between two twists.

    `points` tell the contraction in mm, `turns` the two twists in turns. Contraction rises with twist but for a flat
    beginning, so the ends of the range tell. The mask has the shape (points,).
    """
    ends = [model.forward(points.assign(motor_turns=end, displacement_mm=np.nan)) for end in turns]
    asked_mm = points["displacement_mm"].to_numpy(float)
    return np.asarray((asked_mm < np.minimum(*ends) - room_mm) | (asked_mm > np.maximum(*ends) + room_mm), bool)
