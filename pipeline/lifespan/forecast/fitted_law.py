"""A law fitted to strokes by least squares, and the curves that its uncertainty allows.

A law is linear in its coefficients once its nonlinear parameters are given. So every candidate of these on a grid is
solved at once. The least of them is the bounded least-squares fit. How much worse the others are says how uncertain the
nonlinear parameters are. Where one candidate takes most of the weight, a finer grid is laid about it.

Source: Golub and Pereyra, "The differentiation of pseudo-inverses and nonlinear least squares problems whose variables
separate", SIAM Journal on Numerical Analysis 10, 1973.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np
from scipy.special import ndtr, ndtri

from ...ground.kinematics import Array
from .laws import Law

FINER, SETTLED = 3, 0.5  # grids laid within each other while one candidate takes most of the weight
RIDGE = 1e-10  # keeps candidates that a short recording cannot tell apart solvable
LONGEST_RUNS = 0.8  # correlation of one stroke's rest with the next one's beyond which no law is at fault but noise


@dataclass(frozen=True)
class Fit:
    """A law fitted at every candidate of its nonlinear parameters.

    Shapes: `nonlinear` (candidates, parameters), `coefficients` (candidates, k), `covariance` (candidates, k, k),
    `weights` (candidates,). `seen` is the last stroke seen; `noise` the standard deviation about the best candidate;
    `freedom` what is left of the strokes' number after the coefficients, fewer where what is left over comes in runs.
    """

    law: Law
    seen: float
    nonlinear: Array  # in strokes or without a unit
    coefficients: Array  # in the indicator's unit
    covariance: Array  # in the indicator's unit squared
    weights: Array  # in shares of 1
    noise: float
    freedom: float

    @property
    def best(self) -> int:
        """Index of the likeliest candidate."""
        return int(np.argmax(self.weights))

    def parameters(self) -> dict[str, float]:
        """Parameters of the best fit, by the names in the formula; the coefficients as at n = `seen`."""
        best = zip(self.law.bounds, self.nonlinear[self.best], strict=True)
        nonlinear = {name: float(value) for (name, *_), value in best}
        table = zip(("a", "b", "c"), self.coefficients[self.best], strict=False)
        return nonlinear | {f"{name}_at_last_stroke": float(value) for name, value in table}

    def curve(self, n: Array) -> Array:
        """The best candidate's values at strokes n. Shape (strokes,), in the indicator's unit."""
        best = self.nonlinear[[self.best]]
        return np.asarray(self.law.table(n, best, self.seen)[0] @ self.coefficients[self.best])

    def moments(self, n: Array) -> tuple[Array, Array]:
        """Mean and variance at strokes n over all candidates and coefficients, noise left out.

        Both of shape (strokes,), in the indicator's unit and its square.
        """
        table = self.law.table(n, self.nonlinear, self.seen)
        means = (table @ self.coefficients[..., None])[..., 0]
        spread = np.sum((table @ self.covariance) * table, axis=-1)
        mean = self.weights @ means
        return mean, self.weights @ (spread + np.square(means - mean))

    def draws(self, n: Array, count: int, generator: np.random.Generator) -> Array:
        """Curves at strokes n, drawn by how likely candidates and coefficients are.

        Shape (count, strokes), in the indicator's unit.
        """
        which = generator.choice(len(self.weights), count, p=self.weights)
        inflate = np.sqrt(self.freedom / generator.chisquare(self.freedom, count))
        turned = self.covariance[:, ::-1, ::-1]  # the end's coefficient first: the others follow it
        size = np.trace(turned, axis1=1, axis2=2)[:, None, None]
        factor = np.linalg.cholesky(turned + (RIDGE * size + 1e-300) * np.eye(turned.shape[-1]))
        wide = generator.standard_normal((count, turned.shape[-1]))
        if self.law.end:
            none = -self.coefficients[which, -1] / (factor[which, 0, 0] * inflate)
            least = ndtr(none)
            likely = ndtri(np.clip(least + (1.0 - least) * generator.random(count), 1e-12, 1.0 - 1e-12))
            wide[:, 0] = np.maximum(likely, none)
        moves = np.einsum("mkl,ml->mk", factor[which], wide)[:, ::-1] * inflate[:, None]
        drawn = self.coefficients[which] + moves
        used, at = np.unique(which, return_inverse=True)
        return np.asarray(np.einsum("mnk,mk->mn", self.law.table(n, self.nonlinear[used], self.seen)[at], drawn))


def fit(law: Law, n: Array, values: Array, weights: Array | None = None) -> Fit | None:
    """Fit a law to values over strokes n, both of shape (strokes,), weighed by how many strokes each stands for.

    Gives None where there are too few to judge the law by. In the indicator's unit.
    """
    weights = np.ones(len(n)) if weights is None else weights
    late = slice(len(n) - round(law.recent * len(n)), None)
    n, values, weights = n[late], values[late], weights[late]
    seen, columns = float(n[-1]), 1 + len(law.columns(np.ones((1, 1)), *np.ones((len(law.bounds), 1, 1))))
    if len(n) < columns + len(law.bounds) + 2:
        return None
    axes = law.axes(seen)
    for _ in range(FINER):
        solved = _solved(law, axes, seen, n, values, weights)
        if not law.bounds or solved.weights.max() < SETTLED:
            break
        place = np.unravel_index(solved.best, [len(axis) for axis in axes])
        axes = [
            np.geomspace(axis[max(int(at) - 1, 0)], axis[min(int(at) + 1, len(axis) - 1)], len(axis))
            for axis, at in zip(axes, place, strict=True)
        ]
    return solved


def _solved(law: Law, axes: list[Array], seen: float, n: Array, values: Array, weights: Array) -> Fit:
    """Least squares at every candidate of the nonlinear parameters on a grid."""
    nonlinear = np.array(list(product(*axes))).reshape(-1 if axes else 1, len(axes))
    table = law.table(n, nonlinear, seen)
    columns = table.shape[-1]
    heavy = table * weights[None, :, None]
    gram = heavy.transpose(0, 2, 1) @ table
    gram += RIDGE * np.trace(gram, axis1=1, axis2=2)[:, None, None] * np.eye(columns)
    inverse = np.linalg.inv(gram)
    coefficients = (inverse @ (heavy.transpose(0, 2, 1) @ values)[..., None])[..., 0]
    rest = values - (table @ coefficients[..., None])[..., 0]
    squares = np.maximum(np.einsum("n,gn->g", weights, np.square(rest)), 1e-300)
    best = rest[int(np.argmin(squares))] * np.sqrt(weights)
    runs = float(np.clip(best[1:] @ best[:-1] / max(best @ best, 1e-300), 0.0, LONGEST_RUNS))
    share = (1.0 - runs) / (1.0 + runs)
    freedom = max(share * len(n) - columns, 2.0)
    variance = squares / (len(n) - columns)
    covariance = inverse * variance[:, None, None] / share
    score = -0.5 * freedom * np.log(squares) - 0.5 * np.linalg.slogdet(gram)[1]
    if law.end:
        size = np.sqrt(np.maximum(covariance[:, -1, -1], 1e-300))
        score += np.log(np.maximum(ndtr(coefficients[:, -1] / size), 1e-12))
    likely = np.exp(score - score.max())
    noise = float(np.sqrt(variance.min()))
    return Fit(law, seen, nonlinear, coefficients, covariance, likely / likely.sum(), noise, freedom)
