"""Dimensions that calibration moved further than their tolerance, in words."""

import math
import re
from collections.abc import Iterable

from ....ground.units import unit_of
from ...document.bounds import BOUND, at_bound, of_later_run
from ...document.content import Verdict
from ...document.made_keys import amount, amount_or_none
from ..held_out import holdout
from ..held_out.without_name import moved_in_vain
from ..language.quantity import listing, number, said_unit, size, times
from ..language.text_table import UNKNOWN, wrapped_cells
from ..language.vocabulary import Vocabulary
from . import change, exactness, tolerances

LEAVES = 2.5  # sigma by which a dimension must have moved to be measured again
HARDLY = 0.01  # sigma: a dimension that moved less stayed where it was
FINEST = 12  # decimals
MANY = 4  # that leave at once: then it is no measuring error
HEAD = ["dimension", "as measured", "calibrated (90 % interval)", "tolerance", "moved by"]
CALLED = {"scale": "gain of the displacement sensor", "angle_turns": "zero of the motor"}


def far_moved(content: Verdict) -> dict[str, float]:
    """The dimensions to measure again, with how many sigma each moved; none where the adopted ones fit as well."""
    moved = {} if adopted_fit(content) else content["evidence"]["moved_sigma"]
    return {name: sigma for name, sigma in moved.items() if abs(sigma) > LEAVES and not of_later_run(name)}


def has_table(content: Verdict) -> bool:
    """Whether the details have the table of how far each dimension moved."""
    return content["verdict"] != "consistent" or bool(far_moved(content))


def adopted_fit(content: Verdict) -> bool:
    """Whether effects were adopted with dimensions that all lie within their tolerances."""
    sigma = content["evidence"].get("tolerance", {})
    came = [adoption["dimensions"] for adoption in content.get("adopted", []) if adoption.get("dimensions")][-1:]
    return bool(came) and all(
        abs(its["fitted"] - its["nominal"]) <= LEAVES * sigma[name] for name, its in came[0].items() if sigma.get(name)
    )


def cautions(
    content: Verdict, words: Vocabulary, adopted: list[str], inexact: bool = False, in_step: bool = False
) -> list[str]:
    """How to measure dimensions again that moved far, and what else may have bent them; nothing if none did.

    `adopted` are the effects that run.yaml holds; `inexact`: the simulation leaves more than noise; `in_step`: a step
    asks to measure them, and says how exactly.
    """
    moved = far_moved(content)
    if not moved:
        return []
    names, lines = {name: name_of(name) for name in moved}, list[str]()
    if content["verdict"] == "parameters" and moved_in_vain(content, words):
        lines.append(f"Measure {the(moved)} again before you believe any of these values.")
    elif not in_step:
        exactly = listing([f"the {called} to {exactness.cell(content, name)}" for name, called in names.items()])
        lines += [f"Measure again {exactly}.", *exactness.mistakes(content, names)]
    if any(beyond(content, name) for name in moved):
        lines.append("Intervals are those of the fit: they may reach beyond what calibration may do.")
    if adopted:
        lines.append("They are narrow only because the adopted effects are held fixed: nothing new was measured.")
        lines.append(f"Adopted effects bend dimensions as well ({listing(adopted)}). {do_not_copy(moved)}")
    elif inexact:
        lines.append(f"What the simulation still misses bends dimensions as well. {do_not_copy(moved)}")
    if len(moved) >= MANY:
        lines.append(
            "So many at once are seldom all measured wrong: where measuring again changes none, physics that the "
            "library lacks may have moved them, or run.yaml describes another rig."
        )
    return lines


def the(names: Iterable[str]) -> str:
    """Dimensions as a list: the radius and the length."""
    return listing([f"the {name_of(name)}" for name in names])


def do_not_copy(moved: Iterable[str]) -> str:
    """What to do about dimensions that moved far."""
    return f"Do not copy calibrated values into run.yaml: measure {the(moved)} again and write what you measured."


def suspicious(content: Verdict) -> list[str]:
    """The warning that calibration moved dimensions to the bound of their tolerance."""
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
    """The source of a value that run.yaml lacks: assumed, or derived from the scale that run.yaml gives."""
    shown = content["evidence"]
    from_scale = shown.get("scale_given") is not None and tolerances.stem(name) == "scale"
    return f"taken, after the scale of {number(shown['scale_given'], 4)} in run.yaml" if from_scale else "assumed"


def from_to(content: Verdict, name: str) -> tuple[str, str]:
    """A dimension in `run.yaml` and its fitted value, to a third of the tolerance, finer if both would look alike."""
    dimension, unit = content["parameters"][name], said_unit(unit_of(re.sub(r"_\d+$", "", name)))
    nominal = number(dimension["nominal"], 6)
    least = decimals(content, name)
    spellings = (number(round(dimension["value"], places), 12) for places in range(least, least + 6))
    value = next((spelling for spelling in spellings if spelling != nominal), nominal)
    return f"{nominal} {unit}".strip(), f"{value} {unit}".strip()


