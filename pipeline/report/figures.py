"""Dataset and predictions → Figures 4 and 5 of the paper, as png and pdf."""

import argparse
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pandas as pd

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pipeline import schemas
from pipeline.errors import program
from pipeline.files import whole
from pipeline.kinematics import point_contraction_mm, point_motor_turns

FIGURE_4_STROKES = (1, 3, 5, 7)
FIGURE_5_STROKES = (1, 5, 9)
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")  # Okabe and Ito: told apart by colour-blind readers too
INN, TRADITIONAL = "#d55e00", "#0072b2"
STYLE: dict[Any, Any] = {
    "font.size": 9, "axes.titlesize": 9, "legend.fontsize": 7.5, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.alpha": 0.25, "savefig.dpi": 200, "pdf.fonttype": 42, "legend.frameon": False,
}  # fmt: skip
PAUSE_STEPS = 5  # times the usual step: more is a pause
SHOWN = ["motor_turns", "displacement_mm", "forward_mm", "inverse_turns"]
TURNS, MILLIMETRES = "motor twist θ/2π (turns)", "displacement x (mm)"


def with_nominal(points: pd.DataFrame) -> pd.DataFrame:
    """The points with what the traditional model predicts for them, `forward_mm` and `inverse_turns`."""
    return points.assign(forward_mm=point_contraction_mm(points), inverse_turns=point_motor_turns(points))


def with_median(dataset: pd.DataFrame, predictions: list[Path]) -> pd.DataFrame:
    """The held-out points with the median over the seeds of a model's predictions, as `forward_mm`, `inverse_turns`."""
    middle = pd.concat(schemas.read(path, schemas.PREDICTIONS) for path in predictions).groupby("point").median()
    points = dataset.iloc[middle.index].reset_index(drop=True)
    return points.assign(
        forward_mm=middle["displacement_mm"].to_numpy(), inverse_turns=middle["motor_turns"].to_numpy()
    )


def winding(points: pd.DataFrame, stroke: int) -> pd.DataFrame:
    """Points of one stroke's winding, one string, in order of time, with an empty row wherever the winding pauses.

    A line through them then breaks where the motor held or turned back, instead of jumping.
    """
    chosen = points[(points["stroke"] == stroke) & (points["phase"] == "winding")]
    chosen = chosen[chosen["string"].isin(chosen["string"].iloc[:1])].sort_values("time_s", ignore_index=True)
    step_s = chosen["time_s"].diff()
    pauses = np.flatnonzero(step_s > PAUSE_STEPS * step_s.median())
    chosen.index = chosen.index.astype(float)
    breaks = pd.DataFrame(np.nan, index=pauses - 0.5, columns=SHOWN)
    return pd.concat([chosen[SHOWN], breaks]).sort_index() if len(pauses) else chosen[SHOWN]


def _empty(axes: Axes, text: str) -> None:
    axes.text(0.5, 0.5, text, ha="center", va="center", transform=axes.transAxes, color="0.4")


def _name(axes: Axes, letter: str, title: str, x: str, y: str) -> None:
    axes.set_title(f"({letter}) {title}", loc="left")
    axes.set_xlabel(x)
    axes.set_ylabel(y)


