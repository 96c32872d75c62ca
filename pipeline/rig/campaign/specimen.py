"""One string on its rig, drawn: its true dimensions, its run.yaml, and the effects of its material."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any, TypedDict

import numpy as np
import yaml
from numpy.typing import ArrayLike

from ...ground.kinematics import RAD_PER_TURN, Geometry
from ...run.run_yaml import RunYaml
from ..concealed import Parameters

SIGMA = {"radius": 0.015, "separator_mm": 0.2, "torsion_zone_mm": 0.5, "length_mm": 1.0}  # of how well it is measured
STIFFNESS_SIGMA = 0.05  # relative
SPREAD = 0.10  # log-normal, of each parameter among strings of one material
MOST_MPA = 60.0  # tension that nobody exceeds: thin strings get the lighter loads
REFERENCE_MM, REFERENCE_ZONE_MM, REFERENCE_N = 0.40, 150.0, 20.0  # the string that the materials are told of
STRAIN_BY_TENSION = 0.5  # exponent
Band = tuple[float, float]


class Plastic(TypedDict):
    """How much longer a string stays, in per cent of its zone, after which work in N mm; one number a population."""

    strain_percent: list[float]
    work_n_mm: list[float]


class Creep(TypedDict):
    """How a string creeps: its compliances in mm/N, and how long each takes, in s."""

    compliance_mm_per_n: list[float]
    tau_s: list[float]


class Material(TypedDict):
    """An entry of `materials.yaml`: the modulus, and the parameters of the effects by their names."""

    modulus_gpa: float
    radius_compaction: dict[str, float]
    plastic_elongation: Plastic
    friction_hysteresis: dict[str, float]
    creep: Creep


@dataclass(frozen=True)
class Bands:
    """The ranges from which the dimensions of strings and rigs are drawn, evenly."""

    radius_mm: Band = (0.25, 0.60)
    separator_mm: Band = (4.0, 12.0)
    torsion_zone_mm: Band = (100.0, 200.0)
    length_mm: Band = (300.0, 500.0)
    load_n: Band = (10.0, 40.0)
    helix_tangent: Band = (0.35, 0.60)  # of the helix angle at the top, by the measured dimensions


@dataclass(frozen=True)
class Specimen:
    """A string on its rig; dimensions in mm, the load in N, the top twist in turns."""

    material: str
    measured: Geometry
    true: Geometry
    load_n: float
    top_turns: float
    effects: dict[str, Parameters]  # parameters by the name of the rig's effect

    def described(self, run: str) -> RunYaml:
        """Content of the run.yaml: the measured dimensions, and their tolerances."""
        measured = self.measured
        return {
            "run": run,
            "actuator": "separator",
            "string": {
                "material": self.material,
                "radius_mm": measured.radius_mm,
                "length_mm": measured.length_mm,
                "stiffness_n_per_mm": measured.stiffness_n_per_mm,
            },
            "rig": {
                "torsion_zone_mm": measured.torsion_zone_mm,
                "separator_mm": measured.separator_mm,
                "load_n": self.load_n,
            },
            "tolerance": dict(SIGMA),
        }


@cache
def materials() -> dict[str, Material]:
    """The materials by name, as `materials.yaml` tells of them."""
    content: dict[str, Material] = yaml.safe_load(Path(__file__).with_name("materials.yaml").read_text("utf-8"))
    return content


def draw_specimen(material: str, rng: np.random.Generator, bands: Bands | None = None) -> Specimen:
    """A string of a material on a rig, its dimensions drawn from `bands`."""
    bands = bands or Bands()
    measured = Geometry(
        "separator",
        radius_mm=round(rng.uniform(*bands.radius_mm), 3),
        length_mm=round(rng.uniform(*bands.length_mm), 1),
        stiffness_n_per_mm=1.0,
        torsion_zone_mm=round(rng.uniform(*bands.torsion_zone_mm), 1),
        separator_mm=round(rng.uniform(*bands.separator_mm), 1),
    )
    lightest_n, heaviest_n = bands.load_n
    bearable_n = MOST_MPA * 2.0 * np.pi * measured.radius_mm**2
    load_n = round(rng.uniform(lightest_n, min(heaviest_n, bearable_n)), 1)
    opened_mm = rng.uniform(*bands.helix_tangent) * measured.torsion_zone_mm - measured.separator_mm
    top_turns = round(opened_mm / measured.radius_mm / RAD_PER_TURN, 1)
    properties = materials()[material]
    miss = dict(zip(SIGMA, rng.standard_normal(len(SIGMA)) * list(SIGMA.values()), strict=True))
    true = replace(
        measured,
        radius_mm=measured.radius_mm * (1.0 + miss["radius"]),
        length_mm=measured.length_mm + miss["length_mm"],
        torsion_zone_mm=measured.torsion_zone_mm + miss["torsion_zone_mm"],
        separator_mm=measured.separator_mm + miss["separator_mm"],
    )
    modulus_mpa = 1e3 * properties["modulus_gpa"] * _spread(1.0, rng)
    true = replace(true, stiffness_n_per_mm=float(modulus_mpa * np.pi * true.radius_mm**2 / true.length_mm))
    read = true.stiffness_n_per_mm * (1.0 + STIFFNESS_SIGMA * rng.standard_normal())
    measured = replace(measured, stiffness_n_per_mm=round(float(read), 2))
    return Specimen(material, measured, true, load_n, top_turns, _hidden(properties, true, load_n, rng))


def _hidden(properties: Material, true: Geometry, load_n: float, rng: np.random.Generator) -> dict[str, Parameters]:
    """A material's effects on a string of these dimensions, each string differing a little.

    Contact works the zone alone: what lengthens is in proportion to it, and what must be done to the volume in it.
    """
    wide, long = true.radius_mm / REFERENCE_MM, true.torsion_zone_mm / REFERENCE_ZONE_MM
    tension = load_n / REFERENCE_N / wide**2
    plastic, creep = properties["plastic_elongation"], properties["creep"]
    stretch_mm = 0.01 * true.torsion_zone_mm * tension**STRAIN_BY_TENSION * np.array(plastic["strain_percent"])
    hidden: dict[str, Mapping[str, ArrayLike]] = {
        "radius_compaction": properties["radius_compaction"],
        "plastic_elongation": {
            "stretch_mm": stretch_mm,
            "work_n_mm": np.array(plastic["work_n_mm"]) * wide**2 * long,
        },
        "friction_hysteresis": properties["friction_hysteresis"],
        "creep": {
            "compliance_mm_per_n": np.array(creep["compliance_mm_per_n"]) * long / wide**2,
            "tau_s": creep["tau_s"],
        },
    }
    return {name: {key: _spread(value, rng) for key, value in own.items()} for name, own in hidden.items()}


def _spread(value: ArrayLike, rng: np.random.Generator) -> Any:
    """A parameter of one string about its material's, number by number."""
    nominal = np.asarray(value, float)
    return (nominal * np.exp(SPREAD * rng.standard_normal(nominal.shape))).tolist()
