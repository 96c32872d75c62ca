"""Dimensions that calibration moved by more than a tolerance, for the page: their name, old and new value."""

from ....ground.units import unit_of
from ...document.bounds import of_later_run
from ...document.content import Verdict
from ..language.quantity import listing, number, said_unit, times
from . import change
from .dimensions import LEAVES, far_moved, from_to, name_of

NO_STEP = f"Up to {number(LEAVES)} times nothing needs to be measured again."
FIRST = 2  # of them, in the first line of a page
FROM = 1.0  # tolerances: a dimension that moved by less is as it was measured


def what(content: Verdict) -> str:
    """The word for what may move: `dimensions`, or the one quantity, such as the mass of a moving mass."""
    names = [name for name in content["evidence"]["moved_sigma"] if not of_later_run(name)]
    return name_of(names[0]) if len(names) == 1 and not names[0].endswith("_mm") else "dimensions"


def lines(content: Verdict) -> list[str]:
    """The old and new value of each dimension that moved by more than its tolerance; nothing where a step says it."""
    if content["verdict"] not in ("explained", "ambiguous") or far_moved(content):
        return []
    moved = {name: abs(sigma) for name, sigma in content["evidence"]["moved_sigma"].items() if abs(sigma) > FROM}
    names = [name for name in sorted(moved, key=lambda name: -moved[name]) if name in content["parameters"]]
    each = [f"{_from_to(content, name)} ({_by(content, name)})" for name in names if not of_later_run(name)]
    return [f"Moved by more than its tolerance: {listing(each)}. {NO_STEP}"] if each else []


def bracketed(content: Verdict) -> str:
    """The old and new values of the dimensions that moved farthest, in brackets after a blank; empty if none did."""
    sigmas = {name: abs(sigma) for name, sigma in content["evidence"]["moved_sigma"].items() if not of_later_run(name)}
    names = [name for name in sorted(sigmas, key=lambda name: -sigmas[name]) if name in content["parameters"]]
    far = [name for name in names if sigmas[name] > FROM] or names[:1]
    percents = {name: change.percent(content, name) for name in far[:FIRST]}
    each = [", ".join(filter(None, (_from_to(content, name), percent))) for name, percent in percents.items()]
    more = [f"{len(far) - FIRST} more"] if len(far) > FIRST else []
    return f" ({'; '.join([*each, *more])})" if each else ""


def _from_to(content: Verdict, name: str) -> str:
    """A dimension by its name, with its value in run.yaml and the calibrated one."""
    was, now = from_to(content, name)
    return f"{name_of(name)} from {was} to {now}"


def _by(content: Verdict, name: str) -> str:
    """By how much a dimension moved: in per cent, where it does not begin at 0, and in tolerances."""
    count = times(abs(content["evidence"]["moved_sigma"][name]))
    return ", ".join(filter(None, (change.percent(content, name), f"{count} times{_tolerance(content, name)}")))


def _tolerance(content: Verdict, name: str) -> str:
    """The tolerance that a dimension's move is counted in, in its unit; nothing where the file lacks it."""
    sigma, unit = content["evidence"].get("tolerance", {}).get(name), said_unit(unit_of(name))
    return f" its tolerance of {number(sigma)} {unit}".rstrip() if sigma else ""
