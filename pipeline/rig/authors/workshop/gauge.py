"""The gauge that reads the displacement: late, drifting; and the wheel that runs out of true."""

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import drawn_curve, unit
from pipeline.rig.authors.workshop.kernels import after_ramps

LATEST_S, FARTHEST_MM = 2.0, 6.0


def long_cable(bench: Bench, rng: np.random.Generator) -> Part:
    """Every reading comes a fixed time late."""

    def act(late_s: float, now: Array) -> Array:
        return after_ramps(now, lambda time_s: np.maximum(time_s - late_s, 0.0), bench.tick_s, late_s)

    return Part("reading", "late_s", LATEST_S, act)


def damped_needle(bench: Bench, rng: np.random.Generator) -> Part:
    """A needle that nears its place by the same share in every tick."""

    def act(slow_s: float, now: Array) -> Array:
        return after_ramps(now, lambda t: t - slow_s * -np.expm1(-t / slow_s), bench.tick_s, 14.0 * slow_s)

    return Part("reading", "slow_s", LATEST_S, act)


def two_needles(bench: Bench, rng: np.random.Generator) -> Part:
    """A needle that follows a needle as slow as itself."""

    def act(slow_s: float, now: Array) -> Array:
        return after_ramps(
            now, lambda t: t - 2.0 * slow_s + (t + 2.0 * slow_s) * np.exp(-t / slow_s), bench.tick_s, 18.0 * slow_s
        )

    return Part("reading", "slow_s", LATEST_S, act)


def averaging_display(bench: Bench, rng: np.random.Generator) -> Part:
    """A display that shows the mean over its last window."""

    def act(window_s: float, now: Array) -> Array:
        def ramp(time_s: Array) -> Array:
            inside = np.square(time_s) / (2.0 * window_s)
            return np.where(time_s < window_s, inside, time_s - window_s / 2.0)

        return after_ramps(now, ramp, bench.tick_s, window_s)

    return Part("reading", "window_s", 2.0 * LATEST_S, act)


def _drifted(rng: np.random.Generator, shape: Array, **parameters: float) -> Part:
    sign = float(rng.choice([-1.0, 1.0]))
    return added("reading", "drift_mm", FARTHEST_MM, sign * unit(shape), sign=sign, **parameters)


def zero_log(bench: Bench, rng: np.random.Generator) -> Part:
    """The zero walks evenly, with the log's small unevenness."""
    return _drifted(rng, drawn_curve(rng, 0.0, 8)(bench.time_s / bench.time_s[-1]))


def warm_up_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """The gauge warms up after it was switched on, as its sheet shows."""
    bend = rng.uniform(2.5, 6.0)
    return _drifted(rng, drawn_curve(rng, bend, 9)(bench.time_s / bench.time_s[-1]), bend=bend)


def root_of_time(bench: Bench, rng: np.random.Generator) -> Part:
    """The zero walks by the root of the time."""
    return _drifted(rng, np.sqrt(bench.time_s / bench.time_s[-1]))


def wandering_zero(bench: Bench, rng: np.random.Generator) -> Part:
    """The zero wanders by chance, step upon step, and slowly enough to be seen as a drift."""
    steps = rng.normal(0.0, 1.0, len(bench.time_s))
    ticks = max(1, round(8.0 / bench.tick_s))
    walk = np.cumsum(np.convolve(np.pad(steps, ticks), np.full(ticks, 1.0 / ticks), mode="same")[ticks:-ticks])
    return _drifted(rng, walk, smoothed_s=8.0)


def dial_indicator(bench: Bench, rng: np.random.Generator) -> Part:
    """Runout under the dial, harmonic by harmonic, as large at every height."""
    second, third = rng.uniform(0.0, 0.3), rng.uniform(0.0, 0.12)
    phases = rng.uniform(0.0, RAD_PER_TURN, 3)
    orders = zip((1, 2, 3), (1.0, second, third), phases, strict=True)
    shape = sum(share * np.sin(order * RAD_PER_TURN * bench.turns + phase) for order, share, phase in orders)
    return added("reading", "runout_mm", 3.0, np.asarray(shape), second=second, third=third)


def bent_hook(bench: Bench, rng: np.random.Generator) -> Part:
    """A bent hook carries the string's end round: a ripple that grows as the string leans."""
    phase, floor = rng.uniform(0.0, RAD_PER_TURN), rng.uniform(0.1, 0.4)
    lever = floor + (1.0 - floor) * np.sin(bench.helix_rad) / np.sin(bench.helix_rad).max()
    shape = lever * np.sin(RAD_PER_TURN * bench.turns + phase)
    return added("reading", "runout_mm", 3.0, shape, phase_rad=phase, at_no_lean=floor)


LAG: tuple[Law, ...] = (long_cable, damped_needle, two_needles, averaging_display)
DRIFT: tuple[Law, ...] = (zero_log, warm_up_sheet, root_of_time, wandering_zero)
ECCENTRICITY: tuple[Law, ...] = (dial_indicator, bent_hook)
