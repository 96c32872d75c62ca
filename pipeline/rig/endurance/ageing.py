"""The ageing of a string: the parameters of all its changing effects, from the number of strokes it shall last."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import effects
from ..campaign.specimen import Specimen
from ..concealed import Parameters, numbers
from ..effect import Effect
from ..motion_commands import Strokes
from ..wandering_strength import Waves
from . import x_fatigue, x_galling

LOST_RADIUS = 0.06  # share with which about a tenth of the stroke is lost
LOST_FIBRES = 1.0 - (1.0 - LOST_RADIUS) ** 2  # share with which the radius loses that, when it goes with their root
SPARED_STROKES = 600.0  # in which a string that saturates wears as little as drawn


@dataclass(frozen=True)
class Work:
    """The work of one stroke on the string, by the analytic model."""

    way_mm: float  # of strand on strand, there and back
    contact_n_mm: float  # F sin α dx of the winding
    held_s: float  # sin α dt of the stroke

    @staticmethod
    def of(specimen: Specimen, stroke: Strokes) -> "Work":
        turns = np.linspace(0.0, stroke.top_turns, 200)
        contraction_mm = specimen.true.contraction_mm(turns, stroke.load_n)
        zone_mm = specimen.true.torsion_zone_mm
        sine = np.sqrt(1.0 - (zone_mm / (zone_mm + contraction_mm)) ** 2)
        work_n_mm = stroke.load_n * float(np.trapezoid(sine, contraction_mm))
        turning_s = 2.0 * stroke.top_turns / stroke.speed_turns_per_s
        held_s = float(sine.mean() * turning_s + sine[-1] * stroke.hold_s + sine[0] * stroke.rest_s)
        return Work(2.0 * float(contraction_mm[-1] - contraction_mm[0]), work_n_mm, held_s)


def ageing(
    life: str, strokes: float, work: Work, specimen: Specimen, rng: np.random.Generator
) -> dict[str, Parameters]:
    """Parameters of all effects of a string that `saturates`, or that `wears` or `breaks` in so many strokes."""
    uniform = lambda low, high: float(rng.uniform(low, high))  # noqa: E731
    way_m, load_n = work.way_mm / 1e3, specimen.load_n
    # two more populations, which yield over tens and hundreds of strokes
    plastic, slow = specimen.effects["plastic_elongation"], rng.uniform(0.1, 0.4, 2) * uniform(0.5, 1.5)
    stretched_mm = numbers(plastic, "stretch_mm")
    stretch_mm = [*stretched_mm, *(slow * sum(stretched_mm))]
    slow_n_mm = work.contact_n_mm * np.array([uniform(15.0, 40.0), uniform(80.0, 300.0)])
    worn = {"saturates": uniform(0.05, 0.25), "wears": uniform(0.8, 1.0), "breaks": uniform(0.05, 0.25)}[life]
    lasts = SPARED_STROKES if life == "saturates" else strokes
    first_m = way_m * uniform(5.0, 30.0)
    edge = uniform(0.3, 2.0)
    fresh_m = edge * first_m * np.log1p(lasts * way_m / first_m)  # of way more, that the asperities count for
    aged: dict[str, Parameters] = {
        "radius_compaction": specimen.effects["radius_compaction"] | {"unsteady": _wander(work, rng)},
        "plastic_elongation": {"stretch_mm": stretch_mm, "work_n_mm": [*numbers(plastic, "work_n_mm"), *slow_n_mm]},
        "creep": specimen.effects["creep"],
        "stiffening": {
            "compliance_mm_per_n": uniform(0.005, 0.03),
            "gain": uniform(0.2, 0.5),
            "work_n_mm": load_n * work.way_mm * uniform(10.0, 80.0),
            "order": uniform(2.0, 3.0),
        },
        "wear": {
            "share_per_m": worn * LOST_RADIUS / (lasts * way_m + fresh_m),
            "edge": edge,
            "first_m": first_m,
            "press": 0.0,  # the load is in the strokes already
        },
        "x_galling": specimen.effects["friction_hysteresis"]
        | {"gain": uniform(0.2, 2.0), "rough_turns": 2.0 * specimen.top_turns * uniform(40.0, 400.0)},
    }
    if life == "breaks":
        sharing, holding_share = uniform(3.0, 12.0), uniform(0.05, 0.5)
        lives = strokes / (1.0 - (1.0 - LOST_FIBRES) ** sharing)
        aged["x_fatigue"] = {
            "work_n_mm": lives * work.contact_n_mm / (1.0 - holding_share),
            "held_s": lives * work.held_s / holding_share,
            "sharing": sharing,
            "thinning": uniform(0.8, 1.0),
            "shares": rng.uniform(0.05, 0.3, 2).tolist(),
            "periods": [uniform(0.05, 0.15), uniform(0.2, 0.6)],
            "phases_rad": rng.uniform(0.0, 2.0 * np.pi, 2).tolist(),
        }
    return aged


def _wander(work: Work, rng: np.random.Generator) -> Waves:
    """The air's, over minutes and hours; so the stroke is no straight reading of the age."""
    periods_s = np.exp(rng.uniform(np.log(120.0), np.log(3000.0), 2))
    shares, phases = rng.uniform(0.003, 0.015, 2), rng.uniform(0.0, 2.0 * np.pi, 2)
    return {"shares": shares.tolist(), "periods_s": periods_s.tolist(), "phases_rad": phases.tolist()}


def made(aged: dict[str, Parameters]) -> tuple[list[Effect], x_fatigue.Model | None]:
    """Fresh effects with these parameters, and the bundle of fibres among them if there is one."""
    own = {name: parameters for name, parameters in aged.items() if name in effects.names()}
    own_effects = [effects.make(*effect) for effect in own.items()]
    galling: dict[str, Any] = {**aged["x_galling"]}
    own_effects.append(x_galling.Model(**galling))
    if "x_fatigue" not in aged:
        return own_effects, None
    fatigue: dict[str, Any] = {**aged["x_fatigue"]}
    bundle = x_fatigue.Model(**fatigue)
    return [*own_effects, bundle, x_fatigue.Stretch(bundle)], bundle
