"""The page of a string's life: each indicator over strokes, its law with a band, the limit and the interval."""

from collections.abc import Collection
from pathlib import Path
from textwrap import fill
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from ..ground.stored.figure_file import write_figure
from .bar import ROOM, interval
from .forecast.band import until
from .forecast.life_questions import Answer
from .forecast.strokes_left import LEAST_STROKES
from .legend import legend
from .stroke_axis import farthest, span_of_strokes
from .stroke_health.health import Health
from .stroke_health.indicators import REFERENCE
from .words.figure_words import HEADS, NEGATIVE_LOOP, WHAT, footnote, left_out, no_claim, tail_of, which_run
from .words.percent import tail
from .words.recovery_said import head as recovery_head
from .words.stroke_counts import strokes

SEEN, LAW, FITTED, LIMIT = "#0072b2", "#d55e00", "#009e73", "0.25"  # Okabe and Ito: for colour-blind readers too
TITLE_LETTERS = 80  # of a line of the title: more do not fit the width
BEGINS = "0.4"  # where another recording begins
OTHERS = (
    ("rest_mm", "displacement\nat rest (mm)"),
    ("loop_mm", "loop (mm)"),
    ("stiffness_n_per_mm", "stiffness (N/mm)"),
)


def page(health: Health, answers: list[Answer], level: float, path: Path) -> None:
    """Draw the page and write it as png, whole or not at all."""
    others = [(name, label) for name, label in OTHERS if np.isfinite(health.strokes[name]).sum() > 1]
    style: dict[Any, Any] = {
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "legend.frameon": False,
    }
    with plt.rc_context(style):
        grid: list[Any] = [["loss"] * 6, ["drift"] * 6, [name for name, _ in others for _ in range(6 // len(others))]]
        grid = grid if others else grid[:2]
        heights = [*(3.0 if len(answer.n) else 0.8 for answer in answers), 1.8]
        figure, panels = plt.subplot_mosaic(
            grid, figsize=(7.2, 8.2), layout="constrained", height_ratios=heights[: len(grid)]
        )
        shown = span_of_strokes(answers, level)
        named = list[str]()
        for answer, name in zip(answers, ("loss", "drift"), strict=True):
            named += question(panels[name], answer, level, shown, named)
        for name, label in others:
            axes, table = panels[name], health.strokes
            axes.errorbar(table["stroke"], table[name], table[f"{name}_error"], fmt=".", ms=3, lw=0.6, color=SEEN)
            axes.xaxis.set_major_locator(MaxNLocator(integer=True))
            axes.set_xlabel("number of the stroke")
            axes.set_ylabel(label)
            if name == "loop_mm" and float(np.nanmin(table[name])) < 0.0:
                axes.set_title(NEGATIVE_LOOP, fontsize=7.5, loc="left")  # above it: on it lines cross it
        begins = begun(health)
        for number, axes in enumerate(axes for axes in panels.values() if axes.get_xlabel()):
            mark(axes, begins, named=not number)
        seen = f"{strokes(len(health.strokes))} seen{health.loads.under}"
        not_seen = left_out(len(health.left_out), health.loads.count_left_out)
        title = f"Life of the string {health.string}: {seen}{not_seen}"
        figure.suptitle(fill(title, TITLE_LETTERS), fontsize=11)
        if note := footnote(answers, level, which_run(health.strokes)):
            figure.supxlabel(note, fontsize=7.5, x=0.02, ha="left")
        write_figure(figure, path, dpi=130)
        plt.close(figure)


def begun(health: Health) -> list[tuple[str, float]]:
    """Each further run with the place between its first stroke and the one before, in strokes."""
    places = health.strokes.drop_duplicates("run")[["run", "stroke"]].itertuples(index=False)
    return [(str(run), float(stroke) - 0.5) for run, stroke in [*places][1:]]


def mark(axes: Axes, begins: list[tuple[str, float]], named: bool) -> None:
    """A line where each further recording begins, with the run's name in the first panel."""
    for run, at in begins:
        axes.axvline(at, color=BEGINS, lw=0.8, ls=":")
        if named:
            axes.annotate(
                f"{run} begins", (at, 0.98), xycoords=("data", "axes fraction"), xytext=(2, 0),
                textcoords="offset points", fontsize=7, color=BEGINS, rotation=90, va="top", ha="left", zorder=6,
                bbox={"facecolor": "w", "edgecolor": "none", "pad": 0.8},  # lines go behind it
            )  # fmt: skip


def question(
    axes: Axes, answer: Answer, level: float, strokes_shown: tuple[float, float] | None = None,
    named: Collection[str] = (),
) -> list[str]:  # fmt: skip
    """Indicator, law with its band, limit and interval of one question, over its own strokes or those given.

    Returns what its legend names; what is `named` above is left out there, but for the limit and the law.
    """
    shown = strokes_shown or span_of_strokes([answer], level)
    forecast, span, scale = answer.left, answer.left.span(level), 100.0 if answer.unit == "1" else 1.0
    if not len(answer.n):
        nothing(axes, answer)
        return []
    axes.errorbar(
        answer.n, scale * answer.values, scale * answer.errors, fmt=".", ms=5.0, lw=0.6, color=SEEN, label="measured"
    )
    axes.axhline(
        scale * answer.limit,
        color=LIMIT,
        lw=1.0,
        ls="--",
        label=f"limit, {scale * answer.limit:g} {'%' if answer.unit == '1' else answer.unit}",
    )
    axes.set_xlabel("number of the stroke")
    axes.set_ylabel(f"{WHAT[answer.question]} ({'%' if answer.unit == '1' else answer.unit})")
    top = scale * 1.6 * max(answer.limit, float(np.nanmax(answer.values, initial=0.0)))
    is_open = span.state == "no claim"
    more = [no_claim(forecast.reason)] if is_open else [recovery_head(answer.recovery)]
    head = "\n".join([HEADS[answer.question], *filter(None, more)])
    if forecast.choice and forecast.band is not None:
        seen = float(answer.n[-1])
        end = shown[1] if shown else seen + farthest(span.high, seen, forecast.horizon)
        past, name = np.linspace(answer.n[0], seen, 200), forecast.choice.best.law.name
        fitted = scale * forecast.choice.curve(past - answer.n[0] + 1.0)
        if forecast.lacks is not None:  # by stroke: it falls back in each break
            past, name = answer.n, f"{name}, less what came back"
            fitted = scale * np.abs(forecast.choice.curve(past - answer.n[0] + 1.0) - forecast.lacks)
        axes.plot(past, fitted, color=FITTED, lw=2.0, zorder=3, label=f"law fitted, mostly: {name}")
        least = -np.inf if answer.unit == "1" else 0.0  # a root mean square is not below 0
        out = tail_of(span, level)
        edges = [np.clip(scale * forecast.band.below(share), least, 2.0 * top) for share in (out, 0.5, 1.0 - out)]
        ahead, (low, middle, high) = until(span.high, forecast.band.ahead, edges)
        n = seen + ahead
        axes.plot(n, middle, color=LAW, lw=1.4, label="median of the futures")
        axes.fill_between(
            n, low, high, color=LAW, alpha=0.18, lw=0,
            label=f"the middle {tail(1.0 - 2.0 * out)} of the futures",
        )  # fmt: skip
        axes.set_ylim(min(0.0, scale * float(np.nanmin(answer.values))) - 0.03 * top, top)
        last = n[-1] - np.array([0.01, 0.0]), np.array([low[-1], high[-1]])  # where the shade ends
        curves = [*((n, edge) for edge in (low, middle, high)), last]
        interval(axes, answer, level, end, scale * answer.limit, curves)
    if shown:
        axes.set_xlim(shown[0] - 0.02 * shown[1], shown[1] + ROOM * (shown[1] - shown[0]))
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.axvline(answer.n[-1], color="0.7", lw=0.8, label="last stroke seen")
    names_here, above = legend(axes, named)
    axes.set_title(head, fontsize=9, loc="left", pad=6.0 if is_open else above)
    return names_here


def nothing(axes: Axes, answer: Answer) -> None:
    """The panel of an indicator without a value yet: the reason, and from how many strokes on it has one."""
    words = (
        f"No {answer.what} yet: the first {REFERENCE} strokes set the reference.\n"
        f"It shows from {REFERENCE + 1} compared strokes on, and a forecast from {LEAST_STROKES} on."
    )
    axes.text(0.5, 0.5, words, ha="center", va="center", transform=axes.transAxes)
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)
