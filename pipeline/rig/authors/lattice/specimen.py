"""The string and the rig as they are, and as the operator measured them."""

from dataclasses import dataclass

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, TOLERANCE
from pipeline.rig.authors.interface import RunContent, StringContent
from pipeline.rig.authors.lattice.world import Dimensions

Rng = np.random.Generator
# materials and the stiffness of two strings of 300 mm, N/mm
MATERIALS = {"UHMWPE": (18.0, 45.0), "Vectran": (35.0, 60.0), "Kevlar": (25.0, 50.0), "nylon": (6.0, 10.0)}
FAR = 2.2  # sigmas beyond which nobody mismeasures


@dataclass(frozen=True)
class Specimen:
    """The true and the measured dimensions, the reach of the session, and the errors of scale and zero."""

    material: str
    true: Dimensions
    measured: Dimensions
    top_turns: float
    load_n: float
    gain: float  # share by which the sensor reads too much
    angle_zero_turns: float  # turns by which the encoder reads too little


def _error(rng: Rng, sigma: float) -> float:
    return float(sigma * np.clip(rng.normal(), -FAR, FAR))


def specimen(rng: Rng) -> Specimen:
    """Draw a string on its rig, and how well it was measured."""
    material = str(rng.choice(list(MATERIALS)))
    while True:
        zone_mm, separator_mm = rng.uniform(110.0, 240.0), rng.uniform(5.0, 14.0)
        top_turns, steepest = rng.uniform(14.0, 32.0), rng.uniform(0.36, 0.6)
        radius_mm = (steepest * zone_mm - separator_mm) / (RAD_PER_TURN * top_turns)
        if 0.25 < radius_mm < 0.75:
            break
    length_mm = zone_mm + rng.uniform(90.0, 260.0)
    stiffness = round(rng.uniform(*MATERIALS[material]) * 300.0 / length_mm, 1)  # from a tensile test: exact
    true = Dimensions(radius_mm, length_mm, stiffness, zone_mm, separator_mm)
    measured = Dimensions(
        round(radius_mm * (1.0 + _error(rng, TOLERANCE["radius"])), 3),
        round(length_mm + _error(rng, TOLERANCE["length_mm"]), 1),
        stiffness,
        round(zone_mm + _error(rng, TOLERANCE["torsion_zone_mm"]), 1),
        round(separator_mm + _error(rng, TOLERANCE["separator_mm"]), 1),
    )
    load_n = round(rng.uniform(9.0, 32.0), 1)
    return Specimen(material, true, measured, top_turns, load_n, _error(rng, 0.003), _error(rng, 0.025))


def run_yaml(drawn: Specimen, load_n: float | None) -> RunContent:
    """Content of run.yaml without `run`; the load stands in it where no channel measures it."""
    measured = drawn.measured
    string: StringContent = {
        "material": drawn.material,
        "radius_mm": measured.radius_mm,
        "length_mm": measured.length_mm,
        "stiffness_n_per_mm": measured.stiffness_n_per_mm,
    }
    rig = {"torsion_zone_mm": measured.torsion_zone_mm, "separator_mm": measured.separator_mm}
    return {"actuator": "separator", "string": string, "rig": rig if load_n is None else {**rig, "load_n": load_n}}
