"""The equations of the bare string at the head of docs/physics.md, evaluated as they stand there, beside the code."""

import re

import numpy as np
import pytest

from pipeline.diagnosis.recording.drivers import Moved
from pipeline.diagnosis.words.physics_page import HEAD
from pipeline.ground.kinematics import Geometry, loaded_radius
from pipeline.systems import systems

ROUTE = HEAD.partition("| symbol |")[0]
EQUATIONS = dict(re.findall(r"`([a-z]+ ?a?|L) = ([^`]+)`", ROUTE.partition("A pair")[0]))
PAIR = dict(re.findall(r"`(x) = ([^`]+)`", ROUTE.partition("A pair")[2]))
TURNS, LOAD_N = np.linspace(0.5, 25.0, 60), np.where(np.arange(60) % 2, 9.0, 24.0)
SEPARATED = Geometry("separator", 0.4, 400.0, 15.0, 150.0, 8.0)
TWO = Geometry("twisted_pair", 0.7, 290.0, 50.0)
GIVEN = {"d": 150.0, "b": 8.0, "r0": 0.4, "l": 400.0, "K": 15.0, "F": LOAD_N, "theta": 2.0 * np.pi * TURNS}


def worked_out(equation: str, values: dict) -> np.ndarray:
    """The right side of an equation: ^ is a power, and letters beside each other are multiplied."""
    spelled = re.sub(r"(?<=[\w)]) (?=[\w(])", " * ", equation.replace("^", "**"))
    return eval(spelled, {"__builtins__": {}, "sqrt": np.sqrt}, values)


@pytest.fixture(scope="module")
def bare() -> dict:
    """Every quantity of the page, in the order in which each follows from those before it."""
    values = dict(GIVEN)
    for symbol in ("r", "y", "L", "x", "sin a", "tan a"):
        values[symbol] = worked_out(EQUATIONS[symbol], values)
    return values


def test_the_page_has_these_equations_and_no_other() -> None:
    assert sorted(EQUATIONS) == ["L", "r", "sin a", "tan a", "x", "y"] and list(PAIR) == ["x"]
    assert len(re.findall(r"`[^`]* = [^`]*`", ROUTE)) == len(EQUATIONS) + len(PAIR)


def test_radius_and_displacement_under_a_load_are_those_of_the_page(bare: dict) -> None:
    np.testing.assert_allclose(loaded_radius(0.4, 400.0, 15.0, LOAD_N), bare["r"], rtol=1e-12)
    np.testing.assert_allclose(SEPARATED.contraction_mm(TURNS, LOAD_N), bare["x"], rtol=1e-9)
    np.testing.assert_allclose(SEPARATED.motor_turns(bare["x"], LOAD_N), TURNS, rtol=1e-9)


def test_the_helix_angle_is_that_of_the_page(bare: dict) -> None:
    nothing = np.zeros_like(TURNS)
    inputs = Moved(TURNS, TURNS, nothing, nothing, LOAD_N / 10.0)
    values = np.array([0.4, 8.0, 150.0, 400.0, 1.0, 0.0, 15.0])
    sine, tangent = systems()["separator"].lever(values, inputs)
    np.testing.assert_allclose(sine, bare["sin a"], rtol=1e-9)
    np.testing.assert_allclose(tangent, bare["tan a"], rtol=1e-9)


def test_a_pair_without_separator_is_that_of_the_page_under_any_load() -> None:
    values = {"l": 290.0, "r": 0.7, "theta": GIVEN["theta"]}
    pair = worked_out(PAIR["x"], values)
    np.testing.assert_allclose(TWO.contraction_mm(TURNS, LOAD_N), pair, rtol=1e-9)
    np.testing.assert_allclose(TWO.contraction_mm(TURNS, 3.0 * LOAD_N), pair, rtol=1e-9)
