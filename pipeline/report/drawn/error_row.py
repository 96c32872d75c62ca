"""The row of errors beneath a figure's curves: sizes by ranges of the stroke, on a logarithmic axis with a foot."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from ...ground.kinematics import Array

FOOT = 0.25  # of the best model's usual error
STEPS = (1.0, 2.0, 5.0)  # where an axis may begin within its decade, and its numbers
CLEAR = 0.8  # of the least error: where an axis begins that has none below its foot
BINS, LEAST = 24, 2  # ranges of what is given, and points in one that make a root mean square
FEW_DECADES = 2.0  # of an axis: up to so many it has numbers within a decade


def by_range(x: Array, error: Array, low: float, high: float) -> tuple[Array, Array]:
    """Middles of equal ranges from `low` to `high`, and the root mean square of the errors there.

    NaN where a range holds few points, so that a line breaks between blocks that were held out.
    From shape (points,) to shape (ranges,), each in its own unit.
    """
    is_finite = np.isfinite(error) & np.isfinite(x)
    edges = np.linspace(low, high, BINS + 1)
    place = np.clip(np.digitize(x[is_finite], edges) - 1, 0, BINS - 1)
    count = np.bincount(place, minlength=BINS)
    squares = np.bincount(place, weights=np.square(error[is_finite]), minlength=BINS)
    is_enough = count >= LEAST
    return 0.5 * (edges[1:] + edges[:-1]), np.sqrt(np.where(is_enough, squares, np.nan) / np.maximum(count, 1))


def _logarithmic(axes: Axes) -> None:
    """Plain numbers on a logarithmic axis: 0.02, 0.05, 0.1; over many decades 0.01, 0.1."""
    low, high = axes.get_ylim()
    within = STEPS if high <= low * 10.0**FEW_DECADES else (1.0,)
    axes.yaxis.set_major_locator(LogLocator(subs=within))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def as_bars(middle: Array, size: Array, width: float) -> tuple[Array, Array]:
    """Each size as a level line over its range, with a gap behind it, so that no line joins two ranges.

    `middle` and `width` in the unit of what is given, `size` in that of the error; from shape (ranges,) to shape
    (3 · ranges,).
    """
    gap = np.full_like(middle, np.nan)
    ends = np.column_stack([middle - 0.5 * width, middle + 0.5 * width, gap])
    return ends.ravel(), np.column_stack([size, size, gap]).ravel()


def foot_of(sizes: list[Array]) -> float:
    """The lowest size that an axis shows: only by luck is a range below a quarter of the best model's usual size.

    Errors in the unit of the axis, each of shape (ranges,).
    """
    usual = [float(np.nanmedian(size)) for size in sizes if np.isfinite(size).any()]
    least = FOOT * min((size for size in usual if size > 0.0), default=1.0)
    decade = 10.0 ** np.floor(np.log10(least))
    return float(max(step * decade for step in STEPS if step * decade <= least * (1.0 + 1e-9)))


def footed(row: list[Axes], unit: str) -> str:
    """Smaller errors are drawn on the foot of their row of axes; returns the foot with its unit, if any are."""
    lines = [line for axes in row for line in axes.get_lines()]
    by_model: dict[str, list[Array]] = {}
    for line in lines:
        by_model.setdefault(str(line.get_label()), []).append(np.asarray(line.get_ydata(), float))
    foot = foot_of([np.concatenate(sizes) for sizes in by_model.values()])
    is_below = False
    for line in lines:
        size = np.asarray(line.get_ydata(), float)
        is_below = is_below or bool((size < foot).any())
        line.set_ydata(np.where(size < foot, foot, size))
        line.set_clip_on(False)
    least = min(
        (float(np.nanmin(size)) for sizes in by_model.values() for size in sizes if np.isfinite(size).any()),
        default=foot,
    )
    for axes in row:
        axes.set_ylim(bottom=max(foot, CLEAR * least))
        _logarithmic(axes)
    row[0].set_ylabel(f"rms error ({unit})")
    return f"{foot:g} {unit}" if is_below else ""
