"""Where the load of a planned motion has fallen, and no recorded load ever fell: what falls then was never seen.

Under loads that only rise, what a load stretches and what a new highest load leaves for good look alike.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from ...run.planned_motion.outside import Outside
from ...run.planned_motion.planned_limits import ROOM, stands_still
from ...systems import System


def with_fallen_load(
    beyond: Outside,
    system: System,
    plan: pd.DataFrame,
    recorded: Sequence[pd.DataFrame],
    before: Sequence[pd.DataFrame],
) -> Outside:
    """A plan's rows outside the recorded range, and those under a load that fell further than any recorded one.

    `recorded` are the recordings in their order; `before`: those of them that the plan follows, none of a later run.
    """
    name = system.load
    if name is None or name not in plan or any(name not in table for table in recorded):
        return beyond
    loads, planned = np.concatenate([table[name].to_numpy(float) for table in recorded]), plan[name].to_numpy(float)
    least, most = float(loads.min()), float(loads.max())
    if stands_still(least, most):
        return beyond  # it says already that no other load was recorded
    fell_n = float(_fallen(loads).max())
    limit = fell_n + ROOM * (most - least)
    begins_n = max((float(table[name].max()) for table in before), default=-np.inf)
    rows = _fallen(planned, begins_n) > limit
    if not rows.any():
        return beyond
    low, high = float(planned[rows].min()), max(float(planned.max()), begins_n)
    fell = fell_n > ROOM * (most - least)
    recorded_fall = f"fell by {fell_n:.3g} at most" if fell else "only rose"
    asks = f"{name} that falls from {high:.4g} to {low:.4g} (what was recorded {recorded_fall})"
    if not before:
        mend = f"begin at the lowest {name} of the plan and let it rise only"
    elif begins_n < most - ROOM * (most - least):
        mend = f"let {name} rise only, from {begins_n:.4g}"
    else:  # the highest that was recorded: a load that rises is outside too
        mend = f"keep {name} {f'within {begins_n - fell_n:.4g} to' if fell else 'at'} {most:.4g}"
    mend += ", or record a low load after a high one and diagnose the runs together"
    return replace(beyond, rows=beyond.rows | rows, asks=[*beyond.asks, asks], mends=[*beyond.mends, mend])


def _fallen(loads: Array, before: float = -np.inf) -> Array:
    """How far each load lies below the highest so far, which began at `before`; both of shape (samples,), in N."""
    return np.asarray(np.maximum(np.maximum.accumulate(loads), before) - loads)
