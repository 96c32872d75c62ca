"""From the motor to the reading: each effect acts at the stage where physics has it."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Part

Sized = tuple[Part, float]


def reading(bench: Bench, parts: Sequence[Sized]) -> Array:
    """What an ideal instrument of scale 1 would read with these effects, in mm."""
    turns = _through("twist", parts, bench.turns)
    factor = _through("radius", parts, np.ones_like(turns))
    geometry = replace(bench.geometry, radius_mm=bench.geometry.radius_mm * factor)
    contraction = geometry.contraction_mm(turns, bench.load_n)
    return _through("reading", parts, _through("length", parts, contraction))


def _through(stage: str, parts: Sequence[Sized], signal: Array) -> Array:
    for part, size in parts:
        if part.stage == stage:
            signal = part.act(size, signal)
    return signal
