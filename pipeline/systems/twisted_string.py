"""The twisted string, with a separator (eqs 1–4) or as a pair: twist, load and mechanisms → displacement in mm.

Source: Liu, Wei, Gao and Gong, "Kinematic Modeling of Twisted String Actuator Based on Invertible Neural Networks" (eqs
1–4); Würtz and others, "The twisted string actuation system: modeling and control", IEEE/ASME AIM 2010 (pair).
"""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ..ground.kinematics import RAD_PER_TURN, TOLERANCE, UNKNOWN_STIFFNESS, Array, loaded_radius, usual_stiffness
from .interface import Described, Inputs, Parameter, System, sigma_of

LOAD_UNIT_N = 10.0
SEPARATOR = {"torsion_zone_mm": "the length in mm", "separator_mm": "the length in mm"}
MEASURED = {
    "radius_mm": "half the thickness of one string, untwisted, lightly pulled: a caliper at ten places, the mean",
    "separator_mm": "between the middles of the separator's two holes: a caliper",
    "torsion_zone_mm": "where the strings twist, from the motor's clamp to the separator: a caliper or a steel rule",
    "length_mm": "one string from clamp to clamp, untwisted, under its load: a steel rule",
    "scale": "move the sensor by a known way (gauge blocks, a caliper): gain = what it reads / the way",
    "angle_turns": "what the motor reads where the strings lie parallel, untwisted",
    "stiffness_n_per_mm": "hang two weights on the untwisted string in turn: difference of forces / of lengths",
}
FLATTEST = 0.98  # of its length, that a pair can be wound


class TwistedString(System):
    """Stages: twist → radius → geometry → length → sensor scale. Each mechanism enters at its stage."""

    driver, channel, load, load_unit = "motor_turns", "displacement_mm", "load_n", LOAD_UNIT_N
    turn, levered, needs_string, homed = 1.0, True, True, "angle_turns"
    optional_rig: Mapping[str, str] = {"load_n": "load in N, where no channel tells it"}
    tolerance: Mapping[str, float] = {**TOLERANCE, "scale": 0.005, "angle_turns": 0.05}
    absolute = frozenset({"separator_mm", "torsion_zone_mm", "length_mm", "angle_turns"})
    measured: Mapping[str, str] = MEASURED
    ports: Mapping[str, str] = {
        "twist": "twist", "radius": "radius", "length": "length", "resistance": "length", "sensor": "sensor",
    }  # fmt: skip

    def _zone(self, run: Described) -> list[Parameter]:
        """Dimensions of the rig between radius and length."""
        return []

    def _geometry(self, values: Array, turns: Array, load_n: Array, radius_change: Array) -> tuple[Array, Array]:
        """Contraction in mm and the sine of the helix angle."""
        radius, length, _, angle, _ = values
        wound = RAD_PER_TURN * (turns + angle) * radius * (1.0 + radius_change)
        wound = np.clip(wound, -FLATTEST * length, FLATTEST * length)
        return length - np.sqrt(length * length - wound * wound), wound / length

    def _stiffness(self, run: Described) -> Parameter:
        """Stiffness of the string, measured or as strings usually have it; a pair does not use it."""
        string = run.string
        usual = float(usual_stiffness(string.radius_mm, string.length_mm))
        return Parameter("stiffness_n_per_mm", string.stiffness_n_per_mm or usual, 0.0)

    def parameters(self, run: Described) -> list[Parameter]:
        """Radius, then the dimensions of the zone or of the pair, then sensor scale and the zero of the angle."""
        string = run.string
        return [
            Parameter("radius_mm", string.radius_mm, sigma_of(self, run, "radius") * string.radius_mm),
            *self._zone(run),
            Parameter("length_mm", string.length_mm, sigma_of(self, run, "length_mm")),
            Parameter("scale", 1.0, sigma_of(self, run, "scale")),
            Parameter("angle_turns", 0.0, sigma_of(self, run, "angle_turns")),
            self._stiffness(run),
        ]

    def lever(self, values: Array, inputs: Inputs) -> tuple[Array, Array]:
        """Sine and tangent of the helix angle."""
        _, sine = self._geometry(values, inputs.motion, inputs.load * LOAD_UNIT_N, np.zeros_like(inputs.motion))
        return sine, sine / np.sqrt(np.maximum(1.0 - sine * sine, 1e-6))

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """Contraction in mm."""
        return self._geometry(values, inputs.motion, inputs.load * LOAD_UNIT_N, np.zeros_like(inputs.motion))[0]

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """Displacement in mm, without its zero."""
        nothing = np.zeros_like(inputs.motion)
        turns = inputs.motion + acts.get("twist", nothing)
        contraction, _ = self._geometry(values, turns, inputs.load * LOAD_UNIT_N, acts.get("radius", nothing))
        scale = values[-3]
        return np.asarray(scale * (contraction - acts.get("length", nothing)))


class Pair(TwistedString):
    """x = L - sqrt(L^2 - (theta r)^2); a separator's dimensions are read, but not used."""

    name = "twisted_pair"
    optional_rig: Mapping[str, str] = {**TwistedString.optional_rig, **SEPARATOR}


class Separated(TwistedString):
    """Eqs 1–4 of the paper."""

    name = "separator"
    rig: Mapping[str, str] = SEPARATOR
    never_zero = frozenset({"torsion_zone_mm"})

    def _zone(self, run: Described) -> list[Parameter]:
        """The separator and the torsion zone."""
        separator, zone = (sigma_of(self, run, key) for key in ("separator_mm", "torsion_zone_mm"))
        return [
            Parameter("separator_mm", run.rig["separator_mm"], separator, lowest=0.0),
            Parameter("torsion_zone_mm", run.rig["torsion_zone_mm"], zone),
        ]

    def _stiffness(self, run: Described) -> Parameter:
        """Stiffness of the string; calibration moves it where nobody measured it."""
        measured = super()._stiffness(run)
        unknown = run.string.stiffness_n_per_mm is None
        return replace(measured, sigma=UNKNOWN_STIFFNESS * measured.nominal if unknown else 0.0)

    def _geometry(self, values: Array, turns: Array, load_n: Array, radius_change: Array) -> tuple[Array, Array]:
        """Contraction in mm and the sine of the helix angle."""
        radius, separator, zone, length, _, angle, stiffness = values
        section = loaded_radius(radius, length, stiffness, load_n) * (1.0 + radius_change)
        offset = separator + RAD_PER_TURN * (turns + angle) * section
        strand = np.hypot(zone, offset)
        return strand - zone, offset / strand


SYSTEMS = (Separated(), Pair())
