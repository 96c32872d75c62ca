"""Loops that a string's friction opens between winding and unwinding: what friction and stick-slip share."""

import numpy as np

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Term
from pipeline.kinematics import Array

STOPS = (0.004, 0.012, 0.03, 0.08, 0.2)  # of the range: half-widths of the stops that add up to a loop
SLOW = (0.02, 0.1)  # of the highest rate: below it a string's dry friction closes its loop
SLACK_LOAD = 0.5  # load units: a cable that hangs loose yields more to the same friction
TOTALS = {"mm": "half_loop_mm", "load_mm_per_10_n": "half_loop_mm_per_10_n"}


def loops(drivers: Drivers, sides: dict[str, Array], loaded: bool) -> list[Term]:
    """Stretch by each memory of direction (−1…1, by name) under each envelope.

    `loaded`: whether the recording shows what follows the load.
    """
    return [
        Term(f"{name}_{key}", "resistance", side * size, "mm/10N" if "10_n" in key else "mm", total=TOTALS.get(key))
        for name, side in sides.items()
        for key, size in envelopes(drivers, loaded).items()
    ]


def stops(drivers: Drivers, span_turns: float) -> dict[str, Array]:
    """Stop operators of the motion by name, of half-widths that are shares of `span_turns`, −1…1."""
    return {f"stop_{share:g}": drivers.directed(share * span_turns) for share in STOPS}


def dry(drivers: Drivers, fastest_turns_per_s: float) -> list[Term]:
    """Loops that close at rest: the same everywhere, or growing with load and twist."""
    found = []
    for share in SLOW:
        side = np.tanh(drivers.rate / (share * fastest_turns_per_s))
        found.append(Term(f"dry_{share:g}_mm", "resistance", side))
        twisted = side * drivers.load * drivers.tangent
        found.append(Term(f"dry_{share:g}_twist_mm_per_10_n", "resistance", twisted, "mm/10N"))
    return found


def envelopes(drivers: Drivers, loaded: bool) -> dict[str, Array]:
    """How high a loop may be, by name: the same everywhere, or growing with load, and with load and twist."""
    load, slope = drivers.load, drivers.tangent
    found = {"mm": np.ones_like(load)}
    if drivers.levered:
        found["load_twist_mm_per_10_n"] = load * slope
        found["load_steep_mm_per_10_n"] = load * slope**3
    if loaded and drivers.levered:
        found["root_load_twist_mm"] = np.sqrt(np.abs(load)) * slope
    if loaded:
        found["load_mm_per_10_n"] = np.abs(load)
    if loaded and not drivers.levered:
        found["slack_mm"] = np.exp(-np.abs(load) / SLACK_LOAD)
    return found
