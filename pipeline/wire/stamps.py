"""A device's time stamps: the replacement of a wrong one, and the test for a clock that does not run at all."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BURST = 64  # samples; a clock that is wrong for longer was set anew
LEAP = 10.0  # usual steps: a first or last stamp that stands apart by more was not taken there
FEW, MOST = 0.1, 0.9  # of all steps: more that fall back, or that stand, and there is no clock


def no_clock(samples: int, backward: int, repeated: int) -> bool:
    """Whether more than `FEW` of the steps fall back, or more than `MOST` stand: then nothing can be mended."""
    steps = samples - 1
    return steps > 1 and (backward > FEW * steps or repeated > MOST * steps)


def mend_one(steps: Array, expected: Array, at: int) -> None:
    """Spread the steps around a standing or backward one evenly, over the fewest samples that rise in all.

    Both given are in us and have the shape (steps,).
    """
    positions = []
    ahead = np.cumsum(steps[at : at + BURST])
    behind = np.cumsum(steps[max(0, at + 1 - BURST) : at + 1][::-1])
    if (ahead > 0).any():  # the samples after it are wrong, until the clock is where it was
        positions.append((at, at + int(np.argmax(ahead > 0)) + 1))
    if (behind > 0).any():  # those before it were
        positions.append((at - int(np.argmax(behind > 0)), at + 1))
    ratios = [steps[slice(*where)].sum() / expected[slice(*where)].sum() for where in positions]
    good = [(abs(np.log(ratio)), *where) for ratio, where in zip(ratios, positions, strict=True) if ratio > 0.4]
    if not good:
        steps[at] = expected[at]
        return
    _, start, stop = min(good)
    total, share = steps[start:stop].sum(), expected[start:stop]
    if total > 3.0 * share.sum():  # a gap stays a gap
        steps[start : stop - 1] = share[:-1]
        steps[stop - 1] = total - share[:-1].sum()
    else:
        steps[start:stop] = total * share / share.sum()
