"""A law of this hand: where it acts, what is drawn for it, and which of its parameters says how strong it is."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig.authors.lattice.world import World

Array = NDArray[np.float64]
Params = dict[str, Any]
Rng = np.random.Generator

# Where a law acts, in the order in which the rig passes a motion on. What each stage hands to its laws:
# twist: turns of the string; radius: share of the base radius; contraction: mm from the geometry;
# length: mm after the string has stretched; reading: mm that the sensor shows.
STAGES = ("twist", "radius", "contraction", "length", "reading")


@dataclass(frozen=True)
class Law:
    """One law of one effect: `act` takes a stage's values on the fine clock and gives them back changed.

    `strength` names the parameter that is searched for, from nearly 0 up to `limit`, the most a bench would show.
    """

    effect: str
    name: str
    stage: str
    strength: str
    limit: float
    draw: Callable[[Rng, World], Params]
    act: Callable[[World, Array, Params], Array]


def log_uniform(rng: Rng, low: float, high: float) -> float:
    """A number between two positive ones, every octave as likely as the next."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def nothing(_rng: Rng, _world: World) -> Params:
    """A law without parameters besides its strength."""
    return {}