def decimals(content: Verdict, name: str) -> int:
    """The number of decimals for a dimension: to a third of its tolerance; finer where its ends would read alike."""
    sigma = content["evidence"].get("tolerance", {}).get(name)
    step = exactness.TELLS * sigma if sigma else 1e-3 * abs(content["parameters"][name]["value"])
    places = max(-math.floor(math.log10(step)), 0) if step > 0.0 else 4
    low, value, high = (amount_or_none(content["parameters"][name], end) or 0.0 for end in ("low", "value", "high"))
    inside = [low, value, high] if low < value < high else [low, high]
    while low < high and places < FINEST and len({round(each, places) for each in inside}) < len(inside):
        places += 1
    return places


def likely_range(content: Verdict, name: str) -> str:
    """The 90 % interval of a dimension, in brackets, in its unit; nothing where it has none."""
    dimension = content["parameters"][name]
    if not dimension.get("low", 0.0) < dimension.get("high", 0.0):
        return ""
    places = decimals(content, name)
    low, high = (number(round(dimension[end], places), 12) for end in ("low", "high"))
    return f" ({low} to {high})"


def beyond(content: Verdict, name: str) -> bool:
    """Whether the interval of a dimension reaches beyond the bounds of calibration."""
    dimension, sigma = content["parameters"][name], content["evidence"].get("tolerance", {}).get(name)
    ends = [dimension.get("low", dimension["nominal"]), dimension.get("high", dimension["nominal"])]
    return sigma is not None and sigma > 0.0 and max(abs(end - dimension["nominal"]) for end in ends) > BOUND * sigma


def corrected(content: Verdict, words: Vocabulary) -> list[str]:
    """Where only dimensions moved: the misfit before and after, then the table of them; for the page."""
    shown, lines = content["evidence"], []
    if content["verdict"] != "parameters":
        return []
    if f"nominal_{words.ending}" in shown:
        before, after, floor = (amount(shown, f"{name}_{words.ending}") for name in ("nominal", "calibrated", "floor"))
        sizes = [f"{size(value, words.unit)} rms ({times(value / floor)} times the noise)" for value in (before, after)]
        lines.append(f"The misfit was {sizes[0]} with the dimensions of run.yaml. It is {sizes[1]} once they move.")
    in_step = holdout.included(content) and not moved_in_vain(content, words)  # such a page is long
    return [*lines, *table(content, words, far_moved(content) if in_step else ())]


def table(content: Verdict, words: Vocabulary, but: Iterable[str] = ()) -> list[str]:
    """A row for each dimension that moved but those of `but`, the farthest first, then what to think of them all."""
    sigmas = {name: abs(sigma) for name, sigma in content["evidence"]["moved_sigma"].items()}
    names = [name for name in sorted(sigmas, key=lambda name: -sigmas[name]) if name in content["parameters"]]
    moved = [name for name in names if sigmas[name] >= HARDLY]
    if not moved:
        return ["No dimension moved by a hundredth of its tolerance: only the zero of the reading did."]
    rows = [_row(content, name, words) for name in moved if name not in but]
    lines = [*wrapped_cells([HEAD, *rows]), change.COUNTS] if rows else []
    if stayed := [name_of(name) for name, sigma in sigmas.items() if sigma < HARDLY]:
        lines.append(f"Stayed (moved by less than a hundredth of the tolerance): {listing(stayed)}.")
    if content["verdict"] == "parameters" and moved_in_vain(content, words):
        return [*lines, "Moving them explains next to nothing: these values are no better than the measured ones."]
    if all(sigmas[name] < 1.0 for name in moved):
        right = ": nothing says that one was measured wrong" * (content["verdict"] == "parameters")
        return [*lines, f"Every dimension stays within its tolerance{right}."]
    if not far_moved(content):
        lines.append(f"Only a dimension that moves by more than {LEAVES:g} tolerances is to be measured again.")
    return lines


def _row(content: Verdict, name: str, words: Vocabulary) -> list[str]:
    """The old and the new value of a dimension, and by how many tolerances it moved."""
    nominal, value = from_to(content, name)
    first = f"{nominal}{f' ({whence(content, name)})' if exactness.assumed(name) else ''}"
    sigmas = number(abs(content["evidence"]["moved_sigma"][name]), whole=True)
    far, tolerance = f"{sigmas}{change.in_brackets(content, name)}", tolerances.said(content, name, words) or UNKNOWN
    return [name_of(name), first, f"{value}{likely_range(content, name)}", tolerance, far]


def name_of(parameter: str) -> str:
    """A dimension as a person calls it: `torsion zone` for `torsion_zone_mm`."""
    stem, run = re.sub(r"_\d+$", "", parameter), re.search(r"_(\d+)$", parameter)
    unit = unit_of(stem)
    name = CALLED.get(stem) or (stem.removesuffix(f"_{unit.lower().replace('/', '_per_')}")).replace("_", " ")
    return f"{name} in run {run[1]}" if run else name
