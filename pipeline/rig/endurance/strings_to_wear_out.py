"""The strings that are worked until they fail, and how each ages; every string has random numbers of its own."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..campaign.specimen import Bands, Specimen, draw_specimen
from ..campaign.strings_to_record import material_of
from ..concealed import Parameters
from ..motion_commands import Strokes
from .ageing import Work, ageing

Life = Literal["saturates", "wears", "breaks"]
LIVES: dict[Life, float] = {"saturates": 0.22, "wears": 0.38, "breaks": 0.40}  # shares
MOST_STROKES = 600
GIVEN_UP = 0.2  # share of the recordings that somebody ends sooner, whatever the string does
BANDS = Bands(radius_mm=(0.40, 0.60), torsion_zone_mm=(100.0, 160.0), load_n=(12.0, 30.0), helix_tangent=(0.30, 0.45))
# Strokes in which a string under REFERENCE_MPA loses a tenth of its stroke, in proportion between materials as yarns
# abrade; they fall with the tension's power, and scatter among strings of one kind.
STROKES = {"UHMWPE": 260.0, "polyester": 190.0, "nylon": 170.0, "aramid": 110.0, "LCP": 280.0}
REFERENCE_MPA, BY_TENSION, SCATTER, FEWEST = 14.0, -0.8, 0.40, 50.0


@dataclass(frozen=True)
class Planned:
    """One string: its run's name, its ageing, its motion, and the latest end of the recording."""

    run: str
    life: Life
    specimen: Specimen
    stroke: Strokes
    strokes: int  # at most
    after: int  # strokes that are recorded once a quarter of the stroke is lost
    ageing: dict[str, Parameters]  # parameters, by the effect's name
    noise: np.random.Generator


def plan(seed: int, strings: int) -> Iterator[Planned]:
    """The strings one by one; more strings leave the first ones as they are."""
    for index in range(strings):
        material = material_of(seed, index)
        rng = np.random.default_rng([seed, index, MOST_STROKES])  # not those of the campaign's strings
        specimen = draw_specimen(material, rng, BANDS)
        life: Life = rng.choice(list(LIVES), p=list(LIVES.values()))
        stroke = Strokes(
            top_turns=specimen.top_turns,
            speed_turns_per_s=round(rng.uniform(4.0, 6.0), 2),
            speed_up_s=0.2,
            slow_down_s=0.2,
            hold_s=round(rng.uniform(0.5, 1.0), 1),
            rest_s=round(rng.uniform(1.0, 2.0), 1),
            load_n=specimen.load_n,
        )
        tension_mpa = specimen.load_n / (2.0 * np.pi * specimen.true.radius_mm**2)
        scatter = np.exp(SCATTER * rng.standard_normal())
        strokes = max(STROKES[material] * (tension_mpa / REFERENCE_MPA) ** BY_TENSION * scatter, FEWEST)
        ages = ageing(life, strokes, Work.of(specimen, stroke), specimen, rng)
        most = int(rng.integers(100, MOST_STROKES)) if rng.random() < GIVEN_UP else MOST_STROKES
        after, run = int(rng.integers(2, 9)), f"endurance-{index:03d}-{material.lower()}"
        yield Planned(run, life, specimen, stroke, most, after, ages, rng.spawn(1)[0])
