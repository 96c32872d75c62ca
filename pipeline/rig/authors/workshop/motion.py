"""The protocol as a cam sheet: strokes with their height, speed, load, dwell and rest, laid out on the clock."""

from dataclasses import dataclass

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import Protocol


@dataclass(frozen=True)
class Stroke:
    """One line of the cam sheet: height over the full one, relative speed, load, and pauses."""

    height: float
    speed: float
    load_n: float
    dwell_s: float
    rest_s: float


@dataclass(frozen=True)
class Course:
    """The motion on the clock: time, twist over its range, load, and the stroke's number."""

    time_s: Array
    height: Array
    load_n: Array
    stroke: Array


def _dealt(rng: np.random.Generator, choices: Array, count: int) -> Array:
    """Choices dealt evenly over strokes, shuffled."""
    return rng.permutation(np.resize(rng.permutation(choices), count))


def cam_sheet(rng: np.random.Generator, protocol: Protocol, load_n: float) -> list[Stroke]:
    """Draw the strokes of a protocol about a middle load."""
    if protocol == "poor":
        count = int(rng.integers(6, 11))
        return [Stroke(1.0, 1.0, load_n, 0.0, 0.0)] * count
    if protocol == "usual":
        count = int(rng.integers(9, 13))
        loads = np.array([1.0, rng.uniform(1.4, 2.2)][: int(rng.integers(1, 3))])
        speeds = np.array([1.0, rng.uniform(1.7, 3.0)][: int(rng.integers(1, 3))])
        heights = np.ones(count)
        dwells, rests = rng.uniform(1.0, 4.0, count), rng.uniform(2.0, 7.0, count)
    else:
        count = int(rng.integers(9, 17))
        loads = np.array([rng.uniform(0.45, 0.65), 1.0, rng.uniform(1.5, 2.0)])
        speeds = np.array([rng.uniform(0.4, 0.6), 1.0, rng.uniform(1.7, 2.5)])
        heights = _dealt(rng, np.array([1.0, 1.0, rng.uniform(0.75, 0.9), rng.uniform(0.5, 0.7)]), count)
        dwells, rests = rng.uniform(2.0, 9.0, count), rng.uniform(3.0, 14.0, count)
    of_load, of_speed = _dealt(rng, loads, count) * load_n, _dealt(rng, speeds, count)
    lines = zip(heights, of_speed, of_load, dwells, rests, strict=True)
    return [Stroke(*map(float, line)) for line in lines]


def cam(share: Array, ramp: float) -> Array:
    """Way over its length against time over its length, on a cam with straight ramps of speed at both ends."""
    full = ramp * (1.0 - ramp)
    rising, falling = np.square(share) / (2.0 * full), 1.0 - np.square(1.0 - share) / (2.0 * full)
    even = (share - ramp / 2.0) / (1.0 - ramp)
    return np.where(share < ramp, rising, np.where(share > 1.0 - ramp, falling, even))


def least_moving_s(strokes: list[Stroke], top_turns: float, fastest: float) -> float:
    """How long all the moves last at the least, in s, if the motor makes `fastest` turns/s at most."""
    return sum(2.0 * line.height / line.speed for line in strokes) * max(s.speed for s in strokes) * top_turns / fastest


def laid_out(rng: np.random.Generator, strokes: list[Stroke], rate_hz: float, moving_s: float) -> Course:
    """The strokes on an even clock, at speeds such that all the moves together last `moving_s`."""
    wanted = sum(2.0 * stroke.height / stroke.speed for stroke in strokes)
    second = moving_s / wanted  # of one full winding at relative speed 1
    ramp_s = rng.uniform(0.15, 0.6)
    pieces: list[tuple[float, float, float, float, int]] = []  # lasting, from, to, load, stroke
    first_s = 0.0 if strokes[0].rest_s == 0.0 else float(rng.uniform(1.0, 4.0))
    pieces.append((first_s, 0.0, 0.0, strokes[0].load_n, 1))
    for number, stroke in enumerate(strokes, 1):
        lasting = second * stroke.height / stroke.speed
        following = strokes[min(number, len(strokes) - 1)].load_n
        pieces.append((lasting, 0.0, stroke.height, stroke.load_n, number))
        pieces.append((stroke.dwell_s, stroke.height, stroke.height, stroke.load_n, number))
        pieces.append((lasting, stroke.height, 0.0, stroke.load_n, number))
        pieces.append((stroke.rest_s / 2.0, 0.0, 0.0, stroke.load_n, number))
        pieces.append((stroke.rest_s / 2.0, 0.0, 0.0, following, min(number + 1, len(strokes))))
    ends = np.cumsum([piece[0] for piece in pieces])
    time_s = np.arange(0.0, ends[-1], 1.0 / rate_hz)
    at = np.minimum(np.searchsorted(ends, time_s, side="right"), len(pieces) - 1)
    lasts, begin, end, load, number_of = (np.array(column) for column in zip(*pieces, strict=True))
    share = np.clip((time_s - (ends - lasts)[at]) / np.maximum(lasts[at], 1e-9), 0.0, 1.0)
    ramps = np.minimum(0.3, ramp_s / np.maximum(lasts[at], 1e-9))
    height = begin[at] + (end - begin)[at] * cam(share, ramps)
    ticks = max(1, round(0.6 * rate_hz))  # a weight is put on within this
    padded = np.concatenate([np.full(ticks, load[0]), load[at]])
    smooth = np.convolve(padded, np.full(ticks, 1.0 / ticks))[ticks : ticks + len(time_s)]
    return Course(time_s, height, smooth, number_of[at])
