"""What a law is: where it acts, which parameters it draws, and what change it makes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import Bench

# twist in turns, radius as a share of the true one, elongation in mm, contraction in mm, reading in mm
Stage = Literal["twist", "radius", "elongation", "contraction", "reading"]
STAGES: tuple[Stage, ...] = ("twist", "radius", "elongation", "contraction", "reading")
Parameters = Mapping[str, float]
Change = Callable[[Bench, Array, Parameters, float], Array]


@dataclass(frozen=True)
class Law:
    """A mechanism in one form: `change` of the stage's value at a size, as an array over the bench's time.

    `ranges` are drawn log-uniformly, or uniformly where the low end is not above 0. `keeps` is for what never comes
    back: its increments wander and not its sum. `still` is for what cannot wander at all, such as a stop.
    """

    name: str
    stage: Stage
    largest: float
    change: Change
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    keeps: bool = False
    still: bool = False
    needs_air: bool = False

    def drawn(self, chance: np.random.Generator) -> dict[str, float]:
        """Parameters of one specimen; `population` seeds what is drawn element by element."""
        values: dict[str, float] = {}
        for name, (low, high) in self.ranges.items():
            place = chance.uniform()
            values[name] = float(low * (high / low) ** place if low > 0.0 else low + (high - low) * place)
        values["population"] = float(chance.integers(1, 2**31))
        values["wander"] = float(chance.uniform(0.01, 0.03))
        return values


def crowd(parameters: Parameters) -> np.random.Generator:
    """The generator of the elements of one population, the same at every call."""
    return np.random.default_rng(int(parameters["population"]))
