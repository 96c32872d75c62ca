"""The quick part of a mismatch: its roughness on each way and at rest, ripples per turn, and shaking after starts."""

import numpy as np
from scipy.ndimage import gaussian_filter1d

from .mismatch import Mismatch, follows, mean

FEW = 10  # samples of a phase, at least
SHAKE, RIPPLE = 8, 12  # times the width of a quick change: changes within it count as shakes of a start, and as ripples
MOST = 3.0  # times the size of the mismatch: the largest step between two samples counts as no more


def roughness(mismatch: Mismatch) -> dict[str, float]:
    """By how much neighbouring samples differ beyond the noise: while winding, unwinding and resting; and at most."""
    steps = np.diff(mismatch.raw)
    sign_by_name = {}
    for name, way in (("winding", 1), ("unwinding", -1), ("resting", 0)):
        both = (mismatch.way[1:] == way) & (mismatch.way[:-1] == way)
        enough = np.count_nonzero(both) > FEW
        sign_by_name[f"rough_{name}"] = float(np.std(steps[both])) - np.sqrt(2.0) * mismatch.noise if enough else 0.0
    return sign_by_name | {"rough_most": min(float(np.max(np.abs(np.diff(mismatch.smooth)))), MOST)}


def ripples(mismatch: Mismatch) -> dict[str, float]:
    """The size of ripples that repeat half a time, once and twice per turn of the motor while it moves."""
    moving = mismatch.way != 0
    quick = mismatch.quicker_than(RIPPLE)[moving]
    turned = mismatch.motion[moving]
    return {
        f"ripple_{per_turn:g}": 2.0 * abs(complex(mean(quick * np.cos(2 * np.pi * per_turn * turned)),
                                                 mean(quick * np.sin(2 * np.pi * per_turn * turned))))
        for per_turn in (0.5, 1.0, 2.0)
    }  # fmt: skip


def shakes(mismatch: Mismatch) -> dict[str, float]:
    """How far the quick part moves with the acceleration of the motor."""
    quick = mismatch.quicker_than(SHAKE)
    acceleration = np.gradient(gaussian_filter1d(mismatch.speed * mismatch.way, 1.0))
    return {"shaken": follows(quick, acceleration, np.ones(len(quick), bool))}
