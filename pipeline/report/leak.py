"""Leak and metrics → figure_leak: how much of the INN's inverse error is leak, and what mends it."""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from ..ground.errors import program
from ..ground.stored import schemas
from .drawn.drawing import COLOURS, READING_SIZE, STYLE, save, wrapped
from .web.marks import add_mark, mark_from

GROUPS = {  # of trainings, from above to below
    "random_forward": "A  trained on the\nforward error alone",
    "random_both": "B  trained on the\nerrors of both ways",
    "identity_forward": "C  as A, but a last shuffle\nputs all values back",
    "inn": "D  as C, with the settings\nof the INN of Tables I, II",
}
LETTERS = {group: words[0] for group, words in GROUPS.items()}
WHOLE = ("o", "0.25", "whole error")
PARTS = {"leak_rmse": ("^", COLOURS[1], "leak alone"), "residual_rmse": ("s", COLOURS[0], "rest alone")}
READING = (
    "An INN turns the twist θ into the contraction x, and x back into θ. The string's constants and the stroke's number"
    " pass through it, and should come out unchanged.",
    "Leak: the error of θ from their change, as the way back is given the true ones. Rest: the error of θ that comes"
    " from the error of x. Mended: the leak is smaller than the rest.",
    "Between its blocks an INN shuffles its values by chance, so that θ may end where a constant should (A, B). In C"
    " and D a last shuffle puts each value back to its place.",
    "A mark is one training, on points that it has not seen. Floor: the least error of a model that is not told"
    " whether the motor winds or unwinds.",
)
CANCELS = "Leak and rest can cancel in part: {} is larger than the whole error in {} of {} trainings."
BENEATH = -0.13  # of a panel's height: a legend's place
LARGER = 1.005  # times the whole error: from there on a part of it is told to be larger
WIDE = 500.0  # a logarithmic axis that holds this factor has room for powers of ten alone
LANE = 0.7  # of the room that a lane's marks may take


def floor(metrics: pd.DataFrame, way: str) -> float:
    """RMSE within strokes that no model without the direction beats, in mm or turns."""
    whole = (metrics[["stroke", "phase", "angle_band"]] == "all").all(axis=1) & (metrics["metric"] == "rmse")
    mine = metrics[whole & (metrics["model"] == "floor_blind") & (metrics["split"] == "within")]
    return float(mine.loc[mine["map"] == way, "value"].iloc[0])


def parts_of(leak: pd.DataFrame, group: str) -> tuple[float, float]:
    """The leak alone and the rest alone, RMSE of the inverse in turns, medians over the fits of a group."""
    mine = leak[(leak["model"] == group) & (leak["map"] == "inverse")]
    leaking, residual = (mine.loc[mine["metric"] == name, "value"].median() for name in PARTS)
    return float(leaking), float(residual)


def cancelled(leak: pd.DataFrame) -> str:
    """How often the leak alone or the rest alone exceeds the whole error, and how; empty where it never does."""
    mine = leak[leak["map"] == "inverse"].pivot_table(index=["model", "seed"], columns="metric", values="value")
    larger = {f"the {PARTS[part][2]}": int((mine[part] > LARGER * mine["rmse"]).sum()) for part in PARTS}
    return " ".join(CANCELS.format(words, count, len(mine)) for words, count in larger.items() if count)


def is_large(leak: pd.DataFrame) -> bool:
    """Whether the inverse error of an INN trained only forward comes mostly from leak."""
    leaking, rest = parts_of(leak, "random_forward")
    return leaking > rest


def title(leak: pd.DataFrame) -> str:
    """What the figure shows, without numbers."""
    if is_large(leak):
        return "why an INN trained one way fails the other way"
    return "an INN trained one way, asked the other way: it leaks little"


def outcome(leak: pd.DataFrame) -> str:
    """Leak and rest of each kind of training, and the remedies among them: those with less leak than rest."""
    parts = {letter: parts_of(leak, group) for group, letter in LETTERS.items()}
    numbers = []
    for letter, (leaking, rest) in parts.items():
        result = " (not mended)" if leaking > rest else " (mended)"
        numbers.append(f"{letter} {leaking:.2g} and {rest:.2g}{result if is_large(leak) and letter != 'A' else ''}")
    return f"Leak and rest of θ, medians in turns: {', '.join(numbers)}."


