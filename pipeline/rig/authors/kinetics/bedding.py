"""Bedding-in of the string with work: lengthening that stays, and fibres that begin to carry."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.law import Law, Parameters
from pipeline.rig.authors.kinetics.populations import lognormal, turned_over

# --- plastic elongation


def eyring_sites(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Sites with distributed barriers yield with work, the sooner the more a strand is stressed."""
    exposure = np.diff(bench.worked, prepend=0.0) * np.exp(p["stress"] * (bench.tension - 1.0))
    return np.asarray(size * turned_over(np.cumsum(exposure), 1.0 / lognormal(16, p["strokes"], p["spread"])))


def avrami(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The bedded share grows by Avrami's law of nucleation and growth over the worked strokes."""
    return np.asarray(-size * np.expm1(-((bench.worked / p["strokes"]) ** p["exponent"])))


def tired_fibres(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Bonds give at the greatest tension so far; work tires them, and their strengths are Weibull's."""
    tired = np.maximum.accumulate(bench.tension * (1.0 + bench.worked) ** p["tiring"])
    given = -np.expm1(-((tired / p["strength"]) ** p["shape"]))
    return np.asarray(size * (given - given[0]))


def granular(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Braid settles as tapped grains do: slower than exponentially, by the inverse of a logarithm."""
    return np.asarray(size * (1.0 - 1.0 / (1.0 + p["slow"] * np.log1p(bench.worked / p["strokes"]))))


# --- stiffening


def _shorter(bench: Bench, share: Array, size: float) -> Array:
    """What a string whose stiffness grew by `size` times `share` is shorter by under its load."""
    stretch_mm = bench.load_n / bench.geometry.stiffness_n_per_mm
    return np.asarray(stretch_mm / (1.0 + size * share) - stretch_mm)


def recruited_fibres(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Idle fibres begin to carry with work, each at its own number of strokes."""
    return _shorter(bench, turned_over(bench.worked, 1.0 / lognormal(16, p["strokes"], p["spread"])), size)


def bonds_under_load(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Bonds between fibres form in time under load, over a wide spread of times."""
    pressed_s = np.cumsum(bench.load) * STEP_S
    return _shorter(bench, turned_over(pressed_s, 1.0 / lognormal(16, p["time_s"], p["spread"])), size)


def packed_braid(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The braid packs under cycling and carries more, by the inverse of a logarithm."""
    return _shorter(bench, 1.0 - 1.0 / (1.0 + p["slow"] * np.log1p(bench.worked / p["strokes"])), size)


PLASTIC = (
    Law(
        "eyring_sites",
        "elongation",
        8.0,
        eyring_sites,
        {"stress": (0.3, 1.2), "strokes": (1.0, 6.0), "spread": (0.8, 2.0)},
        keeps=True,
    ),
    Law("avrami", "elongation", 8.0, avrami, {"strokes": (1.5, 5.0), "exponent": (0.55, 0.95)}, keeps=True),
    Law(
        "tired_fibres",
        "elongation",
        8.0,
        tired_fibres,
        {"tiring": (0.15, 0.35), "strength": (1.8, 3.0), "shape": (2.0, 4.0)},
        keeps=True,
    ),
    Law("granular", "elongation", 12.0, granular, {"slow": (0.4, 1.5), "strokes": (0.2, 1.0)}, keeps=True),
)
STIFFENING = (
    Law("recruited_fibres", "elongation", 4.0, recruited_fibres, {"strokes": (1.0, 4.0), "spread": (0.4, 1.2)}),
    Law("bonds_under_load", "elongation", 4.0, bonds_under_load, {"time_s": (40.0, 150.0), "spread": (0.5, 1.5)}),
    Law("packed_braid", "elongation", 8.0, packed_braid, {"slow": (0.5, 2.0), "strokes": (0.2, 1.0)}),
)
