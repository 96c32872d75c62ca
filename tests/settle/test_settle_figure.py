"""The figure of a run: its title is whole, and a load that changes is drawn."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pipeline.settle import foretold_figure

LONG = "one stroke at twice the speed under twice the load with a hold, then one stroke under half the load with a hold"


def drawn(monkeypatch, load_n: list[float], before_n: float | None, title: str = "a run", came=None, ties=True):
    time_s = [0.0, 1.0, 2.0, 3.0]
    curves = {"time_s": time_s, "motor_turns": [0.0, 0.0, 9.0, 0.0], "load": load_n, "calibrated": [0.0, 0.0, 3.0, 0.0]}
    figures: list = []
    monkeypatch.setattr(foretold_figure, "write_page", lambda figure, path: figures.append(figure))
    run = {
        "title": title,
        "load": before_n,
        "curves": curves | {"rivals": {"creep": [0.0, 0.0, 3.1, 0.2]} if ties else {}},
    }
    foretold_figure.draw(run, Path("unwritten"), f"{title}: what each explanation foretells", came)
    return figures[0]


def legend(figure) -> list[str]:
    """What the figure's legends say."""
    inside = [panel.get_legend() for panel in figure.axes if panel.get_legend()]
    return [entry.get_text() for each in (*figure.legends, *inside) for entry in each.get_texts()]


def test_the_legend_says_what_is_foretold_and_what_came_and_lies_beside_the_panels(monkeypatch):
    """It lay on the curves of the lowest panel, named no line of the others, and said: what came."""
    came = pd.DataFrame({"time_s": [0.0, 1.0, 3.0], "motor_turns": [0.0, 0.1, 0.0], "displacement_mm": 0.0})
    figure = drawn(monkeypatch, [20.0] * 4, 20.0, came=came)
    assert legend(figure) == [
        "motion and load as planned",
        "creep: foretold",
        "recorded (lowest panel: means over 0.25 s)",
    ]
    figure.canvas.draw()
    below = figure.legends[0].get_window_extent()
    assert all(not below.overlaps(panel.get_window_extent()) for panel in figure.axes)
    assert [len(panel.lines) for panel in figure.axes] == [2, 2, 2], "what came in each panel, the motion too"


def test_the_title_lies_within_the_figure(monkeypatch):
    figure = drawn(monkeypatch, [20.0] * 4, 20.0, LONG)
    figure.canvas.draw()
    extent = figure._suptitle.get_window_extent()
    assert (
        extent.x0 >= 0
        and extent.x1 <= figure.bbox.width
        and figure._suptitle.get_text().split()
        == [
            *LONG.split()[:-1],
            "hold:",
            *["what", "each", "explanation", "foretells"],
        ]
    )


@pytest.mark.parametrize(
    ("load_n", "before_n", "has"),
    [
        ([20.0, 40.0, 40.0, 40.0], 20.0, True),
        ([40.0] * 4, 20.0, True),
        ([20.0, 20.05, 20.0, 20.0], 20.0, False),
        ([0.0] * 4, None, False),
    ],
)
def test_the_load_has_a_panel_where_it_changes(load_n, before_n, has, monkeypatch):
    came = pd.DataFrame({"time_s": [0.0, 3.0], "motor_turns": [0.0, 0.0], "displacement_mm": 0.0, "load_n": 33.0})
    panels = drawn(monkeypatch, load_n, before_n, came=came).axes
    loads = [panel for panel in panels if panel.get_ylabel() == "load (N)"]
    assert len(loads) == has and len(panels) == 3 + has
    if has:
        foretold, hung = (np.asarray(line.get_ydata()).tolist() for line in loads[0].lines)
        assert foretold == load_n and hung == [33.0, 33.0]


def test_a_first_recording_has_no_panel_of_a_line_at_0_before_it_is_made(monkeypatch):
    """The largest panel showed the simulator beyond itself: flat, while nothing was loaded or compared."""
    panels = drawn(monkeypatch, [20.0] * 4, 20.0, ties=False).axes
    assert [panel.get_ylabel().split()[0] for panel in panels] == ["motor", "displacement"]
    assert panels[-1].get_xlabel() == "time (s)" and legend(panels[-1].figure) == [
        "motion and load as planned",
        "the simulator of run.yaml: foretold",
    ]
    came = pd.DataFrame({"time_s": [0.0, 3.0], "motor_turns": [0.0, 0.0], "displacement_mm": 0.0})
    panels = drawn(monkeypatch, [20.0] * 4, 20.0, came=came, ties=False).axes
    assert [panel.get_ylabel().split()[0] for panel in panels] == ["motor", "displacement", "difference"]
