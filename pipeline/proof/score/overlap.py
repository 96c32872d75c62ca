"""How far two boxes of twist × strokes × phase overlap: the samples in both over those in either."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ...run.samples import read_strokes
from ...run.strokes import of_samples
from ..sealed import Box

EDGE_TURNS = 1e-3  # what rounding moves an edge by


def inside(box: Box, turns: Array, stroke: NDArray[Any], phase: NDArray[Any]) -> NDArray[np.bool_]:
    """Samples of a recording that a box holds; all of shape (samples,). What is before stroke 1 belongs to it.

    Twist in turns, stroke as a count.
    """
    low, high = box["motor_turns"]
    first, last = box["strokes"]
    number = np.maximum(stroke, 1)
    is_inside = (turns >= low - EDGE_TURNS) & (turns <= high + EDGE_TURNS)
    is_inside &= (number >= max(first, 1)) & (number <= max(last, 1))
    return np.asarray(is_inside if box["phase"] == "all" else is_inside & (phase == box["phase"]))


def overlap(run: Path, first: Box, other: Box) -> float:
    """Intersection over union of two boxes on the samples of a recording."""
    _, samples, strokes = read_strokes(run)
    turns = samples["motor_turns"].to_numpy()
    stroke, phase = of_samples(strokes)
    masks = [inside(box, turns, stroke, phase) for box in (first, other)]
    either = int((masks[0] | masks[1]).sum())
    return float((masks[0] & masks[1]).sum() / either) if either else 0.0
