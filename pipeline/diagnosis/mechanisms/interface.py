"""What a mechanism is: it offers terms, and a term acts at a port of the simulator."""

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

from ...ground.kinematics import Array
from ...ground.outside_library import is_outside
from ..recording.drivers import Drivers

Port = Literal["twist", "radius", "length", "resistance", "sensor"]
DRIFT = "absolute time"  # driver of what goes on whatever the rig does
SWINGS = ("acceleration", "angle within the turn", "slow motion")  # drivers of what moves to and fro within a stroke
AT_REST = ("time under load", DRIFT)  # of what goes on while the rig stands
FOR_GOOD = ("sudden events on the length", "sudden events on the twist")  # of what happens once and stays
SLOW = (*AT_REST, "worked strokes", "load x worked strokes", "travel")  # of what goes on over a whole recording
PACE = ("rate", "time", "speed", "slow", "acceleration", "temperature")  # words of a driver that another speed changes
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
    several times (sudden events), each with nonlinear parameters of its own; `at_once` says which two are one event.
    `suggest` adds the candidates that a residual of calibration makes plausible. `beside` gives nonlinear parameters at
    which a helper may take what named effects leave, as a part of the simulator. `random` gives nonlinear parameters
    where a residual shows an effect whose every move is chance.
    `mark` says how clearly a residual of calibration, beside the prediction, shows what only this mechanism leaves:
    about 0 without it, and never more than about 6; where it is less than `least_mark`, no explanation names the
    mechanism. An id that begins with `x_` is no physics of the library: alone it
    names nothing.

    `columns` are drivers by name, or products of them such as "load x time"; "high twist, more" says that the column is
    this mechanism's only where the residual grows with it, "high twist, less" only where it falls.

    `equation` is what the terms do, each strength a letter; a test evaluates it beside them.

    `meaning` is a line of the glossary, in the words of a string: what a person would see; left out, what it follows.
    `sentence` is what a person reads. It holds {size}, and where that helps {span} (from the lowest to the highest
    value of the effect), {loop} (by how much both ways differ at one place), {times} (its time constants), {half} (when
    half of what a step brings is done), {temperature}, {lowers} and {grows} (whether it lowers or raises the reading,
    and so the radius falls or grows, in the course of the recording), and the rig's words: {string} {motion} {rate}
    {reading} {up} {down}. `details` are clauses with names of parameters in braces. The first clause whose parameters
    all have values is put after the sentence, each name replaced by its value. `names` says what a word in its
    coefficients' names multiplies, for who reads them in run.yaml. `letters` says what a letter is: in words, with its
    value after ` | ` where that is always the same, or as the name of a nonlinear parameter.
    `meanings` says what each nonlinear parameter is; `shared_meanings.MEANINGS` has those that several mechanisms have.
    It may hold {string}, {motion}, {motion_unit}, and {scale} for a number that only sets a scale. A name that ends in
    `_load` is a load, counted in 10 N.
    `derived` gives constants that follow from several of its parameters, by a name that ends in their unit; each is as
    uncertain as the effect's size.
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
    columns: tuple[str, ...] = ()  # of drivers, on which a method without physics may regress a residual for it
    steps: int = 1
    details: tuple[str, ...] = ()
    meaning: str = ""
    remembers_turns: bool = False  # acts otherwise after a way back from the middle than after one from an end
    letters: dict[str, str] = field(default_factory=dict)  # of the equation, that mean nothing or otherwise elsewhere
    meanings: dict[str, str] = field(default_factory=dict)  # of its nonlinear parameters, by their names
    strengths: tuple[str, ...] = ()  # letters of the equation that are the coefficients of the terms
    rows: dict[str, str] = field(default_factory=dict)  # what is in the names of a letter's coefficients, as a pattern
    scale_units: dict[str, str] = field(default_factory=dict)  # of nonlinear parameters whose names do not end in it
    variants: dict[str, str] = field(default_factory=dict)  # other equations, by the nonlinear parameter of their kind
    plain_equation: str = ""  # where nothing is twisted, if `equation` is one of a string
    twisted: bool = False  # of a string alone: where nothing is wound it is no candidate, and worth no word
    clips: bool = False  # cuts the reading: what it does depends on how far the reading would go without it
    helper: bool = False  # fits without saying what it is: an explanation that is mostly this explains nothing
    names: dict[str, str] = field(default_factory=dict)
    derived: dict[str, Callable[[Nonlinear], float]] = field(default_factory=dict)  # of all parameters, by their names
    optional: tuple[str, ...] = ()  # nonlinear parameters that a recording may have no use for: `terms` does without
    units: dict[str, str] = field(default_factory=dict)  # of nonlinear parameters, where `candidates` may be empty
    suggest: Callable[[Drivers, Array, Array], list[Nonlinear]] = lambda drivers, residual, predicted: []
    tells: Callable[[Drivers, Nonlinear], bool] = lambda drivers, nonlinear: True  # whether it can be seen
    at_once: Callable[[Drivers, Nonlinear, Nonlinear], bool] = lambda drivers, first, second: False
    beside: Callable[[Drivers], list[Nonlinear]] = lambda drivers: []
    random: Callable[[Drivers, Array, Array], Nonlinear | None] = lambda drivers, residual, predicted: None
    largest_move: str = ""  # the nonlinear parameter of `random` that is the largest single move, in the reading's unit
    mark: Callable[[Drivers, Array, Array], float] | None = None
    least_mark: float = 0.0

    @property
    def acts_at_rest(self) -> bool:
        """Whether the effect goes on while the rig stands."""
        return self.driver in AT_REST

    @property
    def swings(self) -> bool:
        """Whether the effect moves the reading to and fro within a stroke."""
        return self.driver in SWINGS

    @property
    def drifts(self) -> bool:
        """Whether the effect goes on whatever the rig does."""
        return self.driver == DRIFT

    @property
    def paced(self) -> bool:
        """Whether the effect differs in the same motion at another speed: it follows a rate, heat, or time in use."""
        return not self.drifts and any(word in PACE for word in re.findall(r"[a-z]+", self.driver))

    @property
    def stays(self) -> bool:
        """Whether the effect changes the string for good, so that it differs after a recording."""
        return self.slow or self.driver in FOR_GOOD

    @property
    def slow(self) -> bool:
        """Whether the effect goes on over a whole recording."""
        return self.driver in SLOW


def physics(ids: tuple[str, ...]) -> bool:
    """Whether a set of mechanisms names any physics of the library."""
    return not all(map(is_outside, ids))
