"""What a mechanism is: it offers terms, and a term acts at a port of the simulator."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

from ..ground.kinematics import Array
from .drivers import Drivers

Port = Literal["twist", "radius", "length", "resistance", "sensor"]
Nonlinear = dict[str, float]  # values of the parameters that enter a law nonlinearly, by name


@dataclass(frozen=True)
class Term:
    """One way in which a mechanism acts: what a coefficient of 1 adds at a port of the system.

    Ports: `twist` in turns, `radius` as a relative change, `length` in mm of lengthening, `resistance` in mm of output
    that resisting costs, `sensor` in mm on the reading. A sensor term may be an operator instead: a function of the
    simulated reading that returns what it adds. Names and units are written for a string, in mm, turns and 10 N; on
    another system they are read in its own units (`naming`). Coefficients of terms with one `total` are also reported
    as their sum, under that name.
    """

    name: str
    port: Port
    signal: Array | Callable[[Array], Array]
    unit: str = "mm"
    low: float = 0.0
    high: float = float("inf")
    total: str | None = None


@dataclass(frozen=True)
class Mechanism:
    """One piece of physics that a simulator may lack: data and two pure functions of the drivers.

    `candidates` lists values of the nonlinear parameters (at least one set, possibly empty; none when the recording
    cannot show the mechanism at all); `terms` gives the terms at one of them. `steps` > 1: the mechanism may act
    several times (sudden events), each with nonlinear parameters of its own. `suggest` adds the candidates that a
    residual of calibration makes plausible. `random` gives nonlinear parameters where a residual shows an effect whose
    every move is chance.
    `mark` says how clearly a residual of calibration, beside the prediction, shows what only this mechanism leaves:
    about 0 without it, and never more than about 6; where it is less than `least_mark`, no explanation names the
    mechanism. An id that begins with `x_` is no physics of the library: alone it
    names nothing.

    `meaning` is a line of the glossary, in the words of a string: what a person would see; left out, what it follows.
    `sentence` is what a person reads. It holds {size}, and where that helps {span} (from the lowest to the highest
    value of the effect), {times} (its time constants), {temperature}, and the rig's words: {string} {motion}
    {rate} {reading} {up} {down}. `details` follow it: of these the first all of whose parameters were found, each said
    as its value. `names` says what a word in its coefficients' names multiplies, for who reads them in run.yaml.
    """

    id: str
    driver: str
    equation: str
    source: str
    confused_with: str
    told_apart_by: str
    sentence: str
    candidates: Callable[[Drivers], list[Nonlinear]]
    terms: Callable[[Drivers, Nonlinear], list[Term]]
    steps: int = 1
    details: tuple[str, ...] = ()
    meaning: str = ""
    helper: bool = False  # fits without saying what it is: an explanation that is mostly this explains nothing
    names: dict[str, str] = field(default_factory=dict)
    units: dict[str, str] = field(default_factory=dict)  # of nonlinear parameters, where `candidates` may be empty
    suggest: Callable[[Drivers, Array], list[Nonlinear]] = lambda drivers, residual: []
    random: Callable[[Drivers, Array, Array], Nonlinear | None] = lambda drivers, residual, predicted: None
    mark: Callable[[Drivers, Array, Array], float] | None = None
    least_mark: float = 0.0


def physics(ids: tuple[str, ...]) -> bool:
    """Whether a set of mechanisms names any physics of the library."""
    return not all(id_.startswith("x_") for id_ in ids)
