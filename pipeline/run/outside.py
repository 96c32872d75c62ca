"""Where a planned motion leaves what was recorded, row by row: nothing there says how well a simulator does."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground.kinematics import Array
from .description import Run
from .turning import turning_points

STANDS, UNWOUND, SHORT_S = 0.02, 0.05, 1.0  # of the highest speed: slower stands; of the range; not worth a word
LONGER = 2.0  # times the longest hold that was recorded: what is slow goes on in a longer one
ROOM = 0.05  # of what was recorded: a motion that leaves it by less stays inside
SLOWER = 0.5  # of the slowest stroke that was recorded: what lasts goes on in a slower one
WINDOW_S = 0.2  # over which a speed is taken: less is encoder noise
TURNS, NEAR = 0.02, 0.1  # of the recorded range: a smaller way back is no reversal; so near it was recorded

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Outside:
    """Which rows of a plan are outside, of shape (samples,), and what the plan asks for there, in words."""

    rows: Mask
    asks: list[str]


def outside(run: Run, samples: pd.DataFrame, recorded: pd.DataFrame, turns_count: bool = False) -> Outside:
    """The rows of a planned motion that leave what was recorded; a share `ROOM` of it is no leaving.

    `turns_count`: whether an effect at work remembers where the motion turned, so that other reversals count.
    """
    kept = [name for name in samples.columns if name not in ("time_s", run.system.channel) and name in recorded]
    parts = [_beyond_range(name, samples[name].to_numpy(), recorded[name].to_numpy()) for name in kept]
    planned, before = (_Motion.of(table, run.system.driver) for table in (samples, recorded))
    parts += [_faster(planned, before, run.system.driver)]
    parts += [_longer(planned, before, name, wound) for name, wound in (("hold", True), ("rest", False))]
    parts += [_slower(planned, before, run.system.driver)]
    parts += [_turned(planned, before, run.system.driver)] if turns_count else []
    rows = np.logical_or.reduce([rows for rows, _ in parts])
    return Outside(rows, [asks for _, asks in parts if asks])


@dataclass(frozen=True)
class _Motion:
    """Time in s, a motion, and its speed over `WINDOW_S`, per second; each of shape (samples,)."""

    time_s: Array
    way: Array
    speed: Array

    @classmethod
    def of(cls, samples: pd.DataFrame, driver: str) -> "_Motion":
        time_s, way = samples["time_s"].to_numpy(float), samples[driver].to_numpy(float)
        half_s = max(0.5 * WINDOW_S, float(np.median(np.diff(time_s))))
        first_s, last_s = np.maximum(time_s - half_s, time_s[0]), np.minimum(time_s + half_s, time_s[-1])
        moved = np.interp(last_s, time_s, way) - np.interp(first_s, time_s, way)
        return cls(time_s, way, np.abs(moved) / (last_s - first_s))

    @property
    def fastest(self) -> float:
        return float(self.speed.max())

    def moves(self, least: float) -> Mask:
        """Where it does not stand, beside a highest speed of `least` or its own."""
        return np.asarray(self.speed >= STANDS * max(min(least, self.fastest), 1e-9))

    @property
    def high(self) -> Mask:
        """Where it is wound: further than a part of its range from its lowest."""
        return np.asarray(self.way > self.way.min() + UNWOUND * np.ptp(self.way))

    @property
    def range(self) -> float:
        return float(np.ptp(self.way))


def _beyond_range(name: str, planned: Array, recorded: Array) -> tuple[Mask, str]:
    """Rows in which a channel is lower or higher than recorded."""
    least, most = float(recorded.min()), float(recorded.max())
    room = ROOM * max(most - least, abs(most) * ROOM)
    rows = (planned < least - room) | (planned > most + room)
    low, high = float(planned.min()), float(planned.max())
    asks = f"{name} of {low:.4g} to {high:.4g} ({least:.4g} to {most:.4g} were recorded)"
    return rows, asks if rows.any() else ""


def _faster(planned: _Motion, recorded: _Motion, driver: str) -> tuple[Mask, str]:
    """Rows that move faster than anything that was recorded."""
    rows = planned.speed > (1.0 + ROOM) * recorded.fastest
    asks = f"{driver} that change by {planned.fastest:.3g} a second (at most {recorded.fastest:.3g} were recorded)"
    return rows, asks if rows.any() else ""


def _longer(planned: _Motion, recorded: _Motion, name: str, wound: bool) -> tuple[Mask, str]:
    """Rows of a stand, wound or unwound, that come after `LONGER` times the longest that was recorded."""
    stood_s = float(_lasted(recorded, ~recorded.moves(np.inf) & (recorded.high == wound)).max())
    lasted_s = _lasted(planned, ~planned.moves(recorded.fastest) & (planned.high == wound))
    rows = lasted_s > max(LONGER * stood_s, SHORT_S)
    asks = f"a {name} of {lasted_s.max():.3g} s (at most {stood_s:.3g} s were recorded)"
    return rows, asks if rows.any() else ""


def _slower(planned: _Motion, recorded: _Motion, driver: str) -> tuple[Mask, str]:
    """Rows that go on for longer than recorded at less than `SLOWER` of the slowest recorded stroke's speed."""
    moves, points = recorded.moves(np.inf), turning_points(recorded.way, ROOM * recorded.range)
    legs = [np.flatnonzero(moves[first:last]) + first for first, last in pairwise(points)]
    speeds = [float(np.median(recorded.speed[leg])) for leg in legs if len(leg)]
    nothing = np.zeros(len(planned.way), bool)
    if not speeds:
        return nothing, ""
    slowest = min(speeds)
    slow, slow_before = (
        motion.moves(recorded.fastest) & (motion.speed < SLOWER * slowest) for motion in (planned, recorded)
    )
    least_s = max(LONGER * float(_lasted(recorded, slow_before).max()), SHORT_S)
    lasted_s, rows = _lasted(planned, slow), nothing
    for first, last in _spans(slow):
        if lasted_s[last - 1] > least_s:
            rows[first:last] = True
    if not rows.any():
        return rows, ""
    speed = float(np.median(planned.speed[rows]))
    return rows, f"{driver} that change by only {speed:.3g} a second (at least {slowest:.3g} were recorded)"


