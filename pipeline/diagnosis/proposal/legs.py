"""Runs that could be recorded next: legs of straight motion under a load."""

from collections.abc import Callable

import numpy as np

from ...run.description import Run
from ..document.expected import LegSaid
from ..recording.working_samples import Record

Leg = tuple[float, float, float]  # seconds, motion at its end, load at its end
LAST = 50  # samples that tell the load at the end
FELL = 0.25  # of the range of the loads: one that never fell by more only rose


class Rig:
    """What the recording shows that the rig can do: range, usual speed, usual load."""

    def __init__(self, record: Record) -> None:
        speed = np.abs(np.gradient(record.motion, record.time_s))
        self.low, self.high = (float(value) for value in np.percentile(record.motion, [0.5, 99.5]))
        self.speed = float(np.median(speed[speed > 0.2 * np.percentile(speed, 99)]))
        self.load = float(f"{np.percentile(record.load, 50.0, method='lower'):.3g}")  # one that hung, of two
        self.stroke_s = (self.high - self.low) / max(self.speed, 1e-9)
        self.at, self.under = float(record.motion[-1]), float(f"{np.median(record.load[-LAST:]):.3g}")

    def place(self, share: float) -> float:
        """Motion at a share of the range."""
        return self.low + share * (self.high - self.low)

    def home(self) -> Leg:
        """From where the recording ended to the lowest motion, at the usual speed."""
        return (max(2.0, abs(self.at - self.low) / max(self.speed, 1e-9)), self.low, self.under)

    def stroke(self, top: float = 1.0, slower: float = 1.0, load: float = 1.0, dwell_s: float = 0.0) -> list[Leg]:
        """Up, dwell, down; `top` of the range, `slower` times as slow, under `load` times the usual load."""
        high, seconds, force = self.place(top), self.stroke_s * top * slower, load * self.load
        return [
            (0.5, self.low, force),
            (seconds, high, force),
            (max(dwell_s, 0.2), high, force),
            (seconds, self.low, force),
        ]

    def rest(self, seconds: float) -> list[Leg]:
        """Nothing moves, at the lowest motion under the usual load."""
        return [(seconds, self.low, self.load)]

    def minor(self, slower: float) -> list[Leg]:
        """A stroke that reverses three times on its way up."""
        shares = (0.5, 0.3, 0.7, 0.4, 0.9, 0.6, 1.0, 0.0)
        steps = np.abs(np.diff(np.array([0.0, *shares])))
        return [
            (float(step) * self.stroke_s * slower, self.place(share), self.load)
            for step, share in zip(steps, shares, strict=True)
        ]

    def steps(self) -> list[Leg]:
        """At half the range, the load goes up and down twice."""
        middle, quick = self.place(0.5), 0.5 * self.stroke_s
        loads = [leg for _ in range(2) for factor in (1.5, 1.0) for leg in self._held(middle, factor * self.load)]
        return [(quick, middle, self.load), *loads, (quick, self.low, self.load)]

    def _held(self, at: float, load: float) -> list[Leg]:
        return [(1.0, at, load), (15.0, at, load)]

    def stops(self) -> list[Leg]:
        """Three abrupt stops at half the range."""
        up, middle = 0.5 * self.stroke_s, self.place(0.5)
        return [(up, middle, self.load), (20.0, middle, self.load), (up, self.low, self.load)] * 3


def as_left(record: Record) -> Rig:
    """The rig as its recording left it: where the load only rose it goes on under the last one.

    What a fit makes of a load that falls, no such recording has shown.
    """
    rig = Rig(record)
    fell = float((np.maximum.accumulate(record.load) - record.load).max())
    if fell <= FELL * float(np.ptp(record.load)):
        rig.load = max(rig.load, rig.under)
    return rig


CANDIDATES: dict[str, Callable[[Rig], list[Leg]]] = {
    "one more stroke as before": lambda rig: rig.stroke(),
    "a hold at full twist, then a rest": lambda rig: [*rig.stroke(dwell_s=60.0), *rig.rest(60.0)],
    "a rest at the lowest twist, then one stroke": lambda rig: [*rig.rest(120.0), *rig.stroke()],
    "one stroke at half the speed": lambda rig: rig.stroke(slower=2.0),
    "one stroke at a quarter of the speed": lambda rig: rig.stroke(slower=4.0),
    "one stroke at twice the speed": lambda rig: rig.stroke(slower=0.5),
    "one stroke under half the load": lambda rig: rig.stroke(load=0.5),
    "one stroke under twice the load": lambda rig: rig.stroke(load=2.0),
    "four strokes over the lowest quarter of the twist": lambda rig: rig.stroke(top=0.25) * 4,
    "two strokes over three quarters of the twist": lambda rig: rig.stroke(top=0.75) * 2,
}  # fmt: skip

AFTER_UNKNOWN: dict[str, tuple[str, Callable[[Rig], list[Leg]]]] = {
    "twist": ("another load, then half the speed", lambda rig: [*rig.stroke(load=1.5), *rig.stroke(slower=2.0)]),
    "direction": ("reversals within a stroke, at two speeds", lambda rig: [*rig.minor(1.0), *rig.minor(2.0)]),
    "time": ("a rest at the lowest twist, then one stroke", lambda rig: [*rig.rest(300.0), *rig.stroke()]),
    "time, as a steady oscillation": (
        "a rest with the motor off, then one stroke",
        lambda rig: [*rig.rest(120.0), *rig.stroke()],
    ),
    "speed": ("half and a quarter of the speed", lambda rig: [*rig.stroke(slower=2.0), *rig.stroke(slower=4.0)]),
    "angle within the turn": ("a slow stroke", lambda rig: rig.stroke(top=0.4, slower=10.0)),
    "acceleration": ("abrupt stops at half twist", lambda rig: rig.stops()),
    "load": ("load steps at half twist", lambda rig: rig.steps()),
    "temperature": (
        "a long rest while the rig warms by 5 K, then one stroke",
        lambda rig: [*rig.rest(900.0), *rig.stroke()],
    ),
    "current": ("one stroke under half the load", lambda rig: [*rig.stroke(load=0.5), *rig.stroke()]),
}  # by the driver that a mismatch follows; fmt: skip


def as_legs(legs: list[Leg], run: Run) -> list[LegSaid]:
    """Legs for a machine to follow: how long each takes, and the driver and the load at its end, by their channels."""
    driver, load_name = run.system.driver, run.system.load if any(force for _, _, force in legs) else None
    entries = []
    for seconds, to, force in legs:
        leg = {"seconds": seconds, driver: to}
        entries.append(leg | {load_name: force} if load_name else leg)
    return entries
