"""Where the motor stands: spans that are slower than a share of their leg's own speed, for long enough."""

from collections.abc import Iterator
from functools import partial
from itertools import pairwise

import numpy as np

from ..ground.kinematics import Array, Places
from ..ground.numbers import quantiles, spans
from ..ground.numbers.spans import Spans
from ..ground.numbers.unwound import PHASE_REVERSAL
from ..ground.stored import schemas
from .clean_motion import Motion

HOLD_SPEED = 0.10  # of the speed at which the motor does half its travel: slower is holding
HOLD_LEAST_S = 0.25


def _speeds(motion: Motion, parts: list[tuple[int, int]]) -> Iterator[Array]:
    return (motion.speed(*part) for part in parts)


def _slow(motion: Motion, legs: Places) -> Spans:
    """Where the motion is slower than a share of its leg's usual speed; where two legs meet, the second leg counts."""
    slow = []
    for first, last in pairwise(legs.tolist()):
        parts = spans.blocks(first, last + 1, schemas.ROW_GROUP)
        # samples are near enough equally spaced: speed weighs as travel does
        usual = quantiles.half_of_sum(partial(_speeds, motion, parts), last + 1 - first)
        for begin, stop in parts:
            mask = motion.speed(begin, stop) < HOLD_SPEED * usual
            end = stop if last == motion.length - 1 else min(stop, last)
            slow.append(spans.of_mask(mask[: end - begin], begin))
    return spans.joined(slow)


def _jitter(motion: Motion, slow: Spans, legs: Places, span: float) -> Spans:
    """Short moves between slow spans that are no motion, unless the leg consists of such steps and still gets ahead."""
    fast, size = spans.between(slow, motion.length), schemas.ROW_GROUP
    low = spans.reduced(motion.smooth, fast, size, np.minimum, np.inf)
    high = spans.reduced(motion.smooth, fast, size, np.maximum, -np.inf)
    small = np.minimum(fast[high - low < PHASE_REVERSAL * span / 2], motion.length - 1)
    small = spans.cut(small[small[:, 1] > small[:, 0]], legs)
    leg = np.searchsorted(legs, small[:, 0], side="right") - 1
    begin, end = (motion.smooth_at(small[:, side]) for side in (0, 1))
    stepped = np.bincount(leg, end - begin, len(legs) - 1)
    still = np.abs(stepped) < np.abs(np.diff(motion.smooth_at(legs))) / 2
    return small[still[leg]]


def stands(motion: Motion, legs: Places, span: float) -> Spans:
    """Spans of samples in which the motor stands; shape (spans, 2), as places.

    `legs` are the samples at which the motion turns, the first and the last too; `span` is its range.
    """
    slow = _slow(motion, legs)
    slow = spans.joined([slow, _jitter(motion, slow, legs, span)])
    begin_s, end_s = (motion.rows.at("time_s", places) for places in (slow[:, 0], slow[:, 1] - 1))
    return slow[end_s - begin_s >= HOLD_LEAST_S]
