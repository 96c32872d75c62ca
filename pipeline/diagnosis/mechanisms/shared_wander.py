"""What wanders in time without a law: half waves over what a fit sees, and afterwards it stays where it stood."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Nonlinear

MOST, FEWEST = 8.0, 2.0  # half waves: so many at most, and so many at least, or it is no wander


def wandering(drivers: Drivers, law: Nonlinear) -> list[Nonlinear]:
    """The law with a wander beside it; none where a fit sees too few strokes.

    It makes no more half waves than there are strokes. A faster one goes to and fro with the motion, and would follow
    whatever the strokes do.
    """
    most = min(MOST, float(drivers.seen_strokes))
    return [{**law, "half_waves": most}] if most >= FEWEST else []


def passed(drivers: Drivers, nonlinear: Nonlinear) -> Array:
    """How much of the time that a fit saw has passed; it ends at 1 where a wander is among the parameters.

    A law goes on. A wander has none to go on by: what was fitted to it leaps away beyond the last sample that was
    seen. Shape (samples,), in shares of that time.
    """
    share = drivers.elapsed_s / nonlinear["whole_s"]
    return np.minimum(share, 1.0) if "half_waves" in nonlinear else share


def half_waves(share: Array, nonlinear: Nonlinear, first: int) -> dict[int, Array]:
    """Cosines with `first` to `half_waves` half waves, by number; `share` is what `passed` gives.

    None where the parameters have no `half_waves`. Each of shape (samples,), without a unit; `share` in shares of 1.
    """
    last = int(nonlinear.get("half_waves", 0.0))
    return {count: np.cos(np.pi * count * np.clip(share, 0.0, 1.0)) for count in range(first, last + 1)}
