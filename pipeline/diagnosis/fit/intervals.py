"""90 % intervals, honest when a formula is only nearly right: the fit has a smooth random effect inside it.

Source: Patterson and Thompson, "Recovery of inter-block information when block sizes are unequal", Biometrika 58, 1971
(the size of a random effect); Kennedy and O'Hagan, Journal of the Royal Statistical Society B 63, 2001 (a wrong
formula).
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ..mechanisms.library import mechanisms
from ..numerics.noise import Noise
from . import discrepancy, generic
from .linear import Key, Linear
from .problem import Act, Problem, State

Z90 = 1.6448536269514722  # standard deviations that hold 90 % of a normal distribution
DISCREPANCY_SCALES = np.geomspace(0.01, 3.0, 24)  # noise floors: candidates of the random effect's size per column
LEAST_DISCREPANCY = 0.02  # noise floors: least size of the random effect
DISCREPANCY_SHARE = 0.02  # of an effect: what no formula of the library gets right
CONTINUOUS, STEP = 5, 1e-3  # values among the candidates that make a nonlinear parameter continuous; relative step


@dataclass(frozen=True)
class Interval:
    """A value with its 90 % interval."""

    value: float
    low: float
    high: float


def _discrepancy_scale(gram: Array, moment: Array) -> float:
    """Size of the random effect that makes the recording likeliest; everything else is projected out."""
    values, vectors = np.linalg.eigh(gram)
    values, along = np.maximum(values, 0.0), vectors.T @ moment

    def likelihood(scale: float) -> float:
        variance = scale**2
        return float(
            0.5 * np.sum(variance * along**2 / (1.0 + variance * values)) - 0.5 * np.sum(np.log1p(variance * values))
        )

    return float(max(DISCREPANCY_SCALES, key=likelihood))


def continuous(problem: Problem, act: Act) -> list[tuple[int, str]]:
    """The nonlinear parameters of an act that were fitted continuously: by the index of the act's set, and the name."""
    candidates = mechanisms()[act.id].candidates(problem.drivers)
    return [
        (number, name)
        for number, nonlinear in enumerate(act.nonlinear)
        for name in nonlinear
        if len({other[name] for other in candidates if set(other) == set(nonlinear)}) >= CONTINUOUS
    ]


def slopes_of_nonlinear(problem: Problem, state: State, act: Act) -> Array:
    """How the prediction moves with each continuous nonlinear parameter of an act, per half of its value.

    Shape (parameters, samples), in the reading's unit.
    """
    before, slopes = problem.simulate(state), []
    for number, name in continuous(problem, act):
        moved = tuple({**old, name: old[name] * (1.0 + STEP * (i == number))} for i, old in enumerate(act.nonlinear))
        acts = tuple(replace(act, nonlinear=moved) if other is act else other for other in state.acts)
        slopes.append((problem.simulate(replace(state, acts=acts)) - before) * (0.5 / STEP))
    return np.array(slopes).reshape(len(slopes), len(before))


@dataclass(frozen=True)
class Intervals:
    """Intervals of every movable parameter, by name, of the size of every act, by id, and of each run's zero.

    The zeros are in the channel's unit; `zeros_from_first` is by how much each but the first exceeds the first.
    `half_widths` are those of nonlinear parameters.
    These are shares of the value, by the act's id, which time it acts, and the nonlinear parameter's name.
    `covariance` is that of all numbers that were fitted: zeros, movable parameters, the acts' coefficients, each in its
    own unit, and the continuous nonlinear parameters, in halves of the value of each; it is for predictions.
    """

    parameters: dict[str, Interval]
    sizes: dict[str, Interval]
    zeros: tuple[Interval, ...]
    zeros_from_first: tuple[Interval, ...]
    half_widths: dict[tuple[str, int, str], float]
    covariance: Array  # (numbers, numbers)

    def at_least(self, spreads: dict[str, float]) -> "Intervals":
        """These intervals, with those of parameters at least `Z90` standard deviations wide to either side.

        `spreads` has the standard deviations, by parameter, each in its own unit.
        """
        wide = {
            name: Interval(
                interval.value, min(interval.low, interval.value - reach), max(interval.high, interval.value + reach)
            )
            for name, interval in self.parameters.items()
            for reach in [Z90 * spreads.get(name, 0.0)]
        }
        return replace(self, parameters=wide)


