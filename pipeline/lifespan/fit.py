"""A law fitted to strokes by least squares, and the curves that its uncertainty allows.

A law is linear in its coefficients once its shape is given, so every shape on a grid is solved at once: the least of
them is the bounded least-squares fit, and how much worse the others are says how uncertain the shape is. Where one
shape takes most of the weight, a finer grid is laid about it.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np
from scipy.special import ndtr, ndtri

from ..ground.kinematics import Array
from .laws import Law

FINER, SETTLED = 3, 0.5  # grids laid within each other while one shape takes most of the weight
RIDGE = 1e-10  # keeps shapes that a short recording cannot tell apart solvable
LONGEST_RUNS = 0.8  # correlation of one stroke's rest with the next one's beyond which no law is at fault but noise


@dataclass(frozen=True)
class Fit:
    """A law fitted at every shape: coefficients (shapes, k), their covariance (shapes, k, k), noise, shapes' weights.

    `seen` is the last stroke seen; `noise` the standard deviation about the best shape; `freedom` what is left of
    the strokes' number after the coefficients, fewer where what is left over comes in runs.
    """

    law: Law
    seen: float
    shapes: Array
    coefficients: Array
    covariance: Array
    weights: Array
    noise: float
    freedom: float

    @property
    def best(self) -> int:
        """Index of the likeliest shape."""
        return int(np.argmax(self.weights))

    def parameters(self) -> dict[str, float]:
        """Shape and coefficients of the best fit, by the names in the formula; the coefficients as at n = `seen`."""
        shape = {name: float(v) for (name, *_), v in zip(self.law.bounds, self.shapes[self.best], strict=True)}
        table = zip(("a", "b", "c"), self.coefficients[self.best], strict=False)
        return shape | {f"{name}_at_last_stroke": float(value) for name, value in table}

    def curve(self, n: Array) -> Array:
        """The best shape's values at strokes n. Shape (strokes,)."""
        shape = self.shapes[[self.best]]
        return np.asarray(self.law.table(n, shape, self.seen)[0] @ self.coefficients[self.best])

    def moments(self, n: Array) -> tuple[Array, Array]:
        """Mean and variance at strokes n over all shapes and coefficients, noise left out.

        Both of shape (strokes,), in the indicator's unit and its square.
        """
        table = self.law.table(n, self.shapes, self.seen)
        means = (table @ self.coefficients[..., None])[..., 0]
        spread = np.sum((table @ self.covariance) * table, axis=-1)
        mean = self.weights @ means
        return mean, self.weights @ (spread + np.square(means - mean))

    def draws(self, n: Array, count: int, generator: np.random.Generator) -> Array:
        """Curves at strokes n, drawn by how likely shapes and coefficients are; shape (count, strokes)."""
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
        return np.asarray(np.einsum("mnk,mk->mn", self.law.table(n, self.shapes[used], self.seen)[at], drawn))


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
        found = _solved(law, axes, seen, n, values, weights)
        if not law.bounds or found.weights.max() < SETTLED:
            break
        place = np.unravel_index(found.best, [len(axis) for axis in axes])
        axes = [
            np.geomspace(axis[max(int(at) - 1, 0)], axis[min(int(at) + 1, len(axis) - 1)], len(axis))
            for axis, at in zip(axes, place, strict=True)
        ]
    return found


def _solved(law: Law, axes: list[Array], seen: float, n: Array, values: Array, weights: Array) -> Fit:
    """Least squares at every shape on a grid."""
    shapes = np.array(list(product(*axes))).reshape(-1 if axes else 1, len(axes))
    table = law.table(n, shapes, seen)
    columns = table.shape[-1]
    heavy = table * weights[None, :, None]
    gram = heavy.transpose(0, 2, 1) @ table
    gram += RIDGE * np.trace(gram, axis1=1, axis2=2)[:, None, None] * np.eye(columns)
    inverse = np.linalg.inv(gram)
    coefficients = (inverse @ (heavy.transpose(0, 2, 1) @ values)[..., None])[..., 0]
    rest = values - (table @ coefficients[..., None])[..., 0]
    left = np.maximum(np.einsum("n,gn->g", weights, np.square(rest)), 1e-300)
    best = rest[int(np.argmin(left))] * np.sqrt(weights)
    runs = float(np.clip(best[1:] @ best[:-1] / max(best @ best, 1e-300), 0.0, LONGEST_RUNS))
    share = (1.0 - runs) / (1.0 + runs)
    freedom = max(share * len(n) - columns, 2.0)
    variance = left / (len(n) - columns)
    covariance = inverse * variance[:, None, None] / share
    score = -0.5 * freedom * np.log(left) - 0.5 * np.linalg.slogdet(gram)[1]
    if law.end:
        size = np.sqrt(np.maximum(covariance[:, -1, -1], 1e-300))
        score += np.log(np.maximum(ndtr(coefficients[:, -1] / size), 1e-12))
    likely = np.exp(score - score.max())
    noise = float(np.sqrt(variance.min()))
    return Fit(law, seen, shapes, coefficients, covariance, likely / likely.sum(), noise, freedom)
