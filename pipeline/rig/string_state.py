"""The string in time: its state is carried from stretch to stretch and so from stroke to stroke."""

from collections.abc import Iterable

import numpy as np

from ..ground.kinematics import RAD_PER_TURN, Array, Geometry, loaded_radius, separator_contraction
from .effect import ActsOn, Effect, Lived

ROOM_C = 22.0


class String:
    """A string with separator and its effects; call `live` for stretches of time, one after the other.

    Effects on the twist, the radius, the contraction and the reading act one after the other, as the twist, the
    force and the signal pass through them; those on the length add up.
    """

    def __init__(self, geometry: Geometry, effects: Iterable[Effect], step_s: float) -> None:
        self.geometry, self.effects, self.step_s = geometry, list(effects), step_s
        self.motor_rad: float | None = None
        self.helix_mm: float | None = None

    def pull(self, motor_turns: Array, load_n: Array) -> Array:
        """The displacement sensor's reading in mm after every step of commanded twist and load; all (steps,).

        All have the shape (steps,).
        """
        return self.live(motor_turns, load_n).reading_mm

    def live(self, motor_turns: Array, load_n: Array) -> Lived:
        """All quantities of the rig in a stretch of time; twist in turns and load in N, both of shape (steps,)."""
        geometry, motor_rad = self.geometry, motor_turns * RAD_PER_TURN
        turned_rad = np.diff(motor_rad, prepend=motor_rad[0] if self.motor_rad is None else self.motor_rad)
        self.motor_rad = float(motor_rad[-1])
        nothing = np.zeros(len(motor_rad))
        lived = Lived(
            geometry,
            self.step_s,
            load_n=load_n,
            turned_rad=turned_rad,
            twist_rad=motor_rad,
            radius_mm=loaded_radius(geometry.radius_mm, geometry.length_mm, geometry.stiffness_n_per_mm, load_n),
            helix_tangent=nothing,
            helix_mm=nothing,
            advance_mm=nothing,
            contraction_mm=nothing,
            reading_mm=nothing,
            temperature_c=nothing + ROOM_C,
        )
        for effect in self._on("twist"):
            lived.twist_rad = lived.twist_rad - effect.run(lived)
        for effect in self._on("radius"):
            lived.radius_mm = lived.radius_mm * effect.run(lived)
        zone_mm, separator_mm = geometry.torsion_zone_mm, geometry.separator_mm
        lived.helix_tangent = (separator_mm + lived.twist_rad * lived.radius_mm) / zone_mm
        lived.helix_mm = separator_contraction(lived.twist_rad, zone_mm, separator_mm, lived.radius_mm)
        before_mm = lived.helix_mm[0] if self.helix_mm is None else self.helix_mm
        lived.advance_mm = np.diff(lived.helix_mm, prepend=before_mm)
        self.helix_mm = float(lived.helix_mm[-1])
        lived.contraction_mm = lived.helix_mm - sum((effect.run(lived) for effect in self._on("length")), nothing)
        for effect in self._on("contraction"):
            lived.contraction_mm = lived.contraction_mm - effect.run(lived)
        lived.reading_mm = lived.contraction_mm
        for effect in self._on("reading"):
            lived.reading_mm = lived.reading_mm + effect.run(lived)
        return lived

    def _on(self, quantity: ActsOn) -> list[Effect]:
        return [effect for effect in self.effects if effect.acts_on == quantity]
