"""The class of heat: a motor that holds a torque is warmed by its current, and warms the string's mount."""

import numpy as np
from left_by_class import left_by_class


def test_the_heat_of_a_held_torque_is_in_it(problem) -> None:
    drivers, warm, kelvin = problem.drivers, np.zeros(len(problem.record)), 0.0
    heat = (drivers.load * np.maximum(drivers.sine, 0.0)) ** 2
    for place in range(1, len(warm)):
        kelvin += (drivers.time_s[place] - drivers.time_s[place - 1]) * (heat[place] - kelvin) / 60.0
        warm[place] = kelvin
    assert left_by_class(problem, "thermal", warm) < 0.1
