"""The reference of a carriage: strokes of a quarter of a metre with moves between them, 1 kHz for 25 s."""

import numpy as np

from ...ground.kinematics import Array

STEP_S = 1e-3
TIME_S: Array = np.arange(25_000, dtype=np.float64) * STEP_S
STROKE_M = 0.25
PLANS = ("bang", "trapezoid", "speeds")


def told(plan: str, rng: np.random.Generator) -> tuple[Array, Array]:
    """Reference position in m and its speed in m/s, both (samples,); raises ValueError for a plan not known.

    `trapezoid`: all strokes at one speed; `speeds`: each at its own; `bang`: each speeds up and slows down on its
    way, by accelerations that are either full or nothing, and turns at once; the others pause at the ends.
    Each has the shape (samples,).
    """
    if plan not in PLANS:
        raise ValueError(f"{plan} is no plan; known are {', '.join(PLANS)}")
    accelerated = np.zeros(len(TIME_S))
    usual, at_s, at_m, way = rng.uniform(0.10, 0.13), 0.4, 0.0, 1.0
    while at_s < TIME_S[-1]:
        high = STROKE_M if way > 0 else 0.0
        far_m = abs(high - way * rng.uniform(0.0, 0.008) - at_m)
        speed = usual if plan == "trapezoid" else float(np.exp(rng.uniform(np.log(0.07), np.log(0.17))))
        hard = rng.uniform(0.7, 1.5)
        pause_s = rng.uniform(0.0, 0.05) if plan == "bang" else rng.uniform(0.05, 0.35)
        changes = _bang(far_m, rng) if plan == "bang" else [(0.0, speed), (far_m, 0.0)]
        at_s = _ride(accelerated, at_s, changes, way, hard) + pause_s
        at_m += way * far_m
        way = -way
    speed_m_per_s = np.cumsum(accelerated) * STEP_S
    return np.cumsum(speed_m_per_s) * STEP_S, speed_m_per_s


def _bang(far_m: float, rng: np.random.Generator) -> list[tuple[float, float]]:
    """Three speeds on one way: the place (of the way, m) by which each is reached, and the speed."""
    marks = np.sort(rng.uniform(0.2, 0.8, 2)) * far_m
    slow, fast = rng.uniform(0.05, 0.09), rng.uniform(0.11, 0.17)
    speeds = [fast, slow, fast] if rng.random() < 0.5 else [slow, fast, slow]
    return [*zip([0.0, *marks.tolist()], speeds, strict=True), (far_m, 0.0)]


def _ride(out: Array, from_s: float, changes: list[tuple[float, float]], way: float, hard: float) -> float:
    """Put the accelerations of one way into `out`, in areas that are exact; the time at which it ends."""
    at_s, speed, gone_m = from_s, 0.0, 0.0
    for (mark_m, to), (after_m, _) in zip(changes, [*changes[1:], (np.inf, 0.0)], strict=True):
        takes_s = abs(to - speed) / hard
        needs_m = takes_s * (speed + to) / 2.0
        start_m = mark_m - needs_m if to == 0.0 else max(mark_m, gone_m)
        if to != 0.0 and start_m + needs_m + to * to / (2.0 * hard) > (after_m if np.isfinite(after_m) else np.inf):
            continue  # the next change is too near: leave this one out
        if speed > 0.0:
            at_s += max(start_m - gone_m, 0.0) / speed
        begins, ends = at_s / STEP_S, (at_s + takes_s) / STEP_S
        edges = np.clip(np.minimum(np.arange(len(out)) + 1, ends) - np.maximum(np.arange(len(out)), begins), 0.0, 1.0)
        out += way * np.sign(to - speed) * hard * edges
        at_s, speed, gone_m = at_s + takes_s, to, start_m + needs_m
    return at_s
