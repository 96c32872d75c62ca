"""The best fit of a recording by calibration alone: the analytic model with its dimensions moved within tolerance.

Source: Branch, Coleman and Li, "A subspace, interior, and conjugate gradient method for large-scale bound-constrained
minimization problems", SIAM Journal on Scientific Computing 21, 1999.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import least_squares

from ..ground.kinematics import TOLERANCE, Array, Geometry

FREE = ("radius", "separator_mm", "torsion_zone_mm", "length_mm", "scale")
SCALE_SIGMA = 0.01
MOST_SIGMA = 3.0
MOST_SAMPLES = 4000


@dataclass(frozen=True)
class Calibrated:
    """A calibration and its residual."""

    sigmas: dict[str, float]  # how far each dimension moved, in sigma of its tolerance
    residual_mm: Array  # (samples,): recording less model


def moved(measured: Geometry, sigmas: Array) -> Geometry:
    """The dimensions, moved by so many sigma each.

    Shape (dimensions,), without a unit: shares of each tolerance.
    """
    return replace(
        measured,
        radius_mm=measured.radius_mm * (1.0 + TOLERANCE["radius"] * sigmas[0]),
        separator_mm=max(measured.separator_mm + TOLERANCE["separator_mm"] * sigmas[1], 0.0),
        torsion_zone_mm=measured.torsion_zone_mm + TOLERANCE["torsion_zone_mm"] * sigmas[2],
        length_mm=measured.length_mm + TOLERANCE["length_mm"] * sigmas[3],
    )


def _left(sigmas: Array, measured: Geometry, motor_turns: Array, load_n: Array, displacement_mm: Array) -> Array:
    """Residual in mm; the zero is solved for, since it is free."""
    model_mm = moved(measured, sigmas).contraction_mm(motor_turns, load_n) * (1.0 + SCALE_SIGMA * sigmas[4])
    residual_mm = displacement_mm - model_mm
    return np.asarray(residual_mm - residual_mm.mean())


def calibrate(
    measured: Geometry, motor_turns: Array, load_n: Array, displacement_mm: Array, noise_mm: float
) -> Calibrated:
    """Plain least squares over the dimensions and the scale, each with its tolerance as prior and 3 sigma as limit.

    Each of shape (samples,), in turns, N and mm.
    """
    thin = slice(None, None, max(1, len(motor_turns) // MOST_SAMPLES))
    few = (motor_turns[thin], load_n[thin], displacement_mm[thin])
    weight = np.sqrt(len(motor_turns) / len(few[0])) / noise_mm

    def misfit(sigmas: Array) -> Array:
        return np.concatenate([weight * _left(sigmas, measured, *few), sigmas])

    solution = least_squares(misfit, np.zeros(len(FREE)), bounds=(-MOST_SIGMA, MOST_SIGMA), x_scale="jac")
    residual_mm = _left(solution.x, measured, motor_turns, load_n, displacement_mm)
    return Calibrated(dict(zip(FREE, solution.x.tolist(), strict=True)), residual_mm)
