"""A rounded loop by direction that grows with load or twist: friction of strands and guides [C2-C5]."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term
from pipeline.diagnosis.recursions import play
from pipeline.diagnosis.shapes import grid

DRY = (0.003, 0.01, 0.03, 0.1)  # of the highest rate: below it what slides without a string begins to stick
ROUNDINGS = ((0.005, 0.02), (0.02, 0.06), (0.06, 0.2))  # of the range: turns after a reversal that a loop needs


SLACK_LOAD = 0.5  # load units: a cable that hangs loose yields more to the same friction
WIDTHS = {"sharp": "half_turns", "round": "wide_half_turns"}
TOTALS = {"mm": "half_loop_mm", "load_mm_per_10_n": "half_loop_mm_per_10_n"}


def shapes(drivers: Drivers) -> list[Shape]:
    """Stretch, by how far after a reversal the loop is open again; or a play of twist as wide as the load is heavy.

    Where nothing is twisted it may also be dry: open at once, closed at rest. `loaded`: whether the recording can tell
    a loop that follows the load from one that does not.
    """
    stretch = [
        {
            "half_turns": float(f"{a * drivers.span:.6g}"),
            "wide_half_turns": float(f"{b * drivers.span:.6g}"),
            "loaded": float(drivers.loaded),
        }
        for a, b in ROUNDINGS
    ]
    if not drivers.levered:
        fastest = float(np.percentile(np.abs(drivers.rate), 99))
        dry = [{"slow_turns_per_s": float(f"{share * fastest:.6g}"), "loaded": float(drivers.loaded)} for share in DRY]
        return [*stretch, *dry]
    usual = float(f"{max(float(np.median(drivers.load)), 1e-3):.6g}")
    plays = [
        {**shape, "usual_load": usual} for shape in grid("play_turns", 1e-3 * drivers.span, 0.1 * drivers.span, 14)
    ]
    return [*stretch, *plays]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Stretch by a memory of direction, growing with load, with load and twist, or not at all; or lost twist.

    A loop that grows with the twist alone is a play of constant width, and not friction's. Without a lever that
    changes there is no twist to grow with.
    """
    if "play_turns" in shape:
        width = shape["play_turns"] * np.maximum(drivers.load / shape["usual_load"], 0.0)
        lost = play(drivers.motion, width) - drivers.motion
        half = play(drivers.motion, 0.4 * width) - drivers.motion
        return [Term("share", "twist", lost, "1", high=1.25), Term("inner_share", "twist", half, "1", high=1.25)]
    if "slow_turns_per_s" in shape:
        sides = {"dry": np.tanh(drivers.rate / shape["slow_turns_per_s"])}
    else:
        sides = {name: drivers.directed(shape[key]) for name, key in WIDTHS.items()}
    slope = drivers.tangent
    found = []
    for name, side in sides.items():
        signals = {"mm": side}
        if drivers.levered:
            signals["load_twist_mm_per_10_n"] = side * drivers.load * slope
            signals["load_steep_mm_per_10_n"] = side * drivers.load * slope**3
        if shape["loaded"]:
            signals["load_mm_per_10_n"] = side * np.abs(drivers.load)
        if shape["loaded"] and not drivers.levered:
            signals["slack_mm"] = side * np.exp(-np.abs(drivers.load) / SLACK_LOAD)
        found += [
            Term(f"{name}_{key}", "resistance", signal, "mm/10N" if "10_n" in key else "mm", total=TOTALS.get(key))
            for key, signal in signals.items()
        ]
    return found


MECHANISM = Mechanism(
    id="friction_hysteresis",
    driver="direction x load",
    equation="dx = -(F/K) g(a) s, s: stop operators of the twist (Prandtl-Ishlinskii)",
    source="physics.md C2-C5",
    confused_with="backlash, sensor_lag, viscous_loss",
    told_apart_by="two loads (backlash does not follow the load) and two speeds (a lag follows the speed)",
    sentence="Friction makes the {reading} of {up} differ from that of {down}, by up to {span} ({size}).",
    details=(
        "half the loop is {half_loop_mm}",
        "half the loop is {half_loop_mm_per_10_n}",
        "half the loop is {dry_mm}",
        "half the play is {play_turns} under the usual load",
    ),
    shapes=shapes,
    terms=terms,
)
