"""The page of figures: what its panels show can be read, and legends lie on no curve."""

import matplotlib.pyplot as plt
import pytest

from pipeline.diagnosis import figures
from pipeline.diagnosis.engine import make_problem, study
from pipeline.diagnosis.verdict import diagnosis
from pipeline.ingest import read_samples


@pytest.fixture
def drawn(conceal, tmp_path, monkeypatch):
    """The page of a run with creep, not yet closed, and the content of its diagnosis."""
    run, samples = read_samples(conceal("creep")[0])
    found = study(make_problem([run], [samples]))
    content = diagnosis(found, found.problem, None, [run], None, frozenset())
    with monkeypatch.context() as held:
        held.setattr(plt, "close", lambda figure: None)
        figures.page(found, content, tmp_path / "page")
    assert (tmp_path / "page.png").is_file() and (tmp_path / "page.pdf").is_file()
    yield plt.gcf(), content
    plt.close("all")


def test_the_small_panels_share_a_legend_beside_them_and_calibration_leaves_what_the_words_say(drawn) -> None:
    figure, content = drawn
    bottom = figure.subfigs[-1]
    small = [axes for axes in bottom.axes if axes.get_lines()]
    assert small and all(axes.get_legend() is None for axes in small)
    (legend,) = bottom.legends
    assert [text.get_text() for text in legend.get_texts()] == ["calibrated", "as diagnosed", "noise floor"]
    box = legend.get_window_extent()
    assert all(box.y1 <= axes.get_window_extent().y0 for axes in small)
    ranking = figure.subfigs[-2].axes[0]
    evidence = content["evidence"]
    alone = next(place for place, one in enumerate(evidence["explanations"]) if not one["ids"])
    assert ranking.patches[alone].get_width() == pytest.approx(evidence["calibrated_mm"] / evidence["floor_mm"])
    diamonds = next(line for line in ranking.get_lines() if line.get_marker() == "D").get_xdata()
    assert all(x <= bar.get_width() + 1e-9 for x, bar in zip(diamonds, ranking.patches, strict=False))
