"""The look of every figure and its saving: the same bytes for the same data, marked with its configuration."""

import textwrap
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure

from ...ground.stored.figure_file import write_figure
from ..layout.made_by import MadeBy, sentence, warning

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")  # Okabe and Ito: told apart by colour-blind readers too
LIGHTER = (0.0, 0.55, 0.75, 0.85)  # how much white the colour of a further string has
WARNING = "#c2410c"
READING_SIZE, LETTERS = 7.5, 17  # of the words beneath a figure: their size in points, and letters in an inch
STYLE: dict[Any, Any] = {
    "font.size": 9, "axes.titlesize": 9, "legend.fontsize": 7.5, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.alpha": 0.25, "savefig.dpi": 200, "pdf.fonttype": 42, "legend.frameon": False,
    "figure.constrained_layout.use": True,
}  # fmt: skip
TURNS, MILLIMETRES = "motor twist θ/2π (turns)", "displacement x (mm)"


def lighter(colour: str, string: int) -> str:
    """A colour as the first string has it, 0, or lighter, as the second and later ones do."""
    white = LIGHTER[min(string, len(LIGHTER) - 1)]
    red, green, blue = (part + (1.0 - part) * white for part in to_rgb(colour))
    return to_hex((red, green, blue)) if white else colour


def name(axes: Axes, title: str, x: str, y: str) -> None:
    """Title and labels of a panel."""
    axes.set_title(title, loc="left")
    axes.set_xlabel(x)
    axes.set_ylabel(y)


def wrapped(figure: Figure, *sentences: str) -> str:
    """How to read a figure, in lines no wider than it: each sentence begins a line; empty ones do not count."""
    width = int(LETTERS * figure.get_figwidth())
    return "\n".join(textwrap.fill(sentence, width) for sentence in sentences if sentence)


def save(figure: Figure, stem: Path, mark: MadeBy | None = None) -> None:
    """Write a figure as png and pdf, without dates; what is no result says so in a line of text on the figure."""
    metadata: dict[str, dict[str, str]] = {}
    if mark is not None:
        metadata = {".png": {"Description": sentence(mark)}, ".pdf": {"Subject": sentence(mark)}}
        if warning(mark):
            figure.suptitle("\n".join(filter(None, (figure.get_suptitle(), warning(mark)))), color=WARNING)
    for suffix in (".png", ".pdf"):
        write_figure(figure, stem.with_suffix(suffix), STYLE["savefig.dpi"], metadata.get(suffix))
    plt.close(figure)


def legend_beneath(figure: Figure, axes: Axes, most: int, title: str) -> None:
    """The legend of a panel's entries beneath all panels, in as many columns as the figure has room for, `most`."""
    for columns in range(most, 0, -1):
        legend = figure.legend(
            *axes.get_legend_handles_labels(),
            loc="outside lower center",
            ncols=columns,
            title=title,
            title_fontsize=READING_SIZE,
        )
        if columns == 1 or legend.get_window_extent().width <= figure.bbox.width:
            return
        legend.remove()
