"""Figure 4 of the paper: the change of the string over strokes, and that of the traditional model's error."""

from typing import Any

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.figure import Figure

from ...ground.names import SYNTHETIC
from ..layout import paper
from ..shown.shown_strokes import drawn, in_figure, tabled_and_last
from ..shown.strings_drawn import LOOKS, names_drawn, side_by_side, strings_drawn, which_strings
from ..shown.stroke_conditions import labels
from .averaged import averaged, parts_of
from .axis_of_means import axis_of_means
from .clipped import clipped
from .drawing import COLOURS, MILLIMETRES, READING_SIZE, TURNS, legend_beneath, lighter, name, wrapped
from .winding import SHOWN, strokes_of, winding
from .zero_of_x import zero_of_x

STROKES = (1, 3, 5, 7)  # the paper's
MOST_STRINGS = 2  # strings that are drawn over each other
NEUTRAL, NAME_LETTERS = "0.25", 20  # of the legend's entry of a string: its colour, and letters of the string's name
LEGEND_COLUMNS = 5  # of the legend at most: four strokes and the model beside each other
FAINT: dict[str, Any] = {"lw": 0.5, "alpha": 0.3}
THICK: dict[str, Any] = {"lw": 1.4, "marker": ".", "ms": 2.0, "mew": 0.0}  # a mean between two gaps is a dot
MEANS = "(b), (d): faint every sample, thick the mean over each of {} equal parts of a stroke."
SAMPLES = "(b), (d): every sample, joined by lines; the strokes have too few for means."


def strokes_shown(recorded: list[int], material: str) -> list[int]:
    """The paper's strokes for the rig fitted to the paper; for other strings those of the tables, and the last."""
    return drawn(recorded, STROKES) if material == SYNTHETIC else tabled_and_last(recorded, paper.STROKES, len(COLOURS))


def _short(string: str) -> str:
    """A string's name as a legend has room for it."""
    return string if len(string) <= NAME_LETTERS else f"{string[: NAME_LETTERS - 1]}…"


def figure_4(points: pd.DataFrame, material: str) -> Figure:
    """Recorded strokes against the traditional model, and its errors: forward above, inverse below.

    `points` holds every moving point of the material with the traditional model's `forward_mm` and `inverse_turns`.
    """
    figure, ((forward, forward_error), (inverse, inverse_error)) = plt.subplots(2, 2, figsize=(8.0, 6.5))
    recorded = strokes_of(points)
    shown = strokes_shown(recorded, material)
    of_stroke = strings_drawn(points, shown, MOST_STRINGS)
    names, named = names_drawn(of_stroke), labels(points, of_stroke)
    looks = dict(zip(names, LOOKS, strict=False)) if side_by_side(of_stroke) else {}
    windings = {(n, string): winding(points, n, string) for n, strings in of_stroke.items() for string in strings}
    parts = 0 if material == SYNTHETIC else parts_of(own["motor_turns"].count() for own in windings.values())
    inverse_means, inverse_errors = [], []
    for (stroke, string), stroke_points in windings.items():
        rank = list(looks).index(string) if looks else 0
        colour, zorder = lighter(COLOURS[shown.index(stroke)], rank), 2.0 - 0.1 * rank
        label = named[stroke] if string == of_stroke[stroke][0] else "_"
        x, turns = stroke_points["displacement_mm"], stroke_points["motor_turns"]
        forward.plot(turns, x, color=colour, lw=1.2, label=label, zorder=zorder)
        errors = stroke_points["forward_mm"] - x, stroke_points["inverse_turns"] - turns
        of_panels = ((forward_error, turns, errors[0]), (inverse_error, x, errors[1]))
        for axes, along, error in of_panels:
            axes.plot(along, error, color=colour, label=label, zorder=zorder, **(FAINT if parts else {"lw": 0.8}))
            if parts:
                means = averaged(along, error, parts)
                axes.plot(*means, color=colour, zorder=zorder + 1.0, **THICK)
        inverse_errors.append(error.to_numpy())
        inverse_means += [means[1]] if parts else []
        inverse.plot(x, turns, color=colour, lw=1.2, label=label, zorder=zorder)
    for place, string in enumerate(names):
        rank = place if looks else 0
        own_strokes = [own for (_, own_string), own in windings.items() if own_string == string]
        longest = max(own_strokes, key=lambda points: points["motor_turns"].max() - points["motor_turns"].min())
        by_turns, by_x = (longest.dropna().sort_values(column) for column in SHOWN[:2])
        model: dict[str, Any] = {"color": lighter("k", rank), "ls": "--", "lw": 1.1, "zorder": 2.0 - 0.1 * rank}
        model["label"] = "_" if place else "traditional model"
        forward.plot(by_turns["motor_turns"], by_turns["forward_mm"], **model)
        inverse.plot(by_x["displacement_mm"], by_x["inverse_turns"], **model)
    for rank, (string, look) in enumerate(looks.items()):
        forward.plot([], [], color=lighter(NEUTRAL, rank), lw=2.4, label=f"{look}: {_short(string)}")
    for axes in (forward_error, inverse_error):
        axes.axhline(0, color="k", lw=0.6)
    name(forward, "(a) forward kinematics", TURNS, MILLIMETRES)
    name(forward_error, "(b) forward error of the traditional model", TURNS, "model − measured (mm)")
    name(inverse, "(c) inverse kinematics", MILLIMETRES, TURNS)
    name(inverse_error, "(d) inverse error of the traditional model", MILLIMETRES, "model − measured (turns)")
    how_drawn = MEANS.format(parts) if parts else SAMPLES if windings and material != SYNTHETIC else ""
    reading = wrapped(
        figure,
        in_figure(recorded, shown, paper.STROKES),
        which_strings(of_stroke, points),
        how_drawn,
        zero_of_x(points) if shown else "",
        clipped(windings.values(), "(c), (d)"),
        axis_of_means(inverse_error, inverse_means, inverse_errors, "(d)") if parts else "",
    )
    if names:  # of all panels, beneath them: within one it lies over curves
        legend_beneath(figure, forward, LEGEND_COLUMNS, reading)
    else:
        figure.supxlabel(reading, fontsize=READING_SIZE, multialignment="left")
    figure.suptitle(f"{material}: winding, every recorded sample{'' if shown else ' (no winding was recorded)'}")
    return figure
