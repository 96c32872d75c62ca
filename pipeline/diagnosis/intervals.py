"""90 % intervals, honest when a formula is only nearly right: the fit has a smooth random effect inside it."""

from dataclasses import dataclass

import numpy as np

from pipeline.diagnosis import generic
from pipeline.diagnosis.linear import Key, Linear
from pipeline.diagnosis.noise import Noise
from pipeline.diagnosis.problem import Problem, State
from pipeline.kinematics import Array

Z90 = 1.6448536269514722
FORM_SCALES = np.geomspace(0.01, 3.0, 24)  # noise floors: candidates of the random effect's size per column
LEAST_FORM = 0.02


@dataclass(frozen=True)
class Interval:
    """A value with its 90 % interval."""

    value: float
    low: float
    high: float


def _form_scale(gram: Array, moment: Array, samples: int) -> float:
    """Size of the random effect that makes the recording likeliest; everything else is projected out."""
    values, vectors = np.linalg.eigh(gram)
    values, along = np.maximum(values, 0.0), vectors.T @ moment

    def likelihood(scale: float) -> float:
        variance = scale**2
        return float(
            0.5 * np.sum(variance * along**2 / (1.0 + variance * values)) - 0.5 * np.sum(np.log1p(variance * values))
        )

    return float(max(FORM_SCALES, key=likelihood))


def intervals(problem: Problem, state: State, noise: Noise) -> tuple[dict[str, Interval], dict[str, Interval]]:
    """Intervals of every movable parameter and of the size (rms) of every act, by name and by id."""
    acts = tuple(act for act in state.acts if act not in problem.included)
    smooth = generic.dictionary(problem.drivers)[:, : problem.rows]
    scale = np.sqrt(np.mean(np.square(smooth), axis=1))
    smooth = smooth[scale > 0] / scale[scale > 0][:, None] * noise.floor
    linear = Linear(problem, state, noise, {act.id: list(act.shapes) for act in acts}, np.ascontiguousarray(smooth))
    keys: tuple[Key, ...] = tuple((act.id, number) for act in acts for number in range(len(act.shapes)))
    own = linear.columns_of(keys)
    ridge = np.zeros(len(own))
    known = len(linear.calibration)
    coefficients = np.concatenate([np.array(linear.at)[:known], *(np.array(act.coefficients) for act in acts)])
    at = known
    for act in acts:
        part = np.arange(at, at + len(act.coefficients))
        sizes = np.sqrt(np.diag(linear.raw_gram)[own[part]] / linear.rows)
        effect = float(np.sqrt(np.mean(np.square(linear.table[own[part]].T @ coefficients[part])))) or noise.floor
        ridge[part] = np.square(np.maximum(sizes, 1e-12) / effect)
        at += len(act.coefficients)
    gram = linear.gram[np.ix_(own, own)] + np.diag(ridge + 1e-12 * np.diag(linear.gram)[own])
    cross = linear.gram[np.ix_(linear.extra, own)]
    inner = linear.gram[np.ix_(linear.extra, linear.extra)]
    residual_moment = linear.moment[linear.extra] - cross @ coefficients
    solved = np.linalg.solve(gram, cross.T)
    left_moment = residual_moment - solved.T @ (linear.moment[own] - linear.gram[np.ix_(own, own)] @ coefficients)
    form = max(_form_scale(inner - cross @ solved, left_moment, linear.rows), LEAST_FORM)
    full = np.block([[gram, cross.T], [cross, inner + np.eye(len(linear.extra)) / form**2]])
    whole = np.linalg.inv(full)
    covariance = whole[: len(own), : len(own)]
    gradient = np.concatenate([linear.moment[own] - linear.gram[np.ix_(own, own)] @ coefficients, residual_moment])
    shift = (whole @ gradient)[: len(own)]

    def interval(value: float, weights: Array) -> Interval:
        spread = Z90 * float(np.sqrt(max(float(weights @ covariance @ weights), 0.0)))
        middle = value + 0.5 * float(weights @ shift)
        return Interval(value, min(middle - spread, value), max(middle + spread, value))

    parameters = {}
    for place, index in enumerate(problem.movable):
        weights = np.zeros(len(own))
        weights[problem.runs + place] = 1.0
        parameters[problem.parameters[index].name] = interval(float(state.values[index]), weights)
    sizes_: dict[str, Interval] = {}
    at = known
    for act in acts:
        part = np.arange(at, at + len(act.coefficients))
        at += len(act.coefficients)
        effect = linear.table[own[part]].T @ coefficients[part]
        rest = State(state.values, state.zeros, tuple(other for other in state.acts if other is not act))
        size = float(np.sqrt(np.mean(np.square((problem.simulate(state) - problem.simulate(rest))[: problem.rows]))))
        weights = np.zeros(len(own))
        norm = float(np.sqrt(np.mean(np.square(effect)))) or 1.0
        weights[part] = linear.table[own[part]] @ effect / (linear.rows * norm)
        found = interval(size, weights)
        sizes_[act.id] = Interval(found.value, max(found.low, 0.0), found.high)
    return parameters, sizes_
