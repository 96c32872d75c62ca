"""Questions answered by a saved model in Python, within the ranges of its export: what header and graphs say."""

from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..models.parts.reach import unreached
from .inputs import ANSWER
from .interface import Source
from .source import Beside, opened

NEAR = 1e-6  # of the range: a twist that was brought to its end
MAPS = {"motor_turns": "forward", "displacement_mm": "inverse"}  # by what is known


def answers(file: Path, points: pd.DataFrame, known: str, dataset: Path) -> pd.DataFrame:
    """The value of each question, in the answer's unit, and `inside`: whether the export would answer it.

    `points` have the dataset's columns, of which `known` is the twist or the contraction that is asked about. Raises
    BadInput for a file that holds no model which can be exported.
    """
    source = opened(file, None, Beside(dataset=dataset))
    value = np.asarray(getattr(source.model, MAPS[known])(points), float)
    inside = _inside(source, points, known, file)
    if known == "displacement_mm":
        inside &= ~_held(source, points, value)
    return pd.DataFrame({ANSWER[known]: value, "inside": inside})


def _held(source: Source, points: pd.DataFrame, turns: Array) -> NDArray[np.bool_]:
    """Which twists the export holds at an end of its range, as none within gives the contraction; shape (points,)."""
    low, high = source.inputs.motor_turns
    at_end = (turns <= low + NEAR * (high - low)) | (turns >= high - NEAR * (high - low))
    return (turns < low) | (turns > high) | (at_end & unreached(source.model, points, (low, high)))


def _inside(source: Source, points: pd.DataFrame, known: str, file: Path) -> pd.Series:
    """Which questions lie within the ranges of the export; a boolean of shape (points,)."""
    inside = pd.Series(True, index=points.index)
    for field in source.inputs.columns(known):
        if field.name == "material":
            inside &= points["material"].isin(source.inputs.materials)
        elif field.name not in points:
            raise BadInput(file, field.name, "is read by the model, and the dataset lacks it", "say the right dataset")
        else:
            inside &= points[field.name].between(field.low, field.high)
    return inside
