"""Contractions that a model gives for no twist of a range, at each question's stroke, direction and load."""

from collections.abc import Callable

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ....ground.kinematics import Array
from ...interface import Model

Turns = tuple[float, float] | tuple[Array, Array]  # the least and the largest twist: of all questions, or of each


def reached_mm(model: Model, points: pd.DataFrame, turns: Turns) -> tuple[Array, Array]:
    """The least and the largest contraction of a model between two twists, in mm.

    Each has the shape (points,); twists in turns. Contraction rises with twist but for a flat beginning, so the ends
    of the range tell.
    """
    ends = [contraction_mm(model, points, end) for end in turns]
    return np.minimum(*ends), np.maximum(*ends)


def contraction_mm(model: Model, points: pd.DataFrame, turns: float | Array) -> Array:
    """The contraction of a model at a twist in turns, one or of shape (points,), in each question's state, in mm."""
    return model.forward(points.assign(motor_turns=turns, displacement_mm=np.nan))


def unreached(model: Model, points: pd.DataFrame, turns: Turns) -> NDArray[np.bool_]:
    """Whether each question's contraction lies beyond those of the model between two twists.

    `points` tell the contraction in mm, `turns` the two twists in turns. The mask has the shape (points,).
    """
    least_mm, most_mm = reached_mm(model, points, turns)
    asked_mm = points["displacement_mm"].to_numpy(float)
    return np.asarray((asked_mm < least_mm) | (asked_mm > most_mm), bool)


def brought(
    model: Model, points: pd.DataFrame, turns: tuple[Array, Array], room_mm: Callable[[Array], Array]
) -> tuple[Array, NDArray[np.bool_]]:
    """Each question's twist, limited to its range, and whether it then gives another contraction than asked for.

    Another is one that is further off than `room_mm`, by twists in turns, at the answered twist. `points` tell the
    contraction in mm, `turns` the ends of the range in turns; all have the shape (points,).
    """
    low, high = turns
    wished = model.inverse(points)
    twist = np.clip(wished, low, high)
    low_mm, high_mm = contraction_mm(model, points, low), contraction_mm(model, points, high)
    asked_mm = points["displacement_mm"].to_numpy(float)
    under, over = asked_mm < np.minimum(low_mm, high_mm), asked_mm > np.maximum(low_mm, high_mm)
    twist = np.where(over, np.where(high_mm >= low_mm, high, low), twist)
    twist = np.where(under, np.where(high_mm >= low_mm, low, high), twist)
    off_mm = np.abs(contraction_mm(model, points, twist) - asked_mm)
    return twist, (under | over | (twist != wished)) & (off_mm > room_mm(twist))
