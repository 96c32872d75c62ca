"""The protocols as a sequence of ramps and waits on the fine clock: what the operator asked of motor and weights."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d

Array = NDArray[np.float64]
Rng = np.random.Generator


@dataclass(frozen=True)
class Plan:
    """One stroke: how high, how fast, under which load, how long held above and left below."""

    height_turns: float
    rate: float
    load_n: float
    hold_s: float
    rest_s: float


@dataclass(frozen=True)
class Motion:
    """Twist, load and number of the stroke (from 0, −1 before the first) on a clock of even steps."""

    step_s: float
    turns: Array
    load_n: Array
    stroke: NDArray[np.int64]


def plan(rng: Rng, protocol: str, top_turns: float, load_n: float) -> list[Plan]:
    """The strokes of a protocol, about as long in all as a bench session of 3 to 10 minutes."""
    least, most = {"rich": (9, 16), "usual": (9, 12), "poor": (6, 10)}[protocol]
    count = int(rng.integers(least, most + 1))
    total_s = rng.uniform(*{"rich": (300, 510), "usual": (220, 480), "poor": (190, 330)}[protocol])
    if protocol == "poor":
        rate = 2.0 * top_turns * count / total_s
        return [Plan(top_turns, rate, load_n, 0.0, 0.0)] * count
    waiting = rng.uniform(0.35, 0.5) if protocol == "rich" else rng.uniform(0.15, 0.35)
    rates, loads = _levels(rng, protocol, load_n)
    order = rng.permutation(count)
    faster = np.array([rates[i % len(rates)] for i in order])
    borne = np.array([loads[(i // len(rates)) % len(loads)] for i in rng.permutation(count)])
    if len(loads) == 2:  # one lot of weights, then the other
        borne = np.sort(borne)[:: 1 if rng.random() < 0.5 else -1]
    heights = np.ones(count)
    if protocol == "rich":
        heights[1:] = rng.choice([1.0, rng.uniform(0.78, 0.92), rng.uniform(0.5, 0.7)], count - 1, p=[0.5, 0.25, 0.25])
    moving_s = (1.0 - waiting) * total_s
    rate = float(np.sum(2.0 * top_turns * heights / faster) / moving_s)
    pauses = rng.dirichlet(np.full(2 * count, 1.5 if protocol == "rich" else 8.0)) * waiting * total_s
    return [
        Plan(float(top_turns * heights[i]), float(rate * faster[i]), float(borne[i]), pauses[2 * i], pauses[2 * i + 1])
        for i in range(count)
    ]


def _levels(rng: Rng, protocol: str, load_n: float) -> tuple[list[float], list[float]]:
    """Relative rates and loads of a protocol."""
    if protocol == "rich":
        rates = [1.0, float(rng.uniform(1.7, 2.4)), float(rng.uniform(0.4, 0.6))]
        return rates, [load_n, float(load_n * rng.uniform(1.5, 1.9)), float(load_n * rng.uniform(0.5, 0.7))]
    rates = [1.0] if rng.random() < 0.4 else [1.0, float(rng.uniform(1.6, 2.4))]
    loads = [load_n] if rng.random() < 0.5 else [load_n, float(load_n * rng.uniform(1.4, 2.0))]
    return rates, loads


def carried_out(rng: Rng, strokes: list[Plan], step_s: float) -> Motion:
    """The motion of a plan: ramps of even rate with soft ends, weights changed during the rest below."""
    turns, load, number = [], [], []

    def wait(seconds: float, at: float, from_n: float, to_n: float, stroke: int) -> None:
        steps = round(seconds / step_s)
        turns.append(np.full(steps, at))
        load.append(from_n + (to_n - from_n) * _handed_over(steps, step_s))
        number.append(np.full(steps, stroke))

    def ramp(start: float, end: float, plan: Plan, stroke: int) -> None:
        steps = max(2, round(abs(end - start) / plan.rate / step_s))
        turns.append(start + (end - start) * np.arange(1, steps + 1) / steps)
        load.append(np.full(steps, plan.load_n))
        number.append(np.full(steps, stroke))

    first, low = strokes[0].load_n, float(rng.choice([0.0, rng.uniform(0.0, 0.6)]))
    wait(rng.uniform(2.0, 6.0), low, first, first, -1)
    for i, plan in enumerate(strokes):
        ramp(low, plan.height_turns, plan, i)
        wait(plan.hold_s, plan.height_turns, plan.load_n, plan.load_n, i)
        ramp(plan.height_turns, low, plan, i)
        after = strokes[min(i + 1, len(strokes) - 1)].load_n
        wait(max(plan.rest_s, 4.0 if after != plan.load_n else 0.0), low, plan.load_n, after, i)
    wait(rng.uniform(0.5, 3.0), low, strokes[-1].load_n, strokes[-1].load_n, len(strokes) - 1)
    soft = max(1, round(rng.uniform(0.08, 0.5) / step_s))  # how gently the drive starts and stops
    smooth = uniform_filter1d(uniform_filter1d(np.concatenate(turns), soft, mode="nearest"), soft, mode="nearest")
    return Motion(step_s, smooth, np.concatenate(load), np.concatenate(number).astype(np.int64))


def _handed_over(steps: int, step_s: float) -> Array:
    """How far the next weights have been put on, 0 to 1: a second and a half in the middle of the rest."""
    since_s = (np.arange(steps) - 0.5 * steps) * step_s
    return np.asarray(np.clip(0.5 + since_s / 1.5, 0.0, 1.0))
