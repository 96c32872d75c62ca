"""What the operator drives: strokes, speeds, dwells, rests and loads, on the simulation's clock."""

from dataclasses import dataclass

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import Protocol
from pipeline.rig.authors.mechanics.scene import STEP_S

LOWERED = 0.15  # of the weight that the string still carries while it is set down


@dataclass(frozen=True)
class Plan:
    """What a protocol asks: strokes (with their heights and speeds), waits in s and loads, one a stroke."""

    heights: Array
    speeds: Array  # over the slowest stroke's
    dwell_s: Array
    rest_s: Array
    loads: Array  # over the usual load
    set_down: tuple[int, ...]  # strokes before which the weight is set down for a long rest
    total_s: float


def planned(protocol: Protocol, draw: np.random.Generator) -> Plan:
    """The plan of one recording."""
    if protocol == "rich":
        count = int(draw.integers(9, 15))
        kinds = np.arange(count) % 3
        loads = np.array([1.0, draw.uniform(0.4, 0.6), draw.uniform(1.5, 1.9)])[draw.permutation(kinds)]
        speeds = np.array([1.0, draw.uniform(0.3, 0.5), draw.uniform(1.8, 2.6)])[draw.permutation(kinds)]
        heights = draw.uniform(0.55, 1.0, count)
        heights[draw.choice(count, 3, replace=False)] = 1.0
        waits = draw.uniform(1.0, 9.0, count), draw.uniform(2.0, 10.0, count)
        down = tuple(int(stroke) for stroke in np.sort(draw.choice(np.arange(2, count - 1), 2, replace=False)))
        return Plan(heights, speeds, *waits, loads, down, float(draw.uniform(240.0, 450.0)))
    if protocol == "usual":
        count = int(draw.integers(9, 13))
        second = draw.uniform(1.4, 1.9) if draw.random() < 0.6 else 1.0
        faster = draw.uniform(1.6, 2.4) if draw.random() < 0.6 else 1.0
        loads = np.where(np.arange(count) < count // 2, 1.0, second)
        speeds = np.where(np.arange(count) % 2 == 0, 1.0, faster)
        heights = np.where(draw.random(count) < 0.3, draw.uniform(0.75, 0.95, count), 1.0)
        waits = draw.uniform(0.5, 4.0, count), draw.uniform(1.0, 6.0, count)
        return Plan(heights, speeds, *waits, loads, (), float(draw.uniform(200.0, 320.0)))
    count = int(draw.integers(6, 11))
    ones = np.ones(count)
    heights = ones - np.abs(draw.normal(0.0, 0.01, count))
    return Plan(heights, ones, 0.1 * ones, 0.1 * ones, ones, (), float(draw.uniform(190.0, 300.0)))


def _move(start: float, end: float, speed: float, acceleration: float) -> Array:
    """Positions of one move with a trapezoid of speed, one a step, the start left out."""
    way = abs(end - start)
    ramp_s = min(speed / acceleration, np.sqrt(way / acceleration))
    top = ramp_s * acceleration
    total_s = way / top + ramp_s
    time_s = np.minimum(np.arange(1, int(np.ceil(total_s / STEP_S)) + 1) * STEP_S, total_s)
    rise = np.minimum(time_s, ramp_s)
    fall = np.maximum(time_s - (total_s - ramp_s), 0.0)
    gone = 0.5 * acceleration * rise**2 + top * (time_s - rise) - 0.5 * acceleration * fall**2
    return start + np.sign(end - start) * gone


def driven(plan: Plan, low: float, top: float, usual_load_n: float, draw: np.random.Generator) -> tuple[Array, Array]:
    """Turns of the shaft and load in N, one value a step; the strokes start at `low` turns and reach `top`."""
    acceleration = float(draw.uniform(5.0, 20.0))
    heights = low + plan.heights * (top - low)
    way = 2.0 * (heights - low)
    waiting = float(plan.dwell_s.sum() + plan.rest_s.sum()) + 30.0 * len(plan.set_down)
    slowest = float(np.sum(way / plan.speeds)) / max(plan.total_s - waiting, 60.0)
    turns, load = [np.full(int(draw.uniform(1.0, 4.0) / STEP_S), low)], []
    load.append(np.full(len(turns[0]), plan.loads[0]))

    def add(stretch: Array, weight: float) -> None:
        turns.append(stretch)
        load.append(np.full(len(stretch), weight))

    for stroke, height in enumerate(heights):
        if stroke in plan.set_down:
            add(np.full(int(draw.uniform(20.0, 40.0) / STEP_S), low), LOWERED)
        weight, speed = float(plan.loads[stroke]), slowest * float(plan.speeds[stroke])
        add(np.full(int(0.5 / STEP_S), low), weight)
        add(_move(low, float(height), speed, acceleration), weight)
        add(np.full(int(plan.dwell_s[stroke] / STEP_S), height), weight)
        add(_move(float(height), low, speed, acceleration), weight)
        add(np.full(int(plan.rest_s[stroke] / STEP_S), low), weight)
    return np.concatenate(turns), _eased(np.concatenate(load)) * usual_load_n


def _eased(load: Array) -> Array:
    """A load that is changed by hand in steps over about half a second."""
    eased, first = load.copy(), int(0.1 / STEP_S)
    for step in np.flatnonzero(np.diff(load)) + 1:
        for number, share in enumerate((0.25, 0.5, 0.75)):
            part = slice(step + number * first, step + (number + 1) * first)
            eased[part] = load[step - 1] + share * (load[step] - load[step - 1])
    return eased
