"""Where the string is held, and the weight that hangs from it."""

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import eased
from pipeline.rig.authors.workshop.events import strained_instants
from pipeline.rig.authors.workshop.kernels import after_impulses

FARTHEST_MM = 6.0


def _given_way(bench: Bench, rng: np.random.Generator, count: int, lasting_s: float) -> Part:
    instants = strained_instants(bench, rng, count)
    shares = rng.uniform(0.4, 1.0, len(instants))
    shares /= shares.sum()
    slipped = sum(share * eased(bench.time_s, at, lasting_s) for share, at in zip(shares, instants, strict=True))
    numbers = {"instants_s": instants.tolist(), "shares": shares.tolist(), "lasting_s": lasting_s}
    return added("length", "slipped_mm", FARTHEST_MM, -np.asarray(slipped), **numbers)


def one_slip(bench: Bench, rng: np.random.Generator) -> Part:
    """The clamp lets the string through once, at once."""
    return _given_way(bench, rng, 1, 0.0)


def settling_knot(bench: Bench, rng: np.random.Generator) -> Part:
    """The knot draws tight within a second, once or twice."""
    return _given_way(bench, rng, int(rng.integers(1, 3)), float(rng.uniform(0.2, 0.9)))


def slip_after_slip(bench: Bench, rng: np.random.Generator) -> Part:
    """The clamp lets the string through tooth after tooth."""
    return _given_way(bench, rng, int(rng.integers(3, 6)), 0.0)


def _push(bench: Bench) -> Array:
    """Acceleration that the motion gives the weight."""
    return np.gradient(np.gradient(bench.contraction_mm, bench.tick_s), bench.tick_s)


def _swung(shape: Array, **parameters: float) -> Part:
    return added("length", "swing_mm", 5.0, shape / max(float(np.abs(shape).max()), 1e-12), **parameters)


def _knocked(bench: Bench, rng: np.random.Generator, highest_hz: float) -> tuple[Array, float, float]:
    """The recorded answer to a knock, with its frequency and its damping."""
    hertz = float(np.exp(rng.uniform(np.log(0.8), np.log(min(highest_hz, 0.12 / bench.tick_s)))))
    damping = rng.uniform(0.01, 0.06)
    pulsation = RAD_PER_TURN * hertz
    ring = np.exp(-damping * pulsation * bench.time_s) * np.sin(pulsation * bench.time_s) / pulsation
    return ring, hertz, damping


def knock_test(bench: Bench, rng: np.random.Generator) -> Part:
    """What the weight did after a knock, convolved with how the motion pushes it."""
    ring, hertz, damping = _knocked(bench, rng, 4.0)
    return _swung(-after_impulses(_push(bench), ring), frequency_hz=hertz, damping=damping)


def two_tones(bench: Bench, rng: np.random.Generator) -> Part:
    """Two modes, each with its own knock test."""
    ring, hertz, damping = _knocked(bench, rng, 1.8)
    other, high, damped = _knocked(bench, rng, 1.8)
    other, high = np.interp(bench.time_s * 1.9, bench.time_s, other, right=0.0), high * 1.9
    push, share = _push(bench), rng.uniform(0.25, 0.6)
    first, second = after_impulses(push, ring), after_impulses(push, other)
    shape = -(1.0 - share) * first / np.abs(first).max() - share * second / np.abs(second).max()
    numbers = {"frequency_hz": hertz, "second_hz": high, "damping": damping, "second_damping": damped}
    return _swung(shape, second_share=share, **numbers)


def dying_rings(bench: Bench, rng: np.random.Generator) -> Part:
    """Each start and stop sets off a ring that dies quickly while large and slowly when small."""
    hertz = float(rng.uniform(0.8, min(3.5, 0.1 / bench.tick_s)))
    half_s = rng.uniform(0.6, 2.5)
    rate = np.gradient(bench.contraction_mm, bench.tick_s)
    moving = np.abs(rate) > 0.4 * np.abs(rate).max() / 3.0
    shape = np.zeros_like(rate)
    for tick in np.flatnonzero(np.diff(moving.astype(int)) != 0).tolist():
        near = slice(max(tick - 20, 0), tick + 20)
        jolt = np.ptp(rate[near]) * (1.0 if rate[min(tick + 20, len(rate) - 1)] > rate[near][0] else -1.0)
        since = bench.time_s[tick:] - bench.time_s[tick]
        rises = np.minimum(since * hertz * 2.0, 1.0)
        dying = np.exp(-since / 40.0) / (1.0 + since / half_s) ** 2
        shape[tick:] -= jolt * rises * np.sin(RAD_PER_TURN * hertz * since) * dying
    return _swung(shape, frequency_hz=hertz, half_time_s=half_s)


CLAMP_SLIP: tuple[Law, ...] = (one_slip, settling_knot, slip_after_slip)
LOAD_SWING: tuple[Law, ...] = (knock_test, two_tones, dying_rings)
