"""What a recording covers: the loads that hung, how fast it moved, how long it stood, wound and at rest."""

from collections.abc import Sequence
from typing import TypedDict

import numpy as np

from ...ground.kinematics import Array
from ...run.planned_motion.motion_course import Course, Recorded, longest_s
from ...run.planned_motion.planned_limits import NEAR
from ...run.strokes import of_samples
from ..document.evidence import Covered
from .recorded_run import RecordedRun
from .working_samples import PHASES, Record

ENDS = (1.0, 99.0)  # percentiles of the samples: values beyond are noise or last a moment


class Paces(TypedDict, total=False):
    """Speeds in the motion's unit per second: of the slowest and the fastest stroke, and the highest of a moment."""

    strokes_per_s: list[float]
    fastest_per_s: float


def covered(record: Record) -> Covered:
    """Lowest and highest load, slowest and fastest stroke; as `diagnosis.json` holds them.

    Loads in the load channel's unit, speeds in the motion's unit per second. `temperature_c`, where one was logged, is
    its lowest and highest in °C.
    """
    moving = np.isin(record.phase, [PHASES.index("winding"), PHASES.index("unwinding")])
    speeds = [
        float(np.median(np.abs(record.velocity[moving & (record.stroke == stroke)])))
        for stroke in np.unique(record.stroke[moving])
    ]
    logged = record.temperature_c
    warm: Covered = {} if logged is None else {"temperature_c": [float(end) for end in np.percentile(logged, ENDS)]}
    return warm | {
        "load": [float(end) for end in np.percentile(record.load, ENDS)],
        "speed_per_s": [min(speeds, default=0.0), max(speeds, default=0.0)],
    }


def pauses(recorded: Sequence[RecordedRun]) -> dict[str, float]:
    """The longest hold and the longest rest of some runs, in s, at their own rate: as a planned motion is told them."""
    longest: dict[str, list[float]] = {"hold": [], "rest": []}
    for each in recorded:
        time_s, phase = each.samples["time_s"].to_numpy(), of_samples(each.strokes)[1]
        for name, lasted_s in longest.items():
            lasted_s.append(longest_s(time_s, phase == name))
    return {f"longest_{name}_s": max(lasted_s) for name, lasted_s in longest.items()}


def paces(recorded: Sequence[RecordedRun]) -> Paces:
    """The usual speeds of the slowest and the fastest stroke, and the highest speed of a moment, as a plan meets them.

    In the motion's unit per second.
    """
    samples, strokes = [each.samples for each in recorded], [each.strokes for each in recorded]
    all_recorded = Recorded(samples, strokes, recorded[0].run.system.driver)
    return {
        "strokes_per_s": [min(all_recorded.speeds), max(all_recorded.speeds)],
        "fastest_per_s": all_recorded.fastest,
    }


def reversals(recorded: Sequence[RecordedRun]) -> dict[str, dict[str, list[list[float]]]]:
    """Where the motion of some runs turned, at its tops and at its bottoms, in the motion's unit.

    Each place is its lowest and its highest reversal: those so near each other that a plan may turn anywhere between.
    """
    courses = [Course.of(each.samples, each.run.system.driver) for each in recorded]
    whole = max(float(course.way.max()) for course in courses) - min(float(course.way.min()) for course in courses)
    turned = [course.turns(whole)[1] for course in courses]
    at_end = {end: np.concatenate([each[top] for each in turned]) for end, top in (("top", True), ("bottom", False))}
    return {"turned": {end: _places(values, whole) for end, values in at_end.items()}}


def _places(values: Array, whole: float) -> list[list[float]]:
    """Values, of shape (reversals,), as stretches whose neighbours are within reach of each other."""
    ordered = np.sort(values)
    cuts = np.flatnonzero(np.diff(ordered) > 2.0 * NEAR * whole) + 1
    return [[float(part[0]), float(part[-1])] for part in np.split(ordered, cuts) if len(part)]
