"""What a mechanism's class leaves of an effect that a test made by a formula of its own."""

import numpy as np
from scipy.optimize import nnls

from pipeline.diagnosis.mechanisms.library import mechanisms

CURVE = 3  # order of the polynomial of the motion that stands for what calibration takes


def left_by_class(problem, id_: str, effect: np.ndarray) -> float:
    """The least share of what calibration leaves of an effect, that no candidate of a mechanism follows.

    The effect acts where the mechanism's terms do. Shape (samples,), in any unit. A smooth curve of the motion stands
    for calibration.
    """
    mechanism, shares = mechanisms()[id_], []
    place = problem.drivers.motion / problem.drivers.motion.max()
    curve, _ = np.linalg.qr(np.vander(place, CURVE + 1))

    def beside(columns: np.ndarray) -> np.ndarray:
        return columns - curve @ (curve.T @ columns)

    seen = beside(effect)
    for nonlinear in mechanism.candidates(problem.drivers):
        signals = [term.signal for term in mechanism.terms(problem.drivers, nonlinear) if np.any(term.signal)]
        columns = beside(np.column_stack(signals))
        scale = np.linalg.norm(columns, axis=0)
        columns = columns[:, scale > 1e-9 * scale.max()] / scale[scale > 1e-9 * scale.max()]
        shares.append(nnls(columns, seen)[1] / np.linalg.norm(seen))
    return min(shares)
