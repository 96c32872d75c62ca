"""Where a planned motion accelerates harder than any recorded one, on a rig whose reading follows acceleration."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pandas as pd
from scipy.ndimage import uniform_filter1d

from ...ground.kinematics import Array
from ...ground.units import unit_of
from ...run.planned_motion.outside import Outside
from ...run.planned_motion.planned_limits import ROOM, up_to
from ...systems import System
from ..recording.working_samples import averaged, derivatives


def accelerated(system: System, samples: pd.DataFrame) -> Array:
    """The acceleration of a motion, averaged over a working period: shorter peaks are noise.

    Shape (samples,), in the motion's unit per second squared, of both signs alike.
    """
    time_s, motion = samples["time_s"].to_numpy(float), samples[system.driver].to_numpy(float)
    own = derivatives(time_s, motion, system.working_hz)[1]
    return np.abs(uniform_filter1d(own, averaged(system, samples), mode="nearest"))


def with_harder(beyond: Outside, system: System, plan: pd.DataFrame, recorded: Sequence[pd.DataFrame]) -> Outside:
    """A plan's rows outside the recorded range, and those that accelerate harder than any recorded row."""
    if not system.differentiates:
        return beyond
    planned, hardest = accelerated(system, plan), max(float(accelerated(system, table).max()) for table in recorded)
    limit, unit = (1.0 + ROOM) * hardest, f"{unit_of(system.driver)}/s²"
    rows = planned > limit
    if not rows.any():
        return beyond
    why = f"the hardest that was recorded, {hardest:.3g}, and {100.0 * ROOM:.0f} %"
    asks = (
        f"accelerations of up to {float(planned.max()):.3g} {unit} (inside up to {up_to(limit)}: {why}). A corner of a "
        "motion is such a jump of its speed"
    )
    mend = f"round the corners, so that nothing accelerates by more than {up_to(limit)} {unit}"
    return replace(beyond, rows=beyond.rows | rows, asks=[*beyond.asks, asks], mends=[*beyond.mends, mend])
