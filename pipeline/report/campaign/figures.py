"""A campaign's two figures: errors on new strings against strokes shown, and how often prediction intervals held."""

from pathlib import Path

import matplotlib
import numpy as np
import pandas as pd

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from ...ground.stored.figure_file import write_figure
from .results import ALONE, MAPS, TOLERANCE, middles, pooled

COLOURS = ("#d55e00", "#cc79a7", "#009e73", "#0072b2", "#56b4e9", "#e69f00", "0.25")  # Okabe and Ito, then dark grey
MARKERS = "osD^vPX"
MOST_OVER_FLOOR = 3000.0  # times the floor: medians beyond it, of a net hardly trained, must not squeeze the rest
WORDS = {"forward": "contraction", "inverse": "twist"}


def few_shot(table: pd.DataFrame, floor: pd.DataFrame, titles: dict[str, str]) -> Figure:
    """Medians over the new strings against strokes shown; bands from the lower to the upper quartile."""
    figure, panels = plt.subplots(1, 2, figsize=(9.0, 4.4))
    for letter, axes, (map_, (column, unit)) in zip("ab", panels, MAPS.items(), strict=True):
        summed = middles(table, column, titles)
        for (how, name), curve in summed.groupby(["how", "title"], sort=False):
            place = list(titles).index(curve["model"].iloc[0])
            colour, marker = COLOURS[place % len(COLOURS)], MARKERS[place % len(MARKERS)]
            style = "--" if how == ALONE else "-"
            fill = "white" if how == ALONE else colour
            axes.plot(
                curve["shots"], curve["middle"], style, color=colour, marker=marker, ms=4, mfc=fill, lw=1.3, label=name
            )
            axes.fill_between(curve["shots"], curve["low"], curve["high"], color=colour, alpha=0.09, lw=0)
        level = float(floor[column].median())
        axes.axhline(level, color="k", lw=1.0, ls=":", label="floor: each string's own smooth curves")
        _logarithmic(axes, summed, level)
        axes.set_xticks(sorted(summed["shots"].unique()))
        axes.set_xlabel("strokes of the new string shown")
        axes.set_ylabel(f"RMSE of the later strokes ({unit})")
        axes.set_title(f"({letter}) {map_}: {WORDS[map_]}", loc="left")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
    strings = floor["string"].nunique()
    figure.suptitle(f"{strings} new strings: median, and the quartiles as bands; dashed: learnt from the string alone")
    return figure


def _logarithmic(axes: Axes, summed: pd.DataFrame, level: float) -> None:
    axes.set_yscale("log")
    top = min(float(summed["high"].max()) * 1.2, level * MOST_OVER_FLOOR)
    axes.set_ylim(level * 0.75, max(top, level * 4.0))
    marks = [digit * 10.0**power for power in range(-4, 5) for digit in (1, 2, 5)]
    low, high = axes.get_ylim()
    axes.set_yticks([mark for mark in marks if low <= mark <= high])
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())


def coverage(table: pd.DataFrame) -> Figure:
    """Share held against the level asked for, with a band of ± 2 points, and widths by strokes ahead."""
    figure, panels = plt.subplots(1, 3, figsize=(10.5, 3.9))
    _held(panels[0], table)
    for letter, axes, (map_, (_, unit)) in zip("bc", panels[1:], MAPS.items(), strict=True):
        curve = table[(table["map"] == map_) & (table["points"] > 0)]
        for (ahead, rows), colour in zip(curve.groupby("ahead"), COLOURS[3:], strict=False):
            widths = rows.groupby("level")["width"].quantile([0.25, 0.5, 0.75]).unstack()
            percent = 100.0 * widths.index.to_numpy()
            axes.plot(percent, widths[0.5], "o-", color=colour, ms=4, label=f"{ahead} ahead")
            axes.fill_between(percent, widths[0.25], widths[0.75], color=colour, alpha=0.12, lw=0)
        axes.set_ylim(bottom=0.0)
        axes.set_xlabel("level asked for (%)")
        axes.set_ylabel(f"width of the interval ({unit})")
        axes.set_title(f"({letter}) {map_}: median width of a string", loc="left")
        axes.legend(loc="upper left", title="strokes", title_fontsize=7.5)
    strings = table["string"].nunique()
    figure.suptitle(f"Intervals for strokes not yet made, pooled over {strings} strings; bands: quartiles over strings")
    return figure


def _held(axes: Axes, table: pd.DataFrame) -> None:
    levels = np.array(sorted(table["level"].unique()))
    ends = 100.0 * np.array([levels[0] - 0.05, min(levels[-1] + 0.04, 1.0)])
    width = 100.0 * TOLERANCE
    axes.fill_between(ends, ends - width, ends + width, color="0.87", lw=0, label="± 2 points")
    axes.plot(ends, ends, color="0.4", lw=0.8)
    for (map_, rows), colour, shift in zip(pooled(table, ["map", "level"]).groupby("map"), COLOURS[::3], (-0.5, 0.5),
                                           strict=False):  # fmt: skip
        percent, error = 100.0 * rows["level"] + shift, 196.0 * rows["error"].fillna(0.0)
        axes.errorbar(percent, 100.0 * rows["held"], yerr=error, fmt="o", color=colour, ms=4, capsize=2, label=map_)
    axes.set_xlabel("level asked for (%)")
    axes.set_ylabel("held (%; bars: 95 % over strings)")
    axes.set_title("(a) what the intervals held", loc="left")
    axes.legend(loc="upper left")


def save_svg(figure: Figure, path: Path) -> None:
    """Write a figure as svg, without a date, so that the same data gives the same bytes."""
    with plt.rc_context({"svg.hashsalt": "twistbench"}):
        write_figure(figure, path)
