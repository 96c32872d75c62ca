"""How stamps were mended when a recording was held whole: what mending in pieces is compared with."""

import numpy as np

from pipeline.wire.stamps import LEAP, mend_one, no_clock


def mend(time_us, numbers):
    """Stamps in us that rise strictly, and how often each rule was needed; all (samples,)."""
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
            mend_one(steps, expected, at)
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
