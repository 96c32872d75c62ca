"""Leak and metrics → figure_leak: what forward-only training does to the INN's inverse, and what cures it."""

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
from .drawing import COLOURS, STYLE, save
from .marks import add_mark, mark_from

GROUPS = {
    "random_forward": "random,\nforward loss",
    "random_both": "random,\nboth losses",
    "identity_forward": "identity,\nforward loss",
    "inn": "INN of\nTables I, II",
}
PARTS = {"rmse": ("o", "whole error"), "leak_rmse": ("^", "leak alone"), "residual_rmse": ("_", "residual alone")}
OUTPUTS = {"slope_b": ("o", "separator b"), "slope_l": ("^", "length l"), "slope_r": ("s", "radius r")}
READING = (
    "A mark is one training, with permutations and weights of its own, on held-out points. The first three groups "
    "differ in nothing but what stands beneath them.\nA constant input (b, l, r) comes out of the network with a small "
    "error; where θ had to pass through that output, the inverse magnifies it: that part is the leak."
)
BENEATH = -0.24  # of a panel's height: a legend's place
WIDTH = 0.56  # of a group's fits, of the distance between groups


def floor(metrics: pd.DataFrame, way: str) -> float:
    """RMSE within strokes that no model without the direction beats, in mm or turns."""
    whole = (metrics[["stroke", "phase", "angle_band"]] == "all").all(axis=1) & (metrics["metric"] == "rmse")
    mine = metrics[whole & (metrics["model"] == "floor_blind") & (metrics["split"] == "within")]
    return float(mine.loc[mine["map"] == way, "value"].iloc[0])


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
    figure, (forward, inverse, steep) = plt.subplots(1, 3, figsize=(10.4, 4.8))
    dots(forward, leak, "rmse", "forward", PARTS["rmse"])
    forward.set_title("(a) error of the forward way", loc="left")
    forward.set_ylabel("RMSE of x (mm)")
    forward.set_ylim(0.0, 1.1 * float(leak.loc[(leak["map"] == "forward") & (leak["metric"] == "rmse"), "value"].max()))
    for metric, style in PARTS.items():
        dots(inverse, leak, metric, "inverse", style)
    inverse.set_title("(b) error of the inverse, and its parts", loc="left")
    inverse.set_ylabel("RMSE of θ/2π (turns)")
    for axes, way in ((forward, "forward"), (inverse, "inverse")):
        axes.axhline(floor(metrics, way), color="k", ls="--", lw=0.9, label="floor without direction")
    for metric, style in OUTPUTS.items():
        dots(steep, leak, metric, "inverse", style)
    steep.set_title("(c) what a constant's error does to θ", loc="left")
    steep.set_ylabel("slope of θ over the output, rms (std/std)")
    for axes in (inverse, steep):
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter(NullFormatter())
    for axes in (forward, inverse, steep):
        axes.set_xticks(range(len(GROUPS)), list(GROUPS.values()), fontsize=7)
        axes.set_xlabel("product of permutations, loss")
        axes.set_xlim(-0.6, len(GROUPS) - 0.4)
        axes.grid(axis="x", visible=False)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, BENEATH), ncols=2, fontsize=7)  # where no mark can lie
    figure.set_layout_engine("constrained", wspace=0.06)  # a label keeps off the panel beside it
    figure.suptitle(
        f"{material}: what training on the forward error alone does to the inverse of an INN, and two remedies"
    )
    figure.supxlabel(READING, fontsize=7.5)
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
