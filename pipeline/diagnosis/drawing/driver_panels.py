"""The panels that show what a residual follows: its mean in bins of a signal, or over whole strokes where it is slow.

In equal bins of time strokes beat with the bins, and what differs between winding and unwinding looks like a zigzag.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.ticker import MaxNLocator

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .panels import BAND, BINS, MOTION, SHADES, ways
from .stroke_means import stroke_means

MARGIN = 0.12  # of a panel's height: above and below its points, so that none touches the frame
TICKS = 5  # steps between numbers below a panel, at most
GAP = 4.0  # bins: points further apart are not joined by a line
STILL_C = 0.1  # a temperature that moves by less is followed by nothing that a sensor shows
RARE = 0.003  # of the samples: a bin with fewer shows no mean
TIME, TEMPERATURE = "time (s)", "temperature (°C)"
MIXED = "load ("  # begins a label: both ways lie in one mean, so that a line would go to and fro between them
SLOW = (TIME, TEMPERATURE)  # what hardly changes within a stroke


def listeners(drivers: Drivers, pitch: float = 0.0, motion: str = "") -> dict[str, tuple[Array, Array]]:
    """Signals that a residual may follow, by their label, and the samples that count for each.

    Both of shape (samples,): the signal in the unit of its label, and a mask. `pitch`, in the motion's unit, is that of
    a named ripple, or 0; `motion` is what the page calls the motion.
    """
    everywhere = np.ones(len(drivers.motion), bool)
    moving = np.abs(drivers.rate) > 0.05 * np.abs(drivers.rate).max()
    units, (up, down) = drivers.units, ways(drivers)
    going = motion or MOTION.get(units.motion, MOTION[""])
    channels = {
        f"{going}, {up} ({units.motion})": (drivers.motion, moving & (drivers.rate > 0)),
        f"{going}, {down} ({units.motion})": (drivers.motion, moving & (drivers.rate < 0)),
        TIME: (drivers.elapsed_s, everywhere),
        f"rate ({units.motion}/s)": (drivers.rate, everywhere),
    }
    if pitch:
        channels[f"place within a ripple of {pitch:.3g} {units.motion}"] = drivers.motion % pitch, moving
    if drivers.loaded:  # else it moves by no more than its noise, which nothing follows
        channels[f"load ({units.load})"] = drivers.load * units.load_size, everywhere
    if drivers.turn and drivers.span > drivers.turn:
        channels["angle within the turn (turns)"] = ((drivers.motion / drivers.turn) % 1.0, moving)
    if drivers.temperature_c is not None:
        warmth_c = drivers.smooth(drivers.temperature_c)
        if np.ptp(warmth_c) > STILL_C:
            channels[TEMPERATURE] = warmth_c, everywhere
    return {
        label: pair for label, pair in channels.items() if pair[1].sum() > BINS and np.ptp(pair[0]) > 0
    }  # a constant is followed by nothing


def filled(figure: SubFigure, count: int) -> list[Axes]:
    """That many panels in two rows without a gap; all share the axis of the first panel."""
    upper = (count + 1) // 2
    grid = figure.add_gridspec(2 if count > 1 else 1, upper * max(count - upper, 1))
    filled_axes: list[Axes] = []
    for row, many in enumerate((upper, count - upper)):
        wide = upper * max(count - upper, 1) // max(many, 1)
        for place in range(many):
            share = {"sharey": filled_axes[0]} if filled_axes else {}
            filled_axes.append(figure.add_subplot(grid[row, place * wide : (place + 1) * wide], **share))
            filled_axes[-1].tick_params(labelleft=place == 0)
    return filled_axes


def by_driver(
    axes: Axes, signal: Array, residuals: dict[str, Array], floor: float, label: str, period: float = 0.0
) -> None:
    """Mean residual in bins of a signal, before and after, over the noise floor's band; rare values are left out.

    A bin is as wide as whole periods, if the residual has one, for a ripple beats with other bins.
    Each of shape (samples,), in its unit; the period in the signal's.
    """
    low, high = (float(end) for end in np.percentile(signal, [0.5, 99.5]))
    number = BINS
    if period:
        wide = np.ceil((high - low) / BINS / period) * period
        number = max(int((high - low) / wide), 1)
        high = low + number * wide
    edges = np.linspace(low, high, number + 1)
    bins = np.clip(np.digitize(signal, edges) - 1, 0, number - 1)
    count = np.bincount(bins, minlength=number)
    usual = count > RARE * len(signal)
    middle = 0.5 * (edges[1:] + edges[:-1])[usual]
    even = np.diff(middle).max(initial=0.0) < GAP * (edges[1] - edges[0])  # points far apart are not joined
    means = [np.bincount(bins, weights=each, minlength=number)[usual] / count[usual] for each in residuals.values()]
    joined = even and not label.startswith(MIXED)
    _draw(axes, middle, dict(zip(residuals, means, strict=True)), floor, label, joined)


def by_stroke(
    axes: Axes, drivers: Drivers, signal: Array, residuals: dict[str, Array], floor: float, label: str
) -> bool:
    """Mean residual of whole strokes over the mean of a slow signal; False if there are too few strokes.

    Each of shape (samples,), in its unit.
    """
    where, *means = stroke_means(drivers, np.array([signal, *residuals.values()]))
    if not len(where):
        return False
    order = np.argsort(where, kind="stable")
    begins = drivers.breaks if label == TIME else drivers.breaks[:0]
    breaks = np.searchsorted(where[order], drivers.elapsed_s[begins])  # no line leads from run to run
    by_name = {name: np.insert(mean[order], breaks, np.nan) for name, mean in zip(residuals, means, strict=True)}
    _draw(
        axes, np.insert(where[order], breaks, np.nan), by_name, floor, f"{label}, means of whole strokes", label == TIME
    )
    return True


def _draw(axes: Axes, places: Array, means: dict[str, Array], floor: float, label: str, joined: bool) -> None:
    """Means over their places, by simulator, over the noise floor's band."""
    axes.axhspan(-floor, floor, color=BAND)
    axes.margins(y=MARGIN)
    style, size = (".-", 3) if joined else (".", 5)
    widths = ((1.8, 1.6), (0.8, 1.0))  # the one that is drawn first stays seen below the other
    for (name, mean), (wide, large) in zip(means.items(), widths, strict=False):
        axes.plot(places, mean, style, ms=large * size, lw=wide, color=SHADES[name], label=name)
    axes.set_xlabel(label, fontsize=8)
    axes.tick_params(labelsize=7)
    axes.ticklabel_format(axis="x", useOffset=False)
    axes.xaxis.set_major_locator(MaxNLocator(TICKS))
