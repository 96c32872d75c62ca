"""A made motion, and what a state equation of docs/concealment.md is written down with: its exact words and a function.

A function is written from the cell of the table, and gives what the effect does at its port: what the rig's own effect
does there is compared with it. Where a cell is an equation of what the effect does, both sides of it come back.
"""

import math
from collections.abc import Callable

import numpy as np

from pipeline.ground.kinematics import Geometry
from pipeline.rig.effect import Lived
from pipeline.rig.string_state import String

GEOMETRY = Geometry("separator", 0.40, 400.0, 15.0, 150.0, 8.0)
STEP_S, TURN = 0.002, 2.0 * np.pi
# until when (s), to which twist (turns), under which load (N)
LEGS = (
    (1.0, 0.0, 12.0), (6.0, 18.0, 12.0), (8.0, 18.0, 12.0), (13.0, 2.0, 12.0), (15.0, 2.0, 26.0), (21.0, 22.0, 26.0),
    (23.0, 22.0, 26.0), (26.0, 10.0, 26.0), (28.0, 14.0, 26.0), (34.0, 0.0, 26.0), (36.0, 0.0, 18.0),
)  # fmt: skip
Answer = np.ndarray | tuple[np.ndarray, np.ndarray]
Written = tuple[str, dict, Callable[[Lived, dict, np.ndarray], Answer]]
EQUATIONS: dict[str, Written] = {}


def lived() -> Lived:
    """The motion, as a bare string lives it."""
    time_s = np.arange(0.0, LEGS[-1][0], STEP_S)
    turns, load_n = np.zeros_like(time_s), np.zeros_like(time_s)
    begin, place, weight = 0.0, 0.0, 12.0
    for end, to, newton in LEGS:
        inside = (time_s >= begin) & (time_s < end)
        share = (time_s[inside] - begin) / (end - begin)
        soft = share - np.sin(TURN * share) / TURN
        turns[inside], load_n[inside] = place + (to - place) * soft, weight + (newton - weight) * soft
        begin, place, weight = end, to, newton
    return String(GEOMETRY, [], STEP_S).live(turns, load_n)


def states(name: str, cell: str, **parameters):
    """Say of which effect a function is, how its cell reads, and at which parameters they are compared."""

    def added(function):
        EQUATIONS[name] = (cell, parameters, function)
        return function

    return added


def behind(target: np.ndarray, tau_s: float, start: float = 0.0) -> np.ndarray:
    """The state of tau dz/dt = target - z, by small steps from a start."""
    z, out = start, np.empty_like(target)
    for i, now in enumerate(target):
        z += (now - z) * -math.expm1(-STEP_S / tau_s)
        out[i] = z
    return out


def torque(at: Lived, twist_rad: np.ndarray) -> np.ndarray:
    open_mm = GEOMETRY.separator_mm + twist_rad * at.radius_mm
    return at.load_n * at.radius_mm * open_mm / np.sqrt(GEOMETRY.torsion_zone_mm**2 + open_mm**2)


def rise(at: Lived) -> np.ndarray:
    """What the string contracts from its untwisted state."""
    return at.contraction_mm - (np.sqrt(GEOMETRY.torsion_zone_mm**2 + GEOMETRY.separator_mm**2) - 150.0)
