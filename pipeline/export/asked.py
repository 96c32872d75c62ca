"""Questions answered by a saved model in Python, within the ranges of its export: what header and graphs say."""

from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..models.parts.reach import unreached
from .inputs import ANSWER, Field
from .interface import Source
from .source import Beside, opened

SHOWN = 5  # questions whose reason is told
NEAR = 1e-6  # of the range: a twist that was brought to its end
MAPS = {"motor_turns": "forward", "displacement_mm": "inverse"}  # by what is known


def answers(file: Path, points: pd.DataFrame, known: str, dataset: Path) -> tuple[pd.DataFrame, list[str]]:
    """The value of each question, in the answer's unit, and `inside`: whether the export would answer it; and why not.

    `points` have the dataset's columns, of which `known` is the twist or the contraction that is asked about. A
    sentence for each of the first questions that the export does not answer. Raises BadInput for a file that holds no
    model which can be exported.
    """
    source = opened(file, None, Beside(dataset=dataset))
    value = np.asarray(getattr(source.model, MAPS[known])(points), float)
    reasons = [""] * len(points)
    for field in source.inputs.columns(known):
        for row in np.flatnonzero(_outside(source, field, points, file)):
            unit = "" if field.unit == "1" else f" {field.unit}"
            range_ = f"the export takes {field.low:.4g} to {field.high:.4g}{unit}"
            reasons[row] = reasons[row] or f"{field.name} {points[field.name].iloc[row]}: {range_}"
    if known == "displacement_mm":
        for row in np.flatnonzero(_held(source, points, value)):
            asked_mm = points[known].iloc[row]
            reasons[row] = reasons[row] or f"no twist in its range gives {asked_mm:g} mm in this state (TSA_HELD)"
    table = pd.DataFrame({ANSWER[known]: value, "inside": [not reason for reason in reasons]})
    return table, [f"row {row}: {reason}" for row, reason in enumerate(reasons, 1) if reason][:SHOWN]


def _outside(source: Source, field: Field, points: pd.DataFrame, file: Path) -> NDArray[np.bool_]:
    """Which questions lie outside the range of one input of the export; shape (points,)."""
    if field.name == "material":
        return ~points["material"].isin(source.inputs.materials).to_numpy(bool)
    if field.name not in points:
        raise BadInput(file, field.name, "is read by the model, and the dataset lacks it", "say the right dataset")
    return ~points[field.name].between(field.low, field.high).to_numpy(bool)


def _held(source: Source, points: pd.DataFrame, turns: Array) -> NDArray[np.bool_]:
    """Which twists the export holds at an end of its range, as none within gives the contraction; shape (points,)."""
    low, high = source.inputs.motor_turns
    at_end = (turns <= low + NEAR * (high - low)) | (turns >= high - NEAR * (high - low))
    return (turns < low) | (turns > high) | (at_end & unreached(source.model, points, (low, high)))
