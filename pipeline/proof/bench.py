"""A rig and a string with their true dimensions, and the dimensions that somebody measured: drawn from a seed."""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..ground.kinematics import TOLERANCE, Geometry
from ..run.run_yaml import RunYaml, StringYaml

MATERIALS = {"UHMWPE": (12.0, 40.0), "Vectran": (20.0, 60.0), "aramid": (15.0, 50.0), "nylon": (3.0, 10.0)}  # K, N/mm
DIMENSION = {
    "radius": "radius_mm",
    "separator_mm": "separator_mm",
    "torsion_zone_mm": "torsion_zone_mm",
    "length_mm": "length_mm",
}  # the key of run.yaml's `tolerance`, and the dimension that it is of


@dataclass(frozen=True)
class Bench:
    """One string on one rig; `measured` and `true` differ by the errors of measuring."""

    material: str
    true: Geometry
    measured: Geometry
    loads_n: tuple[float, float, float]  # the middle one first
    top_turns: float
    scale: float = 1.0  # of the displacement sensor
    zero_mm: float = 0.0

    @property
    def stroke_mm(self) -> float:
        """What the string contracts from untwisted to wound up."""
        low, high = self.true.contraction_mm([0.0, self.top_turns], self.loads_n[0])
        return float(high - low)

    @property
    def torque_n_mm(self) -> float:
        """Torque of the string when it is wound up under the middle load."""
        open_mm = self.true.separator_mm + 2.0 * math.pi * self.top_turns * self.true.radius_mm
        return float(self.loads_n[0] * self.true.radius_mm * open_mm / math.hypot(self.true.torsion_zone_mm, open_mm))

    def errors(self) -> dict[str, float]:
        """Measured minus true values, in sigma of the tolerance; by the tolerance's key."""
        return {key: self._error(key) / _sigma(self.true, key) for key in DIMENSION}

    def _error(self, key: str) -> float:
        return float(getattr(self.measured, DIMENSION[key]) - getattr(self.true, DIMENSION[key]))

    def described(self, run: str, load: bool) -> RunYaml:
        """Content of run.yaml; with `load` the rig has no load cell, and run.yaml gives the middle load."""
        measured = self.measured
        rig = {"torsion_zone_mm": measured.torsion_zone_mm, "separator_mm": measured.separator_mm}
        string: StringYaml = {
            "material": self.material,
            "radius_mm": measured.radius_mm,
            "length_mm": measured.length_mm,
            "stiffness_n_per_mm": measured.stiffness_n_per_mm,
        }
        rig |= {"load_n": self.loads_n[0]} if load else {}
        return {"run": run, "actuator": "separator", "string": string, "rig": rig}


def _sigma(geometry: Geometry, key: str) -> float:
    return TOLERANCE[key] * (float(geometry.radius_mm) if key == "radius" else 1.0)


def draw_bench(rng: np.random.Generator) -> Bench:
    """A bench whose true dimensions equal the measured ones, to the resolution of a caliper."""
    material = str(rng.choice(list(MATERIALS)))
    geometry = Geometry(
        "separator",
        radius_mm=round(rng.uniform(0.3, 0.7), 3),
        length_mm=round(rng.uniform(250.0, 450.0), 0),
        stiffness_n_per_mm=round(rng.uniform(*MATERIALS[material]), 1),
        torsion_zone_mm=round(rng.uniform(110.0, 200.0), 1),
        separator_mm=round(rng.uniform(4.0, 14.0), 1),
    )
    steepest = rng.uniform(0.40, 0.70)  # tangent of the helix angle when wound up: well below where coils touch
    open_mm = steepest * geometry.torsion_zone_mm - geometry.separator_mm
    top_turns = round(open_mm / geometry.radius_mm / (2.0 * math.pi), 1)
    middle_n = round(rng.uniform(12.0, 25.0), 1)
    loads_n = (middle_n, round(middle_n * rng.uniform(0.45, 0.6), 1), round(middle_n * rng.uniform(1.6, 2.0), 1))
    return Bench(material, geometry, geometry, loads_n, top_turns)


def mismeasure(bench: Bench, rng: np.random.Generator, sigmas: tuple[float, float]) -> Bench:
    """The same measured values for a string and a rig whose true dimensions differ.

    Each error's size is drawn as a normal's between two numbers of sigma; the sensor's scale and zero are drawn
    as well. The true dimensions move, since the measured ones are round numbers.
    """
    true: dict[str, Any] = {}
    for key, name in DIMENSION.items():
        size = np.inf
        while not sigmas[0] <= size <= sigmas[1]:
            size = abs(rng.standard_normal()) + (sigmas[0] if sigmas[0] > 0 else 0.0)
        error = float(rng.choice([-1.0, 1.0])) * float(size) * _sigma(bench.measured, key)
        true[name] = getattr(bench.measured, name) + error
    true["separator_mm"] = max(true["separator_mm"], 1.0)
    stiffness = bench.measured.stiffness_n_per_mm * (1.0 + 0.03 * rng.standard_normal())
    return replace(
        bench,
        true=replace(bench.measured, stiffness_n_per_mm=float(stiffness), **true),
        scale=float(1.0 + 0.003 * rng.standard_normal()),
        zero_mm=float(rng.uniform(-2.0, 2.0)),
    )
