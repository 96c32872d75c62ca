"""The figure of the calibration: how often intervals of each level hold, and intervals beside the truth."""

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from ...ground.stored.figure_file import write_figure

COLOURS = ("#d55e00", "#0072b2", "#009e73", "#cc79a7")  # Okabe and Ito: told apart by colour-blind readers too
MARKS = ("o", "s", "^", "v")
TITLES = {"stroke_loss": "10 % of the stroke lost", "model_error": "model off by 1 mm"}
SHOWN_CUT = "50% of the life"


def levels_held(axes: Axes, rows: pd.DataFrame, levels: tuple[float, ...]) -> None:
    """Share of the intervals that hold against the level that they were given with, a line a method."""
    levels = tuple(sorted(levels))
    axes.plot([0, 100], [0, 100], color="0.4", lw=1, ls="--", label="as promised")
    for (method, part), colour, mark in zip(rows.groupby("method", sort=False), COLOURS, MARKS, strict=False):
        held_percent = [100 * part[f"held_{level:.0%}"].mean() for level in levels]
        axes.plot(
            [100 * level for level in levels], held_percent, color=colour, marker=mark, ms=4, lw=1.4, label=str(method)
        )
    axes.set(xlim=(25, 100), ylim=(0, 102), xlabel="level of the interval (%)", ylabel="intervals that hold (%)")
    axes.legend(fontsize=7.5, loc="upper left")


def against_truth(axes: Axes, rows: pd.DataFrame) -> None:
    """Each string's 90 % interval and median against the strokes that it really had left."""
    ours = rows[(rows["method"] == rows["method"].iloc[0]) & (rows["cut"] == SHOWN_CUT) & ~rows["censored"]]
    ours = ours[ours["state"] != "no claim"]
    top = 3.0 * float(ours["left"].max()) if len(ours) else 1.0
    low, high = ours["low"].clip(lower=1.0), ours["high"].clip(upper=top)
    is_held = (ours["held_90%"] == 1.0).to_numpy()
    for kept, colour, name in ((is_held, COLOURS[1], "holds"), (~is_held, COLOURS[0], "does not")):
        axes.vlines(
            ours["left"][kept], low[kept], high[kept], color=colour, lw=1.0, alpha=0.7, label=f"90 % interval {name}"
        )
    axes.plot(ours["left"], ours["median"].clip(upper=top), ".", color="k", ms=3.5, label="median")
    ends = np.array([max(float(ours["left"].min()), 1.0), float(ours["left"].max())]) if len(ours) else np.ones(2)
    axes.plot(ends, ends, color="0.4", lw=1, ls="--")
    axes.set(xscale="log", yscale="log", ylim=(1.0, top), xlabel="strokes really left", ylabel="strokes left, foretold")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.set_title(
        f"asked after {SHOWN_CUT.replace('%', ' %')}; cut off at the top: no upper end", fontsize=8.5, loc="left"
    )
    axes.legend(fontsize=7.5, loc="lower right")


def page(rows: pd.DataFrame, levels: tuple[float, ...], path: Path) -> None:
    """Draw both panels for both questions and write them as svg."""
    style: dict[Any, Any] = {
        "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
        "svg.hashsalt": "lifespan", "svg.fonttype": "none", "axes.grid": True, "grid.alpha": 0.25,
    }  # fmt: skip
    questions = list(rows.groupby("question", sort=False))
    with plt.rc_context(style):
        figure, panels = plt.subplots(
            len(questions), 2, figsize=(9.0, 3.8 * len(questions)), layout="constrained", squeeze=False
        )
        for (question, part), (level_axes, truth_axes) in zip(questions, panels, strict=True):
            levels_held(level_axes, part, levels)
            level_axes.set_title(TITLES.get(str(question), str(question)), fontsize=9.5, loc="left")
            against_truth(truth_axes, part)
        write_figure(figure, path)
        plt.close(figure)
