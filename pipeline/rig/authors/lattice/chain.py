"""The order in which a motion passes through the rig: twist, radius, contraction, length, reading."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pipeline.rig.authors.lattice.law import STAGES, Law, Params
from pipeline.rig.authors.lattice.world import World

Array = NDArray[np.float64]


def reading_mm(world: World, hidden: Sequence[tuple[Law, Params]]) -> Array:
    """What an ideal sensor would read on the fine clock with the hidden laws at work, in mm; 0 at the start."""
    at = {stage: [(law, params) for law, params in hidden if law.stage == stage] for stage in STAGES}

    def passed(stage: str, values: Array) -> Array:
        for law, params in at[stage]:
            values = law.act(world, values, params)
        return values

    turns = passed("twist", world.turns)
    share = passed("radius", np.ones_like(turns))
    values = world.contraction_mm(turns, share)
    for stage in ("contraction", "length", "reading"):
        values = passed(stage, values)
    return values - values[0]
