"""What else spoils a bench: pulleys that are not round, mains hum, snagging fibres, clocks that part."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import Bench
from pipeline.rig.authors.kinetics.law import Law, Parameters, crowd
from pipeline.rig.authors.kinetics.populations import wandering


def flat_pulley(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A pulley off its centre under the load's cord: ripple with the displacement and not with the twist."""
    return np.asarray(size * np.sin(now / p["radius_mm"] + p["phase"]))


def chipped_rack(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The sensor's scale has places, Gaussian along it, at which it reads wrong."""
    chance = crowd(p)
    places = float(now.min()) + bench.span_mm * chance.uniform(0.1, 0.95, 6)
    depths = chance.normal(0.0, 1.0, 6)
    bumps = [
        d * np.exp(-0.5 * np.square((now - at) / (p["width"] * bench.span_mm)))
        for d, at in zip(depths, places, strict=True)
    ]
    return np.asarray(size * np.sum(bumps, axis=0))


def hum(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Mains hum, folded down by the sampling to a slow wave."""
    return np.asarray(size * np.sin(2.0 * np.pi * p["frequency_hz"] * bench.time_s + p["phase"]))


def hum_of_a_machine(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Another machine shakes the bench at its own pace while it runs, on and off at random."""
    runs = wandering(crowd(p), len(now), 20.0) > 0.0
    return np.asarray(size * runs * np.sin(2.0 * np.pi * p["frequency_hz"] * bench.time_s))


def snagging_fibres(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """Loose fibres catch in the separator's holes in some strokes and hold a bit of length until they let go."""
    chance = crowd(p)
    held = np.zeros(len(now))
    share = bench.turns / bench.top
    for stroke in range(1, int(bench.stroke.max()) + 1):
        low, high = np.sort(chance.uniform(0.15, 0.95, 2))
        caught = chance.gamma(2.0, 0.5) if chance.uniform() < p["often"] else 0.0
        is_snagged = (bench.stroke == stroke) & (share > low) & (share < high) & (bench.rate > 0.0)
        held += caught * is_snagged * (share - low)
    return np.asarray(size * held)


def two_clocks(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The sensor's clock runs at another rate than the encoder's: readings come later and later."""
    late_s = size * bench.time_s / bench.time_s[-1]
    return np.asarray(np.interp(bench.time_s - late_s, bench.time_s, now) - now)


def hopping_buffer(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A buffer fills and empties at random, and readings are late by what stands in it."""
    chance = crowd(p)
    jumps = np.sort(chance.uniform(0.0, bench.time_s[-1], round(p["jumps"])))
    waits = chance.exponential(1.0, len(jumps) + 1)
    late_s = size * waits[np.searchsorted(jumps, bench.time_s)]
    return np.asarray(np.interp(bench.time_s - late_s, bench.time_s, now) - now)


TURN = {"phase": (0.0, 6.28)}
PULLEY = (
    Law("flat_pulley", "reading", 4.0, flat_pulley, {"radius_mm": (0.8, 3.0), **TURN}),
    Law("chipped_rack", "reading", 4.0, chipped_rack, {"width": (0.01, 0.04)}),
)
SHAKING = (
    Law("hum", "reading", 3.0, hum, {"frequency_hz": (0.2, 6.0), **TURN}),
    Law("hum_of_a_machine", "reading", 3.0, hum_of_a_machine, {"frequency_hz": (0.8, 8.0)}),
)
SNAG = (Law("snagging_fibres", "elongation", 25.0, snagging_fibres, {"often": (0.4, 0.9)}),)
CLOCKS = (
    Law("two_clocks", "reading", 3.0, two_clocks, still=True),
    Law("hopping_buffer", "reading", 3.0, hopping_buffer, {"jumps": (6.0, 30.0)}, still=True),
)
