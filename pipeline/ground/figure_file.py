"""A figure of matplotlib as a page in two formats, the same bytes each time."""

from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.figure import Figure

from .files import whole


def write_page(figure: Figure, path: Path) -> None:
    """Write a figure as PNG and as PDF, each whole or not at all; `path` goes without an ending."""
    with whole(path.with_name(f"{path.name}.png")) as temporary:  # each canvas draws once, savefig twice
        FigureCanvasAgg(figure).print_png(temporary, metadata={"Software": None})
    figure.set_layout_engine("none")  # what is laid out stays as it is
    for part in figure.subfigs:
        part.patch.set_visible(False)  # white on white, its corner at 0 or -0, by chance
    with whole(path.with_name(f"{path.name}.pdf")) as temporary:
        FigureCanvasPdf(figure).print_pdf(temporary, metadata={"CreationDate": None})
