"""The strings of a campaign and their motions; every string has random numbers of its own."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from .. import effects
from ..motion_commands import Motion, Strokes
from .specimen import Specimen, draw_specimen, materials
from .specimen_samples import Recorded, recorded

RAMP_S = 0.3


@dataclass(frozen=True)
class Planned:
    """One string of a campaign: its run's name, the string, and its motion."""

    run: str
    specimen: Specimen
    motion: Motion
    noise: np.random.Generator

    def recorded(self, rate_hz: float) -> Recorded:
        """The recording; it can be made only once, since it draws from the noise."""
        own_effects = [effects.make(*effect) for effect in self.specimen.effects.items()]
        return recorded(self.specimen, own_effects, self.motion, rate_hz, self.noise)


def material_of(seed: int, index: int) -> str:
    """Material of a string: among each group of strings in a row, every material occurs once, in a drawn order."""
    names = list(materials())
    block, place = divmod(index, len(names))
    return names[np.random.default_rng([seed, block, len(names)]).permutation(len(names))[place]]


def plan(seed: int, strings: int, strokes: int) -> Iterator[Planned]:
    """The strings of a campaign one by one; more strings leave the first ones as they are."""
    for index in range(strings):
        material = material_of(seed, index)
        rng = np.random.default_rng([seed, index])
        specimen = draw_specimen(material, rng)
        motion = Motion(
            rest_s=5.0,
            strokes=[
                Strokes(
                    repeat=strokes,
                    top_turns=specimen.top_turns,
                    speed_turns_per_s=round(rng.uniform(1.0, 3.0), 2),
                    speed_up_s=RAMP_S,
                    slow_down_s=RAMP_S,
                    hold_s=round(rng.uniform(1.0, 3.0), 1),
                    rest_s=round(rng.uniform(3.0, 8.0), 1),
                    load_n=specimen.load_n,
                )
            ],
        )
        yield Planned(f"campaign-{index:03d}-{material.lower()}", specimen, motion, rng.spawn(1)[0])
