"""The motion of a run's motor, as far as it is known: measured points and estimates, with the gaps filled.

Source: Barlow, Bartholomew, Bremner and Brunk, Statistical Inference under Order Restrictions, 1972 (isotonic
regression); Savitzky and Golay, "Smoothing and differentiation of data by simplified least squares procedures",
Analytical Chemistry 36, 1964.
"""

from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.signal import savgol_filter
from sklearn.isotonic import IsotonicRegression

from ....ground.kinematics import Array, Places
from ....run.strokes import Phases

MOST_IN_A_GAP = 100  # steps: in a long pause nothing moves, and hours of it need no more samples
SMOOTH_S, SMOOTHED = 0.5, 25  # time, and points of it, in which a motor's speed changes evenly
SURE = 1e6  # weight of a measured twist beside an estimated one


@dataclass(frozen=True)
class Motion:
    """Points of one run in order of time; all of shape (points,)."""

    time_s: Array
    motor_turns: Array
    load_n: Array
    stroke: Places  # its number in the dataset, a count
    phase: Phases  # a word, without a unit

    @classmethod
    def of(cls, points: pd.DataFrame) -> "Motion":
        """The motion through points, one for each time stamp: of several the first in the table."""
        _, first = np.unique(points["time_s"].to_numpy(float), return_index=True)
        time_s, turns, load_n = (points[name].to_numpy(float)[first] for name in ("time_s", "motor_turns", "load_n"))
        stroke, phase = points["stroke"].to_numpy(np.intp)[first], points["phase"].to_numpy(object)[first]
        return cls(time_s, turns, load_n, stroke, phase)

    @property
    def step_s(self) -> float:
        """Usual time between two points."""
        return float(np.median(np.diff(self.time_s)))

    def evenly(self, step_s: float) -> "Motion":
        """The same motion with a point every step or a little less, on straight lines between its points.

        A gap has the same samples whatever else is asked, so that a mechanism sees motion as dense as in its fit. It
        belongs to the stroke and the phase that it follows, as a stand does where a recording is cut.
        """
        span_s = self.time_s[-1] - self.time_s[0]
        even = np.linspace(self.time_s[0], self.time_s[-1], max(int(np.ceil(span_s / step_s)), 1) + 1)
        after = np.clip(np.searchsorted(self.time_s, even), 1, len(self.time_s) - 1)
        gap_s = self.time_s[after] - self.time_s[after - 1]
        every = np.maximum(np.ceil(gap_s / (MOST_IN_A_GAP * step_s)), 1).astype(int)
        even = even[np.arange(len(even)) % every == 0]
        even = np.unique(np.concatenate([even, self.time_s[[0, -1]]]))
        turns, load_n = (np.interp(even, self.time_s, own) for own in (self.motor_turns, self.load_n))
        before = np.maximum(np.searchsorted(self.time_s, even, side="right") - 1, 0)
        return Motion(even, turns, load_n, self.stroke[before], self.phase[before])


def one_way(time_s: Array, turns: Array, weight: Array, rising: bool) -> Array:
    """Twist of one winding (rising) or unwinding that fits weighted estimates best, shape (points,).

    A motor has inertia: what moves one way alone would go in steps, and steps are rates that no motor had. Time in s,
    twist in turns, weights beside each other.
    """
    steps = IsotonicRegression(increasing=rising).fit(time_s, turns, sample_weight=weight).predict(time_s)
    order = np.argsort(time_s, kind="stable")
    even_s = np.linspace(time_s.min(), time_s.max(), max(int(np.ptp(time_s) / SMOOTH_S * SMOOTHED), SMOOTHED))
    even = savgol_filter(np.interp(even_s, time_s[order], steps[order]), SMOOTHED, 2)
    return np.interp(time_s, even_s, even)


def path(known_points: pd.DataFrame, points: pd.DataFrame, turns: Array, weight: Array) -> Array:
    """Twist of points of one run, in turns, from weighted estimates: each stretch of a stroke moves one way.

    Known points of the same stretch hold it where they are. `turns` and `weight` have the shape (asked points,), and so
    has the answer.
    """
    path_turns = turns.copy()
    labels = ["stroke", "phase"]
    of_known = known_points.groupby(labels).indices
    for label, rows in points.groupby(labels).indices.items():
        beside: NDArray[np.intp] = of_known.get(label, np.zeros(0, np.intp))
        time_s = np.concatenate(
            [points["time_s"].to_numpy(float)[rows], known_points["time_s"].to_numpy(float)[beside]]
        )
        both = np.concatenate([turns[rows], known_points["motor_turns"].to_numpy(float)[beside]])
        sure = np.concatenate([weight[rows], np.full(len(beside), SURE * max(float(weight[rows].max()), 1e-9))])
        path_turns[rows] = one_way(time_s, both, sure, label[1] == "winding")[: len(rows)]
    return path_turns
