"""A run's simulator with the mechanisms found missing: it maps a motion forward, or finds the motion."""

from dataclasses import asdict, dataclass, replace
from functools import cached_property
from typing import Any, TypedDict

import numpy as np
import pandas as pd

from ....diagnosis.fit.problem import Act, State
from ....diagnosis.recording import drivers
from ....ground.kinematics import Array
from ....run.description import Run
from .diagnosed_problem import CUT, along
from .filled_motion import Motion, path

ROUNDS = 6  # of way and twist; each brings the twist several times nearer
HALVINGS = 40  # of the range in which a twist is sought
NUDGE_TURNS = 0.02  # by which a way is moved to see how what acts changes with the twist
WAVE_S, LEAST_STEPS = 4.0, 12  # period of the nudges: slow for a sensor, and quick for what remembers whole strokes
STEEPEST = 0.7  # of the slope of the simulator in which nothing acts, that what acts may take away
MARGIN = 0.01  # of the range of twist that was seen, by which an answer may leave it


class SavedAct(TypedDict):
    """A mechanism at work: its sets of nonlinear parameters, one for each action, and its terms' coefficients."""

    id: str
    nonlinear: list[dict[str, float]]
    coefficients: list[float]


class SavedSimulator(TypedDict):
    """A run's simulator in its file; `run` is a run.yaml's content, `known` its training points by column."""

    verdict: str
    named: list[list[str]]
    values: list[float]
    zero_mm: float
    level_mm: float
    alone: tuple[list[float], float]
    acts: list[SavedAct]
    run: dict[str, object]
    known: dict[str, list[object]]


