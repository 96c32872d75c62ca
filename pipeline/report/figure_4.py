"""Figure 4 of the paper: what strokes do to the string, and to the error of the traditional model."""

from typing import Any

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.figure import Figure

from . import paper
from .clipped import clipped
from .drawing import COLOURS, MILLIMETRES, READING_SIZE, TURNS, name, wrapped
from .strings_together import together
from .stroke_conditions import labels
from .strokes_there import drawn, in_figure
from .winding import SHOWN, strokes_of, winding

STROKES = (1, 3, 5, 7)


def figure_4(points: pd.DataFrame, material: str) -> Figure:
    """Recorded strokes against the traditional model, and its errors: forward above, inverse below.

    `points` holds every moving point of the material with the traditional model's `forward_mm` and `inverse_turns`.
    """
    figure, ((forward, forward_error), (inverse, inverse_error)) = plt.subplots(2, 2, figsize=(8.0, 6.5))
    recorded = strokes_of(points)
    shown = drawn(recorded, STROKES)
    named = labels(points, shown)
    strokes = {stroke: winding(points, stroke) for stroke in shown}
    for colour, (stroke, stroke_points) in zip(COLOURS, strokes.items(), strict=False):
        x, turns, label = stroke_points["displacement_mm"], stroke_points["motor_turns"], named[stroke]
        forward.plot(turns, x, color=colour, lw=1.2, label=label)
        forward_error.plot(turns, stroke_points["forward_mm"] - x, color=colour, lw=0.8, label=label)
        inverse.plot(x, turns, color=colour, lw=1.2, label=label)
        inverse_error.plot(x, stroke_points["inverse_turns"] - turns, color=colour, lw=0.8, label=label)
    if strokes:
        longest = max(strokes.values(), key=lambda points: points["motor_turns"].max() - points["motor_turns"].min())
        by_turns, by_x = (longest.dropna().sort_values(column) for column in SHOWN[:2])
        style: dict[str, Any] = {"color": "k", "ls": "--", "lw": 1.1, "label": "traditional model"}
        forward.plot(by_turns["motor_turns"], by_turns["forward_mm"], **style)
        inverse.plot(by_x["displacement_mm"], by_x["inverse_turns"], **style)
        forward.legend()
        inverse.legend()
    for axes in (forward_error, inverse_error):
        axes.axhline(0, color="k", lw=0.6)
    name(forward, "(a) forward kinematics", TURNS, MILLIMETRES)
    name(forward_error, "(b) forward error of the traditional model", TURNS, "model − measured (mm)")
    name(inverse, "(c) inverse kinematics", MILLIMETRES, TURNS)
    name(inverse_error, "(d) inverse error of the traditional model", MILLIMETRES, "model − measured (turns)")
    reading = wrapped(
        figure,
        in_figure(recorded, shown, paper.STROKES),
        together(points, shown),
        clipped(strokes.values(), "(c), (d)"),
    )
    figure.supxlabel(reading, fontsize=READING_SIZE, multialignment="left")
    figure.suptitle(f"{material}: winding, every recorded sample{'' if shown else ' (no winding was recorded)'}")
    return figure
