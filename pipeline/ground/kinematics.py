"""The analytic kinematics of a twisted string, forward and inverse: pure functions of arrays.

Lengths in mm, forces in N, twist in rad unless a name says turns. Equation numbers are those of Liu et al.,
"Kinematic Modeling of Twisted String Actuator Based on Invertible Neural Networks".
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Places = NDArray[np.intp]  # of samples or rows, counted from 0
Values = Any  # a float or an array that broadcasts with the others

# One sigma of how well each dimension was measured, unless run.yaml says otherwise; the radius relative.
TOLERANCE = {"radius": 0.03, "separator_mm": 0.5, "torsion_zone_mm": 1.0, "length_mm": 2.0}
# A string whose stiffness nobody measured: K = E·πr²/l0 with a modulus between nylon's 3 GPa and UHMWPE's 12 GPa. One
# sigma of 0.3 lets calibration, which moves by at most three, reach both.
USUAL_MODULUS_MPA = 7000.0
UNKNOWN_STIFFNESS = 0.3
RAD_PER_TURN = 2.0 * np.pi
DIMENSIONS = ("radius_mm", "length_mm", "stiffness_n_per_mm", "torsion_zone_mm", "separator_mm")


def usual_stiffness(radius_mm: Values, length_mm: Values) -> Any:
    """Stiffness that a string of this radius and length usually has, in N/mm; for one that nobody measured.

    Shapes broadcast.
    """
    return USUAL_MODULUS_MPA * np.pi * radius_mm**2 / length_mm


def loaded_radius(radius_mm: Values, length_mm: Values, stiffness_n_per_mm: Values, load_n: Values) -> Array:
    """Radius of a string that a load stretches at constant volume (eqs 2, 3), in mm. Shapes broadcast."""
    stretched_mm = length_mm + load_n / stiffness_n_per_mm
    return np.asarray(radius_mm * np.sqrt(length_mm / stretched_mm))


def separator_contraction(twist_rad: Values, torsion_zone_mm: Values, separator_mm: Values, radius_mm: Values) -> Array:
    """Contraction of a string with separator (eqs 1, 4), in mm; at zero twist it is √(d² + b²) − d, not 0.

    Shapes broadcast.
    """
    return np.asarray(np.hypot(torsion_zone_mm, separator_mm + np.asarray(twist_rad) * radius_mm) - torsion_zone_mm)


def separator_twist(contraction_mm: Values, torsion_zone_mm: Values, separator_mm: Values, radius_mm: Values) -> Array:
    """Twist of a string with separator (eq. 5), in rad.

    Where the contraction is negative eq. 5 has no real root: its radicand is clipped at 0. Shapes broadcast.
    """
    x = np.asarray(contraction_mm)
    radicand = np.maximum(x * (x + 2.0 * np.asarray(torsion_zone_mm)), 0.0)
    return np.asarray((np.sqrt(radicand) - separator_mm) / radius_mm)


def pair_contraction(twist_rad: Values, length_mm: Values, radius_mm: Values) -> Array:
    """Contraction x = L − √(L² − (θr)²) of a twisted pair without separator, in mm; NaN beyond θr = L.

    Shapes broadcast.
    """
    wound_mm = np.asarray(twist_rad) * radius_mm
    with np.errstate(invalid="ignore"):
        return np.asarray(length_mm - np.sqrt(np.square(length_mm) - np.square(wound_mm)))


def pair_twist(contraction_mm: Values, length_mm: Values, radius_mm: Values) -> Array:
    """Twist of a twisted pair without separator, in rad; a contraction outside 0…L is clipped to it.

    Shapes broadcast.
    """
    x = np.clip(contraction_mm, 0.0, length_mm)
    return np.asarray(np.sqrt(x * (2.0 * np.asarray(length_mm) - x)) / radius_mm)


@dataclass(frozen=True)
class Geometry:
    """The measured dimensions of one string on its rig: scalars, or arrays of shape (samples,)."""

    actuator: str  # "separator" or "twisted_pair"
    radius_mm: Values
    length_mm: Values
    stiffness_n_per_mm: Values
    torsion_zone_mm: Values = np.nan  # separator only
    separator_mm: Values = np.nan  # separator only

    def contraction_mm(self, motor_turns: Values, load_n: Values) -> Array:
        """Contraction of the analytic model for a twist and a load (eq. 4, or the pair), in mm; shapes broadcast."""
        twist_rad = np.asarray(motor_turns) * RAD_PER_TURN
        if self.actuator == "twisted_pair":
            return pair_contraction(twist_rad, self.length_mm, self.radius_mm)
        radius_mm = loaded_radius(self.radius_mm, self.length_mm, self.stiffness_n_per_mm, load_n)
        return separator_contraction(twist_rad, self.torsion_zone_mm, self.separator_mm, radius_mm)

    def motor_turns(self, contraction_mm: Values, load_n: Values) -> Array:
        """Twist that a contraction under a load needs (eq. 5, or the pair), in turns; shapes broadcast."""
        if self.actuator == "twisted_pair":
            return pair_twist(contraction_mm, self.length_mm, self.radius_mm) / RAD_PER_TURN
        radius_mm = loaded_radius(self.radius_mm, self.length_mm, self.stiffness_n_per_mm, load_n)
        twist_rad = separator_twist(contraction_mm, self.torsion_zone_mm, self.separator_mm, radius_mm)
        return twist_rad / RAD_PER_TURN

    def slope_mm_per_turn(self, motor_turns: Values, load_n: Values) -> Array:
        """Derivative of the contraction by the twist at a twist and a load, in mm/turn.

        Twist in turns, load in N; shapes broadcast.
        """
        twist_rad = np.asarray(motor_turns) * RAD_PER_TURN
        if self.actuator == "twisted_pair":
            contraction_mm = pair_contraction(twist_rad, self.length_mm, self.radius_mm)
            slope = twist_rad * np.square(self.radius_mm) / (self.length_mm - contraction_mm)
        else:
            radius_mm = loaded_radius(self.radius_mm, self.length_mm, self.stiffness_n_per_mm, load_n)
            open_mm = self.separator_mm + twist_rad * radius_mm
            slope = radius_mm * open_mm / np.hypot(self.torsion_zone_mm, open_mm)
        return np.asarray(slope * RAD_PER_TURN)


def knows_load(points: Any) -> Mask:
    """Whether the equation of each point's string has the load in it, a pair's has not; shape (points,), no unit."""
    return np.asarray(np.asarray(points["actuator"]).astype(str) != "twisted_pair")


def point_contraction_mm(points: Any) -> Array:
    """Contraction for each point's `motor_turns`, in mm (eq. 4, or the pair); `points` as `schemas.DATASET`.

    Shape (points,); its columns by name do as well. A pair wound beyond θr = L, where its equation has no real value,
    is taken as wound up: L.
    """
    contraction = _of_points(points, "motor_turns", Geometry.contraction_mm)
    return np.where(np.isnan(contraction), np.asarray(points["length_mm"]), contraction)


def point_motor_turns(points: Any) -> Array:
    """Twist for each point's `displacement_mm`, in turns, shape (points,): eq. 5, radicand clipped at 0, or pair."""
    return _of_points(points, "displacement_mm", Geometry.motor_turns)


def _of_points(points: Any, from_column: str, equation: Callable[[Geometry, Values, Values], Array]) -> Array:
    """An equation's value for every row of a table, whose rows may be of several strings and actuators."""
    actuators = np.asarray(points["actuator"]).astype(str)
    result = np.empty(len(actuators))
    column = {name: np.asarray(points[name], float) for name in (from_column, "load_n", *DIMENSIONS)}
    for actuator in np.unique(actuators):
        is_actuator = actuators == actuator
        geometry = Geometry(str(actuator), **{name: column[name][is_actuator] for name in DIMENSIONS})
        result[is_actuator] = equation(geometry, column[from_column][is_actuator], column["load_n"][is_actuator])
    return result
