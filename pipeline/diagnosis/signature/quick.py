"""What of a mismatch is quick: how rough it is on each way and at rest, what comes once a turn, what starts shake."""

import numpy as np
from scipy.ndimage import gaussian_filter1d

from .mismatch import Mismatch, follows, mean

FEW = 10  # samples of a phase, at least
SHAKE, RIPPLE = 8, 12  # times the width of what is quick: what a start shakes, and a ripple, are quicker
MOST = 3.0  # times the size of the mismatch: the largest step between two samples counts as no more


def roughness(mismatch: Mismatch) -> dict[str, float]:
    """By how much the differences of neighbours exceed those of the noise: winding, unwinding, resting; the largest."""
    steps = np.diff(mismatch.raw)
    sign_by_name = {}
    for name, way in (("winding", 1), ("unwinding", -1), ("resting", 0)):
        both = (mismatch.way[1:] == way) & (mismatch.way[:-1] == way)
        enough = np.count_nonzero(both) > FEW
        sign_by_name[f"rough_{name}"] = float(np.std(steps[both])) - np.sqrt(2.0) * mismatch.noise if enough else 0.0
    return sign_by_name | {"rough_most": min(float(np.max(np.abs(np.diff(mismatch.smooth)))), MOST)}


def ripples(mismatch: Mismatch) -> dict[str, float]:
    """The size of what comes half a time, once and twice a turn of the motor while it moves."""
    moving = mismatch.way != 0
    quick = mismatch.quicker_than(RIPPLE)[moving]
    turned = mismatch.motion[moving]
    return {
        f"ripple_{per_turn:g}": 2.0 * abs(complex(mean(quick * np.cos(2 * np.pi * per_turn * turned)),
                                                 mean(quick * np.sin(2 * np.pi * per_turn * turned))))
        for per_turn in (0.5, 1.0, 2.0)
    }  # fmt: skip


def shakes(mismatch: Mismatch) -> dict[str, float]:
    """How far what is quick moves with the acceleration of the motor."""
    quick = mismatch.quicker_than(SHAKE)
    acceleration = np.gradient(gaussian_filter1d(mismatch.speed * mismatch.way, 1.0))
    return {"shaken": follows(quick, acceleration, np.ones(len(quick), bool))}