def lane(axes: Axes, leak: pd.DataFrame, way: str, metric: str, lanes: tuple[int, int] = (0, 1)) -> None:
    """One mark a fit, a row of the figure a group, its fits one below the other; `lanes` is which of how many a row."""
    marker, colour, words = PARTS.get(metric, WHOLE)
    chosen = leak[(leak["metric"] == metric) & (leak["map"] == way)]
    number, count = lanes
    for place, group in enumerate(GROUPS):
        values = chosen[chosen["model"] == group].sort_values("seed")["value"].to_numpy()
        apart = LANE * (np.arange(len(values)) / max(len(values) - 1, 1) - 0.5) * (len(values) > 1)
        at = place + ((number + 0.5 + apart) / count - 0.5)
        label = words if place == 0 else None
        axes.plot(values, at, ls="", marker=marker, ms=4.5, color=colour, mec="white", mew=0.4, zorder=3, label=label)


def panels(figure: Figure, leak: pd.DataFrame, metrics: pd.DataFrame) -> None:
    """The error of the way ahead, of the way back, and the two parts of the latter, beside each other."""
    ahead, back, parts = figure.subplots(1, 3, sharey=True, gridspec_kw={"width_ratios": (1.0, 1.2, 1.2)})
    parts.sharex(back)
    back.set_xscale("log")
    lane(ahead, leak, "forward", "rmse")
    lane(back, leak, "inverse", "rmse")
    for number, part in enumerate(PARTS):
        lane(parts, leak, "inverse", part, (number, len(PARTS)))
    ahead.set_title("(a) forward, θ to x", loc="left")
    back.set_title("(b) way back, x to θ", loc="left")
    parts.set_title("(c) the error of (b), taken apart", loc="left")
    ahead.set_xlabel("rms error of x (mm)")
    ahead.set_xlim(0.0, 1.15 * float(leak.loc[(leak["map"] == "forward") & (leak["metric"] == "rmse"), "value"].max()))
    for axes, way in ((ahead, "forward"), (back, "inverse")):
        axes.axvline(floor(metrics, way), color="k", ls="--", lw=0.9, label="floor without direction")
    lowest, highest = back.get_xlim()
    marked = (1.0, 2.0, 5.0) if highest / lowest < WIDE else (1.0,)
    for axes in (back, parts):
        axes.set_xlabel("rms error of θ/2π (turns), logarithmic")
        axes.xaxis.set_major_locator(LogLocator(subs=marked))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_formatter(NullFormatter())
    ahead.set_yticks(range(len(GROUPS)), list(GROUPS.values()), ma="left")
    ahead.set_ylim(len(GROUPS) - 0.5, -0.5)
    for axes in (ahead, back, parts):
        axes.grid(axis="y", visible=False)
        axes.tick_params(axis="y", length=0)
        for edge in range(1, len(GROUPS)):
            axes.axhline(edge - 0.5, color="0.8", lw=0.6)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, BENEATH), ncols=2)  # where no mark can lie


def figure_leak(leak: pd.DataFrame, metrics: pd.DataFrame, material: str) -> Figure:
    """Forward error, inverse error and its two parts, a row for each kind of training."""
    figure = plt.figure(figsize=(10.4, 5.0))
    panels(figure, leak, metrics)
    figure.set_layout_engine("constrained", wspace=0.06)
    figure.suptitle(f"{material}: {title(leak)}")
    figure.supxlabel(
        wrapped(figure, *READING[:2], outcome(leak), *READING[2:], cancelled(leak)),
        fontsize=READING_SIZE,
        multialignment="left",
    )
    return figure


@program
def main() -> None:
    """Draw the figure of one material."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("leak", type=Path)
    parser.add_argument("metrics", type=Path)
    parser.add_argument("--out-dir", type=Path, required=True, help="the folder of the figures; required")
    add_mark(parser)
    arguments = parser.parse_args()
    leak, metrics = (schemas.read(path, schemas.METRICS) for path in (arguments.leak, arguments.metrics))
    mark = mark_from(arguments.made_by)
    with plt.rc_context(STYLE):
        save(figure_leak(leak, metrics, str(leak["material"].iloc[0])), arguments.out_dir / "figure_leak", mark)


if __name__ == "__main__":
    main()
