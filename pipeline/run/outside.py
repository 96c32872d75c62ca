"""Where a planned motion leaves what was recorded, row by row: nothing there says how well a simulator does."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd

from .course import Course, Mask, Recorded, stretches
from .description import Run

SHORT_S = 1.0  # not worth a word
LONGER = 2.0  # times the longest hold that was recorded: what is slow goes on in a longer one
ROOM = 0.05  # of what was recorded: a motion that leaves it by less stays inside
SLOWER = 0.5  # of the slowest stroke's speed: what lasts goes on in a slower one
OTHER = 1.25  # times as slow or as fast as any stroke: another speed, where it matters or nobody knows whether it does
NEAR = 0.1  # of the recorded range: so near it was recorded


@dataclass(frozen=True)
class Outside:
    """Which rows of a plan are outside, of shape (samples,), and what the plan asks for there, in words."""

    rows: Mask
    asks: list[str]


def outside(
    run: Run, samples: pd.DataFrame, recorded: Recorded, turns_count: bool = False, paced: Sequence[str] = ()
) -> Outside:
    """The rows of a planned motion that leave what was recorded; a share `ROOM` of it is no leaving.

    `turns_count`: whether an effect at work remembers where the motion turned, so that other reversals count. `paced`:
    the effects, at work or open, that follow speed or time, so that a speed counts as another one sooner.
    """
    driver, channel = run.system.driver, run.system.channel
    kept = [name for name in samples.columns if name not in ("time_s", channel)]
    kept = [name for name in kept if all(name in table for table in recorded.samples)]
    parts = [_beyond_range(name, samples, recorded) for name in kept]
    planned = Course.of(samples, driver)
    parts += [_faster(planned, recorded)]
    parts += [_longer(planned, recorded, name, wound) for name, wound in (("hold", True), ("rest", False))]
    parts += [_slower(planned, recorded, paced), _quicker(planned, recorded, paced)]
    parts += [_turned(planned, recorded)] if turns_count else []
    rows = np.logical_or.reduce([rows for rows, _ in parts])
    return Outside(rows, [asks for _, asks in parts if asks])


def _beyond_range(name: str, samples: pd.DataFrame, recorded: Recorded) -> tuple[Mask, str]:
    """Rows in which a channel is lower or higher than recorded."""
    planned = samples[name].to_numpy()
    least = min(float(table[name].min()) for table in recorded.samples)
    most = max(float(table[name].max()) for table in recorded.samples)
    room = ROOM * max(most - least, abs(most) * ROOM)
    rows = (planned < least - room) | (planned > most + room)
    low, high = float(planned.min()), float(planned.max())
    asks = f"{name} of {low:.4g} to {high:.4g} ({least:.4g} to {most:.4g} were recorded)"
    return rows, asks if rows.any() else ""


def _faster(planned: Course, recorded: Recorded) -> tuple[Mask, str]:
    """Rows that move faster than anything that was recorded."""
    rows = planned.speed > (1.0 + ROOM) * recorded.fastest
    asks = f"{recorded.driver} that change by {planned.fastest:.3g} a second"
    return rows, f"{asks} (at most {recorded.fastest:.3g} were recorded)" if rows.any() else ""


def _longer(planned: Course, recorded: Recorded, name: str, wound: bool) -> tuple[Mask, str]:
    """Rows of a stand, wound or unwound, that come after `LONGER` times the longest that was recorded."""
    stood_s = recorded.longest_s(name)
    lasted_s = planned.lasted_s(~planned.moves(recorded.fastest) & (planned.high == wound))
    rows = lasted_s > max(LONGER * stood_s, SHORT_S)
    asks = f"a {name} of {lasted_s.max():.3g} s (at most {stood_s:.3g} s were recorded)"
    return rows, asks if rows.any() else ""


def _slower(planned: Course, recorded: Recorded, paced: Sequence[str]) -> tuple[Mask, str]:
    """Rows that go on for longer than recorded at clearly less than the slowest recorded stroke's speed."""
    slowest = min(recorded.speeds)
    most = slowest * (1.0 / OTHER if paced or recorded.one_speed else SLOWER)
    rows = _going_on(
        planned, recorded, [course.moves(recorded.fastest) & (course.speed < most) for course in recorded.courses],
        planned.moves(recorded.fastest) & (planned.speed < most),
    )  # fmt: skip
    speed = float(np.median(planned.speed[rows])) if rows.any() else 0.0
    asks = f"{recorded.driver} that change by only {speed:.3g} a second"
    return rows, f"{asks} ({_known(f'at least {slowest:.3g} were', recorded, paced)})" if rows.any() else ""


def _quicker(planned: Course, recorded: Recorded, paced: Sequence[str]) -> tuple[Mask, str]:
    """Rows that go on for longer than recorded at clearly more than the fastest stroke's speed, where that matters.

    Moments of the recording may have been as fast.
    """
    least = OTHER * max(recorded.speeds)
    if not (paced or recorded.one_speed):
        return np.zeros(len(planned.way), bool), ""
    fast = planned.speed > least
    rows = _going_on(planned, recorded, [course.speed > least for course in recorded.courses], fast)
    rows &= planned.speed <= (1.0 + ROOM) * recorded.fastest  # what is faster is named already
    speed = float(np.median(planned.speed[rows])) if rows.any() else 0.0
    asks = f"strokes whose {recorded.driver} change by {speed:.3g} a second"
    known = _known(f"at most {max(recorded.speeds):.3g} over a stroke were", recorded, paced)
    return rows, f"{asks} ({known})" if rows.any() else ""


def _known(ends: str, recorded: Recorded, paced: Sequence[str]) -> str:
    """What is known of other speeds, in words."""
    known = f"one speed was recorded, {np.median(recorded.speeds):.3g}" if recorded.one_speed else f"{ends} recorded"
    if paced:
        return f"{known}, and {' and '.join(paced)} {'follow' if len(paced) > 1 else 'follows'} speed or time"
    return f"{known}, and nothing in it says what another does" if recorded.one_speed else known


def _going_on(planned: Course, recorded: Recorded, before: Sequence[Mask], rows: Mask) -> Mask:
    """The stretches of some rows that last for longer than `LONGER` times the longest `before`, a mask a recording."""
    pairs = zip(recorded.courses, before, strict=True)
    least_s = max(LONGER * max(float(course.lasted_s(mask).max()) for course, mask in pairs), SHORT_S)
    lasted_s, going_on = planned.lasted_s(rows), np.zeros(len(rows), bool)
    for first, last in stretches(rows):
        going_on[first:last] = lasted_s[last - 1] > least_s
    return going_on


def _turned(planned: Course, recorded: Recorded) -> tuple[Mask, str]:
    """Rows from a reversal inside the recorded range, near which none was recorded, to the next one."""
    rows, places = np.zeros(len(planned.way), bool), []
    low, high = recorded.ends
    points, _ = planned.turns(high - low)
    for before, point, after in zip(points[:-2], points[1:-1], points[2:], strict=True):
        value = planned.way[point]
        near = np.abs(recorded.turns[bool(value > planned.way[before])] - value) <= NEAR * (high - low)
        if low <= value <= high and not near.any():
            rows[point : after + 1] = True
            places.append(float(value))
    many = f"{len(places)} reversals inside the range, the first" if len(places) > 1 else "a reversal inside the range,"
    asks = f"{many} at {recorded.driver} of {places[0]:.4g} (none was recorded near there)" if places else ""
    return rows, asks
