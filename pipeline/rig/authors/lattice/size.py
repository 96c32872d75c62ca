"""How large an effect is: what bounded recalibration cannot take back of it, and the strength that makes it so."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from pipeline.ground.kinematics import TOLERANCE, Geometry
from pipeline.rig.authors.interface import OutOfReach
from pipeline.rig.authors.lattice.instruments import Sampling
from pipeline.rig.authors.lattice.session import Session

Array = NDArray[np.float64]
SIGMAS = 3.0
GAIN, ANGLE_ZERO_TURNS = 0.005, 0.05  # one sigma of the sensor's scale and of the encoder's zero
POINTS = 1200  # samples that the recalibration is fitted on
CLOSE = 0.015  # how near to the size that was asked the search stops
TRIES, PROPORTIONAL = 26, 6  # trials in all, and those that suppose an effect in proportion to its strength
FAR = 0.08  # how far from it no strength may be the best


class Ruler:
    """Measures what recalibration leaves of a reading, about the dimensions that the operator wrote down."""

    def __init__(self, session: Session, taken: Sampling) -> None:
        world, self.measured, self.gain = session.world, session.specimen.measured, session.specimen.gain
        self.fine_s, self.time_s = world.time_s, taken.time_s
        self.turns = np.interp(taken.time_s, world.time_s, world.turns) - session.specimen.angle_zero_turns
        self.load_n = np.interp(taken.time_s, world.time_s, world.load_n)
        self.some = np.unique(np.linspace(0, taken.time_s.size - 1, POINTS).astype(int))

    def model_mm(self, sigmas: Array, turns: Array, load_n: Array) -> Array:
        """The simulator's contraction for calibrations given in sigmas, in mm, on the sensor's scale."""
        to, radius, zone, separator, length, gain, zero = self.measured, *sigmas
        geometry = Geometry(
            "separator",
            to.radius_mm * (1.0 + TOLERANCE["radius"] * radius),
            to.length_mm + TOLERANCE["length_mm"] * length,
            to.stiffness_n_per_mm,
            to.torsion_zone_mm + TOLERANCE["torsion_zone_mm"] * zone,
            to.separator_mm + TOLERANCE["separator_mm"] * separator,
        )
        return (1.0 + GAIN * gain) * geometry.contraction_mm(turns + ANGLE_ZERO_TURNS * zero, load_n)

    def left_mm(self, reading_mm: Array) -> Array:
        """What the best calibration within bounds leaves of a reading on the fine clock, a value a sample, in mm."""
        sampled = (1.0 + self.gain) * np.interp(self.time_s, self.fine_s, reading_mm)
        shown, turns, load_n = sampled[self.some], self.turns[self.some], self.load_n[self.some]
        shown = shown - shown.mean()

        def misfit(sigmas: Array) -> Array:
            model = self.model_mm(sigmas, turns, load_n)
            return np.asarray(shown - (model - model.mean()))

        fit = least_squares(misfit, np.zeros(6), bounds=(-SIGMAS, SIGMAS), x_scale=1.0, max_nfev=30, ftol=1e-6)
        left = sampled - self.model_mm(fit.x, self.turns, self.load_n)
        return np.asarray(left - left.mean())

    def rms_mm(self, reading_mm: Array) -> float:
        """Root mean square of what the best calibration leaves, in mm."""
        return float(np.sqrt(np.mean(np.square(self.left_mm(reading_mm)))))


def strength_for(asked_mm: float, left_mm: Callable[[float], float], limit: float) -> float:
    """The least strength that leaves `asked_mm` after recalibration; OutOfReach when `limit` leaves less.

    Searched as if the effect grew with its strength, by bisection where it does not; where it jumps with its
    strength, the closest strength met is taken.
    """
    at_limit = left_mm(limit)
    if at_limit < asked_mm:
        raise OutOfReach(f"the strongest effect that a bench would show leaves less than {asked_mm:.3f} mm")
    low, high = np.log(limit * 1e-5), np.log(limit)
    guess, closest, best = high - np.log(at_limit / asked_mm), limit, at_limit / asked_mm - 1.0
    for step in range(TRIES):
        if best < CLOSE:
            break
        if step >= PROPORTIONAL or not low < guess < high:
            guess = 0.5 * (low + high)
        ratio = max(left_mm(float(np.exp(guess))) / asked_mm, 1e-9)
        if abs(ratio - 1.0) < best:
            closest, best = float(np.exp(guess)), abs(ratio - 1.0)
        low, high = (guess, high) if ratio < 1.0 else (low, guess)
        guess -= float(np.log(ratio))
    if best > FAR:
        raise OutOfReach(f"no strength leaves {asked_mm:.3f} mm")
    return closest
