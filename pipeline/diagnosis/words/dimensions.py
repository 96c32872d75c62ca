"""Dimensions that calibration moved further than they were measured wrong, in words."""

import re
from collections.abc import Iterable
from typing import Any

from ...ground.schemas import unit_of
from ..bounds import BOUND, at_bound
from . import tolerances
from .headline import LITTLE
from .quantity import listing, number, said_unit, size, times
from .vocabulary import Vocabulary

LEAVES = 2.5  # sigma by which a dimension must have moved to be measured again
HARDLY = 0.01  # sigma: a dimension that moved less stayed where it was
MANY = 4  # that leave at once: then it is no measuring error
CALLED = {"scale": "gain of the displacement sensor", "angle_turns": "zero of the motor"}
GAIN = (
    "If you measured the sensor's gain, give its inverse as the scale: of a sensor that reads 1.5 % too much, the gain "
    "is 1.015 and the scale 0.985. Where run.yaml has no `channels`, add this line to it: `channels: {displacement_mm: "
    "{scale: 0.985}}`. Where it has a scale already, divide that by the gain"
)


def far_moved(content: dict[str, Any]) -> dict[str, float]:
    """By how many sigma each dimension moved that is to be measured again."""
    return {name: sigma for name, sigma in content["evidence"]["moved_sigma"].items() if abs(sigma) > LEAVES}


def remeasured(
    content: dict[str, Any], words: Vocabulary, adopted: list[str], inexact: bool = False, in_vain: bool = False
) -> list[str]:
    """A line for each dimension to measure again, and what else may have bent it.

    `adopted` are the effects that run.yaml holds; `inexact`: the simulation leaves more than noise; `in_vain`: moving
    the dimensions explains next to nothing.
    """
    moved = far_moved(content)
    lines = []
    for name, sigma in ({} if in_vain else moved).items():
        nominal, value = from_to(content, name)
        known = tolerances.said(content, name, words)
        far = f"{abs(sigma):.1f} times its tolerance{f' of {known}' if known else ''} away"
        far += ", as far as calibration may move it" if abs(sigma) >= BOUND else ""
        if assumed(name):
            lines.append(f"Measure the {name_of(name)}: {nominal} was assumed, but {value} fits best, {far}.")
        else:
            lines.append(f"Measure the {name_of(name)} again: run.yaml says {nominal}, but {value} fits best, {far}.")
    if moved and in_vain:
        names = listing([f"the {name_of(name)}" for name in moved])
        lines.append(f"Measure {names} again before you believe any of these values.")
    if moved and adopted:
        lines.append(f"Adopted effects bend dimensions as well ({listing(adopted)}). {do_not_copy(moved)}")
    elif moved and inexact:
        lines.append(f"What the simulation still misses bends dimensions as well. {do_not_copy(moved)}")
    if len(moved) >= MANY:
        lines.append(
            "So many at once are seldom all measured wrong: where measuring again changes none, missing physics bends "
            "them, or run.yaml describes another rig."
        )
    return lines


def tolerance_keys(moved: Iterable[str]) -> list[str]:
    """The keys of `tolerance:` in `run.yaml` of dimensions; a stiffness has none."""
    return list(dict.fromkeys(tolerances.key_of(name) for name in moved if not name.startswith("stiffness")))


def do_not_copy(moved: Iterable[str]) -> str:
    """What to do about dimensions that moved far."""
    names = listing([f"the {name_of(name)}" for name in moved])
    return f"Do not copy calibrated values into run.yaml: measure {names} again and write what you measured."


def suspicious(content: dict[str, Any]) -> list[str]:
    """What a reader must know first of dimensions that calibration moved to the bound of what it may do."""
    bounds = at_bound(content["evidence"]["moved_sigma"])
    found = {name: which for name, which in bounds.items() if name in content["parameters"]}
    if not found:
        return []
    said = []
    for name, which in found.items():
        nominal, value = from_to(content, name)
        whence = f"{nominal} was assumed" if assumed(name) else f"run.yaml says {nominal}"
        said.append(f"{name_of(name)}, {which} bound {value} ({whence})")
    one = len(found) == 1
    return [
        f"Suspicious: calibration moved {'a dimension' if one else f'{len(found)} dimensions'} as far as it may, three "
        f"times the tolerance: {'; '.join(said)}. The best value may lie beyond. Measure {'it' if one else 'them'} "
        f"again; where nothing changes, missing physics bends {'it' if one else 'them'}."
    ]


def assumed(name: str) -> bool:
    """Whether `run.yaml` gives no value of a dimension; of the stiffness too, for one that was measured never moves."""
    return re.sub(r"_\d+$", "", name) in CALLED or name.startswith("stiffness")


def from_to(content: dict[str, Any], name: str) -> tuple[str, str]:
    """A dimension as `run.yaml` has it and as it fits, with as many digits as it takes to tell them apart."""
    known, unit = content["parameters"][name], said_unit(unit_of(re.sub(r"_\d+$", "", name)))
    digits = next((n for n in range(4, 6) if number(known["nominal"], n) != number(known["value"], n)), 6)
    nominal, value = (f"{number(known[key], digits)} {unit}".strip() for key in ("nominal", "value"))
    return nominal, value


def corrected(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """Where only dimensions moved: the misfit before and after, then each dimension, from what to what."""
    shown, lines = content["evidence"], []
    if content["verdict"] != "parameters":
        return []
    before, after, floor = (shown.get(f"{name}_{words.ending}") for name in ("nominal", "calibrated", "floor"))
    if before is not None:
        sizes = [f"{size(value, words.unit)} rms ({times(value / floor)} times the noise)" for value in (before, after)]
        lines.append(f"The misfit was {sizes[0]} with the dimensions of run.yaml. It is {sizes[1]} once they move.")
        if before <= LITTLE * after:
            lines.append("So moving them explains next to nothing: these values are no better than the measured ones.")
    return [*lines, *each_moved(content, words)]


def each_moved(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """Each dimension that moved, the farthest first: from what to what, by how much of which tolerance."""
    moved = {name: sigma for name, sigma in content["evidence"]["moved_sigma"].items() if abs(sigma) >= HARDLY}
    lines = []
    for name, sigma in sorted(moved.items(), key=lambda item: -abs(item[1])):
        nominal, value = from_to(content, name)
        known = tolerances.said(content, name, words)
        far = f"{number(abs(sigma))} times its tolerance{f' of {known}' if known else ''}"
        lines.append(f"{name_of(name)}: from {nominal}{' (assumed)' if assumed(name) else ''} to {value}, {far}.")
    if moved and all(abs(sigma) < 1.0 for sigma in moved.values()):
        right = content["verdict"] == "parameters"
        lines.append(f"Every dimension stays within its tolerance{': none of them was measured wrong' * right}.")
    if not moved:
        lines.append("No dimension moved by a hundredth of its tolerance: only the zero of the reading did.")
    return lines


def name_of(parameter: str) -> str:
    """A dimension as a person calls it: `torsion zone` for `torsion_zone_mm`."""
    stem, run = re.sub(r"_\d+$", "", parameter), re.search(r"_(\d+)$", parameter)
    unit = unit_of(stem)
    said = CALLED.get(stem) or (stem.removesuffix(f"_{unit.lower().replace('/', '_per_')}")).replace("_", " ")
    return f"{said} in run {run[1]}" if run else said
