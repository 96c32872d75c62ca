"""What a rig does and holds, step by step: the scene in which an effect acts."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, Array, Geometry

STEP_S = 0.005
LEAST_CHANGE = 1e-4  # of a shape over its own size
Stage = Literal["twist", "radius", "length", "carriage", "sensor"]
STAGES: tuple[Stage, ...] = ("twist", "radius", "length", "carriage", "sensor")


@dataclass(frozen=True)
class Scene:
    """The true string and the motion on the simulation's clock, one value a step of STEP_S."""

    geometry: Geometry
    turns: Array
    load_n: Array

    @property
    def time_s(self) -> Array:
        """Time of each step in s."""
        return np.asarray(np.arange(len(self.turns)) * STEP_S, float)

    @property
    def usual_load_n(self) -> float:
        """Load that most of the strokes lift, in N."""
        return float(np.median(self.load_n))

    @property
    def contraction_mm(self) -> Array:
        """Contraction of the string without any effect, in mm."""
        return self.geometry.contraction_mm(self.turns, self.load_n)

    @property
    def torque_nmm(self) -> Array:
        """Torque of the load on the shaft, in N·mm."""
        return self.load_n * self.geometry.slope_mm_per_turn(self.turns, self.load_n) / RAD_PER_TURN

    @property
    def tangent(self) -> Array:
        """Tangent of the strands' angle to the string's axis; the lever over the radius is a pair's tangent."""
        lever = self._lever
        return lever if self._is_pair else lever / np.sqrt(1.0 - np.square(lever))

    @property
    def sine(self) -> Array:
        """Sine of the strands' angle to the string's axis; the lever over the radius is a separator's sine."""
        lever = self._lever
        return lever / np.sqrt(1.0 + np.square(lever)) if self._is_pair else lever

    @property
    def _is_pair(self) -> bool:
        return self.geometry.actuator == "twisted_pair"

    @property
    def _lever(self) -> Array:
        slope = self.geometry.slope_mm_per_turn(self.turns, self.load_n)
        return np.asarray(slope / (RAD_PER_TURN * self.geometry.radius_mm))

    def loads(self) -> list[tuple[int, float]]:
        """Stretches of one load: the first step of each and the load there in N."""
        rounded = np.round(self.load_n, 1)
        first = np.concatenate([[0], np.flatnonzero(np.diff(rounded)) + 1])
        return [(int(step), float(rounded[step])) for step in first]


@dataclass(frozen=True)
class Law:
    """One effect's law with its parameters drawn, but for its strength.

    `act(strength, given)` is what it adds to what comes in at its stage: to the turns (twist), to 1 as the radius's
    ratio (radius; given the turns), or to the displacement in mm (length, carriage, sensor).
    """

    stage: Stage
    strength: str
    bounds: tuple[float, float]
    act: Callable[[float, Array], Array]
    parameters: dict[str, float] = field(default_factory=dict)
    wanders: bool = False  # whether its strength may wander a little, as what is permanent or has no strength does not


Writer = Callable[[Scene, np.random.Generator], Law]


def displacement_mm(scene: Scene, acting: list[tuple[Law, float]]) -> Array:
    """Displacement that a perfect sensor would show with these laws at these strengths, in mm, one value a step."""

    def at(stage: Stage) -> list[tuple[Law, float]]:
        return [(law, strength) for law, strength in acting if law.stage == stage]

    turns = scene.turns
    for law, strength in at("twist"):
        turns = turns + law.act(strength, turns)
    ratio = np.ones_like(turns)
    for law, strength in at("radius"):
        ratio = ratio + law.act(strength, turns)
    geometry = scene.geometry
    shrunk = Geometry(
        geometry.actuator,
        geometry.radius_mm * ratio,
        geometry.length_mm,
        geometry.stiffness_n_per_mm,
        geometry.torsion_zone_mm,
        geometry.separator_mm,
    )
    shown = shrunk.contraction_mm(turns, scene.load_n)
    for stage in STAGES[2:]:
        for law, strength in at(stage):
            shown = shown + law.act(strength, shown)
    return shown


def proportional(
    stage: Stage, strength: str, most: float, shape: Array, parameters: dict[str, float], wanders: bool = True
) -> Law:
    """A law whose strength scales a shape that was simulated once; the shape is 0 at first and 1 at its largest.

    A shape that hardly changes stays 0: nothing scales the simulation's rounding up to an effect.
    """
    moved = shape - shape[0]
    largest = float(np.abs(moved).max())
    unit = moved / largest if largest > LEAST_CHANGE * float(np.abs(shape).max()) else np.zeros_like(moved)
    return Law(stage, strength, (1e-6 * most, most), lambda size, given: size * unit, parameters, wanders)
