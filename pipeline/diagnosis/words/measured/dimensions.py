"""Dimensions that calibration moved further than they were measured wrong, in words."""

import math
import re
from collections.abc import Iterable

from ....ground.units import unit_of
from ...document.bounds import BOUND, at_bound, of_later_run
from ...document.content import Verdict
from ..held_out.without_name import LITTLE, moved_in_vain
from ..language.quantity import listing, number, said_unit, size, times
from ..language.vocabulary import Vocabulary
from . import exactness, tolerances

LEAVES = 2.5  # sigma by which a dimension must have moved to be measured again
HARDLY = 0.01  # sigma: a dimension that moved less stayed where it was
FINEST = 12  # decimals
MANY = 4  # that leave at once: then it is no measuring error
CALLED = {"scale": "gain of the displacement sensor", "angle_turns": "zero of the motor"}


def far_moved(content: Verdict) -> dict[str, float]:
    """By how many sigma each dimension moved that is to be measured again: none where the adopted ones fit as well."""
    moved = {} if adopted_fit(content) else content["evidence"]["moved_sigma"]
    return {name: sigma for name, sigma in moved.items() if abs(sigma) > LEAVES and not of_later_run(name)}


def adopted_fit(content: Verdict) -> bool:
    """Whether effects were adopted with dimensions that all lie within their tolerances."""
    known = content["evidence"].get("tolerance", {})
    came = [adoption["dimensions"] for adoption in content.get("adopted", []) if adoption.get("dimensions")][-1:]
    return bool(came) and all(
        abs(its["fitted"] - its["nominal"]) <= LEAVES * known[name] for name, its in came[0].items() if known.get(name)
    )


