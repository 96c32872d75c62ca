"""Figure 4 of the paper: the change of the string over strokes, and that of the traditional model's error."""

from typing import Any

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.figure import Figure

from ...ground.names import SYNTHETIC
from ..layout import paper
from ..shown.shown_strokes import drawn, in_figure, tabled_and_last
from ..shown.strings_together import together
from ..shown.stroke_conditions import labels
from .averaged import PARTS, averaged
from .clipped import clipped
from .drawing import COLOURS, MILLIMETRES, READING_SIZE, TURNS, name, wrapped
from .winding import SHOWN, strokes_of, winding
from .zero_of_x import zero_of_x

STROKES = (1, 3, 5, 7)  # the paper's
LEAST_POINTS = 5 * PARTS  # of a stroke, whose means are drawn
FAINT: dict[str, Any] = {"lw": 0.5, "alpha": 0.3}
MEANS = f"(b), (d): faint every sample, thick the mean over each of {PARTS} equal parts of the stroke."


def strokes_shown(recorded: list[int], material: str) -> list[int]:
    """The paper's strokes for the rig fitted to the paper; for other strings those of the tables, and the last."""
    return drawn(recorded, STROKES) if material == SYNTHETIC else tabled_and_last(recorded, paper.STROKES, len(COLOURS))


def figure_4(points: pd.DataFrame, material: str) -> Figure:
    """Recorded strokes against the traditional model, and its errors: forward above, inverse below.

    `points` holds every moving point of the material with the traditional model's `forward_mm` and `inverse_turns`.
    """
    figure, ((forward, forward_error), (inverse, inverse_error)) = plt.subplots(2, 2, figsize=(8.0, 6.5))
    recorded = strokes_of(points)
    shown = strokes_shown(recorded, material)
    named = labels(points, shown)
    strokes = {stroke: winding(points, stroke) for stroke in shown}
    noisy = [stroke for stroke, own in strokes.items() if material != SYNTHETIC and len(own) >= LEAST_POINTS]
    for colour, (stroke, stroke_points) in zip(COLOURS, strokes.items(), strict=False):
        x, turns, label = stroke_points["displacement_mm"], stroke_points["motor_turns"], named[stroke]
        forward.plot(turns, x, color=colour, lw=1.2, label=label)
        errors = stroke_points["forward_mm"] - x, stroke_points["inverse_turns"] - turns
        of_panels = ((forward_error, turns, errors[0]), (inverse_error, x, errors[1]))
        for axes, along, error in of_panels:
            axes.plot(along, error, color=colour, label=label, **(FAINT if stroke in noisy else {"lw": 0.8}))
            if stroke in noisy:
                axes.plot(*averaged(along, error), color=colour, zorder=3, lw=1.4)
        inverse.plot(x, turns, color=colour, lw=1.2, label=label)
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
        MEANS if noisy else "",
        zero_of_x(points) if shown else "",
        clipped(strokes.values(), "(c), (d)"),
    )
    figure.supxlabel(reading, fontsize=READING_SIZE, multialignment="left")
    figure.suptitle(f"{material}: winding, every recorded sample{'' if shown else ' (no winding was recorded)'}")
    return figure
