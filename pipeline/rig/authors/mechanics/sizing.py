"""How large an effect is once calibration has taken back what it can, and which strength makes it as large as asked."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from scipy.optimize import lsq_linear

from pipeline.ground.kinematics import TOLERANCE, Array, Geometry
from pipeline.rig.authors.interface import OutOfReach

BOUND_SIGMA = 3.0
SCALE, ANGLE_TURNS = 0.005, 0.05
POINTS, PASSES = 1500, 3
NEAR, TRIES = 0.03, 16
FIRST_OF_MOST = 10.0  # how far below the largest strength the first try is


class Calibration:
    """What a bounded recalibration of a string's dimensions, its scale and its angle can take back of an effect."""

    def __init__(self, geometry: Geometry, turns: Array, load_n: Array) -> None:
        self.rows = np.unique(np.linspace(0, len(turns) - 1, POINTS).astype(int))
        self.geometry, self.turns, self.load_n = geometry, turns[self.rows], load_n[self.rows]
        sigmas = {
            "radius_mm": TOLERANCE["radius"] * geometry.radius_mm,
            "length_mm": TOLERANCE["length_mm"],
            "torsion_zone_mm": TOLERANCE["torsion_zone_mm"],
            "separator_mm": TOLERANCE["separator_mm"],
        }
        self.sigmas = {name: sigma for name, sigma in sigmas.items() if not np.isnan(getattr(geometry, name))}
        self.usual = self._shown(np.zeros(len(self.sigmas) + 2))

    def _shown(self, moves: Array) -> Array:
        """The reading with scale, angle and dimensions moved by so many sigmas, its mean taken off, in mm."""
        moved = {
            name: getattr(self.geometry, name) + move * sigma
            for move, (name, sigma) in zip(moves[2:], self.sigmas.items(), strict=True)
        }
        shown = replace(self.geometry, **moved).contraction_mm(self.turns + ANGLE_TURNS * moves[1], self.load_n)
        shown = shown * (1.0 + SCALE * moves[0])
        return np.asarray(shown - shown.mean())

    def left_mm(self, effect_mm: Array) -> float:
        """Rms of what is left of an effect after recalibration and a free zero, in mm; by steps of Gauss and Newton."""
        wanted = self.usual + effect_mm[self.rows] - effect_mm[self.rows].mean()
        moves, step = np.zeros(len(self.sigmas) + 2), 0.1 * np.eye(len(self.sigmas) + 2)
        left = [float(np.std(wanted - self.usual))]
        for _ in range(PASSES):
            slopes = np.column_stack([(self._shown(moves + move) - self._shown(moves - move)) / 0.2 for move in step])
            bounds = (-BOUND_SIGMA - moves - 1e-9, BOUND_SIGMA - moves + 1e-9)
            moves = moves + lsq_linear(slopes, wanted - self._shown(moves), bounds, method="bvls").x
            left.append(float(np.std(wanted - self._shown(moves))))
        return min(left)


def strength_for(size: Callable[[float], float], wanted: float, bounds: tuple[float, float]) -> tuple[float, float]:
    """Strength at which `size` is as wanted, within NEAR, and the size there; raises OutOfReach beyond the bounds.

    Sizes grow with the strength. Each try goes along the line of the last two in logarithms; where that leaves what is
    still possible, to the bound, and once that was tried to the middle.
    """
    least, most = float(np.log(bounds[0])), float(np.log(bounds[1]))
    low, high = least, most
    at = max(most - np.log(FIRST_OF_MOST), 0.5 * (least + most))
    tried: list[tuple[float, float]] = []
    while len(tried) < TRIES:
        reached = size(float(np.exp(at)))
        if abs(reached / wanted - 1.0) < NEAR:
            return float(np.exp(at)), reached
        if at == (most if reached < wanted else least):
            break
        low, high = (at, high) if reached < wanted else (low, at)
        tried.append((at, float(np.log(max(reached, 1e-9)))))
        at = min(max(_next(tried, float(np.log(wanted))), low), high)
        if at in [place for place, _ in tried]:
            at = 0.5 * (low + high)
    raise OutOfReach(f"{wanted:g} noise floors are not reached between {bounds[0]:.3g} and {bounds[1]:.3g}")


def _next(tried: list[tuple[float, float]], wanted: float) -> float:
    """Where the line of the last two tries comes to what is wanted, or a line of slope 1 from the only one."""
    (at, reached), slope = tried[-1], 1.0
    if len(tried) > 1:
        slope = (reached - tried[-2][1]) / (at - tried[-2][0])
    return at + (wanted - reached) / min(max(slope, 0.3), 6.0)
