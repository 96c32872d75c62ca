"""An axis of errors as wide as the thick means: single samples near a clipped root would take half of it."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes

from ...ground.kinematics import Array

ROOM = 0.05  # of what the axis shows, left free at both its ends
OFF = "{}: the axis shows the means. Single samples lie beyond it, the farthest at {} turns."


def axis_of_means(axes: Axes, means: Sequence[Array], samples: Sequence[Array], where: str) -> str:
    """Set a panel's axis by means and 0; a sentence on samples beyond it, or empty where none is.

    Both hold errors of a stroke each in turns, shape (parts,) and (points,), NaN where none is; `where` names
    the panel.
    """
    shown = np.concatenate([*means, [0.0]])
    low, high = float(np.nanmin(shown)), float(np.nanmax(shown))
    room = ROOM * (high - low or 1.0)
    low, high = low - room, high + room
    axes.set_ylim(low, high)
    every = np.concatenate(samples)
    beyond = every[(every < low) | (every > high)]
    if not len(beyond):
        return ""
    farthest = f"{beyond[np.argmax(np.abs(beyond))]:.2g}".replace("-", "−")
    return OFF.format(where, farthest)
