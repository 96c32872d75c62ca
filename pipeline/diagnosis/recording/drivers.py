"""What a mechanism may listen to: drivers made from a recording's inputs, never from the measurement."""

import itertools
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from ...ground.kinematics import Array
from ...run.description import Run
from ...systems import System
from ..numerics.recursions import play
from .system_units import Units
from .working_samples import Record

SMOOTH_S = 0.12  # standard deviation of the Gaussian over which a driver is smoothed
LOAD_MOVES, LEAST_LOAD = 0.05, 0.01  # of the usual load that tells what follows it; least usual load, in load units
DEAD_BAND = 2e-3  # of the range of motion: smaller movements are encoder noise, not travel


@dataclass(frozen=True)
class Drivers:
    """One value a sample, each of shape (samples,), in the system's units; geometry at the nominal dimensions."""

    units: Units
    time_s: Array  # (samples,), in s, as all below in shape
    motion: Array  # in the motion's unit
    velocity: Array | None  # in the motion's unit a second, where the system follows the motion's derivatives
    acceleration: Array  # in the motion's unit a second squared
    load: Array  # in the system's load units
    loaded: bool  # whether the load varies enough to tell what follows it
    levered: bool  # whether the transmission's lever changes with the motion
    free_zero: bool  # whether the reading's zero is arbitrary
    turn: float | None  # of the motion, one turn of the motor
    sine: Array  # of the helix angle, without a unit: how much of the twist's arm is contraction; 1 without helix
    tangent: Array  # of the helix angle, without a unit; 1 without helix
    contraction: Array  # nominal output travel, from its first value, in the channel's unit
    stroke: NDArray[np.intp]  # number of the stroke, a count
    phase: NDArray[np.intp]  # place in `PHASES`, an index
    first: NDArray[np.intp]  # samples since the start of the run, a count
    temperature_c: Array | None  # in °C
    current_a: Array | None  # in A
    counted_s: Array | None = None  # time since what events are timed from, in s; None: since the first sample
    seen: int | None = None  # of the first samples that a fit sees, a count; None: all
    drawn: bool = False  # whether the motion was drawn as straight lines: nothing in it is noise, and nothing is early

    @cached_property
    def step_s(self) -> float:
        """Usual time between samples."""
        return float(np.median(np.diff(self.time_s)))

    def smooth(self, signal: Array) -> Array:
        """A signal smoothed over about an eighth of a second. In the signal's unit, both of shape (samples,)."""
        return gaussian_filter1d(signal, max(SMOOTH_S / self.step_s, 0.6), mode="nearest")

    def slope(self, signal: Array) -> Array:
        """Time derivative of a smoothed signal; beside a drawn motion, of what was, unsmoothed.

        Both of shape (samples,), in the signal's unit and in that unit a second.
        """
        if self.drawn:
            return np.concatenate([[0.0], np.diff(signal) / np.diff(self.time_s)])
        return np.gradient(self.smooth(signal), self.time_s)

    @cached_property
    def rate(self) -> Array:
        """Rate of the motion. In the motion's unit a second, shape (samples,)."""
        return self.slope(self.motion) if self.velocity is None else self.velocity

    def inputs(self, rows: NDArray[np.bool_]) -> "Moved":
        """What a system simulates from, of some rows. `rows` has the shape (samples,) and is a mask."""
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
    def breaks(self) -> NDArray[np.intp]:
        """Where each run after the first begins, as places among the samples, which are indices: shape (runs - 1,)."""
        return np.flatnonzero(self.first[1:] == 0) + 1

    @cached_property
    def elapsed_s(self) -> Array:
        """Time since the first sample, or since what events are timed from. In s, shape (samples,)."""
        return self.time_s - self.time_s[0] if self.counted_s is None else self.counted_s

    @cached_property
    def seen_s(self) -> float:
        """How long what a fit sees lasts, to six digits: the scale of what changes with time alone."""
        return float(f"{self.elapsed_s[: self.seen][-1]:.6g}")

    @cached_property
    def seen_strokes(self) -> int:
        """How many strokes a fit sees, begun ones too."""
        return len(np.unique(self.stroke[: self.seen][self.stroke[: self.seen] > 0]))

    @cached_property
    def load0(self) -> float:
        """Load of the first second: what the displacement was tared under."""
        return self.load0_of(slice(None))

    def load0_of(self, part: slice) -> float:
        """Load of the first second of some samples, in the system's load units."""
        since_s = self.elapsed_s[part]
        return float(np.median(self.load[part][since_s - since_s[0] <= max(1.0, 5 * self.step_s)]))

    @cached_property
    def under_another_load(self) -> list[int]:
        """The numbers of the strokes whose usual load is another than the recording's; none where the load varies."""
        usual = float(np.median(self.load))
        strokes = [] if self.loaded else [int(stroke) for stroke in np.unique(self.stroke) if stroke > 0]
        apart = {each: abs(float(np.median(self.load[self.stroke == each])) - usual) for each in strokes}
        return [each for each, by in apart.items() if by > LOAD_MOVES * max(abs(usual), LEAST_LOAD)]

    @cached_property
    def loaded_within(self) -> bool:
        """Whether the load varies enough to tell what shifts with it: within a run, where each has its own zero."""
        least = LOAD_MOVES * max(abs(float(np.median(self.load))), LEAST_LOAD)
        parts = self.run_parts() if self.free_zero else [slice(None)]
        return any(float(np.subtract(*np.percentile(self.load[part], [95, 5]))) > least for part in parts)

    def run_parts(self) -> list[slice]:
        """The samples of each run, in turn."""
        edges = [0, *map(int, self.breaks), len(self.time_s)]
        return [slice(begin, end) for begin, end in itertools.pairwise(edges)]

    def directed(self, width: float) -> Array:
        """Memory of the direction, −1…1: where the motion stands in a play of half-width `width`.

        `width` in the motion's unit; the answer without a unit, shape (samples,).
        """
        return (self.motion - play(self.motion, np.full(len(self.motion), width))) / width


@dataclass(frozen=True)
class Moved:
    """What a system simulates from, each of shape (samples,)."""

    time_s: Array  # in s
    motion: Array  # in the motion's unit
    rate: Array  # in the motion's unit a second
    acceleration: Array  # in the motion's unit a second squared
    load: Array  # in the system's load units


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
