"""A mismatch under different loads and at different speeds: how far it moves with them, and how its loops change."""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from .mismatch import LOW, MIDDLE, TOP, Mismatch, follows

SLOW, FAST = 0.6, 0.75  # of the usual highest speed
APART = 0.1  # of the mean load: what is heavy or light
BEGINNING, ENDING = 0.35, 0.65  # of the duration
STEP, LEAST_STEP = 0.05, 0.1  # of the mean load: where it changes, and what counts as a change
ROUND, LATER = 5, 40  # samples around a change of the load, and after it
STANDS, RESTS = 0.05, 0.03  # of the range of motion: more motion at a change of the load, or after, tells nothing
FEW = 5  # samples of each way, at least, for a loop


def loads(mismatch: Mismatch) -> dict[str, float]:
    """How far the remainder moves with the load at the bottom, in the middle and at the top, and how loads differ."""
    remainder = mismatch.remainder
    parts = (("low", LOW), ("middle", MIDDLE), ("top", TOP))
    sign_by_name = {f"load_{name}": follows(remainder, mismatch.heavier, mismatch.within(part)) for name, part in parts}
    return sign_by_name | {"loads_differ": float(np.std(mismatch.heavier))}


def loops(mismatch: Mismatch) -> dict[str, float]:
    """By how much the loop in the middle of the range differs from the usual: by speed, load and time."""
    circumstances = {
        "slow": mismatch.speed < SLOW, "fast": mismatch.speed > FAST,
        "heavy": mismatch.heavier > APART, "light": mismatch.heavier < -APART,
        "beginning": mismatch.course < BEGINNING, "ending": mismatch.course > ENDING,
    }  # fmt: skip
    usual = _loop(mismatch, np.ones(len(mismatch.raw), bool)) or 0.0
    loop_by_name = {name: _loop(mismatch, where) for name, where in circumstances.items()}
    return {f"loop_{name}": 0.0 if loop is None else loop - usual for name, loop in loop_by_name.items()}


def _loop(mismatch: Mismatch, where: NDArray[np.bool_]) -> float | None:
    inside = where & mismatch.within(MIDDLE)
    winding, unwinding = (mismatch.smooth[inside & (mismatch.way == way)] for way in (1, -1))
    few = min(len(winding), len(unwinding)) <= FEW
    return None if few else float(np.mean(winding) - np.mean(unwinding))


def load_steps(mismatch: Mismatch) -> dict[str, float]:
    """How far the mismatch moves at a change of the load, and how far it goes on afterwards: medians."""
    changing = np.flatnonzero(np.abs(np.diff(gaussian_filter1d(mismatch.heavier, 1.0))) > STEP)
    at_once, later = [], []
    for group in np.split(changing, np.flatnonzero(np.diff(changing) > LATER // 2) + 1) if len(changing) else []:
        last = len(mismatch.raw) - 1
        before, after = max(int(group[0]) - ROUND, 0), min(int(group[-1]) + ROUND, last)
        on = min(after + LATER, last)
        step = float(mismatch.heavier[after] - mismatch.heavier[before])
        if abs(step) < LEAST_STEP or abs(mismatch.place[after] - mismatch.place[before]) > STANDS:
            continue
        stands = abs(mismatch.place[on] - mismatch.place[after]) < RESTS
        at_once.append((mismatch.smooth[after] - mismatch.smooth[before]) / step)
        later.append((mismatch.smooth[on] - mismatch.smooth[after]) / step if stands else 0.0)
    medians = [float(np.clip(np.median(values), -5.0, 5.0)) if values else 0.0 for values in (at_once, later)]
    return dict(zip(("load_step", "load_step_later"), medians, strict=True))
