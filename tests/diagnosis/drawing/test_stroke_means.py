"""What is slow is shown in means of whole strokes: no beat of strokes with bins of time, however uneven they are."""

from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure

from pipeline.diagnosis.drawing import driver_panels
from pipeline.diagnosis.drawing.stroke_means import MOST, stroke_means
from pipeline.diagnosis.recording.working_samples import PHASES


def strokes(count: int, seed: int = 1) -> SimpleNamespace:
    """Drivers of strokes of uneven length: rest, winding, hold and unwinding, in samples of a tenth of a second."""
    rng, phases, numbers = np.random.default_rng(seed), [], []
    for number in range(1, count + 1):
        for phase in ("rest", "winding", "hold", "unwinding"):
            length = rng.integers(10, 80)
            phases += [PHASES.index(phase)] * length
            numbers += [number] * length
    time_s = 0.1 * np.arange(len(phases))
    return SimpleNamespace(phase=np.array(phases), stroke=np.array(numbers), elapsed_s=time_s, breaks=np.zeros(0, int))


def loop(drivers: SimpleNamespace) -> np.ndarray:
    """What differs between winding and unwinding alone, and more in holds and rests."""
    return np.choose(drivers.phase, [-1.0, -3.0, 1.0, 3.0])


@pytest.mark.parametrize("count", [4, 13, 60])
def test_what_differs_between_winding_and_unwinding_alone_does_not_change_over_time(count):
    drivers = strokes(count)
    where, looped, drifted = stroke_means(
        drivers, np.array([drivers.elapsed_s, loop(drivers), loop(drivers) + drivers.elapsed_s])
    )
    assert len(where) == (count if count <= MOST else 20) and (np.diff(where) > 0).all()
    assert where[-1] < drivers.elapsed_s[-1]
    assert np.allclose(looped, 0.0) and np.allclose(drifted, where), "what is slow stays"


def test_few_strokes_and_strokes_of_one_direction_make_no_point():
    few = strokes(3)
    assert stroke_means(few, np.array([few.elapsed_s])).shape == (1, 0)
    drivers = strokes(6)
    kept = ~((drivers.stroke == 6) & (drivers.phase == PHASES.index("unwinding")))
    last = SimpleNamespace(phase=drivers.phase[kept], stroke=drivers.stroke[kept])
    assert stroke_means(last, np.array([drivers.elapsed_s[kept]])).shape == (1, 5)


def test_the_panel_over_time_shows_strokes_and_one_of_few_strokes_is_left_to_bins():
    axes, drivers = Figure().subplots(), strokes(12)
    residuals = {"calibrated": loop(drivers), "as diagnosed": np.zeros(len(drivers.phase))}
    assert driver_panels.by_stroke(axes, drivers, drivers.elapsed_s, residuals, 0.1, driver_panels.TIME)
    calibrated, _ = axes.get_lines()
    assert np.allclose(calibrated.get_ydata(), 0.0) and "means of whole strokes" in axes.get_xlabel()
    few = strokes(3)
    residuals = {"calibrated": loop(few)}
    assert not driver_panels.by_stroke(axes, few, few.elapsed_s, residuals, 0.1, driver_panels.TIME)


def test_over_a_temperature_strokes_are_points_in_order_of_it_and_joined_by_no_line():
    axes, drivers = Figure().subplots(), strokes(12)
    warm = 20.0 + 5.0 * np.sin(drivers.elapsed_s / 40.0)
    assert driver_panels.by_stroke(axes, drivers, warm, {"calibrated": warm}, 0.1, driver_panels.TEMPERATURE)
    (line,) = axes.get_lines()
    assert (np.diff(line.get_xdata()) >= 0.0).all() and np.allclose(line.get_xdata(), line.get_ydata())
    assert line.get_linestyle() == "None"
