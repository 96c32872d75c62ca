"""A mismatch → its signature: numbers by name that a person can check in a plot of the mismatch."""

import numpy as np

from ..fit.problem import Problem, State
from .by_course import rests, strokes, time
from .by_load_and_speed import load_steps, loads, loops
from .by_place import profile, reversals, spread
from .mismatch import Mismatch, mismatch
from .quick import ripples, roughness, shakes

PARTS = (profile, reversals, spread, time, strokes, rests, loads, loops, load_steps, roughness, ripples, shakes)
MOST = 12.0  # largest value of a signature's number


def signature(of: Mismatch) -> dict[str, float]:
    """All numbers of a mismatch by name, each a share or in units of the mismatch's own size."""
    values = {name: value for part in PARTS for name, value in part(of).items()}
    return {
        name: float(np.clip(np.nan_to_num(value, posinf=0.0, neginf=0.0), -MOST, MOST))
        for name, value in values.items()
    }


def signature_of(problem: Problem, base: State) -> dict[str, float]:
    """The signature of the residual of a calibrated simulator on a recording."""
    return signature(mismatch(problem, base))