def remeasured(
    content: Verdict, words: Vocabulary, adopted: list[str], inexact: bool = False, in_vain: bool = False
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
        exact = exactness.cell(content, name)
        exactly = f", to {exact}"
        best = f"but {value} fits best{likely_range(content, name)}, {far}"
        if exactness.assumed(name):
            lines.append(f"Measure the {name_of(name)}{exactly}: {nominal} was {whence(content, name)}, {best}.")
        else:
            lines.append(f"Measure the {name_of(name)} again{exactly}: run.yaml says {nominal}, {best}.")
    if lines:
        lines += exactness.mistakes(content, {name: name_of(name) for name in moved}) or [
            "A measurement as exact as that tells the two values apart."
        ]
        if any(beyond(content, name) for name in moved):
            lines.append("Intervals are those of the fit: they may reach beyond what calibration may do.")
        if adopted:
            lines.append("They are narrow only because the adopted effects are held fixed: nothing new was measured.")
    if moved and in_vain:
        names = listing([f"the {name_of(name)}" for name in moved])
        lines.append(f"Measure {names} again before you believe any of these values.")
    if moved and adopted:
        lines.append(f"Adopted effects bend dimensions as well ({listing(adopted)}). {do_not_copy(moved)}")
    elif moved and inexact:
        lines.append(f"What the simulation still misses bends dimensions as well. {do_not_copy(moved)}")
    if len(moved) >= MANY:
        lines.append(
            "So many at once are seldom all measured wrong: where measuring again changes none, physics that the "
            "library lacks may have moved them, or run.yaml describes another rig."
        )
    return lines


def do_not_copy(moved: Iterable[str]) -> str:
    """What to do about dimensions that moved far."""
    names = listing([f"the {name_of(name)}" for name in moved])
    return f"Do not copy calibrated values into run.yaml: measure {names} again and write what you measured."


def suspicious(content: Verdict) -> list[str]:
    """What a reader must know first of dimensions that calibration moved to the bound of what it may do."""
    bounds = at_bound(far_moved(content))
    at_end = {name: which for name, which in bounds.items() if name in content["parameters"]}
    if not at_end:
        return []
    moves = []
    for name, which in at_end.items():
        nominal, value = from_to(content, name)
        first = f"{nominal} was {whence(content, name)}" if exactness.assumed(name) else f"run.yaml says {nominal}"
        moves.append(f"{name_of(name)}, {which} bound {value} ({first})")
    many = "a dimension" if len(at_end) == 1 else f"{len(at_end)} dimensions"
    return [
        f"Suspicious: calibration moved {many} as far as it may, three "
        f"times the tolerance: {'; '.join(moves)}. The best value may lie beyond."
    ]


def whence(content: Verdict, name: str) -> str:
    """Where a value comes from that run.yaml does not hold: assumed, or taken after the scale that run.yaml gives."""
    shown = content["evidence"]
    given = shown.get("scale_given") is not None and tolerances.stem(name) == "scale"
    return f"taken, after the scale of {number(shown['scale_given'], 4)} in run.yaml" if given else "assumed"


def from_to(content: Verdict, name: str) -> tuple[str, str]:
    """A dimension as `run.yaml` has it, and as it fits to a third of its tolerance, finer where both read the same."""
    known, unit = content["parameters"][name], said_unit(unit_of(re.sub(r"_\d+$", "", name)))
    nominal = number(known["nominal"], 6)
    least = decimals(content, name)
    spellings = (number(round(known["value"], places), 12) for places in range(least, least + 6))
    value = next((spelling for spelling in spellings if spelling != nominal), nominal)
    return f"{nominal} {unit}".strip(), f"{value} {unit}".strip()


def decimals(content: Verdict, name: str) -> int:
    """After how many decimals a dimension is said: to a third of its tolerance, finer where its ends read alike."""
    sigma = content["evidence"].get("tolerance", {}).get(name)
    known = exactness.TELLS * sigma if sigma else 1e-3 * abs(content["parameters"][name]["value"])
    places = max(-math.floor(math.log10(known)), 0) if known > 0.0 else 4
    low, high = (content["parameters"][name].get(end, 0.0) for end in ("low", "high"))
    while low < high and places < FINEST and round(low, places) == round(high, places):
        places += 1
    return places


def likely_range(content: Verdict, name: str) -> str:
    """The 90 % interval of a dimension, in brackets; nothing where it has none."""
    known = content["parameters"][name]
    if not known.get("low", 0.0) < known.get("high", 0.0):
        return ""
    places, unit = decimals(content, name), said_unit(unit_of(re.sub(r"_\d+$", "", name)))
    low, high = (number(round(known[end], places), 12) for end in ("low", "high"))
    return f" (90 % interval {low} to {high} {unit}".rstrip() + ")"


def beyond(content: Verdict, name: str) -> bool:
    """Whether the interval of a dimension reaches further than calibration may move it."""
    known, sigma = content["parameters"][name], content["evidence"].get("tolerance", {}).get(name)
    ends = [known.get(end, known["nominal"]) for end in ("low", "high")]
    return bool(sigma) and max(abs(end - known["nominal"]) for end in ends) > BOUND * sigma


def corrected(content: Verdict, words: Vocabulary) -> list[str]:
    """Where only dimensions moved: the misfit before and after, then each dimension, from what to what."""
    shown, lines = content["evidence"], []
    if content["verdict"] != "parameters":
        return []
    if f"nominal_{words.ending}" in shown:
        before, after, floor = (shown[f"{name}_{words.ending}"] for name in ("nominal", "calibrated", "floor"))
        sizes = [f"{size(value, words.unit)} rms ({times(value / floor)} times the noise)" for value in (before, after)]
        lines.append(f"The misfit was {sizes[0]} with the dimensions of run.yaml. It is {sizes[1]} once they move.")
        if before <= LITTLE * after:
            lines.append("So moving them explains next to nothing: these values are no better than the measured ones.")
    return [*lines, *each_moved(content, words, () if moved_in_vain(content, words) else far_moved(content))]


def each_moved(content: Verdict, words: Vocabulary, but: Iterable[str] = ()) -> list[str]:
    """Each dimension that moved, the farthest first: from what to what, by how much of which tolerance.

    `but` are those that are told elsewhere.
    """
    sigmas = content["evidence"]["moved_sigma"]
    moved = {name: sigma for name, sigma in sigmas.items() if abs(sigma) >= HARDLY and name not in but}
    measured = [name for name in moved if not name.startswith("stiffness")]
    lines, within = [], [name for name in measured if but and abs(moved[name]) < 1.0]
    if within:
        lines.append(f"Within tolerance: {listing([name_of(name) for name in within])}.")
        moved = {name: sigma for name, sigma in moved.items() if name not in within}
    for name, sigma in sorted(moved.items(), key=lambda item: -abs(item[1])):
        nominal, value = from_to(content, name)
        known = tolerances.said(content, name, words)
        far = f"{number(abs(sigma))} times its tolerance{f' of {known}' if known else ''}"
        first = f"{nominal}{f' ({whence(content, name)})' if exactness.assumed(name) else ''}"
        lines.append(f"{name_of(name)}: from {first} to {value}{likely_range(content, name)}, {far}.")
    stayed = listing([name_of(name) for name, sigma in sigmas.items() if abs(sigma) < HARDLY])
    lines += [f"Stayed (moved by less than a hundredth of the tolerance): {stayed}."] * bool(lines and stayed)
    if moved and not but and all(abs(sigma) < 1.0 for sigma in moved.values()):
        right = content["verdict"] == "parameters"
        lines.append(
            f"Every dimension stays within its tolerance{': nothing says that one was measured wrong' * right}."
        )
    if not moved and not but:
        lines.append("No dimension moved by a hundredth of its tolerance: only the zero of the reading did.")
    return lines


def name_of(parameter: str) -> str:
    """A dimension as a person calls it: `torsion zone` for `torsion_zone_mm`."""
    stem, run = re.sub(r"_\d+$", "", parameter), re.search(r"_(\d+)$", parameter)
    unit = unit_of(stem)
    name = CALLED.get(stem) or (stem.removesuffix(f"_{unit.lower().replace('/', '_per_')}")).replace("_", " ")
    return f"{name} in run {run[1]}" if run else name
