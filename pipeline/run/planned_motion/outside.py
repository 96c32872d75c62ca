"""The rows of a planned motion outside the recorded range: no recording tests a simulator there."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ...ground.numbers import spans
from ...ground.units import unit_of
from ..description import Run
from .motion_course import Course, Mask, Recorded
from .planned_limits import (
    LONGER,
    NEAR,
    ROOM,
    SHORT_S,
    STILL,
    from_on,
    least_speed,
    longest_stand_s,
    most_speed,
    stands_still,
    up_to,
)

SOME = f"{100.0 * ROOM:.0f} %"  # the room, as a person reads it

Part = tuple[Mask, str, str]  # rows of a plan that are outside, of shape (samples,); what it asks for there; the mend


@dataclass(frozen=True)
class Outside:
    """The rows of a plan outside the recorded range, of shape (samples,); the reasons, and the mends.

    `too_slow_below`: the speed below which its slow rows are outside, in the driver's unit per second; 0 without such.
    """

    rows: Mask
    asks: list[str]
    mends: list[str]
    too_slow_below: float = 0.0


def outside(
    run: Run, samples: pd.DataFrame, recorded: Recorded, turns_count: bool = False, paced: Sequence[str] = ()
) -> Outside:
    """The rows of a planned motion outside the recorded range; up to a share `ROOM` beyond it still counts as inside.

    `turns_count`: whether an acting effect remembers where the motion turned, so that new reversals count as outside.
    `paced`: acting or open effects that follow speed or time; with them a speed counts as new sooner.
    """
    driver, channel = run.system.driver, run.system.channel
    kept = [name for name in samples.columns if name not in ("time_s", channel)]
    kept = [name for name in kept if all(name in table for table in recorded.samples)]
    parts = [_beyond_range(name, samples, recorded) for name in kept]
    planned = Course.of(samples, driver)
    parts += [_faster(planned, recorded, paced)]
    parts += [_longer(planned, recorded, name, wound) for name, wound in (("hold", True), ("rest", False))]
    slower = _slower(planned, recorded, paced)
    parts += [slower, _quicker(planned, recorded, paced)]
    parts += [_turned(planned, recorded)] if turns_count else []
    rows = np.logical_or.reduce([rows for rows, _, _ in parts])
    mends = dict.fromkeys(mend for _, asks, mend in parts if asks)
    return Outside(
        rows, [asks for _, asks, _ in parts if asks], list(mends), _least(recorded, paced) if slower[1] else 0.0
    )


def _beyond_range(name: str, samples: pd.DataFrame, recorded: Recorded) -> Part:
    """Rows in which a channel is lower or higher than recorded."""
    planned = samples[name].to_numpy()
    least = min(float(table[name].min()) for table in recorded.samples)
    most = max(float(table[name].max()) for table in recorded.samples)
    low, high = float(planned.min()), float(planned.max())
    if stands_still(least, most):
        usual = float(np.median(np.concatenate([table[name].to_numpy() for table in recorded.samples])))
        rows = np.abs(planned - usual) > STILL * abs(usual) + 0.5 * (most - least)
        about = f"{usual:.3g} was recorded, and it stood still: inside are {100.0 * STILL:.0f} % more or less"
        return rows, f"{name} of {low:.4g} to {high:.4g} ({about})" if rows.any() else "", f"keep {name} at {usual:.3g}"
    room = ROOM * max(most - least, abs(most) * ROOM)
    rows = (planned < least - room) | (planned > most + room)
    asks = f"{name} of {low:.4g} to {high:.4g} ({least:.4g} to {most:.4g} were recorded)"
    return rows, asks if rows.any() else "", f"keep {name} within {least:.4g} to {most:.4g}"


def _faster(planned: Course, recorded: Recorded, paced: Sequence[str]) -> Part:
    """Rows that move faster than anything that was recorded."""
    limit = (1.0 + ROOM) * recorded.fastest
    rows = planned.speed > limit
    why = f"the fastest that was recorded, {recorded.fastest:.3g}, and {SOME}"
    asks = f"{recorded.driver} that change by {planned.fastest:.3g} a second (inside up to {up_to(limit)}: {why})"
    return rows, asks if rows.any() else "", _move_slower(recorded, paced)


def _longer(planned: Course, recorded: Recorded, name: str, wound: bool) -> Part:
    """Rows of a stand, wound or unwound, that come later in it than `LONGER` times the longest recorded stand."""
    stood_s = recorded.longest_s(name)
    limit_s = longest_stand_s(stood_s)
    lasted_s = planned.lasted_s(~planned.moves(recorded.fastest) & (planned.high == wound))
    rows = lasted_s > limit_s
    why = f"twice the longest that was recorded, {stood_s:.3g} s, and {SOME}"
    asks = f"a {name} of {lasted_s.max():.3g} s (inside for its first {up_to(limit_s)} s: {why})"
    return rows, asks if rows.any() else "", f"end each {name} after {up_to(limit_s)} s"


def _slower(planned: Course, recorded: Recorded, paced: Sequence[str]) -> Part:
    """Rows that move clearly slower than the slowest recorded stroke, for longer than in the recording."""
    slowest, least = min(recorded.speeds), _least(recorded, paced)
    rows = _going_on(
        planned, recorded, [course.moves(recorded.fastest) & (course.speed < least) for course in recorded.courses],
        planned.moves(recorded.fastest) & (planned.speed < least),
    )  # fmt: skip
    speed, unit = float(np.median(planned.speed[rows])) if rows.any() else 0.0, unit_of(recorded.driver)
    share = "four fifths" if _other(recorded, paced) else "half"
    limit = f"Inside from {from_on(least)} on: {share} of it, less {SOME}"
    why = f"{_recorded_speed('slowest', slowest, recorded)}. {limit}{_since(recorded, paced)}"
    asks = f"{recorded.driver} that change by only {speed:.3g} a second. {why}"
    return rows, asks if rows.any() else "", f"move at {from_on(least)} {unit}/s or faster"


def _quicker(planned: Course, recorded: Recorded, paced: Sequence[str]) -> Part:
    """Rows that move clearly faster than the fastest recorded stroke, for longer than recorded, if speed matters.

    Moments of the recording may have been as fast.
    """
    limit = most_speed(max(recorded.speeds), np.inf, True)
    if not _other(recorded, paced):
        return np.zeros(len(planned.way), bool), "", ""
    fast = planned.speed > limit
    rows = _going_on(planned, recorded, [course.speed > limit for course in recorded.courses], fast)
    rows &= planned.speed <= (1.0 + ROOM) * recorded.fastest  # what is faster is named already
    speed = float(np.median(planned.speed[rows])) if rows.any() else 0.0
    fastest = _recorded_speed("fastest", max(recorded.speeds), recorded)
    why = f"Inside up to {up_to(limit)}: five quarters of it, and {SOME}{_since(recorded, paced)}"
    asks = f"strokes whose {recorded.driver} change by {speed:.3g} a second. {fastest}. {why}"
    return rows, asks if rows.any() else "", _move_slower(recorded, paced)


def _other(recorded: Recorded, paced: Sequence[str]) -> bool:
    """Whether a speed counts as new sooner: speed matters, or the recording cannot tell whether it does."""
    return bool(paced) or recorded.one_speed


def _least(recorded: Recorded, paced: Sequence[str]) -> float:
    """The speed from which on a plan is inside, in the driver's unit per second."""
    return least_speed(min(recorded.speeds), _other(recorded, paced))