def _turned(planned: _Motion, recorded: _Motion, driver: str) -> tuple[Mask, str]:
    """Rows from a reversal inside the recorded range, near which none was recorded, to the next one."""
    rows, places = np.zeros(len(planned.way), bool), []
    known = {up: values for up, values in _turns(recorded, recorded.range)[1].items()}
    points, _ = _turns(planned, recorded.range)
    low, high = recorded.way.min(), recorded.way.max()
    for before, point, after in zip(points[:-2], points[1:-1], points[2:], strict=True):
        value = planned.way[point]
        near = np.abs(known[bool(value > planned.way[before])] - value) <= NEAR * recorded.range
        if low <= value <= high and not near.any():
            rows[point : after + 1] = True
            places.append(float(value))
    many = f"{len(places)} reversals inside the range, the first" if len(places) > 1 else "a reversal inside the range,"
    asks = f"{many} at {driver} of {places[0]:.4g} (none was recorded near there)" if places else ""
    return rows, asks


def _turns(motion: _Motion, span: float) -> tuple[NDArray[np.intp], dict[bool, Array]]:
    """Samples at which a motion turns, with its ends; and where it turned, by whether that was at a top."""
    points = turning_points(motion.way, TURNS * span)
    values, before = motion.way[points[1:-1]], motion.way[points[:-2]]
    return points, {True: values[values > before], False: values[values <= before]}


def _spans(mask: Mask) -> list[tuple[int, int]]:
    """First row of each stretch in which a mask holds, and the row after its last."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [(int(first), int(last)) for first, last in zip(edges[::2], edges[1::2], strict=True)]


def _lasted(motion: _Motion, mask: Mask) -> Array:
    """For how long a mask has held already, in s, 0 where it does not. Shape (samples,)."""
    lasted_s = np.zeros(len(mask))
    for first, last in _spans(mask):
        lasted_s[first:last] = motion.time_s[first:last] - motion.time_s[first]
    return lasted_s
