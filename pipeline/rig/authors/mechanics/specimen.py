"""One string on its rig: what it truly measures, and what somebody measured on it."""

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, TOLERANCE, Geometry
from pipeline.rig.authors.interface import RunContent, StringContent

MODULI_MPA = {"UHMWPE": 11e3, "Vectran": 9.5e3, "nylon": 3.7e3, "polyester": 6e3}  # of a braided line, voids and all
SOFT = "nylon"


def drawn(draw: np.random.Generator) -> tuple[str, Geometry, float, float]:
    """Material, true geometry, twist that the strokes may reach in turns, and usual load in N."""
    material = str(draw.choice(list(MODULI_MPA)))
    radius_mm = float(draw.uniform(0.3, 0.6))
    if draw.random() < 0.25:
        length_mm = float(draw.uniform(220.0, 400.0))
        zone_mm = separator_mm = float("nan")
        top = length_mm * np.sin(draw.uniform(0.45, 0.65)) / (RAD_PER_TURN * radius_mm)
    else:
        zone_mm, separator_mm = float(draw.uniform(100.0, 190.0)), float(draw.uniform(4.0, 12.0))
        length_mm = zone_mm * float(draw.uniform(1.5, 2.6))
        top = (zone_mm * np.tan(draw.uniform(0.4, 0.65)) - separator_mm) / (RAD_PER_TURN * radius_mm)
    modulus_mpa = MODULI_MPA[material] * float(draw.uniform(0.85, 1.1))
    stiffness = float(modulus_mpa * np.pi * radius_mm**2 / length_mm)
    kind = "twisted_pair" if np.isnan(zone_mm) else "separator"
    geometry = Geometry(kind, radius_mm, length_mm, stiffness, zone_mm, separator_mm)
    return material, geometry, float(top), float(draw.uniform(9.0, 30.0))


def measured(material: str, geometry: Geometry, load_n: float | None, draw: np.random.Generator) -> RunContent:
    """What run.yaml says of the string and the rig: dimensions with errors of their tolerances, rounded as tools read.

    `load_n` is the weight in N where no channel tells the load.
    """

    def off(sigma: float) -> float:
        return float(np.clip(draw.normal(0.0, sigma), -2.5 * sigma, 2.5 * sigma))

    string: StringContent = {
        "material": material,
        "radius_mm": round(geometry.radius_mm * (1.0 + off(TOLERANCE["radius"])), 3),
        "length_mm": round(geometry.length_mm + off(TOLERANCE["length_mm"]), 1),
    }
    if draw.random() < 0.7 or material == SOFT:  # nobody leaves out what moves the radius by more than its tolerance
        string["stiffness_n_per_mm"] = round(geometry.stiffness_n_per_mm * (1.0 + off(0.05)), 2)
    rig = {}
    if geometry.actuator == "separator":
        rig["torsion_zone_mm"] = round(geometry.torsion_zone_mm + off(TOLERANCE["torsion_zone_mm"]), 1)
        rig["separator_mm"] = round(max(geometry.separator_mm + off(TOLERANCE["separator_mm"]), 1.0), 2)
    if load_n is not None:
        rig["load_n"] = round(load_n, 2)
    return {"actuator": geometry.actuator, "string": string, "rig": rig}
