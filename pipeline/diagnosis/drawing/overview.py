"""The panels over time: the recording with the simulators that differ visibly, their residuals, and the load."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure

from ...ground.kinematics import Array
from ..choice.outcome import rms
from ..recording.drivers import Drivers
from ..words.language.quantity import listing, size
from .panels import SHADES

SHADE, UNSEEN = "#f4ecd8", "shaded: the strokes that are left out for the error on unseen strokes"
OFF, GOES_OFF = "#f6d5d5", "red: the reading goes off"
SEEN = 0.02  # of the recording's range: a simulator that never leaves it by more would lie on it, and is not drawn
APART = 0.2  # of the range of a run: zeros of runs that differ by more would squash the strokes
WIDE = 4.0  # times the largest other residual: a wider one would squash the others, and is told as a number
NEARLY = 85.0  # percentile: a line that leaves another one in a few samples alone lies under it
LEAST, MOST = 1.0, 99.0  # percentiles: of the readings of a run, for its lowest; of what a simulator leaves


def overview(
    part: SubFigure, drivers: Drivers, measured: Array, simulations: dict[str, Array], reading: str,
    seen_s: list[float] | None = None, off_s: Sequence[tuple[float, float]] = (),
) -> None:  # fmt: skip
    """Draw the panels; the last two of `simulations` are those whose residuals the other panels show.

    Each array has the shape (samples,), in the reading's unit; `reading` is what the reading is called, and
    `seen_s` how much of each run the fit had without the last strokes, from its begin; None where none were left out.
    `off_s`: from when to when the reading goes off, on the clock of `drivers.elapsed_s`.
    """
    loaded, unit = has_load(drivers), drivers.units.reading
    heights = [2.0, 1.4, 0.6] if loaded else [2.0, 1.2]
    over, under, *rest = part.subplots(len(heights), 1, sharex=True, height_ratios=heights)
    zeros, whence = own_zeros(drivers, measured)
    shown = seen(measured, simulations)
    lines: dict[str, tuple[Array, dict[str, Any]]] = {"recording": (measured - zeros, {"color": "0.1", "lw": 2.4})}
    wide = {name: 1.4 if name == "calibrated" else 0.8 for name in shown}  # what lies below stays seen
    lines |= {name: (simulations[name] - zeros, {"color": SHADES[name], "lw": wide[name]}) for name in shown}
    panels = [over, under, *rest]
    unseen = {axes: unseen_part(axes, drivers, seen_s or []) for axes in panels}
    over_time(over, drivers, lines, f"{reading} ({unit}){whence}")
    hidden = [name for name in simulations if name not in shown]
    if hidden:
        they = "they" if len(hidden) > 1 else "it"
        over.set_title(f"not drawn, for {they} would lie on these lines: {listing(hidden)}", fontsize=7, loc="left")
    residuals = {name: measured - values for name, values in simulations.items()}
    _residuals(under, drivers, residuals, unit)
    for axes in rest:
        load = drivers.load * drivers.units.load_size
        over_time(axes, drivers, {"load": (load, {"color": "0.1", "lw": 0.8})}, f"load ({drivers.units.load})")
        axes.get_legend().remove()
    (rest or [under])[-1].set_xlabel("time (s)")
    for axes in panels:
        for begin_s, end_s in off_s:
            axes.axvspan(begin_s, end_s, color=OFF, lw=0, zorder=0.5)  # above what is shaded, below the lines
    signs = [*([UNSEEN] if unseen[over] else []), *([GOES_OFF] if off_s else [])]
    if signs:
        under.set_title("; ".join(signs), fontsize=7, loc="left")


def has_load(drivers: Drivers) -> bool:
    """Whether the load has a panel: it varies, or a few strokes had another one."""
    return drivers.loaded or bool(drivers.under_another_load)


def over_time(axes: Axes, drivers: Drivers, lines: dict[str, tuple[Array, dict[str, Any]]], label: str) -> None:
    """Channels over time, thinned to what a page can show.

    Each channel has the shape (samples,), in the unit that its label says.
    """
    step = max(1, len(drivers.time_s) // 5000)
    show, breaks = slice(None, None, step), -(-drivers.breaks // step)  # no line leads from run to run
    time_s = np.insert(drivers.elapsed_s[show], breaks, np.nan)
    for name, (values, style) in lines.items():
        axes.plot(time_s, np.insert(values[show], breaks, np.nan), label=name, **style)
    axes.set(xlim=(0.0, drivers.elapsed_s[-1]))
    axes.set_ylabel(label, fontsize=8)  # panels are low: larger ones would touch
    axes.legend(fontsize=7, ncols=len(lines), loc="lower right", bbox_to_anchor=(1.0, 1.0), frameon=False)


def unseen_part(axes: Axes, drivers: Drivers, seen_s: list[float]) -> bool:
    """Shade what the fit has not seen where the last strokes are left out; whether there is any."""
    parts = drivers.run_parts()
    shaded = False
    for part, until_s in zip(parts, seen_s if len(seen_s) == len(parts) else [], strict=False):
        time_s = drivers.elapsed_s[part]
        if time_s[0] + until_s < time_s[-1]:
            axes.axvspan(time_s[0] + until_s, time_s[-1], color=SHADE, lw=0, zorder=0)
            shaded = True
    return shaded


def own_zeros(drivers: Drivers, measured: Array) -> tuple[Array, str]:
    """What is subtracted from each run's readings, and the axis' remark; nothing where the zeros are near.

    Of shape (samples,), in the reading's unit, as `measured` is.
    """
    parts = drivers.run_parts()
    lowest = [float(np.percentile(measured[part], LEAST)) for part in parts]
    most = max(float(np.ptp(measured[part])) for part in parts)
    zeros = np.zeros(len(measured))
    if max(lowest) - min(lowest) <= APART * most:
        return zeros, ""
    for part, low in zip(parts, lowest, strict=True):
        zeros[part] = low
    return zeros, ",\neach run from its lowest"


def seen(measured: Array, simulations: dict[str, Array]) -> list[str]:
    """The simulators that differ visibly from the recording, and the last one in any case.

    Each of shape (samples,), in the reading's unit.
    """
    least = SEEN * float(np.ptp(measured))
    *_, last = simulations
    most = {name: float(np.percentile(np.abs(measured - values), MOST)) for name, values in simulations.items()}
    shown = [name for name in simulations if name == last or most[name] > least]
    return [
        name
        for place, name in enumerate(shown)
        if not any(_alike(simulations[name], simulations[later], least) for later in shown[place + 1 :])
    ]


def _alike(values: Array, others: Array, least: float) -> bool:
    """Whether the lines of two signals of shape (samples,) would cover each other nearly everywhere."""
    return bool(np.percentile(np.abs(values - others), NEARLY) <= least)


def _residuals(axes: Axes, drivers: Drivers, residuals: dict[str, Array], unit: str) -> None:
    """The residual of each simulator; of one far larger than the others only its size, in the legend."""
    *_, other, _ = [rms(values) for values in residuals.values()]
    lines: dict[str, tuple[Array, dict[str, Any]]] = {}
    for name, values in residuals.items():
        style: dict[str, Any] = {"color": SHADES[name], "lw": 0.6}
        if rms(values) > WIDE * other:
            label = f"{name}: {size(rms(values), unit)} rms, not drawn"
            lines[label] = np.full(len(values), np.nan), style
        else:
            lines[name] = values, style
    over_time(axes, drivers, lines, f"residual ({unit})")
