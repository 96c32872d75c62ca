"""From the motion to the true reading: each effect at its stage, and when the logger takes its rows."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import Bench
from pipeline.rig.authors.kinetics.law import STAGES, Law, Parameters
from pipeline.rig.authors.kinetics.populations import wandering


@dataclass(frozen=True)
class Hidden:
    """One effect of one specimen: its id, its law, what was drawn for it, and how strong it is."""

    effect: str
    law: Law
    parameters: Parameters
    size: float = 0.0


def _changed(bench: Bench, now: Array, hidden: Hidden) -> Array:
    """The stage's value after an effect, whose strength wanders by a few per cent where it can."""
    change = hidden.law.change(bench, now, hidden.parameters, hidden.size)
    if hidden.law.still:
        return np.asarray(now + change)
    chance = np.random.default_rng(int(hidden.parameters["population"]) + 1)
    shaken = 1.0 + hidden.parameters["wander"] * wandering(chance, len(now), 90.0)
    if hidden.law.keeps:
        return np.asarray(now + np.cumsum(np.diff(change, prepend=0.0) * np.maximum(shaken, 0.0)))
    return np.asarray(now + change * shaken)


def displacement(bench: Bench, effects: Sequence[Hidden]) -> Array:
    """Displacement in mm over the bench's time with all the effects in it."""
    count = len(bench.turns)
    values = {"twist": bench.turns, "radius": np.ones(count), "elongation": np.zeros(count)}
    for stage in STAGES[:3]:
        for hidden in effects:
            if hidden.law.stage == stage:
                values[stage] = _changed(bench, values[stage], hidden)
    radius_mm = bench.geometry.radius_mm * np.maximum(values["radius"], 0.1)
    now = replace(bench.geometry, radius_mm=radius_mm).contraction_mm(values["twist"], bench.load_n)
    now = now - values["elongation"]
    for stage in STAGES[3:]:
        for hidden in effects:
            if hidden.law.stage == stage:
                now = _changed(bench, now, hidden)
    return now
