"""The linearised fit: columns of calibration and of every candidate, their products, and bounded least squares on them.

All comparisons of sets of mechanisms happen here, on products alone, so that a joint refit with calibration costs
about a tenth of a millisecond.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ..mechanisms.interface import Nonlinear
from ..mechanisms.library import mechanisms
from ..numerics.bounded import boxed, fitted, scan
from ..numerics.columns import Columns
from ..numerics.noise import Noise
from ..numerics.products import Products
from .problem import Act, Problem, State
from .slopes import column, linearised, untouched

Key = tuple[str, int]  # a mechanism's id and the index of one of its candidates
ZERO_SIGMA, FIXED_SIGMA = 1e3, 1e-6  # of a zero that is arbitrary, and of one that is true
FEW, PER_CANDIDATE = 40, 3  # columns that calibration and a few acts have, and that a candidate has on average


@dataclass(frozen=True)
class Fit:
    """A joint bounded fit of calibration and some columns: coefficients by column index, misfit, activity."""

    columns: np.ndarray  # (columns,), places in the table
    coefficients: Array  # (columns,), each in its column's unit
    misfit: float  # whitened, prior included
    energy: float  # squared residual, not whitened, per sample
    active: int


class Linear(Products):
    """A problem linearised at a state, under a noise model, with columns for the candidates of chosen mechanisms."""

    def __init__(
        self,
        problem: Problem,
        state: State,
        noise: Noise,
        catalogue: dict[str, list[Nonlinear]],
        extra: Array | None = None,
        deviations: dict[str, Array] | None = None,
    ) -> None:
        self.problem, self.state, self.noise, self.catalogue = problem, state, noise, dict(catalogue)
        rows = self.rows = problem.rows
        tangent = linearised(problem, state, unclipped=bool(set(catalogue) - {act.id for act in state.acts}))
        clips = any(mechanisms()[id_].clips for id_ in catalogue)
        bare = untouched(problem, tangent) if clips else tangent
        more = sum(map(len, (deviations or {}).values())) + (0 if extra is None else len(extra))
        columns = Columns(rows, FEW + PER_CANDIDATE * sum(map(len, catalogue.values())) + more)
        run_index = problem.record.run_index[:rows]
        reach, spread = (np.inf, ZERO_SIGMA) if problem.system.free_zero else (0.0, FIXED_SIGMA)
        for run in range(problem.runs):
            columns.add((run_index == run).astype(float), -reach, reach, spread, 0.0)  # from where it stands
        for index in problem.movable:
            parameter = problem.parameters[index]
            least, most = (
                max(-parameter.reach * parameter.sigma, parameter.lowest - parameter.nominal),
                parameter.reach * parameter.sigma,
            )
            moved = float(state.values[index] - parameter.nominal)
            columns.add(tangent.slopes[parameter.name][:rows], least, most, parameter.sigma, moved)
        self.calibration = calibration = np.arange(len(columns))
        self.index: dict[Key, np.ndarray] = {}
        for id_, options in catalogue.items():
            beside = [(nonlinear, tangent) for nonlinear in options]
            if bare is not tangent and mechanisms()[id_].clips:
                beside += [(nonlinear, bare) for nonlinear in options]
                self.catalogue[id_] = [*options, *options]
            for number, (nonlinear, reading_at) in enumerate(beside):
                before = len(columns)
                for term in problem.terms(mechanisms()[id_], nonlinear):
                    columns.add(column(problem, term, reading_at)[:rows], term.low, term.high, np.inf)
                self.index[id_, number] = np.arange(before, len(columns))
        self.extra = columns.free(np.zeros((0, rows)) if extra is None else extra, np.inf)
        self.deviations = {id_: columns.free(ways, 1.0) for id_, ways in (deviations or {}).items()}
        self.low, self.high, sigma, self.at = columns.numbers()
        target = (problem.measured - tangent.predicted)[:rows] + self.at[calibration] @ columns.table[calibration]
        for act in state.acts:
            if act in problem.included:
                continue
            for term, coefficient in problem.act_terms(act):
                target = target + coefficient * column(problem, term, tangent)[:rows]
        self.begin = np.zeros(len(columns))  # calibration starts where it stands, the rest at nothing
        self.begin[calibration] = np.clip(self.at[calibration], self.low[calibration], self.high[calibration])
        prior = np.where(np.isfinite(sigma), 1.0 / np.square(sigma), 0.0)
        columns.add(target, 0.0, 0.0, np.inf)
        self.hold(columns.table, prior, noise, problem.drivers.first[:rows])

    @property
    def acting(self) -> tuple[str, ...]:
        """The mechanisms in the catalogue that act at the state, beside those of `run.yaml`; sorted."""
        acts = (act for act in self.state.acts if act not in self.problem.included)
        return tuple(sorted({act.id for act in acts} & set(self.catalogue)))

    def columns_of(self, keys: tuple[Key, ...]) -> np.ndarray:
        """Calibration's columns and those of some candidates. Shape (columns,), as places in the table."""
        return np.concatenate([self.calibration, *(self.index[key] for key in keys)]).astype(int)

    def taken(self, id_: str, numbers: list[int]) -> NDArray[np.bool_]:
        """Which candidates of a mechanism are chosen, or one event with a chosen one.

        Shape (candidates,), without unit.
        """
        options, at_once = self.catalogue[id_], mechanisms()[id_].at_once
        chosen, drivers = [options[number] for number in numbers], self.problem.drivers
        near = [any(at_once(drivers, option, each) for each in chosen) for option in options]
        return np.array(near, bool) | np.isin(np.arange(len(options)), numbers)

    def fit(self, columns: np.ndarray, above: Array | None = None, below: Array | None = None) -> Fit:
        """Whitened joint fit of some columns; `above` and `below` bound their coefficients further.

        Each of shape (columns,), in the column's unit.
        """
        low, high, begin = self.low[columns], self.high[columns], self.begin[columns]
        if above is not None and below is not None:
            low, high = np.maximum(low, above), np.minimum(high, below)
            begin = np.clip(begin, low, high)
        solution, misfit = fitted(self.gram, self.moment, columns, low, high, begin)
        active = int(np.sum((np.abs(solution) * self.scale[columns])[len(self.calibration) :] > 1.0))
        return Fit(columns, solution, self.square + misfit, np.nan, active)

    def scan(self, keys: tuple[Key, ...], id_: str) -> tuple[Array, NDArray[np.intp]]:
        """Whitened misfits, and numbers of active columns, with each candidate of one mechanism added in turn.

        Both of shape (candidates,), misfits without a unit, for they are whitened, and numbers of columns as counts.
        """
        blocks = [self.index[id_, number] for number in range(len(self.catalogue[id_]))]
        starts, counts = np.array([block[0] for block in blocks]), np.array([len(block) for block in blocks])
        columns, calibrated = self.columns_of(keys), len(self.calibration)
        begin = self.begin.copy()
        begin[columns] = self.fit(columns).coefficients  # near to where each of them ends
        misfit, active = scan(self.gram, self.moment, columns, starts, counts, self.low, self.high, begin, calibrated)
        return self.square + misfit, active

    def raw_energy(self, columns: np.ndarray, solution: Array) -> float:
        """Squared residual per sample of a solution, not whitened. Both of shape (columns,)."""
        gram, moment, square = self.raw(columns)
        return float(square - 2.0 * moment @ solution + solution @ gram @ solution) / self.rows

    def plain(self, columns: np.ndarray) -> Fit:
        """Joint fit with all samples weighed alike: its residual is what a person sees in the plot.

        Shape (columns,), places in the table, which are indices.
        """
        gram, moment, _ = self.raw(columns)
        gram[np.arange(len(columns)), np.arange(len(columns))] += self.raw_prior[columns]
        start = np.clip(np.zeros(len(columns)), self.low[columns], self.high[columns])
        solution = boxed(np.ascontiguousarray(gram), moment, self.low[columns], self.high[columns], start)
        return Fit(columns, solution, np.nan, self.raw_energy(columns, solution), 0)

    def gap(self, truth: Fit, rival: np.ndarray) -> float:
        """The misfit that a rival would leave on a noise-free recording made by a fit: the Cox-type expected gap.

        Shape (columns,), places in the table; whitened.
        """
        cross = self.gram[np.ix_(rival, truth.columns)]
        prior = self.gram[np.ix_(truth.columns, truth.columns)]
        moment = cross @ truth.coefficients
        gram = np.ascontiguousarray(self.gram[np.ix_(rival, rival)])
        square = float(truth.coefficients @ prior @ truth.coefficients)
        solution = boxed(
            gram,
            moment,
            self.low[rival],
            self.high[rival],
            np.clip(np.zeros(len(rival)), self.low[rival], self.high[rival]),
        )
        return max(square - 2.0 * float(moment @ solution) + float(solution @ gram @ solution), 0.0)

    def state_of(self, fit: Fit, keys: tuple[Key, ...]) -> State:
        """The state that a linearised fit describes."""
        problem = self.problem
        values = np.array([parameter.nominal for parameter in problem.parameters])
        for place, index in enumerate(problem.movable):
            values[index] += fit.coefficients[problem.runs + place]
        acts: dict[str, tuple[list[Nonlinear], list[float]]] = {}
        at = len(self.calibration)
        for key in keys:
            count = len(self.index[key])
            nonlinears, coefficients = acts.setdefault(key[0], ([], []))
            nonlinears.append(self.catalogue[key[0]][key[1]])
            coefficients.extend(float(value) for value in fit.coefficients[at : at + count])
            at += count
        acts_found = tuple(Act(id_, tuple(nonlinears), tuple(values_)) for id_, (nonlinears, values_) in acts.items())
        zeros = self.state.zeros + fit.coefficients[: problem.runs]
        return State(values, zeros, problem.included + acts_found)
