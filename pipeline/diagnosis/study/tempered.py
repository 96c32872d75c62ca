"""A simulator fitted again that trusts a recording only as far as the residual of the fit is noise.

A residual that is no noise lasts for many samples. These samples together say little more than one. A fit that counts
each of them moves dimensions far, to remove what no dimension can explain. On another motion such a simulator errs more
than one with the measured dimensions. Here samples count only as far as they are independent. So a dimension that the
recording does not show stays near its measured value.

Source: Geyer, "Practical Markov chain Monte Carlo", Statistical Science 7, 1992 (how much correlated samples say);
Müller, "Risk of Bayesian inference in misspecified models", Econometrica 81, 2013 (how far to trust a wrong model).
"""

from dataclasses import replace

import numpy as np

from ...ground.kinematics import Array
from ..choice.outcome import Study
from ..fit.calibrate import calibrate, without_outliers
from ..fit.linear import Linear
from ..fit.problem import Problem, State
from ..numerics.noise import Noise, white
from ..numerics.recursions import whiten

TOO_SURE = 2.0  # times the variance from noise: a residual that moves a fit by more is at least half no noise
ROUNDS = 3  # fits, each weighed by the residual of the one before


def long_run_variance(signal: Array) -> float:
    """Variance of a mean of samples, times their number: for white noise this is its own variance.

    Of shape (samples,), in any unit. Autocovariances are added in pairs while these are positive.
    """
    centred = signal - signal.mean()
    spectrum = np.fft.rfft(centred, 2 * len(centred))
    covariance = np.fft.irfft(np.square(np.abs(spectrum)))[: len(centred)] / len(centred)
    pairs = covariance[: len(centred) // 2 * 2].reshape(-1, 2).sum(axis=1)
    end = int(np.argmax(pairs <= 0.0)) if (pairs <= 0.0).any() else len(pairs)
    return max(float(2.0 * pairs[:end].sum() - covariance[0]), float(covariance[0]) / len(centred))


def too_sure(problem: Problem, noise: Noise, state: State) -> float:
    """How many times farther, squared, the residual of a state moves a fit than noise alone would."""
    residual = (problem.measured - problem.simulate(state))[: problem.rows]
    return long_run_variance(
        whiten(residual[None], noise.ar, problem.drivers.first[: problem.rows])[0] / noise.innovation
    )


def tempered(studied: Study, fine: Problem) -> Study:
    """The study with its simulator fitted again to `fine` where its residual is mostly no noise; verdicts stay.

    All samples weigh alike in that fit, and each weighs only as much as the residual allows. Nonlinear parameters are
    kept.
    """
    if studied.closest:
        alone = tempered(replace(studied, state=studied.closest, closest=None), fine)
        studied = replace(studied, closest=alone.state, best=alone.best)
    if too_sure(studied.problem, studied.noise, studied.state) <= TOO_SURE:
        return studied
    fine, _ = without_outliers(fine, studied.state)
    chance = tuple(act for act in studied.state.acts if act.id in studied.random)
    state = replace(studied.state, acts=tuple(act for act in studied.state.acts if act not in chance))
    for _ in range(ROUNDS):
        acts = tuple(act for act in state.acts if act not in fine.included)
        weights = white(float(np.sqrt(long_run_variance((fine.measured - fine.simulate(state))[: fine.rows]))))
        state = calibrate(fine, weights, state, acts)
    spreads = _spreads(fine, weights, state)
    state = replace(state, acts=(*state.acts, *chance))
    base = state if studied.state is studied.base else studied.base
    best = state if studied.state is studied.best else studied.best
    return replace(studied, state=state, base=base, best=best, spreads=spreads)


def _spreads(problem: Problem, noise: Noise, state: State) -> dict[str, float]:
    """The standard deviation of each dimension after such a fit, in its unit, by name."""
    acts = {act.id: list(act.nonlinear) for act in state.acts if act not in problem.included}
    linear = Linear(problem, state, noise, acts)
    columns = linear.columns_of(tuple((id_, number) for id_, sets in acts.items() for number in range(len(sets))))
    gram = linear.gram[np.ix_(columns, columns)]
    sigma = np.sqrt(np.maximum(np.diag(np.linalg.pinv(gram, hermitian=True)), 0.0))
    places = enumerate(problem.movable, start=problem.runs)  # behind the zeros
    return {problem.parameters[index].name: float(sigma[place]) for place, index in places}
