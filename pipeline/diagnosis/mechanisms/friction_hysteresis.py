"""A rounded loop by direction that grows with load or twist: friction of strands and guides [C2-C5]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.recursions import play
from pipeline.diagnosis.shapes import grid

ROUNDINGS = ((0.005, 0.02), (0.02, 0.06), (0.06, 0.2))  # of the range: turns after a reversal that a loop needs


def shapes(drivers: Drivers) -> list[Shape]:
    """Stretch, by how far after a reversal the loop is open again; or a play of twist as wide as the load is heavy.

    `loaded`: whether the recording can tell a loop that follows the load from one that does not.
    """
    stretch = [
        {
            "half_turns": float(f"{a * drivers.span:.6g}"),
            "wide_half_turns": float(f"{b * drivers.span:.6g}"),
            "loaded": float(drivers.loaded),
        }
        for a, b in ROUNDINGS
    ]
    usual = float(f"{max(float(np.median(drivers.load)), 1e-3):.6g}")
    plays = [
        {**shape, "usual_load": usual} for shape in grid("play_turns", 1e-3 * drivers.span, 0.1 * drivers.span, 14)
    ]
    return [*stretch, *plays]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Stretch by a memory of direction, growing with load, with load and twist, or not at all; or lost twist.

    A loop that grows with the twist alone is a play of constant width, and not friction's.
    """
    if "play_turns" in shape:
        width = shape["play_turns"] * np.maximum(drivers.load / shape["usual_load"], 0.0)
        lost = play(drivers.turns, width) - drivers.turns
        half = play(drivers.turns, 0.4 * width) - drivers.turns
        return [Term("share", "twist", lost, "1", high=1.25), Term("inner_share", "twist", half, "1", high=1.25)]
    slope = drivers.tangent
    found = []
    for name, wide in (("sharp", shape["half_turns"]), ("round", shape["wide_half_turns"])):
        side = drivers.directed(wide)
        signals = {"mm": side, "load_twist_mm_per_10_n": side * drivers.load * slope}
        signals["load_steep_mm_per_10_n"] = side * drivers.load * slope**3
        if shape["loaded"]:
            signals["load_mm_per_10_n"] = side * drivers.load
        found += [Term(f"{name}_{key}", "length", signal, "mm") for key, signal in signals.items()]
    return found


MECHANISM = Mechanism(
    id="friction_hysteresis",
    driver="direction x load",
    equation="dx = -(F/K) g(a) s, s: stop operators of the twist (Prandtl-Ishlinskii)",
    source="physics.md C2-C5",
    confused_with="backlash, sensor_lag, viscous_loss",
    told_apart_by="two loads (backlash does not follow the load) and two speeds (a lag follows the speed)",
    sentence="Winding and unwinding part by up to a loop of friction, {size}, which grows with load or twist.",
    shapes=shapes,
    terms=terms,
)
