"""Questions answered by a saved model in Python, within the ranges of its export: what header and graphs say."""

from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..models.parts.reach import unreached
from ..models.parts.unanswered import first_rows, ranged
from .inputs import ANSWER, Field
from .interface import Source
from .source import Beside, opened

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
    masks = {field: _outside(source, field, points, file) for field in source.inputs.columns(known)}
    held = _held(source, points, value) if known == "displacement_mm" else np.zeros(len(points), bool)
    inside = ~np.any([*masks.values(), held], axis=0)
    reasons = []
    for row in first_rows(inside):
        wrong = [field for field, mask in masks.items() if mask[row]]
        why = [_reason(source, field, points.iloc[row]) for field in wrong]
        nowhere = f"no twist in its range gives {points[known].iloc[row]:g} mm in this state (TSA_HELD)"
        reasons.append(f"row {row + 1}: {'; '.join(why) or nowhere}")
    return pd.DataFrame({ANSWER[known]: value, "inside": inside}), reasons


def _reason(source: Source, field: Field, question: pd.Series) -> str:
    """What is wrong with one number of a question."""
    takes = ranged(field.low, field.high, field.unit)
    if field.name == "material":
        takes = ", ".join(source.inputs.materials)
    return f"{field.name} {question[field.name]}: the export takes {takes}"


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