def figure_4(points: pd.DataFrame, material: str) -> Figure:
    """The effect of the stroke times: recorded strokes against the traditional model, and its errors.

    `points` holds every moving point of the material with the traditional model's `forward_mm` and `inverse_turns`.
    """
    figure, ((forward, forward_error), (inverse, inverse_error)) = plt.subplots(2, 2, figsize=(8.0, 6.2))
    shown = [stroke for stroke in FIGURE_4_STROKES if not winding(points, stroke).empty]
    for colour, stroke in zip(COLOURS, FIGURE_4_STROKES, strict=True):
        one = winding(points, stroke)
        if one.empty:
            continue
        x, turns, label = one["displacement_mm"], one["motor_turns"], f"n={stroke}"
        forward.plot(turns, x, color=colour, lw=1.2, label=label)
        forward_error.plot(turns, one["forward_mm"] - x, color=colour, lw=0.8, label=label)
        inverse.plot(x, turns, color=colour, lw=1.2, label=label)
        inverse_error.plot(x, one["inverse_turns"] - turns, color=colour, lw=0.8, label=label)
    if shown:
        longest = max(
            (winding(points, stroke) for stroke in shown),
            key=lambda one: one["motor_turns"].max() - one["motor_turns"].min(),
        )
        by_turns, by_x = (longest.dropna().sort_values(column) for column in SHOWN[:2])
        style: dict[str, Any] = {"color": "k", "ls": "--", "lw": 1.1, "label": "traditional model"}
        forward.plot(by_turns["motor_turns"], by_turns["forward_mm"], **style)
        inverse.plot(by_x["displacement_mm"], by_x["inverse_turns"], **style)
    for axes in (forward, forward_error, inverse, inverse_error):
        if not shown:
            _empty(axes, "no winding of strokes 1, 3, 5, 7 recorded")
        elif axes in (forward, inverse):
            axes.legend()
    for axes in (forward_error, inverse_error):
        axes.axhline(0, color="k", lw=0.6)
    _name(forward, "a", "forward kinematics", TURNS, MILLIMETRES)
    _name(forward_error, "b", "forward error of the traditional model", TURNS, "model − measured (mm)")
    _name(inverse, "c", "inverse kinematics", MILLIMETRES, TURNS)
    _name(inverse_error, "d", "inverse error of the traditional model", MILLIMETRES, "model − measured (turns)")
    missing = ", ".join(f"n={stroke}" for stroke in FIGURE_4_STROKES if stroke not in shown)
    figure.suptitle(f"{material}: winding, every recorded sample" + (f" (not recorded: {missing})" if missing else ""))
    return figure


def figure_5(inn: pd.DataFrame, recorded: pd.DataFrame, material: str) -> Figure:
    """INN, traditional model and measurement at n = 1, 5, 9: forward above, inverse below, on held-out points."""
    figure, grid = plt.subplots(2, 3, figsize=(9.6, 6.0), sharey="row")
    for column, stroke in enumerate(FIGURE_5_STROKES):
        measured, learned = winding(recorded, stroke), winding(inn, stroke)
        forward, inverse = grid[:, column]
        _name(forward, "abc"[column], f"forward, n={stroke}", TURNS, MILLIMETRES if column == 0 else "")
        _name(inverse, "def"[column], f"inverse, n={stroke}", MILLIMETRES, TURNS if column == 0 else "")
        if measured.empty:
            _empty(forward, f"no stroke {stroke} recorded")
            _empty(inverse, f"no stroke {stroke} recorded")
            continue
        by_turns, by_x = (measured.dropna().sort_values(column) for column in SHOWN[:2])
        forward.plot(measured["motor_turns"], measured["displacement_mm"], color="0.55", lw=2.6, label="measured")
        forward.plot(
            by_turns["motor_turns"], by_turns["forward_mm"], color=TRADITIONAL, ls="--", label="traditional model"
        )
        forward.plot(learned["motor_turns"], learned["forward_mm"], ".", color=INN, ms=2.5, label="INN, held out")
        inverse.plot(measured["displacement_mm"], measured["motor_turns"], color="0.55", lw=2.6, label="measured")
        inverse.plot(by_x["displacement_mm"], by_x["inverse_turns"], color=TRADITIONAL, ls="--")
        inverse.plot(learned["displacement_mm"], learned["inverse_turns"], ".", color=INN, ms=2.5)
        if not figure.legends:
            figure.legend(handles=forward.get_lines(), loc="outside lower center", ncols=3)
    figure.suptitle(f"{material}: winding; the INN's points are the median over the seeds")
    return figure


def save(figure: Figure, stem: Path) -> None:
    """Write a figure as png and pdf, without dates, so that the same data gives the same bytes."""
    for suffix, metadata in {".png": {"Software": None}, ".pdf": {"CreationDate": None}}.items():
        with whole(stem.with_suffix(suffix)) as temporary:
            figure.savefig(temporary, metadata=metadata)
    plt.close(figure)


@program
def main() -> None:
    """Draw both figures of one material."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--inn", type=Path, nargs="+", required=True, help="the INN's predictions, one file a seed")
    parser.add_argument("--out-dir", type=Path, required=True)
    arguments = parser.parse_args()
    dataset = schemas.read(arguments.dataset, schemas.DATASET)
    material = arguments.dataset.parent.name
    inn, recorded = with_median(dataset, arguments.inn), with_nominal(dataset)
    with plt.rc_context({**STYLE, "figure.constrained_layout.use": True}):
        save(figure_4(recorded, material), arguments.out_dir / "figure_4")
        save(figure_5(inn, recorded, material), arguments.out_dir / "figure_5")


if __name__ == "__main__":
    main()