@dataclass(frozen=True)
class Simulator:
    """One run's simulator: values of its dimensions, its zero, the acting mechanisms, and the training motion."""

    run: Run
    known: pd.DataFrame  # the training points, in order of time
    verdict: str  # of the diagnosis, or why there is none
    named: list[list[str]]  # what it named: sets of mechanisms that the training points cannot tell apart
    values: list[float]
    zero_mm: float
    acts: tuple[Act, ...]
    level_mm: float  # mean contraction of the training points: what the zero stands for
    alone: tuple[list[float], float]  # values and zero of the best simulator in which nothing acts

    @cached_property
    def motion(self) -> Motion:
        """The motion of the training points."""
        return Motion.of(self.known)

    def base_mm(self, turns: Array, load_n: Array) -> Array:
        """Contraction in mm by the simulator without any mechanism, shape (points,)."""
        return self._base_mm(turns, load_n, self.values, self.zero_mm)

    def _base_mm(self, turns: Array, load_n: Array, values: list[float], zero_mm: float) -> Array:
        nothing = np.zeros_like(turns)
        inputs = drivers.Moved(nothing, turns, nothing, nothing, load_n / self.run.system.load_unit)
        return self.run.system.simulate(np.array(values), inputs, {}) + zero_mm

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm at asked points of the run, shape (points,)."""
        turns, load_n = (points[name].to_numpy(float) for name in ("motor_turns", "load_n"))
        return self.base_mm(turns, load_n) + self._added_mm(points, turns)[0]

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns at asked points of the run, shape (points,), within the twists that were seen.

        What acts depends on the way there, which is sought as well: from the calibrated simulator's twist, each round
        takes the way that is nearest to the last twists and can be gone, and solves for the twist at every point alone.
        """
        measured_mm, load_n = (points[name].to_numpy(float) for name in ("displacement_mm", "load_n"))
        seen = self.known["motor_turns"]
        low, high = seen.min() - MARGIN * np.ptp(seen), seen.max() + MARGIN * np.ptp(seen)

        def solved(values: list[float], zero_mm: float, added_mm: Array, steep: Array, way: Array) -> Array:
            below, above = np.full(len(points), low), np.full(len(points), high)
            for _ in range(HALVINGS):
                middle = 0.5 * (below + above)
                predicted_mm = self._base_mm(middle, load_n, values, zero_mm) + added_mm + steep * (middle - way)
                below, above = (
                    np.where(predicted_mm < measured_mm, *pair) for pair in ((middle, below), (above, middle))
                )
            return 0.5 * (below + above)

        nothing = np.zeros(len(points))
        turns = best_turns = solved(*self.alone, nothing, nothing, nothing)
        least = np.inf
        for _ in range(ROUNDS if self.acts else 0):
            way = path(self.known, points, turns, np.square(self._slope(turns, load_n)))
            (added_mm, steep), slope = self._added_mm(points, way), self._slope(way, load_n)
            steep = np.clip(steep, -STEEPEST * slope, slope / STEEPEST)  # at a reversal a play has no slope at all
            turns = solved(self.values, self.zero_mm, added_mm, steep, way)
            mean_square = float(np.mean(np.square(self.base_mm(way, load_n) + added_mm - measured_mm)))
            if mean_square < least:
                least, best_turns = mean_square, turns
        return best_turns

    def _slope(self, turns: Array, load_n: Array) -> Array:
        """Slope of the simulator without any mechanism, in mm/turn, shape (points,)."""
        further_mm = self.base_mm(turns + NUDGE_TURNS, load_n) - self.base_mm(turns - NUDGE_TURNS, load_n)
        return further_mm / (2.0 * NUDGE_TURNS)

    def _added_mm(self, points: pd.DataFrame, turns: Array) -> tuple[Array, Array]:
        """What the mechanisms add at points that the motor moved to `turns`, in mm, and its slope in mm a turn."""
        if not self.acts:
            return np.zeros(len(points)), np.zeros(len(points))
        moved = points[["time_s", "load_n", *CUT]].assign(motor_turns=turns)
        even = Motion.of(pd.concat([moved, self.known])).evenly(self.motion.step_s)
        added_mm = self._along_mm(even, np.zeros_like(even.time_s))
        phase = 2.0 * np.pi * even.time_s / max(WAVE_S, LEAST_STEPS * self.motion.step_s)
        steep = np.zeros_like(added_mm)
        for wave in (np.sin(phase), np.cos(phase)):
            steep += (self._along_mm(even, NUDGE_TURNS * wave) - added_mm) / NUDGE_TURNS * wave
        base_mm = self.base_mm(self.motion.motor_turns, self.motion.load_n)
        level_mm = np.mean(base_mm + np.interp(self.motion.time_s, even.time_s, added_mm))
        at = points["time_s"].to_numpy(float)
        return np.interp(at, even.time_s, added_mm + self.level_mm - level_mm), np.interp(at, even.time_s, steep)

    def _along_mm(self, motion: Motion, nudge_turns: Array) -> Array:
        """What the mechanisms add along a motion with small changes, in mm, shape (points of the motion,)."""
        turns = motion.motor_turns + nudge_turns
        problem = along(self.run, replace(motion, motor_turns=turns), float(self.motion.time_s[0]))
        state = State(np.array(self.values), np.array([self.zero_mm]), self.acts)
        return problem.simulate(state) - self.base_mm(turns, motion.load_n)

    def saved(self) -> SavedSimulator:
        """Plain values for a file."""
        acts: list[Any] = [asdict(act) for act in self.acts]
        return {
            "verdict": self.verdict,
            "named": self.named,
            "values": self.values,
            "zero_mm": self.zero_mm,
            "level_mm": self.level_mm,
            "alone": self.alone,
            "acts": acts,
            "run": self.run.model_dump(),
            "known": self.known.to_dict("list"),
        }

    @classmethod
    def from_saved(cls, saved: SavedSimulator) -> "Simulator":
        """The simulator that `saved` wrote."""
        acts = tuple(Act(act["id"], tuple(act["nonlinear"]), tuple(act["coefficients"])) for act in saved["acts"])
        own = {"run": Run.model_validate(saved["run"]), "known": pd.DataFrame(saved["known"]), "acts": acts}
        fields: dict[str, Any] = {**saved, **own}
        return cls(**fields)
