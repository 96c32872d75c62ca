"""Friction between strands and loss with rate: sliders, relays and flow over barriers."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import Bench
from pipeline.rig.authors.kinetics.elements import relays, sliders
from pipeline.rig.authors.kinetics.law import Law, Parameters, crowd
from pipeline.rig.authors.kinetics.populations import quantiles, relaxed

# --- friction


def iwan(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Sliders drawn at random with a power law of strengths hold twist back, the more the greater the load."""
    bounds = 0.01 * bench.top * (1.0 + crowd(p).pareto(p["power"], 48))
    bounds = np.minimum(bounds, 0.15 * bench.top)
    weights = np.full(48, 1.0 / bounds.sum())
    return np.asarray(-size * sliders(now, bounds, weights, bench.load ** p["load_power"]))


def rough_strands(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Contacts of rough strands, exponential in strength; twist presses more of them together."""
    bounds = -p["reach"] * bench.top * np.log1p(-quantiles(24))
    grip = bench.load ** p["load_power"] * (p["bare"] + (1.0 - p["bare"]) * bench.turns / bench.top)
    return np.asarray(-size * sliders(now, bounds, np.full(24, 1.0 / bounds.sum()), grip))


def preisach(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Domains of strand that flip between two lays, each at its own twist up and down; the load sizes each flip."""
    chance = crowd(p)
    middles = bench.top * (0.03 + 0.97 * quantiles(600))
    halves = np.minimum(chance.gamma(2.0, 0.5 * p["half"], 600) * bench.top, middles - 0.025 * bench.top)
    on = relays(now, middles + halves, middles - halves, np.full(600, 1.0 / 600.0))
    # the same domains without hysteresis would flip at their middles
    free = np.searchsorted(middles, now) / 600.0
    return np.asarray(-size * bench.load ** p["load_power"] * (free - on))


def capstan(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Tension is lost along the helix by Euler's exponential, turned over by sliders as the twist goes back."""
    bounds = p["reach"] * bench.top * (0.2 + 1.6 * quantiles(16))
    turned = sliders(bench.turns, bounds, np.full(16, 1.0 / bounds.sum()), np.ones(len(now)))
    wrapped = np.expm1(p["wrap"] * bench.turns / bench.top) / np.expm1(p["wrap"])
    return np.asarray(size * bench.load * wrapped * turned)


# --- viscous loss


def _flow(bench: Bench, rate: Array) -> Array:
    """Rate as a share of the greatest."""
    return np.asarray(rate / np.abs(bench.rate).max())


def eyring_flow_stress(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Flow stress of an activated process, the inverse hyperbolic sine of the rate, stretches the string."""
    return np.asarray(size * np.arcsinh(_flow(bench, bench.rate) / p["slow"]) / np.arcsinh(1.0 / p["slow"]))


def thinning(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Grease between the strands thins as it is sheared: Carreau's viscosity times the rate."""
    flow = _flow(bench, bench.rate)
    return np.asarray(size * flow * (1.0 + np.square(flow / p["slow"])) ** ((p["power"] - 1.0) / 2.0))


def maxwell_crowd(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Bonds of short, distributed lives carry a stress that follows the twisting rate and dies with them."""
    times_s = p["life_s"] * np.exp(p["spread"] * np.linspace(-1.0, 1.0, 5))
    return size * relaxed(_flow(bench, bench.rate), times_s, times_s)


LOAD = {"load_power": (0.5, 1.2)}
FRICTION = (
    Law("iwan", "twist", 8.0, iwan, {"power": (0.8, 2.0), **LOAD}),
    Law("rough_strands", "twist", 8.0, rough_strands, {"reach": (0.015, 0.06), "bare": (0.2, 0.7), **LOAD}),
    Law("preisach", "twist", 20.0, preisach, {"half": (0.02, 0.08), **LOAD}),
    Law("capstan", "elongation", 6.0, capstan, {"reach": (0.01, 0.05), "wrap": (0.8, 2.5)}),
)
VISCOUS = (
    Law("eyring_flow_stress", "elongation", 6.0, eyring_flow_stress, {"slow": (0.03, 0.3)}),
    Law("thinning", "elongation", 8.0, thinning, {"slow": (0.1, 0.5), "power": (0.4, 0.9)}),
    Law("maxwell_crowd", "elongation", 6.0, maxwell_crowd, {"life_s": (0.05, 0.25), "spread": (0.3, 0.8)}),
)