def intervals(problem: Problem, state: State, noise: Noise) -> Intervals:
    """Intervals of everything that a state holds.

    The size is the rms of the prediction with the act less the prediction without it, all else held, its constant
    part included. The act's formula may be wrong by smooth factors, which calibration may hide in part.
    """
    acts = tuple(act for act in state.acts if act not in problem.included)
    smooth = generic.dictionary(problem.drivers)
    scale = np.sqrt(np.mean(np.square(smooth[:, : problem.rows]), axis=1))
    smooth = smooth[scale > 0] / scale[scale > 0][:, None] * noise.floor
    deviations = discrepancy.columns(problem, [state])
    shaped = [slopes_of_nonlinear(problem, state, act) for act in acts]
    shaped = [np.vstack([slopes, deviations[act.id]]) for act, slopes in zip(acts, shaped, strict=True)]
    extra = np.ascontiguousarray(np.vstack([*shaped, smooth]))
    linear = Linear(problem, state, noise, {act.id: list(act.nonlinear) for act in acts}, extra)
    keys: tuple[Key, ...] = tuple((act.id, number) for act in acts for number in range(len(act.nonlinear)))
    calibrated, free = len(linear.calibration), linear.extra[sum(map(len, shaped)) :]
    own = np.concatenate([linear.columns_of(keys), linear.extra[: sum(map(len, shaped))]])
    coefficients = np.concatenate([np.array(linear.at)[:calibrated], *(np.array(act.coefficients) for act in acts)])
    coefficients = np.concatenate([coefficients, np.zeros(len(own) - len(coefficients))])
    prior = np.ones(len(own))
    prior[:calibrated] = 0.0  # calibration has its own in the products; half a nonlinear value is one sigma
    effects, at = [], calibrated
    for act in acts:
        part = np.arange(at, at + len(act.coefficients))
        at += len(act.coefficients)
        effects.append((part, linear.table[own[part]].T @ coefficients[part]))
        sizes = np.sqrt(np.diag(linear.raw(own[part])[0]) / linear.rows)
        effect = float(np.sqrt(np.mean(np.square(effects[-1][1])))) or noise.floor
        prior[part] = np.square(np.maximum(sizes, 1e-12) / effect)
    plain = linear.gram[np.ix_(own, own)]
    gram = plain + np.diag(prior + 1e-12 * np.diag(plain))
    cross, inner = linear.gram[np.ix_(free, own)], linear.gram[np.ix_(free, free)]
    own_moment = linear.moment[own] - plain @ coefficients
    discrepancy_moment = linear.moment[free] - cross @ coefficients
    solved = np.linalg.solve(gram, cross.T)
    size = max(
        _discrepancy_scale(inner - cross @ solved, discrepancy_moment - solved.T @ own_moment), LEAST_DISCREPANCY
    )
    whole = np.linalg.inv(np.block([[gram, cross.T], [cross, inner + np.eye(len(free)) / size**2]]))
    covariance = whole[: len(own), : len(own)]
    shift = (whole @ np.concatenate([own_moment, discrepancy_moment]))[: len(own)]

    def interval(value: float, weights: Array, share: float = 0.0) -> Interval:
        spread = Z90 * float(np.sqrt(max(float(weights @ covariance @ weights), 0.0) + (share * value) ** 2))
        middle = value + 0.5 * float(np.clip(weights @ shift, -spread, spread))
        return Interval(value, min(middle - spread, value), max(middle + spread, value))

    each = np.eye(len(own))
    zeros = tuple(interval(float(zero), each[run]) for run, zero in enumerate(state.zeros))
    from_first = tuple(
        interval(float(state.zeros[run] - state.zeros[0]), each[run] - each[0]) for run in range(1, problem.runs)
    )
    parameters = {
        problem.parameters[index].name: interval(float(state.values[index]), each[problem.runs + place])
        for place, index in enumerate(problem.movable)
    }
    sizes_: dict[str, Interval] = {}
    half_widths: dict[tuple[str, int, str], float] = {}
    kept = list(range(at))  # of the numbers that were fitted: no discrepancy of a formula
    for act, ways, (part, effect) in zip(acts, shaped, effects, strict=True):
        rest = State(state.values, state.zeros, tuple(other for other in state.acts if other is not act))
        rms = float(np.sqrt(np.mean(np.square((problem.simulate(state) - problem.simulate(rest))[: problem.rows]))))
        norm = linear.rows * (float(np.sqrt(np.mean(np.square(effect)))) or 1.0)
        weights = np.zeros(len(own))
        weights[part] = linear.table[own[part]] @ effect / norm
        weights[at : at + len(ways)] = ways[:, : problem.rows] @ effect / norm
        for place, (number, name) in enumerate(continuous(problem, act), start=at):
            half_widths[act.id, number, name] = 0.5 * Z90 * float(np.sqrt(covariance[place, place]))
            kept.append(place)
        at += len(ways)
        size_interval = interval(rms, weights, DISCREPANCY_SHARE)
        sizes_[act.id] = Interval(size_interval.value, max(size_interval.low, 0.0), size_interval.high)
    within = _within_noise(linear, own[kept], covariance[np.ix_(kept, kept)])
    return Intervals(parameters, sizes_, zeros, from_first, half_widths, within)


def _within_noise(linear: Linear, columns: NDArray[np.intp], covariance: Array) -> Array:
    """A covariance of shape (numbers, numbers), no larger than the noise of the recording allows.

    A fit is off over its own recording by no more than the noise that it was fitted to. Colour that is taken from few
    slow swings says more.
    """
    table = linear.table[columns][:, : linear.rows]
    off = float(np.sqrt(np.mean(np.sum(table * (covariance @ table), axis=0))))
    return covariance * min(1.0, (linear.noise.floor / off) ** 2) if off > 0.0 else covariance
