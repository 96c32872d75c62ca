"""One recording with its simulator: predict with any set of mechanisms inside, and how the prediction moves."""

from dataclasses import dataclass, field, replace

import numpy as np

from ...ground.kinematics import Array
from ...systems import Parameter, System
from ..mechanisms.interface import Mechanism, Nonlinear, Term
from ..mechanisms.library import mechanisms
from ..numerics.judge import Judge, judge
from ..recording.drivers import Drivers
from ..recording.working_samples import Record

REMEMBERED, REMEMBERED_NUMBERS = 64, 6_400_000  # terms that are kept, of what acts again and again; numbers in them


@dataclass(frozen=True)
class Act:
    """A mechanism at work: its sets of `nonlinear` parameters, one for each time it acts, and its coefficients."""

    id: str
    nonlinear: tuple[Nonlinear, ...]
    coefficients: tuple[float, ...]


@dataclass(frozen=True)
class State:
    """A simulator: values of the parameters, the zero of each run in the channel's unit, and the acts in it."""

    values: Array  # (parameters,), each in its parameter's unit
    zeros: Array  # (runs,), in the channel's unit
    acts: tuple[Act, ...] = ()


def placed(system: System, terms: list[Term]) -> bool:
    """Whether a system has a port for each of the given terms."""
    return {term.port for term in terms} <= set(system.ports)


@dataclass(frozen=True)
class Problem:
    """Everything that a fit needs; `rows` samples from the start are seen by it, the drivers cover all."""

    system: System
    record: Record
    drivers: Drivers
    parameters: tuple[Parameter, ...]
    measured: Array  # (samples,), in the channel's unit
    rows: int
    included: tuple[Act, ...] = ()  # what the simulator has from run.yaml, and `beside`
    homed: int = 0  # of the parameters, the last: what shifts the motion of each run after the first
    without: frozenset[str] = frozenset()  # ids that no explanation may name
    judge: Judge = field(default_factory=judge)  # who says how likely each explanation is
    stays: bool = False  # whether all runs name one string
    beside: tuple[Act, ...] = ()  # of what is included: stand-ins that take what named effects leave
    _terms: dict[tuple[str, tuple[tuple[str, float], ...]], list[Term]] = field(default_factory=dict)

    def until(self, rows: int) -> "Problem":
        """The same problem, with a fit that sees only the first rows."""
        return replace(self, rows=rows, drivers=replace(self.drivers, seen=rows))

    @property
    def library(self) -> dict[str, Mechanism]:
        """The mechanisms that an explanation may name, by id."""
        return {id_: mechanism for id_, mechanism in mechanisms().items() if id_ not in self.without}

    @property
    def adopted(self) -> tuple[Act, ...]:
        """The acts that the simulator has from run.yaml."""
        return tuple(act for act in self.included if act not in self.beside)

    @property
    def runs(self) -> int:
        """How many runs are joined in it."""
        return int(self.record.run_index.max()) + 1

    @property
    def movable(self) -> list[int]:
        """Indices of the parameters that calibration may move."""
        return [i for i, parameter in enumerate(self.parameters) if parameter.sigma > 0]

    def nominal(self) -> State:
        """The simulator as written in run.yaml, with its zero on the median of the seen samples."""
        values = np.array([parameter.nominal for parameter in self.parameters])
        state = State(values, np.zeros(self.runs), self.included)
        if not self.system.free_zero:
            return state
        gap = (self.measured - self.simulate(state))[: self.rows]
        index = self.record.run_index[: self.rows]
        zeros = np.array([np.median(gap[index == run]) if (index == run).any() else 0.0 for run in range(self.runs)])
        return replace(state, zeros=zeros)

    def terms(self, mechanism: Mechanism, nonlinear: Nonlinear) -> list[Term]:
        """Terms of a mechanism at nonlinear parameters; the last few that were asked for are remembered."""
        key = (mechanism.id, tuple(nonlinear.items()))
        if key not in self._terms:
            terms = mechanism.terms(self.drivers, nonlinear)
            most = min(REMEMBERED, REMEMBERED_NUMBERS // len(self.record))
            while self._terms and sum(map(len, [*self._terms.values(), terms])) > most:
                del self._terms[next(iter(self._terms))]
            self._terms[key] = terms
        return self._terms[key]

    def act_terms(self, act: Act) -> list[tuple[Term, float]]:
        """All terms of an act with their coefficients."""
        mechanism = mechanisms()[act.id]
        terms = [term for nonlinear in act.nonlinear for term in self.terms(mechanism, nonlinear)]
        return list(zip(terms, act.coefficients, strict=True))

    def ports(self, acts: tuple[Act, ...]) -> tuple[dict[str, Array], list[tuple[Term, float]]]:
        """The acts' sums at each port, shape (samples,) in its unit, and the operators on the reading."""
        added: dict[str, Array] = {}
        operators = []
        for act in acts:
            for term, coefficient in self.act_terms(act):
                if coefficient == 0.0:
                    continue
                if callable(term.signal):
                    operators.append((term, coefficient))
                else:
                    port = self.system.ports[term.port]
                    before = added.get(port)
                    step = coefficient * term.signal
                    added[port] = step if before is None else before + step
        return added, operators

    def simulated(self, values: Array, added: dict[str, Array]) -> Array:
        """The system's channel; values after the system's own ones are the motor's zeros of later runs.

        `values` in the parameters' units, `added` in the ports' units; shape (samples,) in the channel's unit.
        """
        own = len(values) - self.homed
        if self.homed:
            port = self.system.ports["twist"]
            shift = np.concatenate([[0.0], values[own:]])[self.record.run_index]
            added = {**added, port: added[port] + shift if port in added else shift}
        if not self.system.remembers or self.runs == 1:
            return self.system.simulate(values[:own], self.drivers, added)
        parts = [self.record.run_index == run for run in range(self.runs)]  # no memory reaches from run to run
        moved = {port: np.broadcast_to(np.asarray(acting, float), len(self.record)) for port, acting in added.items()}
        return np.concatenate(
            [
                self.system.simulate(values[:own], self.drivers.inputs(rows), {p: a[rows] for p, a in moved.items()})
                for rows in parts
            ]
        )

    def reading(self, values: Array, added: dict[str, Array], operators: list[tuple[Term, float]]) -> Array:
        """The reading of a simulator without its zero. Shape (samples,), in the channel's unit."""
        return self.read(self.simulated(values, added), added, operators)

    @staticmethod
    def read(clean: Array, added: dict[str, Array], operators: list[tuple[Term, float]]) -> Array:
        """The simulated channel after operators and the sensor port: the reading without zero.

        Shape (samples,), in the channel's unit.
        """
        changes = [coefficient * term.signal(clean) for term, coefficient in operators if callable(term.signal)]
        reading = clean
        for change in changes:
            reading = reading + change
        return reading + added["sensor"] if "sensor" in added else reading

    def simulate(self, state: State) -> Array:
        """Predicted channel of every sample. Shape (samples,), in the channel's unit."""
        added, operators = self.ports(state.acts)
        return self.reading(state.values, added, operators) + state.zeros[self.record.run_index]
