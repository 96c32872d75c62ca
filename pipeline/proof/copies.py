"""Which effects look alike to any diagnosis: the best copy of an effect by another one, with calibration free.

Source: Lawson and Hanson, Solving Least Squares Problems, 1974 (least squares without negative weights).
"""

from collections.abc import Iterable, Mapping

import numpy as np
from scipy.optimize import nnls

from ..ground.kinematics import Array
from ..rig.concealed import Parameters
from .bench import Bench
from .case import Case
from .draws import EITHER_SIGN, NAMED, draw_effect
from .perform import perform
from .protocol import Protocol
from .size import calibrated, measure, rms

SHAPES = 6  # of each effect, drawn; a copy may mix them, which is more than one set of parameters can
MOST_STRENGTH = 30.0
DEAR = 0.03  # noise floors that a weight of 1 costs, so that no huge shapes cancel each other to make a copy
THIN = 5  # samples of which one is compared
Copies = Mapping[str, Array]  # by effect: what calibration leaves of its shapes, (samples, shapes)


def copies(case: Case, names: Iterable[str] = NAMED, shapes: int = SHAPES) -> Copies:
    """The residual after calibration of every effect on a case's bench, each about one noise floor large."""
    rng = np.random.default_rng([case.seed, 2])
    bench, protocol, floor_mm = case.bench, case.protocol, case.nuisance.floor_mm
    # what calibration leaves of nothing is no copy: the limits of the dimensions show in it
    bare_mm = _left_mm(bench, protocol, {}, floor_mm)
    copied = {}
    for name in names:
        left_mm = [np.zeros(len(bare_mm))]
        for _ in range(shapes):
            of = draw_effect(name, bench, protocol, rng, steady=True)
            kappa = measure(bench, protocol, {name: of(1.0)}, floor_mm)[0].kappa
            if kappa < 1.0 / MOST_STRENGTH:  # nothing of it shows on this protocol: what is left is rounding
                continue
            strength = max(1.0 / kappa, 1e-3)
            left_mm.append(_left_mm(bench, protocol, {name: of(strength)}, floor_mm) - bare_mm)
        both = [-coefficient for coefficient in left_mm] if name in EITHER_SIGN else []
        copied[name] = np.array(left_mm + both).T
    return copied


def left_over(case: Case, of: Copies) -> dict[str, float]:
    """By effect: what is left of the case's mismatch, in noise floors, after the effect's best copy of it.

    An effect that leaves less than a diagnosis could see ties by construction, however good the recording is.
    """
    bench, protocol, floor_mm = case.bench, case.protocol, case.nuisance.floor_mm
    wanted_mm = _left_mm(bench, protocol, case.effects, floor_mm) - _left_mm(bench, protocol, {}, floor_mm)
    dear = DEAR * floor_mm * np.sqrt(len(wanted_mm))
    left_floors = {}
    for name, mixed in of.items():
        costs = dear * np.eye(mixed.shape[1])
        weights = nnls(np.vstack([mixed, costs]), np.append(wanted_mm, np.zeros(len(costs))))[0]
        left_floors[name] = rms(wanted_mm - mixed @ weights) / floor_mm
    return left_floors


def _left_mm(bench: Bench, protocol: Protocol, hidden: Mapping[str, Parameters], floor_mm: float) -> Array:
    return calibrated(bench, perform(bench, protocol, hidden), floor_mm).residual_mm[::THIN]
