"""One page of figures: recording over simulation, mismatch maps, explanations, held-out error."""

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from pipeline.diagnosis.engine import Study
from pipeline.files import whole
from pipeline.kinematics import Array


def _map(axes: Any, found: Study, residual: Array, title: str, limit: float, unit: str) -> None:
    drivers = found.problem.drivers
    edges = np.linspace(drivers.turns.min(), drivers.turns.max() + 1e-9, 25)
    strokes = np.unique(drivers.stroke)
    column = np.clip(np.digitize(drivers.turns, edges) - 1, 0, 23)
    row = np.searchsorted(strokes, drivers.stroke)
    total, count = np.zeros((len(strokes), 48)), np.zeros((len(strokes), 48))
    side = np.where(drivers.rate >= 0, 0, 24)
    np.add.at(total, (row, column + side), residual)
    np.add.at(count, (row, column + side), 1.0)
    mean = np.where(count > 0, total / np.maximum(count, 1.0), np.nan)
    image = axes.imshow(mean, aspect="auto", cmap="RdBu_r", vmin=-limit, vmax=limit, interpolation="nearest",
                        extent=(0, 48, strokes[-1] + 0.5, strokes[0] - 0.5))  # fmt: skip
    axes.axvline(24, color="k", lw=0.8)
    axes.set_xticks(
        [0, 12, 24, 36, 48],
        [f"{edges[0]:.0f}", "winding", f"{edges[-1]:.0f}|{edges[0]:.0f}", "unwinding", f"{edges[-1]:.0f}"],
    )
    axes.set(title=title, xlabel="twist (turns)", ylabel="stroke")
    axes.figure.colorbar(image, ax=axes, label=unit)


def page(found: Study, content: dict[str, Any], path: Path) -> None:
    """Draw the page and write it, whole or not at all."""
    problem, drivers = found.problem, found.problem.drivers
    unit = problem.system.channel.rpartition("_")[2]
    measured = problem.measured
    residuals = {
        "calibrated": measured - problem.simulate(found.base),
        "explained": measured - problem.simulate(found.state),
    }
    figure, axes = plt.subplots(3, 2, figsize=(13, 12), layout="constrained")
    figure.suptitle(
        f"{content['run']}: {content['verdict']}" + "".join(f" · {entry['id']}" for entry in content["mechanisms"])
    )
    show = slice(None, None, max(1, len(measured) // 4000))
    axes[0, 0].plot(drivers.time_s[show], measured[show], "k", lw=0.8, label="recording")
    axes[0, 0].plot(drivers.time_s[show], problem.simulate(found.nominal)[show], lw=0.8, label="nominal simulation")
    axes[0, 0].plot(drivers.time_s[show], problem.simulate(found.state)[show], lw=0.8, label="simulation as diagnosed")
    axes[0, 0].set(xlabel="time (s)", ylabel=f"{problem.system.channel} ({unit})", title="recording over simulation")
    axes[0, 0].legend(fontsize=8)
    for name, residual in residuals.items():
        axes[0, 1].plot(drivers.turns[show], residual[show], ".", ms=1.5, label=name)
    axes[0, 1].set(xlabel="twist (turns)", ylabel=f"residual ({unit})", title="residual by twist")
    axes[0, 1].legend(fontsize=8, markerscale=6)
    limit = 3.0 * max(found.mismatch, found.noise.floor)
    _map(axes[1, 0], found, residuals["calibrated"], "mismatch, calibrated", limit, unit)
    _map(axes[1, 1], found, residuals["explained"], "mismatch, explained", limit, unit)
    ranking = found.search.all_of(1)[:10]
    names = [explanation.ids[0] for explanation in ranking]
    whole_ = max(found.search.nothing.energy - found.noise.floor**2, 1e-12)
    shares = [(found.search.nothing.energy - explanation.energy) / whole_ for explanation in ranking]
    axes[2, 0].barh(
        names[::-1], shares[::-1], color=["tab:red" if name in found.best_ids else "0.6" for name in names[::-1]]
    )
    axes[2, 0].set(xlim=(0, 1.05), title="share of the mismatch that one mechanism explains")
    held = content["fit"]["heldout"]
    if held:
        keys = ["nominal", "calibrated", "explained"]
        axes[2, 1].bar(keys, [held[f"{key}_{unit}"] for key in keys], color=["0.7", "0.5", "tab:red"])
        axes[2, 1].axhline(content["fit"][f"noise_floor_{unit}"], color="k", ls="--", label="noise floor")
        axes[2, 1].set(yscale="log", ylabel=f"rms error ({unit})", title="strokes that no fit has seen")
        axes[2, 1].legend(fontsize=8)
    with whole(path) as temporary:
        figure.savefig(temporary, dpi=90, metadata={"Software": None})
    plt.close(figure)
