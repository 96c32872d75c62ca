"""The bundle's radius: voids that close under pressure, and strands that wear with travel."""

import numpy as np
from scipy.special import expit

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import Bench
from pipeline.rig.authors.kinetics.law import Law, Parameters, crowd
from pipeline.rig.authors.kinetics.populations import lognormal, turned_over

# --- compaction


def closing_voids(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Voids between fibres close at Weibull-distributed pressures, and open as the pressure goes."""
    return np.asarray(size * np.expm1(-((bench.squeeze / p["pressure"]) ** p["shape"])))


def van_wyk(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A random fibre mass bears pressure as a power of its density, so its radius falls as a small power of it."""
    return np.asarray(size * ((1.0 + bench.squeeze / p["grown"]) ** (-p["power"]) - 1.0))


def ordering(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Fibres fall into hexagonal order about a pressure, a cooperative change between two states."""
    where = np.log(bench.squeeze + 1e-3) - np.log(p["middle"])
    return np.asarray(-size * (expit(where / p["width"]) - expit((np.log(1e-3) - np.log(p["middle"])) / p["width"])))


# --- wear


def worn_summits(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Summits of distributed height run in first; what is below them wears on in proportion to travel."""
    ran_in = turned_over(bench.travel, 1.0 / lognormal(16, p["running_in"], p["spread"]))
    return np.asarray(-size * (p["share"] * ran_in + (1.0 - p["share"]) * bench.travel / bench.travel[-1]))


def broken_filaments(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Filaments drawn at random break at Weibull-distributed travels; the rest lies closer."""
    lives = np.sort(crowd(p).weibull(p["shape"], 400)) * p["life"] * bench.travel[-1]
    left = 1.0 - np.searchsorted(lives, bench.travel) / 400.0
    return np.asarray(size * (np.sqrt(0.3 + 0.7 * left) - 1.0))


def fuzz(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Rubbed fibrils stand up and thicken the strands, ever fewer of them: a stretched exponential of travel."""
    return np.asarray(-size * np.expm1(-((bench.travel / bench.travel[-1] / p["share"]) ** p["exponent"])))


COMPACTION = (
    Law("closing_voids", "radius", 0.35, closing_voids, {"pressure": (0.3, 1.2), "shape": (0.8, 2.0)}),
    Law("van_wyk", "radius", 1.5, van_wyk, {"grown": (0.05, 0.4), "power": (0.08, 0.3)}),
    Law("ordering", "radius", 0.35, ordering, {"middle": (0.25, 0.7), "width": (0.15, 0.5)}),
)
WEAR = (
    Law(
        "worn_summits",
        "radius",
        0.35,
        worn_summits,
        {"running_in": (0.3, 2.0), "spread": (0.5, 1.5), "share": (0.2, 0.8)},
        keeps=True,
    ),
    Law("broken_filaments", "radius", 0.6, broken_filaments, {"shape": (0.7, 2.5), "life": (0.4, 1.5)}, keeps=True),
    Law("fuzz", "radius", 0.35, fuzz, {"share": (0.2, 0.8), "exponent": (0.5, 0.95)}, keeps=True),
)
