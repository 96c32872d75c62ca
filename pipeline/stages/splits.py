"""Which points of a material are held out, and which are for training: evenly spaced over all that may be."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ..ground.kinematics import Mask

TRAINING_POINTS = 5000  # as in the paper
HELD_OUT_POINTS = 20000  # more tell no more, and cost the learned models minutes
MOST_BLOCKS = 80  # into which a stroke's winding, or unwinding, is cut
BLOCK_LEAST_SAMPLES = 10
HOLD_OUT = 4  # one block in so many
WHICH_OF_FOUR = np.array([0, 2, 1, 3])  # in the first group of four blocks, the second, …

Numbers = NDArray[np.int64]


def block_of(from_top: Numbers, samples: int) -> Numbers:
    """Block, counted from the top, of the samples of one winding at some places from its top.

    `from_top` counts from 0, and so does the answer; both of shape (samples,), as counts. The winding has so many
    samples.
    """
    count = min(max(samples // BLOCK_LEAST_SAMPLES, 1), MOST_BLOCKS)
    return from_top * count // max(samples, 1)


def blocks_from_top(samples: int) -> Numbers:
    """Block of each sample of one winding, from its top, in order of rising twist; shape (samples,), a count."""
    return block_of(np.arange(samples)[::-1], samples)


def held_out(block: Numbers, stroke: Numbers) -> Mask:
    """Whether a block of a stroke is held out in the split `within`; shape (points,), as masks.

    One block of every four, another one from group to group so that no part of the range is favoured, and shifted from
    stroke to stroke so that over four strokes every twist is held out once. Strokes 1, 5 and 9, which the tables show,
    hold out their very top.
    """
    first = WHICH_OF_FOUR[block // HOLD_OUT % len(WHICH_OF_FOUR)]
    return np.asarray(block % HOLD_OUT == (first + stroke - 1) % HOLD_OUT)


class Thinned:
    """At most that many of the points that may be chosen, evenly spaced; points come in pieces, in order."""

    def __init__(self, count: int, most: int) -> None:
        self.count = min(count, most)
        self._places = np.linspace(0, count - 1, most).round().astype(int) if count > most else None
        self._before = 0

    def chosen(self, may: Mask) -> Mask:
        """Which points of the next piece are chosen; shape (points,), as masks."""
        rows = np.flatnonzero(may)
        if self._places is not None:
            in_piece = self._places - self._before
            self._before += len(rows)
            rows = rows[in_piece[(in_piece >= 0) & (in_piece < len(rows))]]
        mask = np.zeros(len(may), bool)
        mask[rows] = True
        return mask


class Split:
    """Labels "train", "test" and "" of points in pieces; each piece says which are held out and which may be used."""

    def __init__(self, pieces: Iterable[tuple[Mask, Mask]]) -> None:
        """Count what there is; each piece is a mask of what is held out, and one of what may be used."""
        counts = np.array([(np.count_nonzero(may & ~test), np.count_nonzero(test)) for test, may in pieces])
        learnt, test_count = counts.sum(axis=0).tolist()
        self.train, self.test = Thinned(learnt, TRAINING_POINTS), Thinned(test_count, HELD_OUT_POINTS)

    def labels(self, test: Mask, may: Mask) -> NDArray[np.object_]:
        """The labels of the next piece, from its two masks; shape (points,), as labels."""
        labels = np.full(len(test), "", object)  # a pointer each: text side by side is as large as all channels
        labels[self.train.chosen(may & ~test)] = "train"
        labels[self.test.chosen(test)] = "test"
        return labels
