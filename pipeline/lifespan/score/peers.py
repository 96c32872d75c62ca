"""Peers of the forecast: one law for every string, fitted once, and trusted without a check."""

import numpy as np

from ...ground.kinematics import Array
from ..forecast.fitted_law import fit
from ..forecast.laws import LAWS, Law
from ..forecast.strokes_left import FUTURES, HORIZON, STEPS, Left, passages

ONE_LOG = Law("one logarithm", "a + b ln(1 + n)", lambda n: (np.log1p(n),))
LINE = next(law for law in LAWS if law.name == "linear")
PEERS = ("line through all strokes", "line through the last third", "one logarithm")


def peer(name: str, n: Array, values: Array, limit: float, seed: int = 0) -> Left:
    """Strokes left by one of PEERS; the interval comes from its coefficients, and the limit is taken as it is.

    `n` and values have the shape (strokes,), in the indicator's unit.
    """
    seen = float(n[-1] - n[0] + 1.0)
    horizon = HORIZON * seen
    ahead = np.concatenate([[0.0], np.geomspace(0.25, horizon, STEPS)])
    last = slice(2 * len(n) // 3, None) if name == PEERS[1] else slice(None)
    fitted = fit(ONE_LOG if name == PEERS[2] else LINE, n[last] - n[0] + 1.0, values[last])
    if fitted is None:
        return Left("too few strokes")
    paths = fitted.draws(seen + ahead, FUTURES, np.random.default_rng(seed))
    when = passages(paths, np.full(FUTURES, limit), ahead)
    return Left("", np.nan, np.where(when > horizon, np.inf, when), horizon)
