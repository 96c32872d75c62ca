"""What of a forecast is drawn: the values that shares of the futures have reached, by the rules that the strokes left
follow. So the edges of the drawn band pass the limit where the interval of the strokes left begins and ends."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...ground.kinematics import Array

SHARES = np.linspace(0.005, 0.995, 199)  # of the futures: those at which a band is kept


@dataclass(frozen=True)
class Band:
    """The values that shares of the futures have reached; after a sudden end a future's value is infinite."""

    ahead: Array  # (steps,), in strokes from the last one seen
    values: Array  # (shares, steps), in the indicator's unit

    def below(self, share: float) -> Array:
        """The value below which that share of the futures stays. Shape (steps,), in the indicator's unit."""
        return np.asarray(self.values[int(np.argmin(np.abs(SHARES - share)))])


def until(end: float, ahead: Array, edges: Sequence[Array]) -> tuple[Array, list[Array]]:
    """Strokes ahead until `end`, and finite edges of a band until there; each of shape (steps,), in any unit.

    Beyond the last stroke at which the limit may be passed the futures say nothing: how much later they pass it was
    measured, not how they go on after it.
    """
    if not np.isfinite(end):
        return ahead, list(edges)
    kept = np.append(ahead[ahead < end], end)
    return kept, [np.interp(kept, ahead, edge) for edge in edges]


def band_of(paths: Array, off: Array, ends: Array, ahead: Array) -> Band:
    """The band of futures `paths`, shape (futures, steps), so many strokes `ahead` of the last one seen, (steps,).

    `off` is by how much each future's limit is off, in the indicator's unit, and `ends` the strokes until its sudden
    end; both of shape (futures,). A future counts by the highest value that it has reached.
    """
    reached = np.maximum.accumulate(paths - off[:, None], axis=1)
    reached = np.where(ahead >= ends[:, None], np.inf, reached)
    return Band(ahead, np.quantile(reached, SHARES, axis=0, method="inverted_cdf"))
