"""The proof's figures: which effect was named instead of which, how that depends on size, and named over true sizes."""

from pathlib import Path

import matplotlib
import numpy as np
import pandas as pd

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from ...ground.stored.figure_file import write_figure
from . import share_intervals

COLOURS = ("#0072b2", "#009e73", "#d55e00", "#cc79a7")  # Okabe and Ito: told apart by colour-blind readers too
RATIOS = (0.1, 0.2, 0.5, 0.8, 1.0, 1.25, 2.0, 5.0, 10.0)  # ticks
OTHER = ("several", "tie, truth in it", "tie, truth not in it", "unknown", "nothing missing", "refused")
SPOKEN = {
    "tie with the truth": "tie, truth in it",
    "tie without the truth": "tie, truth not in it",
    "unknown": "unknown",
    "unknown as it should": "unknown",
    "missed": "nothing missing",
    "quiet": "nothing missing",
    "refused": "refused",
}
KINDS = {
    "named exactly": ["exact"],
    "tie that holds the truth": ["tie with the truth"],
    "named wrongly": ["wrong", "extra", "part", "tie without the truth"],
    "found nothing, or unknown": ["missed", "unknown", "refused"],
}


def _answered(case: pd.Series) -> str:
    word = SPOKEN.get(case["outcome"])
    return word or ("several" if "+" in case["named"] else case["named"])


def _row(case: pd.Series) -> str:
    if case["stratum"] == "single":
        return str(case["effects"])
    return {"none": "(none)", "parameters": "(parameters wrong)", "noise": "(noise)"}.get(
        case["stratum"], f"(open) {case['effects']}"
    )


def confusion(cases: pd.DataFrame) -> Figure:
    """Counts of verdicts (columns) by hidden effect (rows): single effects on the rich protocol, and controls."""
    shown = cases[
        (cases["protocol"] == "rich") & cases["stratum"].isin(["none", "parameters", "noise", "single", "open"])
    ]
    truth, answered = shown.apply(_row, axis=1), shown.apply(_answered, axis=1)
    rows = sorted(set(truth), key=lambda name: (name.startswith("("), name.startswith("(open"), name))
    named = sorted({*truth[~truth.str.startswith("(")], *answered} - {*OTHER})
    columns = [*named, *(name for name in OTHER if name in set(answered))]
    counts = pd.crosstab(truth, answered).reindex(index=rows, columns=columns, fill_value=0)
    shares = counts.div(counts.sum(axis=1), axis=0)
    figure, axes = plt.subplots(figsize=(2.4 + 0.3 * len(columns), 1.9 + 0.26 * len(rows)), layout="constrained")
    axes.imshow(shares, cmap="Blues", vmin=0.0, vmax=1.0, aspect="auto")
    for at, of in np.argwhere(counts.to_numpy() > 0):
        colour = "white" if shares.iat[at, of] > 0.5 else "black"
        axes.text(of, at, str(counts.iat[at, of]), ha="center", va="center", fontsize=7, color=colour)
    axes.set_xticks(range(len(columns)), columns, rotation=60, ha="right", rotation_mode="anchor", fontsize=7)
    axes.set_yticks(range(len(rows)), rows, fontsize=7)
    if len(columns) > len(named):
        axes.axvline(len(named) - 0.5, color="black", linewidth=0.6)
    axes.set_xticks(np.arange(len(columns)) - 0.5, minor=True)
    axes.set_yticks(np.arange(len(rows)) - 0.5, minor=True)
    axes.grid(which="minor", color="0.88", linewidth=0.4)
    axes.tick_params(which="minor", length=0)
    axes.set_ylabel("hidden", fontsize=8)
    axes.set_xlabel("said", fontsize=8)
    axes.set_title("Cases of the rich protocol", fontsize=8, loc="left")
    return figure


