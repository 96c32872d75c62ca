"""Figure 5 of the paper: models against the measurement, stroke by stroke, and how large the errors are, beneath."""

from typing import Any

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.legend_handler import HandlerTuple
from matplotlib.lines import Line2D

from ..layout import paper
from ..shown.shown_strokes import drawn, in_figure
from ..shown.strings_drawn import of_one, strings_drawn, which_strings
from ..shown.stroke_conditions import labels
from .clipped import clipped
from .drawing import MILLIMETRES, READING_SIZE, TURNS, name, wrapped
from .error_row import BINS, as_bars, by_range, footed
from .winding import strokes_of, windings

Ends = tuple[float, float]
MEASURED: dict[str, Any] = {"color": "0.72", "lw": 4.0, "solid_capstyle": "butt"}
TRADITIONAL: dict[str, Any] = {"color": "#0072b2", "ls": "--", "lw": 1.2}
LEARNED: tuple[dict[str, Any], ...] = (
    {"color": "#d55e00", "ls": "", "marker": ".", "ms": 4.0, "mew": 0, "zorder": 3},
    {"color": "#00684c", "ls": "", "marker": "x", "ms": 3.0, "mew": 0.7},
    {"color": "#8a3f78", "ls": "", "marker": "+", "ms": 3.5, "mew": 0.7},
)
BAR: dict[str, Any] = {"ls": "-", "marker": "", "solid_capstyle": "butt"}
BARS_WIDE = (1.6, 3.4, 5.2)  # points, in the order of the models: of errors that are alike each bar has edges that show
ON_THE_AXIS = 3.0  # zorder: over the axis, on which small errors stand
BARS = (
    f"A bar: the rms error over one of {BINS} equal parts of the stroke, where points of that part were held out. "
    "Where errors are alike, the wider bar lies beneath the narrower one."
)
FOOTED = "An error that stands on the lower axis is {} or less."
BEST = "{}: beside INN and traditional, the least forward error over all held-out strokes together."
TAKEN = "{}: the model to take, by the rule on the page of the models."
WAYS = (("motor_turns", "displacement_mm", "forward_mm"), ("displacement_mm", "motor_turns", "inverse_turns"))


def _bar(style: dict[str, Any]) -> dict[str, Any]:
    """How the bars of a model with such points are drawn: those of the first models narrower, and on top."""
    place = [each["color"] for each in LEARNED].index(style["color"])
    return {**BAR, "lw": BARS_WIDE[place], "zorder": ON_THE_AXIS + 0.1 * (len(LEARNED) - place)}


def _drawn(
    curve: Axes, below: Axes, shown: pd.DataFrame, way: tuple[str, str, str], style: dict[str, Any], ends: Ends
) -> None:
    """A model's curve, and beneath it the size of the curve minus the measurement along the stroke."""
    from_column, answer, label = way
    ordered = shown.dropna().sort_values(from_column) if style.get("ls") == "--" else shown
    curve.plot(ordered[from_column], ordered[label], **style)
    middle, size = by_range(shown[from_column].to_numpy(float), (shown[label] - shown[answer]).to_numpy(float), *ends)
    if style.get("ls"):
        below.plot(middle, size, **{**style, "lw": 1.1})
    else:
        below.plot(*as_bars(middle, size, (ends[1] - ends[0]) / BINS), **{**style, **_bar(style)})


def _legend(figure: Figure, styles: dict[str, dict[str, Any]], columns: int, reading: str) -> None:
    """How to read the figure: the curves of models that learned the points, and the bars beneath."""
    handles: list[Any] = [Line2D([], [], **MEASURED), Line2D([], [], **TRADITIONAL)]
    words = ["measured", "traditional model, and its error"]
    for title, style in styles.items():
        handles.append((Line2D([], [], **style), Line2D([], [], **{**style, **_bar(style)})))
        words.append(f"{title}: held-out points, and their error")
    figure.legend(
        handles,
        words,
        loc="outside lower center",
        ncols=min(columns, 2),
        handlelength=3.0,
        handler_map={tuple: HandlerTuple(ndivide=None, pad=0.6)},
        title=reading,
        title_fontsize=READING_SIZE,
        alignment="center",
    )


def figure_5(
    recorded: pd.DataFrame, learned: dict[str, pd.DataFrame], material: str, best: str = "", taken: str = ""
) -> Figure:
    """Curves of the models with an error row beneath, forward above and inverse below, a column for each stroke.

    `recorded` holds every moving point with the traditional model's `forward_mm` and `inverse_turns`; `learned` maps
    titles, the INN's first, to held-out points with what that model predicts. `best` is the title of the model that
    is shown for its least error, `taken` of the one that is shown as the model to take.
    """
    every = strokes_of(recorded)
    strokes = drawn(every, paper.STROKES)
    of_stroke = strings_drawn(recorded, strokes, 1)
    named = labels(recorded, of_stroke)
    columns = max(len(strokes), 1)
    figure, grid = plt.subplots(
        4, columns, figsize=(1.4 + 2.75 * columns, 10.2), sharey="row", squeeze=False,
        gridspec_kw={"height_ratios": [1.5, 1.0, 1.5, 1.0]},
    )  # fmt: skip
    styles = dict(zip(learned, LEARNED, strict=False))
    shown = {title: windings(points, of_stroke) for title, points in learned.items()}
    windings_measured, feet = windings(recorded, of_stroke), list[str]()
    for row, (way, label) in enumerate(zip(WAYS, (("forward", TURNS), ("inverse", MILLIMETRES)), strict=True)):
        from_column, answer, _ = way
        curve_label, unit = ((MILLIMETRES, "mm"), (TURNS, "turns"))[row]
        for column, stroke in enumerate(strokes):
            curve, below = grid[2 * row, column], grid[2 * row + 1, column]
            below.sharex(curve)
            curve.tick_params(labelbottom=False)
            measured = windings_measured[column]
            curve.plot(measured[from_column], measured[answer], label="measured", **MEASURED)
            x_measured = measured[from_column].dropna()
            ends = (float(x_measured.min()), float(x_measured.max())) if len(x_measured) else (0.0, 1.0)
            _drawn(curve, below, measured, way, {**TRADITIONAL, "label": "traditional model"}, ends)
            for title, own in shown.items():
                style = {**styles[title], "label": f"{title}, held-out points"}
                _drawn(curve, below, own[column], way, style, ends)
            below.set_yscale("log")
            letter = "abcdef"[columns * row + column]
            name(curve, f"({letter}) {label[0]}, {named[stroke]}", "", curve_label if column == 0 else "")
            name(below, f"error of ({letter}) along the stroke", label[1], "")
        feet.append(footed(list(grid[2 * row + 1]), unit))
    if strokes:
        why = [BEST.format(best) if best else "", TAKEN.format(taken) if taken else ""]
        reading = wrapped(
            figure,
            in_figure(every, strokes, paper.STROKES),
            which_strings(of_stroke, recorded),
            BARS if shown else "",
            FOOTED.format(" or ".join(filter(None, feet))) if any(feet) else "",
            *why,
            clipped(windings_measured, "Inverse"),
        )
        _legend(figure, {title: styles[title] for title in shown}, columns, reading)
    figure.suptitle(
        f"{material}: winding{of_one(of_stroke, recorded)}{'' if strokes else ' (no winding was recorded)'}"
    )
    return figure
