"""What a mechanism and a system are; a mechanism offers terms, a term acts at a port of the simulator."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, Protocol

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.record import Record
from pipeline.kinematics import Array
from pipeline.run_yaml import Run

Port = Literal["twist", "radius", "length", "sensor"]
Shape = dict[str, float]


@dataclass(frozen=True)
class Term:
    """One way in which a mechanism acts: what a coefficient of 1 adds at a port.

    Ports: `twist` in turns, `radius` as a relative change, `length` in mm of lengthening, `sensor` in mm on the
    reading. A sensor term may be an operator instead: a function of the simulated reading that returns what it adds.
    """

    name: str
    port: Port
    signal: Array | Callable[[Array], Array]
    unit: str = "mm"
    low: float = 0.0
    high: float = float("inf")


@dataclass(frozen=True)
class Mechanism:
    """One piece of physics that a simulator may lack: data and two pure functions of the drivers.

    `shapes` lists candidates for the parameters that enter nonlinearly (at least one, possibly empty; none when the
    recording cannot show the mechanism at all); `terms` gives the terms of one shape. `steps` > 1: the mechanism may
    act several times (sudden events), each with a shape of its own. `suggest` adds the shapes that a residual of
    calibration makes plausible. `random` gives a shape where a residual shows an effect whose every move is chance.
    An id that begins with `x_` is no physics of the library: alone it names nothing.
    """

    id: str
    driver: str
    equation: str
    source: str
    confused_with: str
    told_apart_by: str
    sentence: str  # with {size}
    shapes: Callable[[Drivers], list[Shape]]
    terms: Callable[[Drivers, Shape], list[Term]]
    steps: int = 1
    units: dict[str, str] = field(default_factory=dict)  # of a shape, where `shapes` may be empty
    suggest: Callable[[Drivers, Array], list[Shape]] = lambda drivers, residual: []
    random: Callable[[Drivers, Array, Array], Shape | None] = lambda drivers, residual, predicted: None


@dataclass(frozen=True)
class Parameter:
    """A dimension of the simulator that calibration may move: nominal value, 1 sigma, and its bounds."""

    name: str
    nominal: float
    sigma: float
    reach: float = 3.0  # sigma
    lowest: float = float("-inf")


class System(Protocol):
    """A simulator of one kind of actuator: inputs, dimensions and acts at its ports → the measured channel."""

    name: str
    channel: str

    def parameters(self, run: Run) -> list[Parameter]:
        """Dimensions with nominal values and tolerances; the displacement zero is not among them."""

    def drivers(self, record: Record, run: Run) -> Drivers:
        """What mechanisms may listen to."""

    def simulate(self, values: Array, drivers: Drivers, acts: dict[str, Array]) -> Array:
        """The reading without its zero, for values of the parameters and acts at the ports twist, radius, length."""
