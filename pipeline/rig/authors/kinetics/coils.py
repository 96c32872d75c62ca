"""Beyond a critical twist: strands that jam, and coils that come and go over a barrier."""

import numpy as np
from scipy.stats import norm

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.elements import hopping, relays
from pipeline.rig.authors.kinetics.law import Law, Parameters, crowd
from pipeline.rig.authors.kinetics.populations import quantiles

# --- jam, whose size is the share of the twist beyond that is lost


def touching_strands(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Parts of the string jam at twists spread about a critical one; a jammed part takes no more twist."""
    criticals = bench.top * (p["critical"] + p["spread"] * norm.ppf(quantiles(24)))
    return np.asarray(-size * np.mean([np.maximum(now - at, 0.0) for at in criticals], axis=0))


def free_volume(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Room between strands runs out: what more twist still does falls exponentially."""
    past = np.maximum(now - p["critical"] * bench.top, 0.0)
    room = 0.5 * bench.top * (1.0 - p["critical"]) / size
    return np.asarray(-room * np.expm1(-past / room) - past)


def force_chains(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Chains of contacts stiffen as a power of the overrun, as grains do past their jamming density."""
    way = bench.top * (1.0 - p["critical"])
    past = np.maximum(now - p["critical"] * bench.top, 0.0)
    return np.asarray(-size * way * (past / way) ** p["power"])


# --- overtwist, whose size is the added contraction in mm where all coils stand


def nucleated_coils(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Many small coils, each born above a twist of its own and gone only well below it."""
    chance = crowd(p)
    born = bench.top * (p["critical"] + (0.97 - p["critical"]) * chance.uniform(0.0, 1.0, 300))
    gone = born - bench.top * p["late"] * chance.uniform(0.5, 1.5, 300)
    return np.asarray(size * relays(bench.turns, born, gone, np.full(300, 1.0 / 300.0)))


def few_big_coils(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A handful of big coils of exponential sizes snap in one at a time and out again late."""
    chance = crowd(p)
    count = int(chance.integers(5, 11))
    born = bench.top * (
        p["critical"] + (0.97 - p["critical"]) * (np.arange(count) + chance.uniform(0, 1, count)) / count
    )
    gone = born - bench.top * p["late"] * chance.uniform(0.7, 1.3, count)
    sizes = 0.3 + chance.exponential(1.0, count)
    snapped = relays(bench.turns, born, gone, sizes / sizes.sum())
    return np.asarray(size * snapped)


def activated_coils(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Coils come and go over a barrier that the twist tilts, by Kramers' rates; slow twisting closes the loop a bit."""
    tilt = (bench.turns / bench.top - p["critical"]) / p["width"]
    barriers = np.linspace(1.5, 4.5, 8)
    return np.asarray(size * hopping(tilt, barriers, p["attempts"], STEP_S))


JAM = (
    Law("touching_strands", "twist", 0.9, touching_strands, {"critical": (0.55, 0.8), "spread": (0.01, 0.06)}),
    Law("free_volume", "twist", 4.0, free_volume, {"critical": (0.5, 0.75)}),
    Law("force_chains", "twist", 0.6, force_chains, {"critical": (0.45, 0.7), "power": (1.3, 1.8)}),
)
OVERTWIST = (
    Law("nucleated_coils", "contraction", 20.0, nucleated_coils, {"critical": (0.55, 0.75), "late": (0.08, 0.2)}),
    Law("few_big_coils", "contraction", 20.0, few_big_coils, {"critical": (0.55, 0.75), "late": (0.08, 0.2)}),
    Law(
        "activated_coils",
        "contraction",
        20.0,
        activated_coils,
        {"critical": (0.55, 0.7), "width": (0.02, 0.045), "attempts": (0.5, 2.0)},
    ),
)
