"""Slow motion goes in jerks: what sticks is drawn along until it slips [C7]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.recursions import sticking


def shapes(drivers: Drivers) -> list[Shape]:
    """How far the contraction is ahead, in mm, before it slips; `usual_rate` (turns/s) says what is slow."""
    reach_mm = float(np.ptp(drivers.contraction))
    rate = np.abs(drivers.rate)
    usual = float(f"{np.median(rate[rate > 0.1 * rate.max()]) if rate.max() > 0 else 1.0:.6g}")
    return [
        {"reach_mm": float(f"{value:.6g}"), "back_share": back, "usual_rate": usual}
        for value in np.geomspace(1e-3, 0.1, 32) * reach_mm
        for back in (0.0, 0.15, 0.4)
    ]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """The gap to what sticks: at every speed, and at low speed only."""
    gap = drivers.contraction - sticking(
        drivers.contraction, shape["reach_mm"], shape["back_share"] * shape["reach_mm"]
    )
    slow = np.exp(-np.square(drivers.rate / shape["usual_rate"]))
    return [Term("always", "length", gap, "1"), Term("slow", "length", gap * slow, "1")]


MECHANISM = Mechanism(
    id="stick_slip",
    driver="slow motion",
    equation="dx = -(x - s), s sticks until |x - s| > reach, then slips",
    source="physics.md C7",
    confused_with="eccentricity, backlash",
    told_apart_by="one slow stroke: the jerks come at equal steps of contraction and vanish at speed",
    sentence="Slow motion goes in jerks of {size}.",
    shapes=shapes,
    terms=terms,
)
