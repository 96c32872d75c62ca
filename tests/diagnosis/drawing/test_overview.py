"""The panels over time: what can be told apart is drawn, and what cannot is said."""

import itertools
from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.figure import Figure

from pipeline.diagnosis.drawing import overview, panels


def drawn(drivers, measured, simulations):
    """The axes of the panels, and the words of each legend."""
    figure = Figure()
    part = figure.subfigures(1, 1)
    overview.overview(part, drivers, measured, simulations, "displacement")
    return part.axes, [[text.get_text() for text in axes.get_legend().get_texts()] for axes in part.axes[:2]]


@pytest.mark.long
def test_a_simulator_that_would_lie_on_the_recording_is_named_and_not_drawn(studied) -> None:
    problem = studied("creep")[0].problem
    measured = problem.measured
    far, near = measured + 0.1 * np.ptp(measured), measured + 1e-3 * np.ptp(measured)
    axes, (above, below) = drawn(
        problem.drivers, measured, {"nominal": far, "calibrated": near, "as diagnosed": measured + 9e-4}
    )
    assert above == ["recording", "nominal", "as diagnosed"]
    assert axes[0].get_title(loc="left") == "not drawn, for it would lie on these lines: calibrated"
    assert below[0].startswith("nominal: ") and below[0].endswith("mm rms, not drawn"), "it would squash the others"
    assert below[1:] == ["calibrated", "as diagnosed"]
    *_, (above, below) = drawn(problem.drivers, measured, {"nominal": near, "calibrated": near, "as diagnosed": near})
    assert above == ["recording", "as diagnosed"] and below == ["nominal", "calibrated", "as diagnosed"]
    plt.close("all")


def test_runs_with_zeros_of_their_own_are_drawn_from_their_lowest_readings(studied) -> None:
    problem = studied("creep")[0].problem
    drivers, half = problem.drivers, len(problem.measured) // 2
    place = np.arange(len(problem.measured))
    two = replace(drivers, first=np.where(place < half, drivers.first, drivers.first[0] + place - half))
    assert len(two.breaks) == 1
    zeros, whence = overview.own_zeros(two, problem.measured)
    assert not zeros.any() and whence == "", "the zeros are near"
    shifted = np.where(place < half, problem.measured, problem.measured + 150.0)
    axes, _ = drawn(two, shifted, {"nominal": shifted, "calibrated": shifted})
    assert axes[0].get_ylabel() == "displacement (mm),\neach run from its lowest"
    values = axes[0].get_lines()[0].get_ydata()
    assert np.nanmax(values) < 1.1 * np.ptp(problem.measured)


def test_a_load_that_varies_has_a_panel(studied) -> None:
    problem = studied("creep")[0].problem
    same = {"nominal": problem.measured, "calibrated": problem.measured}
    steady = replace(problem.drivers, loaded=False, load=np.full(len(problem.measured), 2.0))
    still, varied = (
        drawn(drivers, problem.measured, same)[0] for drivers in (steady, replace(problem.drivers, loaded=True))
    )
    assert [axes.get_ylabel() for axes in varied][-1] == "load (N)" and len(varied) == len(still) + 1
    assert varied[-1].get_xlabel() == still[-1].get_xlabel() == "time (s)"


def test_the_error_of_other_effects_does_not_have_the_colour_of_the_diagnosis() -> None:
    _, axes = plt.subplots()
    heldout = {"nominal_mm": 0.4, "calibrated_mm": 0.2, "explained_mm": 0.3}
    panels.held_out(axes, heldout, 0.02, "mm", "mm", without="creep")
    colours = axes.collections[1].get_facecolors()[:, :3]
    assert not np.allclose(colours[2], plt.matplotlib.colors.to_rgb(panels.AFTER))
    plt.close("all")


def test_the_labels_of_the_panels_over_time_do_not_touch(studied) -> None:
    problem = studied("creep")[0].problem
    figure = Figure(figsize=(9.6, 3.4), layout="constrained")
    part = figure.subfigures(1, 1)
    drivers = replace(problem.drivers, loaded=True)
    overview.overview(
        part,
        drivers,
        problem.measured,
        {"calibrated": problem.measured + 1.0, "as diagnosed": problem.measured},
        "displacement",
    )
    figure.draw_without_rendering()
    boxes = [axes.yaxis.label.get_window_extent() for axes in part.axes]
    assert len(boxes) == 3 and all(above.y0 > below.y1 for above, below in itertools.pairwise(boxes))


def test_a_simulator_that_lies_under_a_later_one_is_named_and_not_drawn(studied) -> None:
    """Nominal stood in the legend of a figure that did not show it."""
    problem = studied("creep")[0].problem
    measured = problem.measured
    away = measured + 0.3 * np.ptp(measured)
    axes, (above, _) = drawn(
        problem.drivers, measured, {"nominal": away + 1e-4, "calibrated": away, "as diagnosed": measured}
    )
    assert above == ["recording", "calibrated", "as diagnosed"]
    assert axes[0].get_title(loc="left") == "not drawn, for it would lie on these lines: nominal"
    plt.close("all")


def test_the_strokes_that_no_fit_has_seen_are_shaded(studied) -> None:
    problem = studied("creep")[0].problem
    end_s = float(problem.drivers.elapsed_s[-1])
    part = Figure().subfigures(1, 1)
    simulations = {"nominal": problem.measured + 1.0, "calibrated": problem.measured}
    overview.overview(part, problem.drivers, problem.measured, simulations, "displacement", [0.7 * end_s])
    for axes in part.axes:
        (shade,) = axes.patches
        assert shade.get_x() == pytest.approx(0.7 * end_s) and shade.get_width() == pytest.approx(0.3 * end_s)
    assert part.axes[1].get_title(loc="left") == overview.UNSEEN
    axes, _ = drawn(problem.drivers, problem.measured, simulations)
    assert not any(panel.patches or panel.get_title(loc="left") for panel in axes[1:]), "none were left out"
