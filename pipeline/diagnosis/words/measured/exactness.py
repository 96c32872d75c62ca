"""The accuracy for measuring a dimension again: to tell two values apart, or only to find a gross error."""

import math
import re
from collections.abc import Mapping

from ....ground.units import unit_of
from ...document.bounds import at_bound
from ...document.content import Verdict
from ..language.quantity import listing, quantity
from . import tolerances

TELLS = 1.0 / 3.0  # of the way that a dimension moved: a measurement so exact tells the two values apart
AS_BEFORE = "as before"
ENOUGH = 0.99  # of its tolerance: where no more is asked for, the exactness of the value in run.yaml is enough
NEVER_SAID = ("scale", "angle_turns")  # dimensions that run.yaml has no values of
TRADES = 0.8  # correlation of two dimensions from which on one of them alone settles little


def tells(content: Verdict, name: str) -> str:
    """The accuracy to measure a dimension with: a third of the distance that it moved."""
    return quantity(TELLS * way(content, name), unit_of(tolerances.stem(name)))


def way(content: Verdict, name: str) -> float:
    """How far a dimension moved, in its unit."""
    dimension = content["parameters"][name]
    return abs(float(dimension["value"]) - float(dimension["nominal"]))


def distance(content: Verdict, name: str) -> str:
    """How far a dimension moved, with its unit."""
    return quantity(way(content, name), unit_of(tolerances.stem(name)))


def gross(content: Verdict, name: str) -> bool:
    """Whether a measured dimension stands at its bound: its old tolerance is then accurate enough."""
    sigma = content["evidence"].get("tolerance", {}).get(name)
    bounds = at_bound(content["evidence"]["moved_sigma"])
    if not sigma or assumed(name) or name not in bounds:
        return False
    return TELLS * way(content, name) >= ENOUGH * sigma


def cell(content: Verdict, name: str) -> str:
    """The accuracy to measure a dimension with, in a table: `0.0037 mm or better`, or `0.5 mm, as before`."""
    if not gross(content, name):
        return f"{tells(content, name)} or better"
    return f"{quantity(content['evidence']['tolerance'][name], unit_of(tolerances.stem(name)))} {AS_BEFORE}"


def mistakes(content: Verdict, names: Mapping[str, str]) -> list[str]:
    """The advice to look for a gross error, where the old accuracy is enough; else nothing.

    `names` are what the dimensions are called, by their own names.
    """
    off = _off(content, names)
    return [
        f"Where this says `as before`, measure as exactly as before, and look for a gross error: what fits best is "
        f"three tolerances away, {listing(off)}. Such an error is another spool, another place or a misread scale."
    ] * bool(off)


def look_for(content: Verdict, names: Mapping[str, str]) -> str:
    """The same advice in one short sentence, for the page; empty where the old accuracy is not enough."""
    off = _off(content, names)
    return f" As before: look for a gross error of about {listing(off)}." if off else ""


def _off(content: Verdict, names: Mapping[str, str]) -> list[str]:
    """The size of each possible gross error, with its dimension."""
    return [f"{distance(content, name)} for the {called}" for name, called in names.items() if gross(content, name)]


def assumed(name: str) -> bool:
    """Whether `run.yaml` gives no value of a dimension. A stiffness counts too: a measured one never moves."""
    return re.sub(r"_\d+$", "", name) in NEVER_SAID or name.startswith("stiffness")


def trading(content: Verdict, names: list[str]) -> list[tuple[str, str, float]]:
    """Pairs of dimensions that can replace each other in the fit, with their correlation, the strongest first."""
    moves = {doubt["name"]: doubt["moves"] for doubt in content.get("uncertainty", []) if "id" not in doubt}
    moving = [name for name in names if name in moves]
    pairs = []
    for place, first in enumerate(moving):
        for second in moving[place + 1 :]:
            shared = sum(a * b for a, b in zip(moves[first], moves[second], strict=False))
            whole = math.hypot(*moves[first]) * math.hypot(*moves[second])
            if whole > 0.0 and abs(shared) >= TRADES * whole:
                pairs.append((first, second, shared / whole))
    return sorted(pairs, key=lambda pair: -abs(pair[2]))
