"""The interface of a system: the base simulator of one kind of rig, and the channels of its recordings."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from ..ground.kinematics import Array

LISTENED = ("temperature_c", "motor_current_a")  # channels that any rig may have
PORTS = ("twist", "radius", "length", "resistance", "sensor")


@dataclass(frozen=True)
class Parameter:
    """A dimension of the simulator that calibration may move: nominal value, 1 sigma, and its bounds."""

    name: str
    nominal: float
    sigma: float
    reach: float = 3.0  # sigma
    lowest: float = float("-inf")


class Described(Protocol):
    """The parts of `run.yaml` that a system reads: the string, the rig's dimensions, and their tolerances."""

    @property
    def string(self) -> Any:
        """Radius, length and stiffness of the string, or None."""

    @property
    def rig(self) -> Mapping[str, float]:
        """Dimensions of the rig, by the system's own keys."""

    @property
    def tolerance(self) -> Mapping[str, float]:
        """One sigma of a dimension, where it is not the system's default."""


class Inputs(Protocol):
    """The inputs of a system, one value a sample: motion in the driver's unit, load in the system's load unit."""

    @property
    def time_s(self) -> Array:
        """Time, for what has a memory of its own. In s, shape (samples,)."""

    @property
    def motion(self) -> Array:
        """The motion of the motor. In the driver's unit, shape (samples,)."""

    @property
    def rate(self) -> Array:
        """Its rate. In the driver's unit a second, shape (samples,)."""

    @property
    def acceleration(self) -> Array:
        """Its acceleration. In the driver's unit a second squared, shape (samples,)."""

    @property
    def load(self) -> Array:
        """Load in units of `load_unit`; zeros where there is none. Shape (samples,)."""


class System:
    """The base simulator of one kind of rig; a new rig is one module of this folder with one of these in `SYSTEMS`.

    The class attributes say what a recording holds and what `run.yaml` must tell; two methods say the physics.
    `ports` are the places where missing physics may act, each with the name under which `simulate` receives it:

    - `twist`: added to the motion before the transmission, in the motion's unit;
    - `radius`: relative change of the transmission;
    - `length`: output lost as the tension member lengthens, in the channel's unit;
    - `resistance`: what resisting the motion costs, in the channel's unit: lost output, or added force;
    - `sensor`: added to the reading by the engine itself.
    """

    name: str
    driver: str  # column of the motion; its ending is its unit
    channel: str  # column of what is predicted; its ending is its unit
    load: str | None = None  # column of what the motion works against, where a recording may have it
    load_unit: float = 1.0  # mechanisms see the load in this many of its unit: about its usual size
    turn: float | None = None  # of the motion: one turn of the motor; None where nothing turns
    levered: bool = False  # whether the transmission's lever changes with the motion, as a string's does
    free_zero: bool = True  # whether the reading's zero is arbitrary
    working_hz: float | None = None  # both sides are averaged to it: what is faster tells nothing
    differentiates: bool = False  # whether the channel follows derivatives of the motion: taken before, not smoothed
    stated_below_hz: float | None = None  # the band in which the relative residual is stated, where one is usual
    remembers: bool = False  # whether what acts at a port shows later too: a spring and mass, a filter, a tank
    homed: str | None = None  # parameter that shifts the motion, which each run may have of its own
    needs_string: bool = False
    rig: Mapping[str, str] = {}  # keys of `rig:` that must be there, each with what it means
    optional_rig: Mapping[str, str] = {}
    may_be_negative: frozenset[str] = frozenset()  # of those
    never_zero: frozenset[str] = frozenset()
    tolerance: Mapping[str, float] = {}  # keys of `tolerance:` with their defaults
    absolute: frozenset[str] = frozenset()  # of those, in the dimension's own unit; the others are shares of its value
    measured: Mapping[
        str, str
    ] = {}  # by the name of a dimension: from where to where, and with what, a person measures it
    ports: Mapping[str, str] = {port: port for port in PORTS}

    @property
    def columns(self) -> tuple[str, ...]:
        """Columns that a recording may have, the first three of which it must."""
        own = (self.driver, self.channel, *([self.load] if self.load else []))
        return ("time_s", *own, *(name for name in LISTENED if name not in own))

    def parameters(self, run: Described) -> list[Parameter]:
        """Dimensions with nominal values and tolerances; a free zero is not among them."""
        raise NotImplementedError

    def simulate(self, values: Array, inputs: Inputs, acts: dict[str, Array]) -> Array:
        """The reading without its zero, for values of the parameters and additions at the ports.

        `values` of shape (parameters,), in the order and the units of `parameters`; each of `acts` and the reading of
        shape (samples,).
        """
        raise NotImplementedError

    def lever(self, values: Array, inputs: Inputs) -> tuple[Array, Array]:
        """The share of a resisting torque that reaches the output: sine and tangent of the helix angle; else ones.

        Each of shape (samples,).
        """
        ones = np.ones_like(inputs.motion)
        return ones, ones

    def travel(self, values: Array, inputs: Inputs) -> Array:
        """Nominal output travel, in the channel's unit; the motion itself where the output is no displacement.

        Shape (samples,).
        """
        return self.simulate(values, inputs, {})


def sigma_of(system: System, run: Described, name: str) -> float:
    """One sigma of a dimension: what `run.yaml` says, or the system's default."""
    return float(run.tolerance.get(name, system.tolerance[name]))
