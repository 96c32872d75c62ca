"""A public rig's figure: every method's error on strokes it has not seen, and on recordings it has not seen."""

from typing import Any

import matplotlib
import numpy as np
import pandas as pd

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from ...real.black_boxes import looks
from .results import BLACK_BOXES, SIMULATORS, TITLES, Result, apart

COLOURS = {"nominal": "0.75", "calibrated": "0.45", "explained": "#d55e00"}
COLOURS |= {name: look["colour"] for name, look in looks().items()}
MARKERS = {**dict.fromkeys(SIMULATORS, "o"), **{name: look["marker"] for name, look in looks().items()}}
MATRIX_MOST = 9  # recordings of a group: of more a matrix is too fine to read


def errors(axes: Axes, results: list[Result], unit: str) -> None:
    """Held-out error of every method, a line for each recording."""
    shown = [result for result in results if result.heldout]
    names = [result.name for result in shown]
    for at, result in enumerate(shown):
        values = [value for value in result.heldout.values() if value > 0]
        axes.plot([min(values), max(values)], [at, at], color="0.88", lw=1.0, zorder=1)
    for method, title in TITLES.items():
        points = [(result.heldout[method], at) for at, result in enumerate(shown) if result.heldout.get(method)]
        if points:
            x, y = zip(*points, strict=True)
            # the nominal one as a ring: behind, where calibration moved nothing
            style: dict[str, Any] = {"s": 60, "facecolor": "none", "edgecolor": "0.55"}
            style = style if method == "nominal" else {"s": 26, "color": COLOURS[method]}
            axes.scatter(x, y, marker=MARKERS[method], label=title, zorder=2, **style)
    axes.set_yticks(range(len(names)), names, fontsize=7)
    axes.set_ylim(max(len(names), 1) - 0.5, -0.5)
    axes.set_title("the last strokes of the same recording", fontsize=8, loc="left")
    _logarithmic(axes, f"rms error ({unit})")


def transfer(axes: Axes, pairs: pd.DataFrame, left_out: pd.DataFrame, unit: str) -> None:
    """Error after learning from another recording, a dot for each ordered pair; rings: from all others together."""
    methods = [method for method in TITLES if method in set(pairs["method"])]
    for at, method in enumerate(methods):
        values = pairs.loc[pairs["method"] == method, "rms"].to_numpy()
        spread = at + 0.16 * np.sin(2.4 * np.arange(len(values)))  # apart, the same at every run
        axes.scatter(values, spread, s=12, color=COLOURS[method], marker=MARKERS[method], alpha=0.7, lw=0)
        middle = float(np.median(values))
        axes.plot([middle, middle], [at - 0.34, at + 0.34], color=COLOURS[method], lw=2.5)
        axes.annotate(f"{middle:.2g}", (middle, at - 0.36), fontsize=7, ha="center", va="bottom")
        rings = left_out.loc[left_out["method"] == method, "rms"].to_numpy()
        axes.scatter(rings, np.full(len(rings), at + 0.3), s=26, facecolor="white", edgecolor="black", lw=0.8, zorder=3)
    axes.set_yticks(range(len(methods)), [TITLES[method] for method in methods], fontsize=7)
    axes.set_ylim(len(methods) - 0.4, -0.7)
    count = len(pairs) // max(1, len(methods))
    rings = "; rings: learnt from all others" if len(left_out) else ""
    axes.set_title(f"another recording, {count} ordered pairs{rings}", fontsize=8, loc="left")
    _logarithmic(axes, f"rms error ({unit}), zero set on the first second")


def _logarithmic(axes: Axes, label: str) -> None:
    axes.set_xscale("log")
    low, high = axes.get_xlim()
    marks = [digit * 10.0**power for power in range(-6, 7) for digit in (1, 2, 5)]
    axes.set_xticks([mark for mark in marks if low <= mark <= high])
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(label, fontsize=8)
    axes.tick_params(labelsize=7)
    axes.grid(axis="x", alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)


def matrix(axes: Axes, pairs: pd.DataFrame, method: str, unit: str, ends: tuple[float, float]) -> None:
    """A method's error for every ordered pair of a group: rows learnt, columns are asked; colours from end to end."""
    table = pairs[pairs["method"] == method].pivot(index="learnt_from", columns="asked_about", values="rms")
    names = sorted({*table.index, *table.columns})
    values = table.reindex(index=names, columns=names).to_numpy(float)
    shown = LogNorm(*ends)
    axes.imshow(values, cmap="YlOrRd", norm=shown, aspect="auto")
    for at, of in np.argwhere(np.isfinite(values)):
        colour = "white" if shown(values[at, of]) > 0.65 else "black"
        axes.text(of, at, f"{values[at, of]:.2g}", ha="center", va="center", fontsize=7, color=colour)
    parts = [name.split("-") for name in names]
    same = next((at for at, names in enumerate(zip(*parts, strict=False)) if len(set(names)) > 1), 0)
    short = ["-".join(part[same:]) for part in parts]
    axes.set_xticks(range(len(names)), short, rotation=30, ha="right", rotation_mode="anchor", fontsize=7)
    axes.set_yticks(range(len(names)), short, fontsize=7)
    axes.tick_params(length=0)
    axes.set_title(f"{TITLES[method]} ({unit}): {pairs['group'].iloc[0]}", fontsize=8, loc="left")
    axes.set_xlabel("asked about", fontsize=8)
    axes.set_ylabel("learnt from", fontsize=8)


def matrices(pairs: pd.DataFrame) -> list[tuple[str, str]]:
    """Groups and methods that get a matrix: the explained simulator, and of a lone group its best black box too."""
    explained = pairs[pairs["method"] == "explained"]
    shown = [
        str(group)
        for group, group_pairs in explained.groupby("group")
        if group_pairs["asked_about"].nunique() <= MATRIX_MOST
    ]
    drawn = [(group, "explained") for group in shown]
    others = pairs[pairs["method"].isin(list(BLACK_BOXES))].groupby("method")["rms"].median()
    return [*drawn, (shown[0], str(others.idxmin()))] if len(shown) == 1 and len(others) else drawn


def figure(results: list[Result], carried: pd.DataFrame, unit: str) -> Figure:
    """All panels; those for transfer only where there is any."""
    pairs, left_out = apart(carried)
    shown = sum(1 for result in results if result.heldout)
    drawn_below = matrices(pairs)
    height, below = max(1.9 + 0.2 * shown, 3.0), 3.0 if drawn_below else 0.0
    columns = 1 if pairs.empty else 2
    drawn = plt.figure(figsize=(5.2 * columns, height + below), layout="constrained")
    rows = drawn.subfigures(2, 1, height_ratios=(height, below), squeeze=False) if below else np.array([[drawn]])
    upper = rows[0, 0].subplots(1, columns, squeeze=False)[0]
    errors(upper[0], results, unit)
    if not pairs.empty:
        transfer(upper[1], pairs, left_out, unit)
    if drawn_below:
        errors_below = pairs[pairs["method"].isin([method for _, method in drawn_below])]["rms"]
        lower = rows[1, 0].subplots(1, len(drawn_below), squeeze=False)[0]
        for axes, (group, method) in zip(lower, drawn_below, strict=True):
            matrix(
                axes,
                pairs[pairs["group"] == group],
                method,
                unit,
                (float(errors_below.min()), float(errors_below.max())),
            )
    lines = upper[0].get_legend_handles_labels()
    rows[0, 0].legend(*lines, fontsize=7, frameon=False, ncols=3 * columns, loc="outside lower left")
    return drawn
