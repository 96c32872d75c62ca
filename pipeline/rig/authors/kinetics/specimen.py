"""The string and the rig of a seed: as they are, and as somebody measured them."""

from dataclasses import dataclass

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, TOLERANCE, Geometry
from pipeline.rig.authors.interface import StringContent

MATERIALS = {"UHMWPE": (25.0, 60.0), "Vectran": (30.0, 70.0), "Nylon": (3.0, 12.0), "Aramid": (25.0, 60.0)}


@dataclass(frozen=True)
class Specimen:
    """A string on its rig: the true geometry, what was written down of it, the errors of the two sensors."""

    geometry: Geometry
    string: StringContent
    rig: dict[str, float]
    top_turns: float
    load_n: float
    scale: float
    angle_zero_turns: float


def _missed(chance: np.random.Generator, sigma: float) -> float:
    return float(np.clip(chance.normal(0.0, sigma), -2.0 * sigma, 2.0 * sigma))


def specimen(chance: np.random.Generator) -> Specimen:
    """Draw a string, its rig, and the errors with which both were measured."""
    actuator = "twisted_pair" if chance.uniform() < 0.25 else "separator"
    material = str(chance.choice(list(MATERIALS)))
    radius_mm = float(chance.uniform(0.3, 0.75))
    length_mm = float(chance.uniform(220.0, 450.0))
    stiffness = float(chance.uniform(*MATERIALS[material]))
    zone_mm = float(chance.uniform(100.0, 0.55 * length_mm))
    separator_mm = float(chance.uniform(4.0, 13.0))
    if actuator == "twisted_pair":
        geometry = Geometry(actuator, radius_mm, length_mm, stiffness)
        top = length_mm * chance.uniform(0.35, 0.6) / radius_mm / RAD_PER_TURN
    else:
        geometry = Geometry(actuator, radius_mm, length_mm, stiffness, zone_mm, separator_mm)
        top = (zone_mm * chance.uniform(0.5, 0.85) - separator_mm) / radius_mm / RAD_PER_TURN
    written_radius = radius_mm * (1.0 + _missed(chance, TOLERANCE["radius"]))
    written_length = length_mm + _missed(chance, TOLERANCE["length_mm"])
    string: StringContent = {
        "material": material,
        "radius_mm": round(written_radius, 3),
        "length_mm": round(written_length, 1),
    }
    if chance.uniform() < 0.7:
        string["stiffness_n_per_mm"] = round(stiffness * (1.0 + 0.1 * _missed(chance, 1.0)), 1)
    rig = {}
    if actuator == "separator":
        rig["torsion_zone_mm"] = round(zone_mm + _missed(chance, TOLERANCE["torsion_zone_mm"]), 1)
        rig["separator_mm"] = round(separator_mm + _missed(chance, TOLERANCE["separator_mm"]), 2)
    load_n = float(chance.uniform(10.0, 40.0))
    return Specimen(geometry, string, rig, float(top), load_n, 1.0 + _missed(chance, 0.0025), _missed(chance, 0.025))
