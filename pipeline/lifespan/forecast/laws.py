"""How an indicator may go on over strokes: candidate laws, linear in all but one or two parameters of their columns.

Source: Meeker and Escobar, Statistical Methods for Reliability Data, 1998 (paths of wear); Voight, "A relation to
describe rate-dependent material failure", Science 243, 1989 (a hyperbola before the end).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array

Columns = Callable[..., tuple[Array, ...]]
STEPS = 16  # of a grid over one nonlinear parameter


@dataclass(frozen=True)
class Law:
    """Columns after the constant over n (strokes), by nonlinear parameters, and the bounds of each of these.

    Those called `tau` and `N` are strokes: their bounds are shares of the strokes seen.
    The last column of a law with `end` is wear that goes on or accelerates: its coefficient is not negative. A law is
    fitted to the last `recent` share of the strokes: what a string did when it was new tells little of its end.
    """

    name: str
    formula: str
    columns: Columns
    bounds: tuple[tuple[str, float, float], ...] = ()
    end: bool = False
    recent: float = 1.0

    def axes(self, seen: float) -> list[Array]:
        """Values of each nonlinear parameter on the grid for so many strokes seen.

        Each of shape (values,), in strokes or without a unit.
        """
        steps = STEPS if len(self.bounds) < 2 else STEPS // 2
        scale = [seen if name in ("tau", "N") else 1.0 for name, *_ in self.bounds]
        return [np.geomspace(low * by, high * by, steps) for (_, low, high), by in zip(self.bounds, scale, strict=True)]

    def table(self, n: Array, nonlinear: Array, seen: float) -> Array:
        """Columns at strokes n for candidates of the nonlinear parameters, each column but the constant 1 at `seen`.

        From shapes (strokes,) and (candidates, parameters) to shape (candidates, strokes, columns), without units.
        """
        values = [column[:, None] for column in nonlinear.T]
        rows = [np.ones((len(nonlinear), len(n)))]
        now = self.columns(np.array([[seen]]), *values)
        for column, last in zip(self.columns(n[None, :], *values), now, strict=True):
            rows.append(np.broadcast_to(column / last, (len(nonlinear), len(n))))
        return np.stack(rows, axis=-1)


def _log(n: Array, n0: Array) -> tuple[Array, ...]:
    return (np.log1p(n / n0),)


def _hyperbola(n: Array, end: Array) -> tuple[Array, ...]:
    """1/(1 − n/N) without its constant and slope, which the law's own columns have; huge beyond N."""
    life_left = 1.0 - n / end
    return n, np.where(life_left > 1e-3, np.square(n / end) / np.maximum(life_left, 1e-3), 1e6)


def _onset(n: Array, tau: Array) -> tuple[Array, ...]:
    return n, np.expm1(np.minimum(n / tau, 60.0))


LAWS = (
    Law("constant", "a", lambda n: ()),
    Law("logarithmic", "a + b ln(1 + n/n0)", _log, (("n0", 0.3, 100.0),)),
    Law("power", "a + b n^p", lambda n, p: (n**p,), (("p", 0.15, 0.9),)),
    Law("saturating", "a + b (1 - exp(-n/tau))", lambda n, tau: (-np.expm1(-n / tau),), (("tau", 0.05, 3.0),)),
    Law("linear", "a + b n", lambda n: (n,)),
    Law("linear of late", "a + b n", lambda n: (n,), recent=1 / 3),
    Law("quadratic of late", "a + b n + c n^2", lambda n: (n, n * n), end=True, recent=1 / 2),
    Law(
        "saturating, then linear",
        "a + b (1 - exp(-n/tau)) + c n",
        lambda n, tau: (-np.expm1(-n / tau), n),
        (("tau", 0.02, 1.0),),
        True,
    ),
    Law("linear, then a hyperbola", "a + b n + c/(1 - n/N)", _hyperbola, (("N", 1.05, 12.0),), True),
    Law("linear, then a power", "a + b n + c n^p", lambda n, p: (n, n**p), (("p", 1.5, 8.0),), True),
    Law("linear, then an exponential", "a + b n + c exp(n/tau)", _onset, (("tau", 0.1, 3.0),), True),
    Law(
        "logarithmic, then a power",
        "a + b ln(1 + n/n0) + c n^p",
        lambda n, n0, p: (np.log1p(n / n0), n**p),
        (("n0", 0.3, 100.0), ("p", 1.0, 8.0)),
        True,
    ),
)
