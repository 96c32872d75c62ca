"""Which run to add: candidates appended to the recording, scored by how far they part what ties."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from pipeline.diagnosis.linear import Fit, Key, Linear
from pipeline.diagnosis.noise import Noise
from pipeline.diagnosis.problem import Problem
from pipeline.diagnosis.record import PHASES, Record
from pipeline.diagnosis.search import Explanation, Search
from pipeline.kinematics import Array
from pipeline.run_yaml import Run

Leg = tuple[float, float, float]  # seconds, motion at its end, load at its end
MOST_STEPS = 6000


class Rig:
    """What the recording shows that the rig can do: range, usual speed, usual load."""

    def __init__(self, record: Record) -> None:
        speed = np.abs(np.gradient(record.motion, record.time_s))
        self.low, self.high = (float(value) for value in np.percentile(record.motion, [0.5, 99.5]))
        self.speed = float(np.median(speed[speed > 0.2 * np.percentile(speed, 99)]))
        self.load = float(np.median(record.load))
        self.stroke_s = (self.high - self.low) / max(self.speed, 1e-9)

    def stroke(self, top: float = 1.0, slower: float = 1.0, load: float = 1.0, dwell_s: float = 0.0) -> list[Leg]:
        """Up, dwell, down; `top` of the range, `slower` times as slow, under `load` times the usual load."""
        high, seconds, force = self.low + top * (self.high - self.low), self.stroke_s * top * slower, load * self.load
        return [
            (0.5, self.low, force),
            (seconds, high, force),
            (max(dwell_s, 0.2), high, force),
            (seconds, self.low, force),
        ]


CANDIDATES: dict[str, Callable[[Rig], list[Leg]]] = {
    "one more stroke as before": lambda rig: rig.stroke(),
    "hold at full twist for 60 s, then unwind and rest for 60 s": lambda rig: [
        *rig.stroke(dwell_s=60.0), (60.0, rig.low, rig.load)
    ],
    "rest at the lowest twist for 120 s, then one stroke": lambda rig: [(120.0, rig.low, rig.load), *rig.stroke()],
    "one stroke at half the speed": lambda rig: rig.stroke(slower=2.0),
    "one stroke at a quarter of the speed": lambda rig: rig.stroke(slower=4.0),
    "one stroke at twice the speed": lambda rig: rig.stroke(slower=0.5),
    "one stroke under half the load": lambda rig: rig.stroke(load=0.5),
    "one stroke under twice the load": lambda rig: rig.stroke(load=2.0),
    "four strokes over the lowest quarter of the twist": lambda rig: rig.stroke(top=0.25) * 4,
    "two strokes over three quarters of the twist": lambda rig: rig.stroke(top=0.75) * 2,
}  # fmt: skip


UNKNOWN = {
    "twist": "repeat one stroke under another load, and one at half the speed",
    "direction": "reverse three times within one stroke, at two speeds",
    "time": "rest for five minutes at the lowest twist, then repeat one stroke",
    "time, as a steady oscillation": "rest for two minutes with the motor off",
    "speed": "repeat one stroke at half and at a quarter of the speed",
    "angle within the turn": "wind ten turns at a tenth of the speed",
    "acceleration": "stop abruptly at half twist and hold for 20 s, three times",
    "load": "hold at half twist and step the load up and down twice",
    "temperature": "hold under the usual load while the rig warms by 5 K",
    "current": "repeat one stroke with the string unhooked from its load",
}  # by the driver that a mismatch follows


def appended(record: Record, legs: list[Leg]) -> Record:
    """The record with legs of straight motion after it; the measured channel is carried on, and means nothing."""
    step_s = max(float(np.median(np.diff(record.time_s))), sum(leg[0] for leg in legs) / MOST_STEPS)
    motion, load, moving = [], [], []
    at, force = float(record.motion[-1]), float(record.load[-1])
    legs = [(2.0, float(np.percentile(record.motion, 0.5)), force), *legs]
    for seconds, to, weight in legs:
        count = max(2, round(seconds / step_s))
        motion.append(np.linspace(at, to, count + 1)[1:])
        load.append(np.full(count, weight))
        moving.append(np.full(count, 0 if to > at else 2 if to < at else 1))
        at = to
    turns = np.concatenate(motion)
    phase = np.concatenate(moving)
    starts = np.concatenate([[False], (np.diff(phase) != 0) & (phase[1:] == PHASES.index("winding"))])
    count = len(turns)

    def longer(column: Array | None, new: Array | None = None) -> Array | None:
        if column is None:
            return None
        return np.concatenate([column, np.full(count, column[-1]) if new is None else new.astype(column.dtype)])

    new = {
        "time_s": record.time_s[-1] + step_s * np.arange(1, count + 1), "motion": turns, "load": np.concatenate(load),
        "stroke": record.stroke[-1] + np.cumsum(starts), "phase": phase,
    }  # fmt: skip
    return Record(**{name: longer(getattr(record, name), new.get(name)) for name in Record.__dataclass_fields__})  # type: ignore[arg-type]


def separation(
    problem: Problem, run: Run, noise: Noise, search: Search, sets: list[Explanation], record: Record
) -> float:
    """Smallest expected gap between two explanations that tie, if the recording went on like `record`."""
    drivers = problem.system.drivers(record, run)
    longer = replace(problem, record=record, drivers=drivers, measured=record.measured, rows=len(record), _terms={})
    catalogue: dict[str, list] = {}
    chosen: list[tuple[Key, ...]] = []
    for one in sets:
        keys = []
        for id_, number in one.keys:
            shape = search.linear.catalogue[id_][number]
            known = catalogue.setdefault(id_, [])
            if shape not in known:
                known.append(shape)
            keys.append((id_, known.index(shape)))
        chosen.append(tuple(keys))
    linear = Linear(longer, search.linear.state, noise, catalogue)
    gaps = []
    for i, one in enumerate(sets):
        columns = linear.columns_of(chosen[i])
        truth = Fit(columns, one.fit.coefficients, 0.0, 0.0, 0)
        gaps += [linear.gap(truth, linear.columns_of(keys)) for j, keys in enumerate(chosen) if j != i]
    return min(gaps)


def best(problem: Problem, run: Run, noise: Noise, search: Search, sets: list[Explanation]) -> str:
    """The candidate that parts the closest pair of the explanations most, in words."""
    rig = Rig(problem.record)
    scores = {
        name: separation(problem, run, noise, search, sets[:4], appended(problem.record, legs(rig)))
        for name, legs in CANDIDATES.items()
    }
    name = max(scores, key=lambda key: scores[key])
    now = separation(problem, run, noise, search, sets[:4], problem.record)
    return f"{name}: it raises the expected gap between what ties from {now:.3g} to {scores[name]:.3g}"


def after_unknown(driver: str) -> str:
    """What to record when nothing in the library explains a mismatch that follows a driver most."""
    return f"{UNKNOWN.get(driver, UNKNOWN['twist'])}: it shows whether the mismatch follows {driver} or only seems to"
