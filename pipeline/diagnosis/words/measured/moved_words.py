"""What calibration moved, for the page: what it is called, and from where to where, beyond a tolerance."""

from ....ground.units import unit_of
from ...document.bounds import of_later_run
from ...document.content import Verdict
from ..language.quantity import listing, number, said_unit, times
from .dimensions import LEAVES, far_moved, from_to, name_of

NO_STEP = f"Up to {number(LEAVES)} times nothing needs to be measured again."
FROM = 1.0  # tolerances: a dimension that moved by less is as it was measured


def what(content: Verdict) -> str:
    """What may move: `dimensions`, or the one quantity that does, as the mass of a moving mass."""
    names = [name for name in content["evidence"]["moved_sigma"] if not of_later_run(name)]
    return name_of(names[0]) if len(names) == 1 and not names[0].endswith("_mm") else "dimensions"


def lines(content: Verdict) -> list[str]:
    """From where to where each dimension moved by more than its tolerance; nothing where a step says it."""
    if content["verdict"] not in ("explained", "ambiguous") or far_moved(content):
        return []
    moved = {name: abs(sigma) for name, sigma in content["evidence"]["moved_sigma"].items() if abs(sigma) > FROM}
    names = [name for name in sorted(moved, key=lambda name: -moved[name]) if name in content["parameters"]]
    ends = {name: from_to(content, name) for name in names if not of_later_run(name)}
    each = [
        f"{name_of(name)} from {was} to {now} ({times(moved[name])} times{_tolerance(content, name)})"
        for name, (was, now) in ends.items()
    ]
    return [f"Moved by more than its tolerance: {listing(each)}. {NO_STEP}"] if each else []


def _tolerance(content: Verdict, name: str) -> str:
    """Of what a dimension moved so many times, in its unit; nothing where the diagnosis does not hold it."""
    sigma, unit = content["evidence"].get("tolerance", {}).get(name), said_unit(unit_of(name))
    return f" its tolerance of {number(sigma)} {unit}".rstrip() if sigma else ""
