"""A stiffness that nobody measured: it follows from the radius and the length, and is no remark of its own."""

from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd

from ....ground.kinematics import Mask, usual_stiffness

STIFFNESS = "stiffness_n_per_mm"
OF = ("radius_mm", "length_mm")  # from which it follows
SAME = 1e-6  # relative: a stiffness that was computed
ROUNDED = 1e-3  # relative: a usual stiffness that is told with four digits


def is_never_measured(points: pd.DataFrame) -> bool:
    """Whether all recorded points have the usual stiffness of their string's radius and length."""
    return bool(_has_usual(points, SAME).all())


def _has_usual(points: pd.DataFrame, relative: float) -> Mask:
    """Whether each point has the usual stiffness, but for a relative difference; of shape (points,), without unit."""
    usual = usual_stiffness(*(points[name].to_numpy(float) for name in OF))
    return np.isclose(points[STIFFNESS].to_numpy(float), usual, rtol=relative)


def said_once(
    points: pd.DataFrame, by_column: Mapping[str, Sequence[str]], never_measured: bool
) -> dict[str, list[str]]:
    """Remarks on each point by the column that they are of, without one on a stiffness that repeats one on its radius.

    It does so where the point's stiffness is the usual one, or that of no recorded string was measured. An empty remark
    is none.
    """
    remarks = {name: list(sentences) for name, sentences in by_column.items()}
    if STIFFNESS not in remarks or not set(OF) & set(remarks):
        return remarks
    for row in np.flatnonzero(_has_usual(points, ROUNDED) | never_measured):
        if any(remarks[name][row] for name in OF if name in remarks):
            remarks[STIFFNESS][row] = ""
    return remarks