def _move_slower(recorded: Recorded, paced: Sequence[str]) -> str:
    """The mend for rows that are too fast by any rule."""
    limit = most_speed(max(recorded.speeds), recorded.fastest, _other(recorded, paced))
    return f"move at {up_to(limit)} {unit_of(recorded.driver)}/s or slower"


def _recorded_speed(which: str, speed: float, recorded: Recorded) -> str:
    """The recorded speed that a limit is a share of: a sentence without its full stop."""
    if recorded.one_speed:
        return f"Recorded was one speed, {speed:.3g}"
    return f"The {which} stroke that was recorded had {speed:.3g}"


def _since(recorded: Recorded, paced: Sequence[str]) -> str:
    """Why a speed counts as new so soon: a sentence after a full stop; empty where it does not."""
    if paced:
        return f". So near, since {' and '.join(paced)} {'follow' if len(paced) > 1 else 'follows'} speed or time"
    return ". Nothing that was recorded says what another speed does" if recorded.one_speed else ""


def _going_on(planned: Course, recorded: Recorded, before: Sequence[Mask], rows: Mask) -> Mask:
    """The stretches of rows that last longer than `LONGER` times the longest in `before`, masks by recording."""
    pairs = zip(recorded.courses, before, strict=True)
    least_s = max(LONGER * max(float(course.lasted_s(mask).max()) for course, mask in pairs), SHORT_S)
    lasted_s, going_on = planned.lasted_s(rows), np.zeros(len(rows), bool)
    for first, last in spans.of_mask(rows):
        going_on[first:last] = lasted_s[last - 1] > least_s
    return going_on


def _turned(planned: Course, recorded: Recorded) -> Part:
    """Rows after a reversal inside the recorded range where no recording reversed, up to the next reversal."""
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
    return rows, asks, "turn where the recorded motion turned"