def dose_response(cases: pd.DataFrame) -> Figure:
    """Share of each kind of answer over the effect's size, with exact 95 % intervals; one panel a protocol."""
    single = cases[cases["stratum"] == "single"]
    protocols = [name for name in ("rich", "poor") if name in set(single["protocol"])]
    figure, panels = plt.subplots(
        1, max(len(protocols), 1), figsize=(3.6 * max(len(protocols), 1) + 0.4, 3.4), sharey=True, squeeze=False,
        layout="constrained",
    )  # fmt: skip
    for panel, protocol in zip(panels[0], protocols, strict=False):
        of_protocol = single[single["protocol"] == protocol]
        sizes = sorted(of_protocol["kappa"].unique())
        for shift, (kind, words) in enumerate(KINDS.items()):
            hits = [of_protocol[of_protocol["kappa"] == kappa]["outcome"].isin(words) for kappa in sizes]
            value = np.array([hit.mean() for hit in hits])
            bounds = np.array([share_intervals.share(int(hit.sum()), len(hit)) for hit in hits]).T
            panel.errorbar(
                np.array(sizes) * 1.04 ** (shift - 1.5), 100 * value, yerr=100 * np.abs(bounds - value),
                color=COLOURS[shift], marker="osv^"[shift], markersize=4, linewidth=1.2, elinewidth=0.8, capsize=2,
                label=kind,
            )  # fmt: skip
        panel.set_xscale("log")
        panel.set_xlim(sizes[0] / 1.5, sizes[-1] * 1.5)
        panel.set_xticks(sizes, [f"{kappa:g}" for kappa in sizes])
        panel.minorticks_off()
        panel.set_xlabel("effect that calibration leaves (noise floors)", fontsize=8)
        panel.set_title(f"{protocol} protocol, {len(of_protocol)} single effects", fontsize=8, loc="left")
        panel.grid(alpha=0.25)
        panel.spines[["top", "right"]].set_visible(False)
        panel.tick_params(labelsize=8)
    panels[0][0].set_ylim(-4, 104)
    panels[0][0].set_ylabel("share of cases (%)", fontsize=8)
    figure.legend(
        *panels[0][0].get_legend_handles_labels(), fontsize=7, frameon=False, loc="outside lower center", ncols=4
    )
    return figure


def named_sizes(sizes: pd.DataFrame) -> Figure:
    """Named over true size of every effect that was named exactly, with its 90 % interval."""
    figure, axes = plt.subplots(figsize=(4.6, 4.0), layout="constrained")
    for inside, colour, marker in ((True, COLOURS[0], "o"), (False, COLOURS[2], "s")):
        shown = sizes[sizes["inside"].astype(bool) == inside]
        below = np.maximum(shown["value_mm"] - shown["low_mm"], 0.0)
        above = np.maximum(shown["high_mm"] - shown["value_mm"], 0.0)
        ratio = shown["true_mm"]
        axes.errorbar(
            ratio, shown["value_mm"] / ratio, yerr=[below / ratio, above / ratio], fmt=marker, color=colour,
            markersize=3.5, linewidth=0, elinewidth=0.8,
            label=f"interval {'holds' if inside else 'misses'} the truth: {len(shown)}",
        )  # fmt: skip
    axes.axhline(1.0, color="0.4", linewidth=0.8)
    if len(sizes):
        axes.set_xscale("log")
        axes.set_yscale("log")
        low, high = axes.get_ylim()
        axes.set_yticks(RATIOS, [f"{ratio:g}" for ratio in RATIOS])
        axes.set_ylim(low, high)
        axes.minorticks_off()
    axes.set_xlabel("true size of the effect (mm rms)", fontsize=8)
    axes.set_ylabel("named size over true size", fontsize=8)
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(labelsize=8)
    figure.legend(fontsize=7, frameon=False, loc="outside upper center", ncols=2)
    return figure


def draw(cases: pd.DataFrame, sizes: pd.DataFrame, out: Path) -> None:
    """Write all of them."""
    figures = {"confusion": confusion(cases), "dose_response": dose_response(cases), "sizes": named_sizes(sizes)}
    for name, figure in figures.items():
        for suffix in ("png", "pdf") if name != "sizes" else ("png",):
            write_figure(figure, out / f"{name}.{suffix}", dpi=200)
        plt.close(figure)
