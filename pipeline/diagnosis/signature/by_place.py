"""A mismatch over the place in the stroke: its profile, the difference of both ways, its course after reversals."""

import numpy as np

from ...ground.kinematics import Array
from .mismatch import EDGES, Mismatch, mean

AFTER = (0.01, 0.03, 0.08, 0.2)  # of the range of motion, from where it turned round
SOON = 2000  # samples after a reversal that are looked at


def profile(mismatch: Mismatch) -> dict[str, float]:
    """The mean of both ways at each place, the loop between them, and how large profile and loop are."""
    bins, places = mismatch.bins, len(EDGES) + 1
    way_up, way_down = ([_mean_at(mismatch, bins == place, way) for place in range(places)] for way in (1, -1))
    winding = np.array([down if up is None else up for up, down in zip(way_up, way_down, strict=True)], float)
    unwinding = np.array([up if down is None else down for up, down in zip(way_up, way_down, strict=True)], float)
    winding, unwinding = np.nan_to_num(winding), np.nan_to_num(unwinding)
    middle, loop = 0.5 * (winding + unwinding), winding - unwinding
    middle = middle - np.mean(middle)
    return {
        **{f"middle_{place}": float(middle[place]) for place in range(places)},
        **{f"loop_{place}": float(loop[place]) for place in range(places)},
        "loop": float(np.mean(loop)),
        "loop_grows": float(np.mean(loop[6:9]) - np.mean(loop[1:4])),
        "middle_size": float(np.std(middle)),
        "loop_size": float(np.mean(np.abs(loop))),
        "remainder_size": float(np.std(mismatch.remainder)),
    }


def _mean_at(mismatch: Mismatch, where: Array, way: int) -> float | None:
    values = mismatch.smooth[where & (mismatch.way == way)]
    return float(np.mean(values)) if len(values) > 3 else None


def reversals(mismatch: Mismatch) -> dict[str, float]:
    """How far the mismatch has moved at given distances after a reversal, at the top and at the bottom: medians."""
    return {
        f"after_{end}_{share:g}": value
        for end, way in (("top", -1), ("bottom", 1))
        for share, value in zip(AFTER, _after(mismatch, way), strict=True)
    }


def _after(mismatch: Mismatch, way: int) -> list[float]:
    moving = np.flatnonzero(mismatch.way)
    ways = mismatch.way[moving]
    moved: list[list[float]] = [[] for _ in AFTER]
    for turn in np.flatnonzero((ways[1:] == way) & (ways[:-1] == -way)):
        last, ahead = moving[turn], moving[turn + 1 : turn + 1 + SOON]
        other = np.flatnonzero(mismatch.way[ahead] != way)
        ahead = ahead[: other[0]] if len(other) else ahead
        gone = np.abs(mismatch.place[ahead] - mismatch.place[ahead[0]])
        for share, values in zip(AFTER, moved, strict=True):
            beyond = np.flatnonzero(gone >= share)
            if len(beyond):
                values.append(float(mismatch.smooth[ahead[beyond[0]]] - mismatch.smooth[last]))
    return [float(np.median(values)) if values else 0.0 for values in moved]


def spread(mismatch: Mismatch) -> dict[str, float]:
    """The third and fourth moment of the mismatch, the latter as a logarithm."""
    cubed, fourth = mean(mismatch.raw**3), mean(mismatch.raw**4)
    return {"skew": float(np.clip(cubed, -6.0, 6.0)), "peaked": float(np.log(fourth + 1e-9))}
