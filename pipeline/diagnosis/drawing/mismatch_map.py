"""The map of a mismatch: its mean by stroke and by place on the stroke, up and down again."""

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from ..recording.working_samples import PHASES
from ..words.language.quantity import at
from .panels import BINS, MOTION, ways

EMPTY = "0.8"  # the grey of a cell without samples: white is a residual of 0
TURN: dict[str, Any] = {"color": "k", "lw": 0.8}
BREAK: dict[str, Any] = {"color": "k", "lw": 0.8, "ls": "--"}


def map_of(drivers: Drivers, residual: Array) -> tuple[Array, NDArray[np.intp], Array]:
    """Mean residual by stroke and place on the stroke (up, then down again); the strokes; edges of the motion.

    Shapes (strokes, places), (strokes,) and (places + 1,); in the reading's unit, as a count, in the motion's unit.
    """
    edges = np.linspace(drivers.motion.min(), drivers.motion.max() + 1e-9, BINS + 1)
    strokes = np.unique(drivers.stroke[drivers.stroke > 0])
    down = drivers.phase >= PHASES.index("unwinding")
    column = np.clip(np.digitize(drivers.motion, edges) - 1, 0, BINS - 1)
    column = np.where(down, 2 * BINS - 1 - column, column)
    worked = drivers.stroke > 0
    place = np.searchsorted(strokes, drivers.stroke[worked]), column[worked]
    total, count = np.zeros((len(strokes), 2 * BINS)), np.zeros((len(strokes), 2 * BINS))
    np.add.at(total, place, residual[worked])
    np.add.at(count, place, 1.0)
    return np.where(count > 0, total / np.maximum(count, 1.0), np.nan), strokes, edges


def begins_of_runs(drivers: Drivers) -> list[int]:
    """The first stroke of each run after the first, as a number."""
    later = (drivers.stroke[place:][drivers.stroke[place:] > drivers.stroke[place - 1]] for place in drivers.breaks)
    return [int(strokes[0]) for strokes in later if len(strokes)]


def map_signs(drivers: Drivers, residual: Array) -> list[Artist]:
    """What the lines and the empty cells of a map mean, for a legend; `residual` of shape (samples,), in any unit."""
    _, down = ways(drivers)
    signs: list[Artist] = [Line2D([], [], **TURN, label=f"the turn; right of it: {down}")]
    if begins_of_runs(drivers):
        signs.append(Line2D([], [], **BREAK, label="between two runs"))
    if np.isnan(map_of(drivers, residual)[0]).any():
        signs.append(Patch(color=EMPTY, label="nothing recorded"))
    return signs


def mismatch_map(axes: Axes, drivers: Drivers, residual: Array, title: str, limit: float, motion: str = "") -> Any:
    """The map of a residual; returns the image, for its colour bar.

    It has the shape (samples,), in the reading's unit, as `limit` is. `motion` is what the page calls it.
    """
    mean, strokes, edges = map_of(drivers, residual)
    image = axes.imshow(mean, aspect="auto", cmap="RdBu_r", vmin=-limit, vmax=limit, interpolation="nearest",
                        extent=(0, 2 * BINS, strokes[-1] + 0.5, strokes[0] - 0.5))  # fmt: skip
    axes.set_facecolor(EMPTY)  # of the cells in which nothing was recorded
    axes.axvline(BINS, **TURN)
    for first in begins_of_runs(drivers):
        axes.axhline(first - 0.5, **BREAK)
    up, down = ways(drivers)
    low, high = (at(float(edge), "", float(np.ptp(edges))) for edge in (edges[0], edges[-1]))  # as the page says them
    axes.set_xticks(
        [0, BINS / 2, BINS, 3 * BINS / 2, 2 * BINS],
        [low, f"{up} →", high, f"→ {down}", low],
    )
    axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    unit = drivers.units.motion
    axes.set(title=title, xlabel=f"{motion or MOTION.get(unit, MOTION[''])} ({unit})", ylabel="stroke")
    return image
