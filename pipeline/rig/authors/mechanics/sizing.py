"""How large an effect is once calibration has taken back what it can, and which strength makes it as large as asked."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from scipy.optimize import lsq_linear

from pipeline.kinematics import TOLERANCE, Array, Geometry
from pipeline.rig.authors.interface import OutOfReach

BOUND_SIGMA = 3.0
SCALE, ANGLE_TURNS = 0.005, 0.05
POINTS = 3000
NEAR, TRIES = 0.03, 16
FIRST_OF_MOST = 10.0  # how far below the largest strength the first try is


class Calibration:
    """What a bounded recalibration can take back: the reading's change by each parameter's one sigma, linearised."""

    def __init__(self, geometry: Geometry, turns: Array, load_n: Array) -> None:
        self.rows = np.unique(np.linspace(0, len(turns) - 1, POINTS).astype(int))
        turns, load_n = turns[self.rows], load_n[self.rows]
        usual = geometry.contraction_mm(turns, load_n)
        moved = {
            "radius_mm": TOLERANCE["radius"] * geometry.radius_mm,
            "length_mm": TOLERANCE["length_mm"],
            "torsion_zone_mm": TOLERANCE["torsion_zone_mm"],
            "separator_mm": TOLERANCE["separator_mm"],
        }
        columns = [SCALE * (usual - usual[0]), ANGLE_TURNS * geometry.slope_mm_per_turn(turns, load_n)]
        for name, sigma in moved.items():
            value = getattr(geometry, name)
            if np.isnan(value):
                continue
            up, down = (replace(geometry, **{name: value + sign * sigma}) for sign in (0.5, -0.5))
            columns.append(up.contraction_mm(turns, load_n) - down.contraction_mm(turns, load_n))
        shapes = np.column_stack(columns)
        self.shapes = shapes - shapes.mean(axis=0)

    def left_mm(self, effect_mm: Array) -> float:
        """Rms of what is left of an effect after recalibration and a free zero, in mm."""
        effect = effect_mm[self.rows] - effect_mm[self.rows].mean()
        fit = lsq_linear(self.shapes, effect, (-BOUND_SIGMA, BOUND_SIGMA), method="bvls")
        return float(np.sqrt(np.mean(np.square(effect - self.shapes @ fit.x))))


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
        found = size(float(np.exp(at)))
        if abs(found / wanted - 1.0) < NEAR:
            return float(np.exp(at)), found
        if at == (most if found < wanted else least):
            break
        low, high = (at, high) if found < wanted else (low, at)
        tried.append((at, float(np.log(max(found, 1e-9)))))
        at = min(max(_next(tried, float(np.log(wanted))), low), high)
        if at in [place for place, _ in tried]:
            at = 0.5 * (low + high)
    raise OutOfReach(f"{wanted:g} noise floors are not reached between {bounds[0]:.3g} and {bounds[1]:.3g}")


def _next(tried: list[tuple[float, float]], wanted: float) -> float:
    """Where the line of the last two tries comes to what is wanted, or a line of slope 1 from the only one."""
    (at, found), slope = tried[-1], 1.0
    if len(tried) > 1:
        slope = (found - tried[-2][1]) / (at - tried[-2][0])
    return at + (wanted - found) / min(max(slope, 0.3), 6.0)
