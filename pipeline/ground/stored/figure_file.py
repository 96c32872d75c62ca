"""A figure of matplotlib as a file, with the same bytes each time."""

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure, SubFigure
from matplotlib.transforms import Bbox, BboxBase

from ..kinematics import Array
from .files import whole

CANVASES: dict[str, Any] = {".png": FigureCanvasAgg, ".pdf": FigureCanvasPdf, ".svg": FigureCanvasSVG}
DATES = {".png": "Software", ".pdf": "CreationDate", ".svg": "Date"}  # what differs from one day or version to another
DIGITS = 7  # of a position, as a share of the figure: less than any printer shows


def settle_layout(figure: Figure) -> None:
    """Lay a figure out once, and round the places of its parts.

    The solver of matplotlib's layout orders its variables by where they lie in memory, so the last bit of a position
    is chance, and a PDF writes ten decimals of it. What has been laid out stays as it is.
    """
    engine = figure.get_layout_engine()
    if engine is None:
        return
    engine.execute(figure)
    figure.set_layout_engine("none")
    _round(figure)


def _round(figure: Figure | SubFigure) -> None:
    """Round the places of a figure's axes, and of its parts' within it."""
    for part in figure.subfigs:
        part.bbox_relative.set_points(_rounded(part.bbox_relative))
        _round(part)
    for axes in figure.axes:
        axes.set_position(Bbox(_rounded(axes.get_position(original=True))))


def _rounded(box: BboxBase) -> Array:
    return np.asarray(np.round(box.get_points(), DIGITS) + 0.0)  # and no -0


def write_figure(figure: Figure, path: Path, dpi: float | None = None, metadata: dict[str, str] | None = None) -> None:
    """Write a figure in the format of the file's ending, without a date, whole or not at all.

    `dpi` are the dots per inch, by default the figure's; `metadata` are matplotlib's, by the format.
    """
    dots, suffix = dpi or figure.dpi, path.suffix
    figure.set_dpi(dots)
    settle_layout(figure)
    with whole(path) as temporary:  # a canvas draws once, savefig twice
        canvas = CANVASES[suffix](figure)
        getattr(canvas, f"print_{suffix[1:]}")(temporary, metadata={DATES[suffix]: None, **(metadata or {})})
    figure.set_dpi(dots)  # PDF and SVG have set their own


def write_page(figure: Figure, path: Path) -> None:
    """Write a figure as PNG and as PDF, each whole or not at all; `path` goes without an ending."""
    for suffix in (".png", ".pdf"):
        write_figure(figure, path.with_name(f"{path.name}{suffix}"))
