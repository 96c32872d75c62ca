"""The prediction of each tied explanation for a run before it is made, with the recorded samples drawn over it."""

import textwrap
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from ..ground.kinematics import Array
from ..ground.stored.figure_file import write_page
from .beyond import SMOOTH_S, simulated_mm, zero_mm
from .proposed import ProposedRun

SIZE_INCHES, DOTS = (8.0, 7.0), 150
TITLE_POINTS, TITLE_WIDE = 10, 90  # letters of a line that the width has room for
LEGEND_COLUMNS = 3
SAME = 0.01  # of a load: less is no other load
COLOURS = ("#2166ac", "#4d9221", "#762a83", "#b8860b", "#008b8b", "#8c510a")  # of explanations, as on watch's page
SIMULATOR = "#d6604d"  # of the simulator of run.yaml, as there


def draw(run: ProposedRun, path: Path, title: str, came: pd.DataFrame | None = None) -> None:
    """Draw a proposed run, with the recorded samples over it, as PNG and PDF; `path` goes without an ending.

    One legend below all panels says what each colour is, since no panel has room for it where curves go everywhere.
    Where no explanations tie yet the simulator is drawn alone.
    """
    curves = run["curves"]
    figure = Figure(figsize=SIZE_INCHES, dpi=DOTS, layout="constrained")
    figure.suptitle(textwrap.fill(title, TITLE_WIDE), fontsize=TITLE_POINTS)
    loads = changes(run)
    differ = bool(curves["rivals"]) or came is not None  # the simulator beyond itself is a flat line at 0
    heights = [1, *([1] if loads else []), 2, *([3] if differ else [])]
    panels = figure.subplots(len(heights), 1, sharex=True, height_ratios=heights)
    motion, *hangs, reading = panels[:-1] if differ else panels
    apart = panels[-1] if differ else None
    time_s, base_mm = np.array(curves["time_s"]), np.array(curves["calibrated"])
    motion.plot(time_s, curves["motor_turns"], "0.4", lw=1.2, label="motion and load as planned")
    motion.set_ylabel("motor (turns)")
    for panel in hangs:
        panel.plot(time_s, curves["load"], "0.4", lw=1.2)
        if came is not None and "load_n" in came:
            panel.plot(came["time_s"] - came["time_s"].iloc[0], came["load_n"], "k", lw=0.8)
        panel.set_ylabel("load (N)")
    alone = {} if curves["rivals"] else {"the simulator of run.yaml": base_mm}
    for number, (name, curve) in enumerate((curves["rivals"] or alone).items()):
        colour = COLOURS[number % len(COLOURS)] if curves["rivals"] else SIMULATOR
        reading.plot(time_s, curve, color=colour, lw=1.2, label=f"{name}: foretold")
        if apart is not None:
            apart.plot(time_s, np.array(curve) - base_mm, color=colour, lw=1.5)
    if came is not None:
        at_s = came["time_s"].to_numpy() - came["time_s"].iloc[0]
        turns = came["motor_turns"].to_numpy()
        came_mm = came["displacement_mm"].to_numpy() - zero_mm(turns, came["displacement_mm"].to_numpy())
        motion.plot(at_s, turns, "k", lw=0.8)
        reading.plot(at_s, came_mm, "k", lw=0.8, label=f"recorded (lowest panel: means over {SMOOTH_S:g} s)")
        beyond_mm = came_mm - simulated_mm(curves, at_s, turns)
        assert apart is not None
        apart.plot(at_s, averaged(at_s, beyond_mm), "k", lw=1.2)
    reading.set_ylabel("displacement since\nthe run began (mm)")
    if apart is not None:
        apart.set_ylabel("difference to the simulator\nwithout a mechanism (mm)")
    panels[-1].set_xlabel("time (s)")
    figure.legend(loc="outside lower center", ncols=LEGEND_COLUMNS, fontsize=8, frameon=False)
    write_page(figure, path)


def changes(run: ProposedRun) -> bool:
    """Whether the load changes within a run, or from the load before it."""
    before = run.get("load")
    loads_n = [*run["curves"]["load"], *([] if before is None else [before])]
    return max(loads_n) - min(loads_n) > SAME * max(map(abs, loads_n))


def averaged(at_s: Array, values: Array) -> Array:
    """Running means over SMOOTH_S. Shape (samples,), in the values' unit; times in s."""
    width = max(1, round(SMOOTH_S / max(float(np.median(np.diff(at_s))), 1e-9))) if len(at_s) > 1 else 1
    weights = np.ones(min(width, len(values)))
    return np.convolve(values, weights, "same") / np.convolve(np.ones(len(values)), weights, "same")
