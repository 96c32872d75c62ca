"""A device's time stamps, unwrapped, and mended where a few of them cannot be: the numbers say which sample is next."""

import numpy as np
from numpy.typing import NDArray

from .counters import Whole, steps_of

Array = NDArray[np.float64]

BURST = 64  # samples; a clock that is wrong for longer was set anew
LEAP = 10.0  # usual steps: a first or last stamp that stands apart by more was not taken there
FEW, MOST = 0.1, 0.9  # of all steps: more that fall back, or that stand, and there is no clock


def unwrap_us(t_us: NDArray[np.uint32], first_us: int) -> Whole:
    """Microseconds since `first_us` of a 32-bit clock that wraps every 71.6 min, for stamps < 35 min apart.

    Shape (stamps,), in us.
    """
    return np.cumsum(steps_of(t_us, first_us))


def no_clock(samples: int, backward: int, repeated: int) -> bool:
    """Whether the stamps of so many samples stand or fall back throughout, so that nothing can be mended."""
    steps = samples - 1
    return steps > 1 and (backward > FEW * steps or repeated > MOST * steps)


def mend(time_us: Whole, numbers: Whole) -> tuple[Array, dict[str, int]]:
    """Stamps in us that rise strictly, by the numbers of their frames, and how often each rule was needed.

    `backward_time_stamps`: stamps that fall back, or leap ahead and fall back to where they should be, are put between
    the neighbours that are right; where the clock falls back for good, what follows is moved to a usual step after
    the sample before. `repeated_time_stamps`: samples that share a stamp are spread up to the next.
    `leaping_time_stamps`: a first or last stamp that stands apart by ten usual steps. No sample is dropped. Where
    there is no clock at all the stamps stay as they are. Both given have the shape (samples,).
    """
    steps = np.diff(time_us).astype(np.float64)
    backward, repeated = int((steps < 0).sum()), int((steps == 0).sum())
    stamps = time_us.astype(np.float64)
    if len(steps) < 2 or not (steps > 0).any() or no_clock(len(stamps), backward, repeated):
        return stamps, {}
    apart = np.diff(numbers).astype(np.float64)
    apart[apart <= 2] = 1.0  # an EVENT between two samples takes a number and no time
    rising = steps > 0  # a clock that ticks at every fifth sample has steps five times too long
    usual_us = float(np.median(steps[rising] / apart[rising])) * rising.sum() / (rising.sum() + repeated)
    expected = usual_us * apart
    for at in np.flatnonzero(steps <= 0).tolist():
        if steps[at] <= 0:  # else it was mended with the one before
            _mend_one(steps, expected, at)
    leaping = 0
    for end in (0, -1) if len(steps) > 2 else ():
        if steps[end] > max(LEAP * expected[end], *np.delete(steps, end)):
            steps[end] = expected[end]
            leaping += 1
    counted = {
        "backward_time_stamps": backward,
        "repeated_time_stamps": repeated,
        "leaping_time_stamps": leaping,
    }
    mended = {rule: times for rule, times in counted.items() if times}
    return (stamps[0] + np.append(0.0, np.cumsum(steps)) if mended else stamps), mended


def _mend_one(steps: Array, expected: Array, at: int) -> None:
    """Spread the steps about one that stands or falls back, over the fewest samples that rise in all."""
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
