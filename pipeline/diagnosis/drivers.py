"""What a mechanism may listen to: drivers made from a recording's inputs, never from the measurement."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from pipeline.diagnosis.recursions import play
from pipeline.kinematics import Array

LOAD_UNIT_N = 10.0
SMOOTH_S = 0.12
DEAD_BAND = 2e-3  # of the range of motion: smaller movements are encoder noise, not travel


@dataclass(frozen=True)
class Drivers:
    """One value a sample. `turns` is the motion in turns; geometry at the nominal dimensions, lengths in mm."""

    time_s: Array
    turns: Array
    load: Array  # in units of 10 N (or of the torque's usual size)
    loaded: bool  # whether the load varies enough to tell what follows it
    sine: Array  # of the helix angle: how much of the twist's arm reaches the contraction
    tangent: Array  # of the helix angle
    contraction: Array  # nominal model's, from its first value
    stroke: NDArray[np.intp]
    phase: NDArray[np.intp]
    first: NDArray[np.intp]  # samples since the start of the run
    temperature_c: Array | None
    current_a: Array | None

    @cached_property
    def step_s(self) -> float:
        """Usual time between samples."""
        return float(np.median(np.diff(self.time_s)))

    def smooth(self, signal: Array) -> Array:
        """A signal smoothed over about an eighth of a second."""
        return gaussian_filter1d(signal, max(SMOOTH_S / self.step_s, 0.6), mode="nearest")

    def slope(self, signal: Array) -> Array:
        """Time derivative of a smoothed signal, per second."""
        return np.gradient(self.smooth(signal), self.time_s)

    @cached_property
    def rate(self) -> Array:
        """Twisting rate, turns/s."""
        return self.slope(self.turns)

    @cached_property
    def span(self) -> float:
        """Range of the motion, turns."""
        return float(np.subtract(*np.percentile(self.turns, [99.9, 0.1])))

    @cached_property
    def moved(self) -> Array:
        """The motion without encoder noise, turns."""
        return play(self.turns, np.full(len(self.turns), DEAD_BAND * self.span))

    @cached_property
    def path(self) -> Array:
        """Travel of the motion since the start, turns."""
        return np.concatenate([[0.0], np.cumsum(np.abs(np.diff(self.moved)))])

    def worked(self, load_power: float) -> Array:
        """Work of winding, ∫ load^power · dx⁺, in units of 10 mm (at 10 N)."""
        lifted = np.maximum(np.diff(np.interp(self.moved, *self._curve)), 0.0)
        lift = 0.5 * (np.abs(self.load[1:]) + np.abs(self.load[:-1])) ** load_power
        return np.concatenate([[0.0], np.cumsum(lift * lifted)]) / 10.0

    @cached_property
    def _curve(self) -> tuple[Array, Array]:
        grid = np.linspace(self.moved.min(), self.moved.max(), 200)
        order = np.argsort(self.turns, kind="stable")
        return grid, np.interp(grid, self.turns[order], np.maximum.accumulate(self.contraction[order]))

    @cached_property
    def elapsed_s(self) -> Array:
        """Time since the first sample."""
        return self.time_s - self.time_s[0]

    @cached_property
    def load0(self) -> float:
        """Load of the first second: what the displacement was tared under."""
        return float(np.median(self.load[self.elapsed_s <= max(1.0, 5 * self.step_s)]))

    def directed(self, width: float) -> Array:
        """Memory of the direction, −1…1: where the motion stands in a play of half-width `width` turns."""
        return (self.turns - play(self.turns, np.full(len(self.turns), width))) / width
