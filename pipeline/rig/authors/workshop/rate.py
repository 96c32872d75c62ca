"""What follows the twisting rate, and what sticks and lets go."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import drawn_curve, histogram_draws

LARGEST_MM = 4.0


def _damped(bench: Bench, of_rate: Array, **parameters: float) -> Part:
    return added("length", "at_top_speed_mm", LARGEST_MM, -np.sign(bench.speed) * of_rate, **parameters)


def _rate(bench: Bench) -> Array:
    return np.abs(bench.speed) / np.abs(bench.speed).max()


def straight_rate(bench: Bench, rng: np.random.Generator) -> Part:
    """Loss in proportion to the twisting rate."""
    lean = rng.uniform(-0.05, 0.05)
    return _damped(bench, _rate(bench) * (1.0 + lean * (bench.height - 0.5)), lean=lean)


def rate_to_a_power(bench: Bench, rng: np.random.Generator) -> Part:
    """Loss by the twisting rate to a power."""
    power = float(rng.choice([rng.uniform(0.35, 0.75), rng.uniform(1.3, 2.0)]))
    return _damped(bench, _rate(bench) ** power, power=power)


def damping_curve(bench: Bench, rng: np.random.Generator) -> Part:
    """Loss off the damper's characteristic curve, which flattens with the rate."""
    bend = rng.uniform(1.0, 4.0)
    return _damped(bench, drawn_curve(rng, bend)(_rate(bench)), bend=bend)


def _hung(course: Array, thresholds: list[float], slow: Array, over: float) -> Array:
    """Where a carriage stands that hangs until its pull passes a threshold, then jumps beyond its rest."""
    at, out = float(course[0]), []
    number = 0
    for place, share in zip(course.tolist(), slow.tolist(), strict=True):
        pull = place - at
        limit = thresholds[number % len(thresholds)] * share
        if abs(pull) > limit:
            at = place + (over * limit if pull > 0.0 else -over * limit)
            number += 1
        out.append(at)
    return np.array(out)


def drawn_releases(bench: Bench, rng: np.random.Generator) -> Part:
    """It lets go at thresholds off a histogram; quick motion shakes it loose."""
    over, loose = rng.uniform(0.75, 0.95), rng.uniform(1.0, 3.0)
    table = histogram_draws(rng, np.array([0.5, 0.8, 1.2, 1.6]), np.array([2.0, 5.0, 2.0]), 61)
    slow = 1.0 / (1.0 + (np.abs(bench.speed) / (loose * np.abs(bench.speed).mean())) ** 2)

    def act(amount: float, now: Array) -> Array:
        return _hung(now, (amount * table).tolist(), slow, over)

    return Part("length", "threshold_mm", LARGEST_MM, act, {"overshoot": over, "loose_speed": loose})


def aged_releases(bench: Bench, rng: np.random.Generator) -> Part:
    """The grip ages while it holds: the longer it has stuck, the harder it lets go."""
    over, ageing, young_s = rng.uniform(0.75, 0.95), rng.uniform(0.1, 0.3), rng.uniform(0.1, 0.5)
    scatter = rng.uniform(0.85, 1.15, 53).tolist()

    def act(amount: float, now: Array) -> Array:
        at, held, number, out = float(now[0]), 0.0, 0, []
        for place in now.tolist():
            limit = amount * scatter[number % 53] * (1.0 + ageing * np.log1p(held / young_s))
            held += bench.tick_s
            if abs(place - at) > limit:
                at = place + (over * limit if place > at else -over * limit)
                held, number = 0.0, number + 1
            out.append(at)
        return np.array(out)

    return Part("length", "threshold_mm", LARGEST_MM, act, {"overshoot": over, "ageing": ageing, "young_s": young_s})


VISCOUS: tuple[Law, ...] = (straight_rate, rate_to_a_power, damping_curve)
STICK_SLIP: tuple[Law, ...] = (drawn_releases, aged_releases)
