"""Where a motion turns by more than a reversal; read once, piece by piece, whatever its length."""

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from ..ground.kinematics import Array

Indices = NDArray[np.intp]


def _extremes(pieces: Iterable[Array]) -> Iterator[tuple[int, float]]:
    """Places and values of the first sample, of every local extreme and of the last sample: only these can turn."""
    before, direction, at = np.zeros(0), 0.0, -1
    for piece in pieces:
        motion = np.concatenate([before, piece])
        if at < 0:
            yield 0, float(motion[0])
        begin = at + 1 - len(before)
        step = np.diff(motion)
        moving = np.flatnonzero(step)
        signs = np.sign(step[moving])
        turned = np.diff(signs, prepend=direction or signs[:1]) != 0
        extremes = moving[turned]
        yield from zip((begin + extremes).tolist(), motion[extremes].tolist(), strict=True)
        direction = float(signs[-1]) if len(signs) else direction
        at, before = at + len(piece), motion[-1:]
    yield at, float(before[0])


def turning_points(motion: Array | Iterable[Array], reversal: float) -> Indices:
    """Samples at which a motion turns by at least `reversal`, and its first and last sample; shape (points,).

    Motion and `reversal` in one unit; a motion of shape (samples,), or its pieces.
    """
    extremes = _extremes([motion] if isinstance(motion, np.ndarray) else motion)
    points: list[int] = []
    index, value = next(extremes)
    low, high, lowest, highest = index, index, value, value
    direction = 0  # of the leg under way: +1 up, -1 down, 0 not known yet
    for index, value in extremes:
        if direction >= 0 and value > highest:
            high, highest = index, value
        if direction <= 0 and value < lowest:
            low, lowest = index, value
        if direction >= 0 and highest - value >= reversal:
            points.append(high)
            direction, low, lowest = -1, index, value
        elif direction <= 0 and value - lowest >= reversal:
            points.append(low)
            direction, high, highest = 1, index, value
    if not points:
        return np.array([0, index])
    points[0] = 0  # what comes before the first point is less than a reversal: it belongs to the first leg
    return np.unique([*points, index])
