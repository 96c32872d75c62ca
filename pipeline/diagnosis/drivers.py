"""What a mechanism may listen to: drivers made from a recording's inputs, never from the measurement."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from ..ground.kinematics import Array
from ..run.description import Run
from ..systems import System
from .naming import Units
from .record import Record
from .recursions import play

SMOOTH_S = 0.12
LOAD_MOVES, LEAST_LOAD = 0.05, 0.01  # of the usual load that tells what follows it; least usual load, in load units
DEAD_BAND = 2e-3  # of the range of motion: smaller movements are encoder noise, not travel


@dataclass(frozen=True)
class Drivers:
    """One value a sample, in the system's units; geometry at the nominal dimensions."""

    units: Units
    time_s: Array
    motion: Array
    velocity: Array | None  # of the motion, where the system follows its derivatives
    acceleration: Array
    load: Array  # in the system's load units
    loaded: bool  # whether the load varies enough to tell what follows it
    levered: bool  # whether the transmission's lever changes with the motion
    free_zero: bool  # whether the reading's zero is arbitrary
    turn: float | None  # of the motion, one turn of the motor
    sine: Array  # of the helix angle: how much of the twist's arm reaches the contraction; 1 without helix
    tangent: Array  # of the helix angle; 1 without helix
    contraction: Array  # nominal output travel, from its first value
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
        """A signal smoothed over about an eighth of a second. In the signal's unit, both of shape (samples,)."""
        return gaussian_filter1d(signal, max(SMOOTH_S / self.step_s, 0.6), mode="nearest")

    def slope(self, signal: Array) -> Array:
        """Time derivative of a smoothed signal, per second. Both of shape (samples,)."""
        return np.gradient(self.smooth(signal), self.time_s)

    @cached_property
    def rate(self) -> Array:
        """Rate of the motion, per second. Shape (samples,)."""
        return self.slope(self.motion) if self.velocity is None else self.velocity

    def inputs(self, rows: NDArray[np.bool_]) -> "Moved":
        """What a system simulates from, of some rows. `rows` is a mask of shape (samples,)."""
        return Moved(self.time_s[rows], self.motion[rows], self.rate[rows], self.acceleration[rows], self.load[rows])

    @cached_property
    def span(self) -> float:
        """Range of the motion."""
        return float(np.subtract(*np.percentile(self.motion, [99.9, 0.1])))

    @cached_property
    def moved(self) -> Array:
        """The motion without encoder noise. In the motion's unit, shape (samples,)."""
        return play(self.motion, np.full(len(self.motion), DEAD_BAND * self.span))

    @cached_property
    def path(self) -> Array:
        """Travel of the motion since the start. In the motion's unit, shape (samples,)."""
        return np.concatenate([[0.0], np.cumsum(np.abs(np.diff(self.moved)))])

    def worked(self, load_power: float) -> Array:
        """Work of winding, ∫ load^power · dx⁺, in units of 10 mm (at 10 N). Shape (samples,)."""
        lifted = np.maximum(np.diff(np.interp(self.moved, *self._curve)), 0.0)
        lift = 0.5 * (np.abs(self.load[1:]) + np.abs(self.load[:-1])) ** load_power
        return np.concatenate([[0.0], np.cumsum(lift * lifted)]) / 10.0

    @cached_property
    def _curve(self) -> tuple[Array, Array]:
        grid = np.linspace(self.moved.min(), self.moved.max(), 200)
        order = np.argsort(self.motion, kind="stable")
        return grid, np.interp(grid, self.motion[order], np.maximum.accumulate(self.contraction[order]))

    @cached_property
    def elapsed_s(self) -> Array:
        """Time since the first sample. In s, shape (samples,)."""
        return self.time_s - self.time_s[0]

    @cached_property
    def load0(self) -> float:
        """Load of the first second: what the displacement was tared under."""
        return float(np.median(self.load[self.elapsed_s <= max(1.0, 5 * self.step_s)]))

    def directed(self, width: float) -> Array:
        """Memory of the direction, −1…1: where the motion stands in a play of half-width `width`.

        `width` in the motion's unit; shape (samples,).
        """
        return (self.motion - play(self.motion, np.full(len(self.motion), width))) / width


@dataclass(frozen=True)
class Moved:
    """What a system simulates from."""

    time_s: Array
    motion: Array
    rate: Array
    acceleration: Array
    load: Array


def drivers_of(system: System, record: Record, run: Run) -> Drivers:
    """Drivers of a record, with the geometry at the nominal dimensions."""
    nominal = np.array([parameter.nominal for parameter in system.parameters(run)])
    load = record.load / system.load_unit
    spread = np.subtract(*np.percentile(record.load, [95, 5]))
    usual = max(abs(float(np.median(record.load))), LEAST_LOAD * system.load_unit)
    change = np.flatnonzero(np.diff(record.run_index, prepend=-1))
    first = np.arange(len(record)) - np.repeat(change, np.diff(change, append=len(record)))
    inputs = Moved(record.time_s, record.motion, record.velocity, record.acceleration, load)
    sine, tangent = system.lever(nominal, inputs)
    travel = system.travel(nominal, inputs)
    return Drivers(
        Units.of(system), record.time_s, record.motion, record.velocity if system.differentiates else None,
        record.acceleration, load, bool(spread > LOAD_MOVES * usual), system.levered, system.free_zero, system.turn,
        sine, tangent, travel - travel[0], record.stroke, record.phase, first, record.temperature_c, record.current_a,
    )  # fmt: skip
