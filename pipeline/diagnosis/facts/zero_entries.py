"""The zero of each run's reading, as `diagnosis.json` lists it, and by how much it differs from the first run's."""

from ..document.effects_named import Dimension
from ..document.rounded import to_its_width
from ..fit.intervals import Intervals
from ..fit.problem import Problem
from ..fit.uncertainty import zero_names
from .mechanism_entries import as_entry


def zero_entries(problem: Problem, bands: Intervals, ending: str) -> dict[str, Dimension]:
    """The zeros by name; `ending`: of the channel. None of a reading that has a true zero."""
    if not problem.system.free_zero:
        return {}
    names = zero_names(problem, ending)
    zeros: dict[str, Dimension] = {
        name: {"nominal": 0.0, **to_its_width(as_entry(interval))}
        for name, interval in zip(names, bands.zeros, strict=True)
    }
    for name, interval in zip(names[1:], bands.zeros_from_first, strict=True):
        zeros[name]["from_first"] = to_its_width(as_entry(interval))
    return zeros
