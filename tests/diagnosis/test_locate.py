"""The box is where the energy is."""

import numpy as np

from pipeline.diagnosis import locate


def test_box_of_a_patch(problem) -> None:
    drivers = problem.drivers
    top = drivers.motion.max()
    inside = (drivers.motion > 0.6 * top) & (drivers.stroke >= 4) & (drivers.stroke <= 9) & (drivers.phase == 0)
    found = locate.box(np.where(inside, 1.0, 0.02), problem)
    assert found["phase"] == "winding" and found["share"] >= 0.8
    assert found["strokes"][0] >= 4 and found["strokes"][1] <= 9
    assert found["motor_turns"][0] >= 0.55 * top
