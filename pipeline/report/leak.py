"""Leak and metrics → figure_leak: how much of the INN's inverse error is leak, and what mends it."""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from ..ground import schemas
from ..ground.errors import program
from .drawing import COLOURS, READING_SIZE, STYLE, save, wrapped
from .marks import add_mark, mark_from

GROUPS = {
    "random_forward": "shuffled,\nforward error",
    "random_both": "shuffled,\nboth errors",
    "identity_forward": "as they came,\nforward error",
    "inn": "INN of\nTables I, II",
}
PARTS = {"rmse": ("o", "whole error"), "leak_rmse": ("^", "leak alone"), "residual_rmse": ("_", "rest alone")}
OUTPUTS = {"slope_b": ("o", "separator b"), "slope_l": ("^", "length l"), "slope_r": ("s", "radius r")}
CHANGES = {"random_both": "both errors", "identity_forward": "as they came"}  # of the training, by their words above
WITHOUT = "random_forward"
READING = (
    "An invertible network (INN) computes the contraction x from the twist θ, and θ back from x. It is also given"
    " constants of the string: the separator b, the length l, the radius r (and the stroke's number n). It should"
    " put them out unchanged.",
    "Leak: it puts them out a little wrong. The way back is given the true ones, so θ comes out wrong. Rest: the "
    "error of θ that comes from the error of x.",
    "Compare in (b) the triangle of a training (leak alone) with its dash (rest alone); the dot is its whole "
    "error. (c): by how much θ changes where a constant is 1 mm off.",
    "Shuffled: between its blocks the network shuffles its five values, and leaves them so. Then θ may have to "
    "pass through the output of a constant, and the leak is large. As they came: the shuffles undo each other.",
    "Forward error: the training sees the errors of x and of the constants. Both errors: that of θ on the way "
    "back too, at twice the cost. Dashed: the least error of a model that is not told whether the motor winds or "
    "unwinds.",
    "A mark is one training with shuffles and weights of its own, on points that it has not seen. The first three"
    " groups differ in nothing but what stands beneath them.",
)
CANCELS = (
    "Leak and rest can have opposite signs. Then they cancel in part, so that {} is larger than the whole error: "
    "here in {} of {} trainings."
)
BENEATH = -0.2  # of a panel's height: a legend's place
LARGER = 1.005  # times the whole error: from there on a part of it is told to be larger
WIDTH = 0.56  # of a group's fits, of the distance between groups


def floor(metrics: pd.DataFrame, way: str) -> float:
    """RMSE within strokes that no model without the direction beats, in mm or turns."""
    whole = (metrics[["stroke", "phase", "angle_band"]] == "all").all(axis=1) & (metrics["metric"] == "rmse")
    mine = metrics[whole & (metrics["model"] == "floor_blind") & (metrics["split"] == "within")]
    return float(mine.loc[mine["map"] == way, "value"].iloc[0])


def parts_of(leak: pd.DataFrame, group: str) -> tuple[float, float]:
    """The leak alone and the rest alone, RMSE of the inverse in turns, medians over the fits of a group."""
    mine = leak[(leak["model"] == group) & (leak["map"] == "inverse")]
    leaking, residual = (mine.loc[mine["metric"] == name, "value"].median() for name in ("leak_rmse", "residual_rmse"))
    return float(leaking), float(residual)


def cancelled(leak: pd.DataFrame) -> str:
    """How often the leak alone or the rest alone is larger than the whole error, and how; empty where it never is."""
    mine = leak[leak["map"] == "inverse"].pivot_table(index=["model", "seed"], columns="metric", values="value")
    larger = {
        words: int((mine[metric] > LARGER * mine["rmse"]).sum())
        for metric, words in (("leak_rmse", "the leak alone"), ("residual_rmse", "the rest alone"))
    }
    return " ".join(CANCELS.format(words, count, len(mine)) for words, count in larger.items() if count)


