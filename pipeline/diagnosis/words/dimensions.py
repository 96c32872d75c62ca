"""Dimensions that calibration moved further than they were measured wrong, in words."""

import re
from typing import Any

from pipeline.diagnosis.words.quantity import number, said_unit
from pipeline.schemas import unit_of

LEAVES = 2.5  # sigma by which a dimension must have moved to be measured again
MANY = 4  # that leave at once: then it is no measuring error
CALLED = {"scale": "gain of the displacement sensor", "angle_turns": "zero of the motor"}


def remeasured(content: dict[str, Any]) -> list[str]:
    """A line for each dimension to measure again; where nearly all move, what that means."""
    moved = {name: sigma for name, sigma in content["evidence"]["moved_sigma"].items() if abs(sigma) > LEAVES}
    lines = []
    for name, sigma in moved.items():
        known, unit = content["parameters"][name], said_unit(unit_of(re.sub(r"_\d+$", "", name)))
        nominal, value = (f"{number(known[key], 4)} {unit}".strip() for key in ("nominal", "value"))
        # a stiffness that was measured never moves: the one that does is the usual one, which was assumed
        do, known_as = ("measure", "assumed") if name.startswith("stiffness") else ("re-measure", "measured")
        lines.append(f"{do} the {name_of(name)}: {nominal} {known_as}, {value} fits, {abs(sigma):.1f} sigma away.")
    if len(moved) >= MANY:
        lines.append("So many at once are hardly measured wrong: rather physics is missing that bends them.")
    return lines


def name_of(parameter: str) -> str:
    """A dimension as a person calls it: `torsion zone` for `torsion_zone_mm`."""
    stem, run = re.sub(r"_\d+$", "", parameter), re.search(r"_(\d+)$", parameter)
    unit = unit_of(stem)
    said = CALLED.get(stem) or (stem.removesuffix(f"_{unit.lower().replace('/', '_per_')}")).replace("_", " ")
    return f"{said} in run {run[1]}" if run else said
