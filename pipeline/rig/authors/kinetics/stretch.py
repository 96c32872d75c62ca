"""Stretch of the string: at once with the load, and over time under the tension along its strands."""

import numpy as np
from scipy.special import expit

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.elements import eyring
from pipeline.rig.authors.kinetics.law import Law, Parameters
from pipeline.rig.authors.kinetics.populations import lognormal, quantiles, relaxed, weibull

# --- creep


def barrier_band(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Barriers spread evenly over a band of energies: times spread evenly over their logarithm."""
    times_s = p["fastest_s"] * (p["slowest_s"] / p["fastest_s"]) ** quantiles(14)
    return size * relaxed(bench.tension, times_s, np.ones(14), p["hung_s"])


def lognormal_times(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Relaxation times about one median, spread lognormally; little of the spread means one spring and dashpot."""
    return size * relaxed(bench.tension, lognormal(12, p["time_s"], p["spread"]), np.ones(12), p["hung_s"])


def cole_cole(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Relaxation times with the symmetric, wide-tailed distribution of Cole and Cole."""
    logs = np.linspace(-5.0, 3.0, 24)
    angle = np.pi * p["order"]
    weights = np.sin(angle) / (np.cosh(p["order"] * logs) + np.cos(angle))
    return size * relaxed(bench.tension, p["time_s"] * np.exp(logs), weights, p["hung_s"])


def eyring_flow(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Dashpots whose flow is activated by stress, each over its own barrier, beside springs that bring them back."""
    barriers = np.log(lognormal(8, p["time_s"], p["spread"]))
    start = bench.tension[0] * -np.expm1(-p["hung_s"] * np.exp(-barriers))
    return np.asarray(size * eyring(bench.tension, barriers, start, p["softness"], STEP_S))


# --- axial elasticity


def alike_fibres(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Fibres all alike and all taut stretch in proportion to the load."""
    return np.asarray(size * (bench.load - 1.0))


def crimped_fibres(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Crimped fibres come taut one after another, so the string hardens as it stretches."""
    strain = np.linspace(0.0, 12.0, 1600)
    pull = np.maximum(strain[:, None] - weibull(40, p["crimp"], p["shape"])[None, :], 0.0).mean(1) + 0.05 * strain
    return np.asarray(size * (np.interp(bench.load, pull, strain) - np.interp(1.0, pull, strain)))


def contact_crowd(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Rough strands lie on each other with exponentially distributed summits: approach goes as the log of the load."""
    return np.asarray(size * np.log((bench.load + p["held"]) / (1.0 + p["held"])))


def yielding_knots(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Loops in the end knots open elastically about a load, a few at a time, beside a linear string."""
    opened = expit((bench.load - p["opens"]) / p["width"]) - expit((1.0 - p["opens"]) / p["width"])
    return np.asarray(size * (0.4 * (bench.load - 1.0) + opened))


HUNG = {"hung_s": (60.0, 600.0)}
CREEP = (
    Law("barrier_band", "elongation", 8.0, barrier_band, {"fastest_s": (0.5, 2.0), "slowest_s": (80.0, 400.0), **HUNG}),
    Law("lognormal_times", "elongation", 8.0, lognormal_times, {"time_s": (8.0, 45.0), "spread": (0.2, 1.0), **HUNG}),
    Law("cole_cole", "elongation", 8.0, cole_cole, {"time_s": (8.0, 60.0), "order": (0.5, 0.8), **HUNG}),
    Law(
        "eyring_flow",
        "elongation",
        8.0,
        eyring_flow,
        {"time_s": (20.0, 90.0), "spread": (0.5, 1.2), "softness": (0.2, 0.6), **HUNG},
    ),
)
ELASTICITY = (
    Law("alike_fibres", "elongation", 6.0, alike_fibres),
    Law("crimped_fibres", "elongation", 8.0, crimped_fibres, {"crimp": (1.5, 4.0), "shape": (1.2, 2.5)}),
    Law("contact_crowd", "elongation", 6.0, contact_crowd, {"held": (0.03, 0.3)}),
    Law("yielding_knots", "elongation", 6.0, yielding_knots, {"opens": (0.8, 1.5), "width": (0.08, 0.3)}),
)
