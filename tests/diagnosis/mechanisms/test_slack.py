"""The class of slack: a length that is taken up first, and a sag that is taken up bit by bit."""

import numpy as np
import pytest
from scipy.optimize import nnls

from pipeline.diagnosis.mechanisms.library import mechanisms

SLACK = mechanisms()["slack"]


def left(problem, swallowed_mm: np.ndarray, kind: str) -> float:
    """The least share of what slack swallows, beside a zero of the reading, that no candidate of a kind follows."""
    shares = []
    for nonlinear in SLACK.candidates(problem.drivers):
        terms = SLACK.terms(problem.drivers, nonlinear)
        if kind in nonlinear:
            zero = np.ones_like(swallowed_mm)
            columns = np.column_stack([*(term.signal for term in terms), zero, -zero])
            shares.append(nnls(columns, swallowed_mm)[1] / np.linalg.norm(swallowed_mm - swallowed_mm.mean()))
    return min(shares)


@pytest.mark.parametrize("share", [0.04, 0.11, 0.17])
def test_a_length_is_taken_up_first_or_a_sag_bit_by_bit(problem, share) -> None:
    height_mm = problem.drivers.contraction - problem.drivers.contraction.min()
    length_mm = share * height_mm.max()
    taken_up_first = np.minimum(height_mm, length_mm)
    toe = length_mm * (1.0 - np.exp(-height_mm / length_mm))
    assert left(problem, taken_up_first, "take_up_mm") < 0.03
    assert left(problem, toe, "sag_mm") < 0.04
