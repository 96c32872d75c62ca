"""What rubs grips harder at low speed than at speed: Stribeck's fall of friction."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term

SLOW = (0.03, 0.06)  # of the highest rate: at this speed all but a third of the grip is gone; wider is like oil
STICKING = 0.1  # of that speed: below it the grip turns with the direction


def shapes(drivers: Drivers) -> list[Shape]:
    """Stribeck's speed; only where a force is read, and nothing is wound."""
    if drivers.levered or drivers.velocity is None:
        return []
    fastest = float(np.percentile(np.abs(drivers.rate), 99))
    return [{"stribeck_turns_per_s": float(f"{share * fastest:.6g}")} for share in SLOW]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Extra resistance against the motion that fades with the speed."""
    share = drivers.rate / shape["stribeck_turns_per_s"]
    return [Term("extra_mm", "resistance", np.tanh(share / STICKING) * np.exp(-np.abs(share)), "mm")]


MECHANISM = Mechanism(
    id="x_stribeck",
    driver="direction at low speed",
    equation="F = (F_s - F_c) exp(-|v|/v_s) sign(v)",
    source="R. Stribeck, 1902",
    confused_with="friction_hysteresis (which does not fall with the speed)",
    told_apart_by="slow strokes at several speeds",
    sentence="At low speed it grips harder than at speed, by up to half of {span} ({size}).",
    details=("by {extra_mm}, which fades at {stribeck_turns_per_s}",),
    shapes=shapes,
    terms=terms,
)
