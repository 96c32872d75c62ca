import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pipeline.ground import kinematics as k

TURNS = np.linspace(0.0, 27.2, 200)
SEPARATOR = k.Geometry("separator", 0.40, 400.0, 15.0, 150.0, 8.0)
PAIR = k.Geometry("twisted_pair", 0.70, 290.0, 50.0)


def test_contraction_by_hand():
    # √(150² + (8 + 10·2π·0.4)²) − 150, worked out on paper
    assert k.separator_contraction(20 * np.pi, 150.0, 8.0, 0.4) == pytest.approx(3.61568, abs=1e-5)
    assert k.separator_contraction(0.0, 150.0, 8.0, 0.4) == pytest.approx(np.sqrt(150**2 + 64) - 150)
    assert k.pair_contraction(np.pi * 100, 290.0, 0.5) == pytest.approx(290 - np.sqrt(290**2 - (np.pi * 50) ** 2))


def test_load_thins_the_string_at_constant_volume():
    radius = k.loaded_radius(0.4, 400.0, 15.0, 20.0)
    assert radius**2 * (400.0 + 20.0 / 15.0) == pytest.approx(0.4**2 * 400.0)


@pytest.mark.parametrize("geometry", [SEPARATOR, PAIR])
def test_inverse_undoes_forward(geometry):
    x = geometry.contraction_mm(TURNS, 20.0)
    assert geometry.motor_turns(x, 20.0) == pytest.approx(TURNS, abs=1e-6)


@pytest.mark.parametrize("geometry", [SEPARATOR, PAIR])
def test_slope_is_the_derivative(geometry):
    step = 1e-5
    difference = (geometry.contraction_mm(TURNS + step, 20.0) - geometry.contraction_mm(TURNS - step, 20.0)) / (
        2 * step
    )
    assert geometry.slope_mm_per_turn(TURNS, 20.0) == pytest.approx(difference, abs=1e-6)


def test_eq_5_clips_its_radicand():
    below = k.separator_twist(np.array([-0.5, -3.0]), 150.0, 8.0, 0.4)
    assert below == pytest.approx([-8.0 / 0.4] * 2)


@given(st.floats(0.1, 1.0), st.floats(50, 300), st.floats(0, 20), st.floats(0, 200))
def test_contraction_rises_with_twist(radius, zone, separator, twist):
    lower, upper = k.separator_contraction(np.array([twist, twist + 1.0]), zone, separator, radius)
    assert upper > lower


def test_points_may_be_of_several_actuators():
    rows = []
    for geometry in (SEPARATOR, PAIR):
        x = geometry.contraction_mm(TURNS, 20.0)
        rows.append(pd.DataFrame({"motor_turns": TURNS, "displacement_mm": x, "load_n": 20.0, **vars(geometry)}))
    points = pd.concat(rows, ignore_index=True).sample(frac=1.0, random_state=0)
    forward_mm, inverse_turns = k.point_contraction_mm(points), k.point_motor_turns(points)
    assert forward_mm == pytest.approx(points["displacement_mm"].to_numpy())
    assert inverse_turns == pytest.approx(points["motor_turns"].to_numpy(), abs=1e-6)
