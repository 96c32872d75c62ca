"""What keeps a memory of where the motion turned: plays, relays, and curves after each reversal."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.curves import Curve


def heading(course: Array) -> Array:
    """Direction of a course at each sample, 1 or -1, kept while it stands still; 1 before it moves."""
    way = np.sign(np.where(np.abs(np.diff(course, prepend=course[0])) < 1e-9, 0.0, np.diff(course, prepend=course[0])))
    last = np.maximum.accumulate(np.where(way != 0.0, np.arange(len(way)), 0))
    kept = way[last]
    return np.where(kept == 0.0, 1.0, kept)


def play(course: Array, half_width: Array | float, start: float = 0.0) -> Array:
    """Follower of a course inside a gap of ± half a width; `start` is where in the gap it begins, -1 to 1."""
    halves = np.broadcast_to(np.asarray(half_width, float), course.shape).tolist()
    followed = course.tolist()
    at = followed[0] - start * halves[0]
    out = []
    for place, half in zip(followed, halves, strict=True):
        at = min(max(at, place - half), place + half)
        out.append(at)
    return np.array(out)


def ceiling_play(course: Array, gap: float) -> Array:
    """Follower that rises with a course at once and falls with it only after a gap."""
    at = float(course[0])
    out = []
    for place in course.tolist():
        at = min(max(at, place), place + gap)
        out.append(at)
    return np.array(out)


def relay(course: Array, up: float, down: float) -> Array:
    """A relay that goes to 1 at or above `up` and to 0 at or below `down`; it starts by its middle."""
    begun = 1 if course[0] > 0.5 * (up + down) else -1
    marks = np.where(course >= up, 1, np.where(course <= down, -1, 0))
    last = np.maximum.accumulate(np.where(marks != 0, np.arange(len(marks)), 0))
    return np.where(np.where(marks[last] == 0, begun, marks[last]) > 0, 1.0, 0.0)


def reversal_curves(course: Array, span: Array, approach: Curve) -> Array:
    """A loop between -1 and 1 that approaches the way's own branch along one curve after each reversal.

    `span` is how far after a reversal the branch is reached, per sample and read at the reversal. Standing still
    changes nothing. The loop starts at 0.
    """
    way = heading(course)
    turning = np.flatnonzero(np.diff(way) != 0.0) + 1
    starts = [0, *turning.tolist()]
    loop = np.zeros_like(course)
    held = 0.0
    for first, end in zip(starts, [*turning.tolist(), len(course)], strict=True):
        origin = course[max(first - 1, 0)]
        gone = approach(np.abs(course[first:end] - origin) / span[first])
        loop[first:end] = held + (way[first] - held) * gone
        held = float(loop[end - 1])
    return loop
