"""How far winding and unwinding part at one place: the loop that an effect draws over whole strokes of a recording."""

from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array
from ..fit.problem import Problem
from ..recording.working_samples import PHASES

OTHER_LOAD = 0.2  # of the highest load of the strokes: loads that differ by less count as one
WHOLE = 0.9  # of the motion's range: a stroke that covers less is no whole one
BINS, LEAST_BINS = 60, 10  # of the motion's range, over which ways are compared; of these, samples lie in so many


@dataclass(frozen=True)
class Loop:
    """The widest opening of a loop, in the reading's unit, and the motion where it is so wide, in its own unit."""

    width: float
    motion: float
    by_load: tuple[tuple[float, float], ...] = ()  # the lowest and the highest load, with the width under each


def widest(problem: Problem, effect: Array) -> Loop | None:
    """The largest difference of an effect between both ways at one motion: its median over whole strokes, and where.

    The first stroke of a run is left out, since it begins from rest. None where no whole stroke follows it, or where
    the effect opens no loop. `effect` in the reading's unit, shape (samples,). Loads in the load channel's.
    """
    record, openings, places, loads = problem.record, [], [], []
    edges = np.linspace(record.motion.min(), record.motion.max(), BINS + 1)
    middles = 0.5 * (edges[1:] + edges[:-1])
    up, down = (record.phase == PHASES.index(phase) for phase in ("winding", "unwinding"))
    for run in np.unique(record.run_index):
        inside = record.run_index == run
        for stroke in np.unique(record.stroke[inside & (up | down)])[1:]:
            ways = [
                _means(record.motion, effect, inside & (record.stroke == stroke) & way, edges) for way in (up, down)
            ]
            apart = np.abs(ways[0] - ways[1])
            reached = np.flatnonzero(np.isfinite(apart))
            if len(reached) == 0 or middles[reached[-1]] - middles[reached[0]] < WHOLE * np.ptp(middles):
                continue
            place = reached[int(np.argmax(apart[reached]))]
            openings.append(float(apart[place]))
            places.append(float(middles[place]))
            loads.append(float(np.median(record.load[inside & (record.stroke == stroke)])))
    width = float(np.median(openings)) if openings else 0.0
    return Loop(width, float(np.median(places)), _by_load(openings, loads)) if width > 0.0 else None


def _by_load(openings: list[float], loads: list[float]) -> tuple[tuple[float, float], ...]:
    """The lowest and the highest load of the strokes, with the median width under each; empty where they are one."""
    near = 0.5 * OTHER_LOAD * max(map(abs, loads))
    if max(loads) - min(loads) <= 2.0 * near:
        return ()
    return tuple(
        (end, float(np.median([width for width, load in zip(openings, loads, strict=True) if abs(load - end) < near])))
        for end in (min(loads), max(loads))
    )


def _means(motion: Array, effect: Array, rows: Array, edges: Array) -> Array:
    """The mean of an effect in each bin of the motion, in line with its neighbours where none of the rows lies.

    Shape (bins,); NaN beyond the first and the last bin with rows, and everywhere if too few bins have some.
    """
    place = np.clip(np.searchsorted(edges, motion[rows], side="right") - 1, 0, len(edges) - 2)
    count = np.bincount(place, minlength=len(edges) - 1)
    total = np.bincount(place, weights=effect[rows], minlength=len(edges) - 1)
    (filled,) = np.nonzero(count)
    if len(filled) < LEAST_BINS:
        return np.full(len(count), np.nan)
    every = np.arange(len(count))
    return np.asarray(np.interp(every, filled, total[filled] / count[filled], left=np.nan, right=np.nan))
