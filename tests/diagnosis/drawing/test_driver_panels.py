"""The panels by driver: a ripple beats with bins that are no whole periods wide."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from pipeline.diagnosis.drawing import driver_panels
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem
from pipeline.rig.others import cases, made
from pipeline.run.samples import read_strokes

PITCH_M = 0.0093


def drawn(place_m, residual, period_m):
    """The means that the panel draws, in N."""
    axes = Figure().subplots()
    driver_panels.by_driver(axes, place_m, {"calibrated": residual}, 1.0, "position (m)", period_m)
    return np.asarray(axes.get_lines()[0].get_ydata())


def test_a_ripple_makes_no_wave_of_another_length_over_the_place():
    place_m = np.linspace(0.0, 0.25, 20_000)
    ripple = 5.0 * np.sin(2.0 * np.pi * place_m / PITCH_M)
    assert np.abs(drawn(place_m, ripple, 0.0)).max() > 0.5, "bins of their own width show a wave that is not there"
    assert np.abs(drawn(place_m, ripple, PITCH_M)).max() < 0.2, "both ends hold parts of a period"


@pytest.fixture(scope="module")
def drivers(tmp_path_factory):
    drawn_case = cases.make("mass-cogging", 21)
    folder = tmp_path_factory.mktemp("raw") / drawn_case.run["run"]
    made.write_run(drawn_case, folder)
    return make_problem([RecordedRun(*read_strokes(folder))]).drivers


def test_a_named_ripple_has_a_panel_of_one_period(drivers):
    added = set(driver_panels.listeners(drivers, PITCH_M)) - set(driver_panels.listeners(drivers))
    assert added == {"place within a ripple of 0.0093 m"}
    within_m, moving = driver_panels.listeners(drivers, PITCH_M)[added.pop()]
    assert within_m.min() >= 0.0 and within_m.max() < PITCH_M and moving.any()


def test_no_point_touches_the_frame_of_its_panel():
    axes = Figure().subplots()
    place_m = np.linspace(0.0, 1.0, 1000)
    driver_panels.by_driver(axes, place_m, {"calibrated": 10.0 * place_m}, 0.1, "position (m)")
    means, (low, high) = np.asarray(axes.get_lines()[0].get_ydata()), axes.get_ylim()
    assert min(high - means.max(), means.min() - low) > 0.1 * np.ptp(means)
