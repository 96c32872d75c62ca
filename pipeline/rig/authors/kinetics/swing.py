"""What turns and swings: ripple once a turn as a sum of modes, and a load that rings after a jerk."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.kinetics.bench import STEP_S, Bench
from pipeline.rig.authors.kinetics.elements import rung
from pipeline.rig.authors.kinetics.law import Law, Parameters, crowd

# --- eccentricity, whose size is the ripple's height in mm


def _waves(turns: Array, heights: Array, phases: Array) -> Array:
    waves = [
        h * np.sin(2.0 * np.pi * (k + 1) * turns + phase)
        for k, (h, phase) in enumerate(zip(heights, phases, strict=True))
    ]
    return np.asarray(np.sum(waves, axis=0))


def bent_shaft(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A bent shaft carries the string's end round once a turn."""
    return size * _waves(bench.turns, np.ones(1), np.array([p["phase"]]))


def rough_round(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """An uneven seat: three harmonics with random heights and phases, the first the strongest."""
    chance = crowd(p)
    heights = np.array([1.0, *(np.array([0.5, 0.25]) * chance.normal(0.0, 1.0, 2))])
    return size * _waves(bench.turns, heights, chance.uniform(0.0, 2.0 * np.pi, 3))


def crooked_disc(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """A crooked coupling turns unevenly, and the string's lever makes contraction of it."""
    lever = bench.lever_mm / bench.lever_mm.max()
    return np.asarray(size * lever * _waves(bench.turns, np.array([1.0, 0.15]), np.array([p["phase"], p["second"]])))


# --- swing, whose size is a share of what an ideal spring and mass would ring


def _jerked(bench: Bench) -> Array:
    """Acceleration of the load's end in mm/s²."""
    return -np.gradient(np.gradient(bench.contraction_mm, STEP_S), STEP_S)


def one_mode(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The load rings in one mode on its string."""
    return np.asarray(size * rung(_jerked(bench), 2.0 * np.pi * p["frequency_hz"], p["damping"], 0.0, STEP_S))


def two_modes(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The load bobs and rolls: two modes that a start excites together."""
    low = rung(_jerked(bench), 2.0 * np.pi * p["frequency_hz"], p["damping"], 0.0, STEP_S)
    high = rung(_jerked(bench), 2.0 * np.pi * p["frequency_hz"] * p["apart"], p["damping"], 0.0, STEP_S)
    return np.asarray(size * (low + p["second"] * high))


def air_damped(bench: Bench, now: Array, p: Parameters, size: float) -> Array:
    """The swing loses energy to the air by the square of its speed, so big swings die faster than small ones."""
    push = size * _jerked(bench)
    return np.asarray(rung(push, 2.0 * np.pi * p["frequency_hz"], 0.3 * p["damping"], p["drag_per_mm"], STEP_S))


RING = {"frequency_hz": (0.7, 3.5), "damping": (0.01, 0.06)}
ECCENTRICITY = (
    Law("bent_shaft", "contraction", 3.0, bent_shaft, {"phase": (0.0, 6.28)}),
    Law("rough_round", "contraction", 3.0, rough_round),
    Law("crooked_disc", "contraction", 4.0, crooked_disc, {"phase": (0.0, 6.28), "second": (0.0, 6.28)}),
)
SWING = (
    Law("one_mode", "contraction", 60.0, one_mode, RING),
    Law("two_modes", "contraction", 60.0, two_modes, {**RING, "apart": (1.4, 2.6), "second": (0.3, 1.0)}),
    Law("air_damped", "contraction", 60.0, air_damped, {**RING, "drag_per_mm": (0.05, 0.5)}),
)
