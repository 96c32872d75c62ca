"""The zero of each run's reading, as `diagnosis.json` lists it, and by how much it differs from the first run's."""

from ..document.effects_named import Dimension
from ..document.made_keys import Interval as Entry
from ..document.rounded import to_its_width
from .intervals import Interval, Intervals
from .problem import Problem
from .uncertainty import zero_names


def zero_entries(problem: Problem, bands: Intervals, ending: str) -> dict[str, Dimension]:
    """The zeros by name; `ending`: of the channel. None of a reading that has a true zero."""
    if not problem.system.free_zero:
        return {}
    names = zero_names(problem, ending)
    zeros: dict[str, Dimension] = {
        name: {"nominal": 0.0, **_entry(interval)} for name, interval in zip(names, bands.zeros, strict=True)
    }
    for name, interval in zip(names[1:], bands.zeros_from_first, strict=True):
        zeros[name]["from_first"] = _entry(interval)
    return zeros


def _entry(interval: Interval) -> Entry:
    """A zero with its interval, rounded."""
    return to_its_width({"value": interval.value, "low": interval.low, "high": interval.high})
