"""32-bit counters that wrap, used for stamps and numbers: the steps from one value to another."""

import numpy as np
from numpy.typing import NDArray

Whole = NDArray[np.int64]


def steps_of(stamps: NDArray[np.uint32], first: int) -> Whole:
    """Steps from each stamp of a wrapping 32-bit counter to the next, the first one's from `first`; (stamps,).

    Shape (stamps,), in the counter's unit.
    """
    steps = np.diff(stamps, prepend=np.uint32(first % 2**32)).astype(np.uint32)
    return steps.view(np.int32).astype(np.int64)


def from_one(stamps: NDArray[np.uint32], stamp: int) -> Whole:
    """Steps from one stamp of a wrapping 32-bit counter to each of others; (stamps,).

    Shape (stamps,), in the counter's units.
    """
    return (stamps - np.uint32(stamp % 2**32)).view(np.int32).astype(np.int64)