def outcome(leak: pd.DataFrame) -> tuple[str, str]:
    """What a training without a change leaks, for the title, and a sentence on which changes are remedies here."""
    leaking, rest = parts_of(leak, WITHOUT)
    sizes = f"leak {leaking:.2g} turns, rest {rest:.2g} turns"
    if leaking <= rest:
        return f"this INN's way back errs little by leak ({sizes})", "Here there is no large leak to mend."
    parts = {group: parts_of(leak, group) for group in CHANGES}
    words = [
        f"“{CHANGES[group]}” {'does' if leaking <= rest else 'does not'} ({leaking:.2g} against {rest:.2g} turns)"
        for group, (leaking, rest) in parts.items()
    ]
    sentence = f"A change is a remedy if it brings the leak below the rest, in the median: {', '.join(words)}."
    return f"an INN trained on its forward error alone errs backwards mostly by leak ({sizes})", sentence


def dots(axes: Axes, leak: pd.DataFrame, metric: str, way: str, style: tuple[str, str]) -> None:
    """One mark a fit, the fits of a group side by side in order of their seeds, in the group's colour."""
    marker, label = style
    chosen = leak[(leak["metric"] == metric) & (leak["map"] == way)]
    for place, (group, colour) in enumerate(zip(GROUPS, COLOURS, strict=True)):
        values = chosen[chosen["model"] == group].sort_values("seed")["value"].to_numpy()
        at = place + WIDTH * (np.arange(len(values)) / max(len(values) - 1, 1) - 0.5) * (len(values) > 1)
        filled = colour if metric == "rmse" or metric in OUTPUTS else "none"
        size = 11 if marker == "_" else 6  # a dash must show on both sides of a dot
        axes.plot(at, values, ls="", marker=marker, ms=size, color=colour, mfc=filled, mew=1.2, zorder=3)
    filled = "none" if metric == "leak_rmse" else "0.35"
    axes.plot([], [], ls="", marker=marker, ms=6, color="0.35", mfc=filled, mew=1.2, label=label)


def figure_leak(leak: pd.DataFrame, metrics: pd.DataFrame, material: str) -> Figure:
    """Forward error, inverse error and its parts, and how steeply the inverse answers to constant outputs."""
    figure, (forward, inverse, steep) = plt.subplots(1, 3, figsize=(10.4, 5.5))
    dots(forward, leak, "rmse", "forward", PARTS["rmse"])
    forward.set_title("(a) forward, θ to x: error", loc="left")
    forward.set_ylabel("RMSE of x (mm)")
    forward.set_ylim(0.0, 1.1 * float(leak.loc[(leak["map"] == "forward") & (leak["metric"] == "rmse"), "value"].max()))
    for metric, style in PARTS.items():
        dots(inverse, leak, metric, "inverse", style)
    inverse.set_title("(b) inverse, x to θ: error, and its parts", loc="left")
    inverse.set_ylabel("RMSE of θ/2π (turns)")
    for axes, way in ((forward, "forward"), (inverse, "inverse")):
        axes.axhline(floor(metrics, way), color="k", ls="--", lw=0.9, label="floor without direction")
    for metric, style in OUTPUTS.items():
        dots(steep, leak, metric, "inverse", style)
    steep.set_title("(c) how θ answers to a wrong constant", loc="left")
    steep.set_ylabel("change of θ per mm of the constant, rms\n(in standard deviations of θ)")
    for axes in (inverse, steep):
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter(NullFormatter())
    for axes in (forward, inverse, steep):
        axes.set_xticks(range(len(GROUPS)), list(GROUPS.values()), fontsize=7)
        axes.set_xlabel("order of the outputs, error trained on")
        axes.set_xlim(-0.6, len(GROUPS) - 0.4)
        axes.grid(axis="x", visible=False)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, BENEATH), ncols=2, fontsize=7)  # where no mark can lie
    figure.set_layout_engine("constrained", wspace=0.06)  # a label keeps off the panel beside it
    fact, remedies = outcome(leak)
    figure.suptitle(f"{material}: {fact}")
    figure.supxlabel(wrapped(figure, *READING, cancelled(leak), remedies), fontsize=READING_SIZE, multialignment="left")
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
