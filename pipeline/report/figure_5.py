"""Figure 5 of the paper: models against the measurement, stroke by stroke, and the errors beneath the curves."""

from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullLocator, SymmetricalLogLocator

from pipeline.report import paper
from pipeline.report.drawing import MILLIMETRES, TURNS, name
from pipeline.report.strokes_there import drawn
from pipeline.report.winding import strokes_of, winding

MEASURED: dict[str, Any] = {"color": "0.72", "lw": 4.0, "solid_capstyle": "butt"}
TRADITIONAL: dict[str, Any] = {"color": "#0072b2", "ls": "--", "lw": 1.2}
LEARNED: tuple[dict[str, Any], ...] = (
    {"color": "#d55e00", "ls": "", "marker": ".", "ms": 4.0, "mew": 0, "zorder": 3},
    {"color": "#00684c", "ls": "", "marker": "x", "ms": 3.0, "mew": 0.7},
)
MOST = 0.9  # of the learned errors lie within the decade above the straight part of their axis
WAYS = (("motor_turns", "displacement_mm", "forward_mm"), ("displacement_mm", "motor_turns", "inverse_turns"))


def straight_up_to(errors: list[np.ndarray]) -> float:
    """Where the error's axis turns from straight to logarithmic: the decade below most of the learned errors."""
    sizes = np.abs(np.concatenate([np.empty(0), *errors]))
    sizes = sizes[np.isfinite(sizes)]
    large = float(np.quantile(sizes, MOST)) if len(sizes) else 0.0
    return float(10.0 ** np.floor(np.log10(large))) if large > 0.0 else 1.0


def _scale(axes: Axes, straight: float) -> None:
    axes.set_yscale("symlog", linthresh=straight, linscale=0.7)
    axes.yaxis.set_major_locator(SymmetricalLogLocator(base=10.0, linthresh=straight))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}".replace("-", "−")))
    axes.axhline(0, color="k", lw=0.6)


def _drawn(curve: Axes, below: Axes, shown: pd.DataFrame, way: tuple[str, str, str], style: dict[str, Any]) -> None:
    """A model's curve, and beneath it the curve minus the measurement."""
    given, asked, said = way
    ordered = shown.dropna().sort_values(given) if style.get("ls") == "--" else shown
    curve.plot(ordered[given], ordered[said], **style)
    below.plot(shown[given], shown[said] - shown[asked], **{**style, "lw": 0.9})


def figure_5(recorded: pd.DataFrame, learned: dict[str, pd.DataFrame], material: str) -> Figure:
    """Curves of the models with an error row beneath, forward above and inverse below, a column for each stroke.

    `recorded` holds every moving point with the traditional model's `forward_mm` and `inverse_turns`; `learned` maps
    titles, the INN's first, to held-out points with what that model predicts.
    """
    strokes = drawn(strokes_of(recorded), paper.STROKES)
    columns = max(len(strokes), 1)
    figure, grid = plt.subplots(
        4, columns, figsize=(1.4 + 2.75 * columns, 9.6), sharey="row", squeeze=False,
        gridspec_kw={"height_ratios": [1.5, 1.0, 1.5, 1.0]},
    )  # fmt: skip
    styles = dict(zip(learned, LEARNED, strict=False))
    shown = {title: [winding(points, stroke) for stroke in strokes] for title, points in learned.items()}
    for row, (way, label) in enumerate(zip(WAYS, (("forward", TURNS), ("inverse", MILLIMETRES)), strict=True)):
        given, asked, said = way
        errors = [one[said] - one[asked] for windings in shown.values() for one in windings]
        straight = straight_up_to([error.to_numpy() for error in errors])
        unit = (MILLIMETRES, "model − measured (mm)") if row == 0 else (TURNS, "model − measured (turns)")
        for column, stroke in enumerate(strokes):
            curve, below = grid[2 * row, column], grid[2 * row + 1, column]
            below.sharex(curve)
            curve.tick_params(labelbottom=False)
            measured = winding(recorded, stroke)
            curve.plot(measured[given], measured[asked], label="measured", **MEASURED)
            _drawn(curve, below, measured, way, {**TRADITIONAL, "label": "traditional model"})
            for title, windings in shown.items():
                _drawn(curve, below, windings[column], way, {**styles[title], "label": f"{title}, held-out points"})
            _scale(below, straight)
            first = column == 0
            letter = "abcdef"[3 * row + column]
            name(curve, f"({letter}) {label[0]}, n={stroke}", "", unit[0] if first else "")
            name(below, f"error of ({letter}), logarithmic beyond ±{straight:g}", label[1], unit[1] if first else "")
    if strokes:
        figure.legend(handles=grid[0, 0].get_lines(), loc="outside lower center", ncols=4)
    figure.suptitle(f"{material}: winding{'' if strokes else ' (no winding was recorded)'}")
    return figure
