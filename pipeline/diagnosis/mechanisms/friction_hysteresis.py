"""A rounded loop that depends on direction and grows with load or twist: friction between strands and at guides [C2-C5]."""

from pipeline.diagnosis.drivers import Drivers
from pipeline.diagnosis.interface import Mechanism, Shape, Term

ROUNDINGS = ((0.005, 0.02), (0.02, 0.06), (0.06, 0.2))  # of the range: turns after a reversal that a loop needs


def shapes(drivers: Drivers) -> list[Shape]:
    """How far after a reversal the loop is open again: two half-widths in turns."""
    return [
        {"half_turns": float(f"{a * drivers.span:.6g}"), "wide_half_turns": float(f"{b * drivers.span:.6g}")}
        for a, b in ROUNDINGS
    ]


def terms(drivers: Drivers, shape: Shape) -> list[Term]:
    """Stretch (and lost twist) by a memory of direction, growing with load, with twist, with both or not at all."""
    slope = drivers.tangent
    found = []
    for name, width in (("sharp", shape["half_turns"]), ("round", shape["wide_half_turns"])):
        side = drivers.directed(width)
        found.append(Term(f"{name}_mm", "length", side))
        found.append(Term(f"{name}_load_twist_mm_per_10_n", "length", side * drivers.load * slope, "mm/10N"))
        found.append(Term(f"{name}_load_steep_mm_per_10_n", "length", side * drivers.load * slope**3, "mm/10N"))
        if drivers.loaded:
            found.append(Term(f"{name}_load_mm_per_10_n", "length", side * drivers.load, "mm/10N"))
            found.append(Term(f"{name}_twist_mm", "length", side * slope))
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
