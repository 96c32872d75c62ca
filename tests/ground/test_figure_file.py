"""Figures come out the same, byte by byte, whatever the last bits of their layout are."""

import pytest
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.transforms import Bbox

from pipeline.ground.stored.figure_file import settle_layout, write_figure, write_page


class Shaken(ConstrainedLayoutEngine):
    """A layout whose last digits are chance, as where its solver's variables lie in memory."""

    def __init__(self, by):
        super().__init__()
        self.by = by

    def execute(self, fig):
        super().execute(fig)
        for part in fig.subfigs:
            part.bbox_relative.set_points(part.bbox_relative.get_points() + self.by)
        for axes in fig.axes:
            axes._set_position(Bbox(axes.get_position().get_points() + self.by))


def drawn(by):
    figure = Figure(figsize=(5.0, 4.0), dpi=90, layout=Shaken(by))
    upper, lower = figure.subfigures(2, 1)
    upper.suptitle("two panels")
    for axes in (*upper.subplots(1, 2), lower.subplots()):
        axes.plot([0.0, 1.0, 3.0], [0.2, 0.7, 1e3], "o-", label="values")
        axes.set_xlabel("time (s)")
        axes.legend()
    return figure


@pytest.mark.parametrize("suffix", [".png", ".pdf"])
def test_the_last_digits_of_a_layout_are_not_in_the_file(tmp_path, suffix):
    page_bytes = []
    for by in (0.0, 1e-11, -3e-11):
        write_page(drawn(by), tmp_path / "page")
        page_bytes.append((tmp_path / f"page{suffix}").read_bytes())
    assert page_bytes[0] and page_bytes == [page_bytes[0]] * 3


def test_both_formats_have_the_same_layout(tmp_path):
    figure = drawn(0.0)
    write_figure(figure, tmp_path / "page.png", dpi=120)
    before = [axes.get_position().bounds for axes in figure.axes]
    write_figure(figure, tmp_path / "page.pdf", dpi=120)
    assert before == [axes.get_position().bounds for axes in figure.axes]
    assert figure.dpi == 120


def test_a_figure_without_a_layout_stays_as_it_is(tmp_path):
    figure = Figure()
    axes = figure.add_axes((0.123456789, 0.2, 0.5, 0.5))
    settle_layout(figure)
    write_figure(figure, tmp_path / "plain.svg")
    assert axes.get_position().x0 == 0.123456789
    assert (tmp_path / "plain.svg").read_text().startswith("<?xml")
