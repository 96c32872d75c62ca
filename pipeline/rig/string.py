"""The string in time: its state is carried from step to step and so from stroke to stroke."""

import math
from collections.abc import Iterable

import numpy as np

from pipeline.kinematics import RAD_PER_TURN, Array, Geometry, loaded_radius, separator_contraction
from pipeline.rig.effect import Effect, Now


class String:
    """A string with separator and its effects; call `pull` for stretches of time, one after the other."""

    def __init__(self, geometry: Geometry, effects: Iterable[Effect], step_s: float) -> None:
        effects = list(effects)
        self.twist = [effect for effect in effects if effect.acts_on == "twist"]
        self.radius = [effect for effect in effects if effect.acts_on == "radius"]
        self.length = [effect for effect in effects if effect.acts_on == "length"]
        self.now = Now(geometry, step_s, radius_mm=float(geometry.radius_mm))
        self.motor_rad: float | None = None
        self.helix_mm: float | None = None

    def pull(self, motor_turns: Array, load_n: Array) -> Array:
        """Contraction in mm after every step of commanded twist and load; all of shape (steps,)."""
        steps = zip((motor_turns * RAD_PER_TURN).tolist(), load_n.tolist(), strict=True)
        return np.array([self._step(motor_rad, force_n) for motor_rad, force_n in steps])

    def _step(self, motor_rad: float, load_n: float) -> float:
        now, geometry = self.now, self.now.geometry
        zone_mm, separator_mm = geometry.torsion_zone_mm, geometry.separator_mm
        now.turned_rad = 0.0 if self.motor_rad is None else motor_rad - self.motor_rad
        now.load_n, self.motor_rad = load_n, motor_rad

        now.twist_rad = motor_rad - math.fsum(effect.step(now) for effect in self.twist)

        now.helix_tangent = (separator_mm + now.twist_rad * now.radius_mm) / zone_mm
        now.radius_mm = float(
            loaded_radius(geometry.radius_mm, geometry.length_mm, geometry.stiffness_n_per_mm, load_n)
        )
        now.radius_mm *= math.prod(effect.step(now) for effect in self.radius)
        now.helix_tangent = (separator_mm + now.twist_rad * now.radius_mm) / zone_mm

        helix_mm = float(separator_contraction(now.twist_rad, zone_mm, separator_mm, now.radius_mm))
        now.advance_mm = 0.0 if self.helix_mm is None else helix_mm - self.helix_mm
        self.helix_mm = helix_mm
        return helix_mm - math.fsum(effect.step(now) for effect in self.length)
