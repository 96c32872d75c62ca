"""What a mechanism's class leaves of an effect that a test made by a formula of its own."""

import numpy as np
from scipy.optimize import nnls

from pipeline.diagnosis.mechanisms.library import mechanisms


def left_by_class(problem, id_: str, effect: np.ndarray) -> float:
    """The least share of an effect, beside a zero of the reading, that no candidate of a mechanism follows.

    The effect acts where the mechanism's terms do. Shape (samples,), in any unit.
    """
    mechanism, shares = mechanisms()[id_], []
    zero = np.ones_like(effect)
    for nonlinear in mechanism.candidates(problem.drivers):
        signals = [term.signal for term in mechanism.terms(problem.drivers, nonlinear) if np.any(term.signal)]
        columns = np.column_stack([*signals, zero, -zero])
        scale = np.linalg.norm(columns, axis=0)
        shares.append(nnls(columns / scale, effect)[1] / np.linalg.norm(effect - effect.mean()))
    return min(shares)
