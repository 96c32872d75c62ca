"""Which effects look alike to any diagnosis: the best copy of one that another can make, once calibration is free."""

from collections.abc import Iterable

import numpy as np
from scipy.optimize import nnls

from pipeline.kinematics import Array
from pipeline.proof.case import Case
from pipeline.proof.draws import NAMED, draw_effect
from pipeline.proof.perform import perform
from pipeline.proof.size import OutOfReach, calibrated, rms, strength_for

SHAPES = 6  # of the other effect, drawn; a copy may mix them, which is more than one set of parameters can
THIN = 5  # samples of which one is compared


def left_over(case: Case, names: Iterable[str] = NAMED, shapes: int = SHAPES) -> dict[str, float]:
    """By effect: what it leaves of the case's mismatch, in noise floors, when it copies it as well as it can.

    What leaves less than a diagnosis could see is a tie by construction, whatever the recording is worth else.
    """
    bench, protocol, floor_mm = case.bench, case.protocol, case.nuisance.floor_mm
    rng = np.random.default_rng([case.seed, 2])
    clean_mm = calibrated(bench, perform(bench, protocol, case.effects), floor_mm).residual_mm[::THIN]
    # what calibration leaves of nothing is no copy: the limits of the dimensions show in it
    bare_mm = calibrated(bench, perform(bench, protocol, {}), floor_mm).residual_mm[::THIN]
    left = {}
    for name in names:
        copies: list[Array] = []
        for _ in range(shapes):
            of = draw_effect(name, bench, protocol, rng)
            try:
                strength, _ = strength_for(name, of, bench, protocol, floor_mm, 1.0)
            except OutOfReach:
                continue
            copy = calibrated(bench, perform(bench, protocol, {name: of(strength)}), floor_mm)
            copies.append(copy.residual_mm[::THIN] - bare_mm)
        wanted_mm = clean_mm - bare_mm
        mixed, _ = nnls(np.array(copies).T, wanted_mm) if copies else (np.zeros(0), 0.0)
        copied_mm = np.array(copies).T @ mixed if copies else np.zeros(len(wanted_mm))
        left[name] = rms(wanted_mm - copied_mm) / floor_mm
    return left
